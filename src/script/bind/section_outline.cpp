#include "script/bind/section_outline.h"

#include <cmath>

namespace hinge::script {
namespace {

/// The pair of numbers on top of the stack, { x, y } in m.
Eigen::Vector2d pair(lua_State* L, const std::string& what) {
    Eigen::Vector2d p;
    const bool table = lua_istable(L, -1);
    for (int i : {0, 1}) {
        double value = std::nan("");
        if (table) {
            lua_rawgeti(L, -1, i + 1);
            if (lua_type(L, -1) == LUA_TNUMBER) value = lua_tonumber(L, -1);
            lua_pop(L, 1);
        }
        if (!std::isfinite(value)) throw InputError(what + " is " + show(L, -1) + "; must be {x, y}, two numbers in m");
        p[i] = value;
    }
    return p;
}

beam::Outline::Polygon read_polygon(lua_State* L, const std::string& what) {
    beam::Outline::Polygon polygon;
    const int count = lua_istable(L, -1) ? int(lua_rawlen(L, -1)) : 0;
    if (count < 3)
        throw InputError(what + ": field 'corners' has " + std::to_string(count) +
                         " corners; must be a list of three or more, each {x, y} in m");
    for (int i = 1; i <= count; ++i) {
        lua_rawgeti(L, -1, i);
        polygon.corners.push_back(pair(L, what + ": corner " + std::to_string(i)));
        lua_pop(L, 1);
    }
    return polygon;
}

void read_part(lua_State* L, const std::string& what, beam::Outline& outline) {
    Options part(L, -1, what);
    const bool hole = part.flag("hole", false);
    const auto diameter = part.maybe_number("diameter", "m", Range::positive);
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    if (part.push_field("centre") != LUA_TNIL) centre = pair(L, what + ": field 'centre'");
    lua_pop(L, 1);
    const bool corners = part.push_field("corners") != LUA_TNIL;
    if (corners == diameter.has_value())
        throw InputError(what + ": give either 'corners', a list of {x, y} in m, or 'diameter', m");
    beam::Outline alone;
    if (corners) outline.polygons.push_back(read_polygon(L, what)), alone.polygons = {outline.polygons.back()};
    else outline.circles.push_back({centre, *diameter / 2, hole}), alone.circles = {{centre, *diameter / 2, false}};
    lua_pop(L, 1);
    if (corners) outline.polygons.back().hole = hole;
    if (!(alone.area() > 0)) throw InputError(what + ": its area is 0 m^2; its corners are on one line");
    part.finish();
}

}  // namespace

std::shared_ptr<const beam::SectionOutline> read_outline(Options& section) {
    lua_State* L = section.L();
    if (section.push_field("outline") == LUA_TNIL) return lua_pop(L, 1), nullptr;
    if (!lua_istable(L, -1) || lua_rawlen(L, -1) == 0)
        section.complain("outline", show(L, -1), "must be a list of parts: { { corners = { {x, y}, ... } }, ... }, m");
    beam::Outline outline;
    for (int i = 1, count = int(lua_rawlen(L, -1)); i <= count; ++i) {
        lua_rawgeti(L, -1, i);
        const std::string what = section.function() + ", outline, part " + std::to_string(i);
        if (!lua_istable(L, -1)) throw InputError(what + " is " + show(L, -1) + "; must be a table");
        read_part(L, what, outline);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    if (!(outline.area() > 0))
        section.complain("outline", "with an area of " + show(outline.area()) + " m^2",
                         "the area must be above 0: a hole (hole = true) lies within a part that is none");
    outline.move(-outline.centroid());
    return std::make_shared<const beam::SectionOutline>(std::move(outline));
}

}  // namespace hinge::script

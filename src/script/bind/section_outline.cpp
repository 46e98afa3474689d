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
    if (corners) outline.polygons.push_back(read_polygon(L, what)), outline.polygons.back().hole = hole;
    else outline.circles.push_back({centre, *diameter / 2, hole});
    lua_pop(L, 1);
    part.finish();
}

/// A number of at least 1e5 Pa: one below that is in MPa.
double strength(Options& o, const char* field) {
    const double stress = o.number(field, "Pa", Range::positive);
    if (stress < 1e5) o.complain(field, show(stress) + " Pa", "must be 100000 Pa or more: 1 MPa is 1e6");
    return stress;
}

/// Strains of concrete, and E of the bars.
beam::ConcreteStrains read_strains(lua_State* L, const std::string& what) {
    if (!lua_istable(L, -1)) throw InputError(what + " is " + show(L, -1) + "; must be a table");
    Options s(L, -1, what);
    s.expect({"peak", "ultimate", "exponent", "block", "bars"});
    beam::ConcreteStrains out;
    out.peak = s.number("peak", "", Range::positive);
    out.ultimate = s.number("ultimate", "", Range::positive);
    out.exponent = s.number("exponent", "", Range::positive, out.exponent);
    out.block = s.number("block", "", Range::not_negative, 0);
    out.bars = s.number("bars", "Pa", Range::positive, out.bars);
    s.finish();
    return out;
}

beam::Reinforcement read_bars(Options& r) {
    lua_State* L = r.L();
    beam::Reinforcement out;
    r.expect({"concrete", "bars", "strains"});
    out.concrete = strength(r, "concrete");
    if (r.push_field("strains") != LUA_TNIL) out.strains = read_strains(L, r.function() + ", strains");
    lua_pop(L, 1);
    const bool list = r.push_field("bars") == LUA_TTABLE;
    const int count = list ? int(lua_rawlen(L, -1)) : 0;
    if (!list)
        r.complain("bars", show(L, -1), "must be a list of bars: { { x, y, area =, tension =, compression = }, ... }");
    for (int i = 1; i <= count; ++i) {
        lua_rawgeti(L, -1, i);
        const std::string what = r.function() + ", bar " + std::to_string(i);
        if (!lua_istable(L, -1)) throw InputError(what + " is " + show(L, -1) + "; must be a table");
        beam::Reinforcement::Bar bar;
        bar.centre = pair(L, what);
        Options b(L, -1, what);
        bar.area = b.number("area", "m^2", Range::positive);
        bar.tension = strength(b, "tension");
        bar.compression = b.number("compression", "Pa", Range::positive, bar.tension);
        b.finish(2);
        out.bars.push_back(bar);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return out;
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
    std::optional<beam::Reinforcement> concrete;
    if (section.push_field("reinforcement") != LUA_TNIL) {
        Options r(L, -1, section.function() + ", reinforcement");
        concrete = read_bars(r);
    }
    lua_pop(L, 1);
    return beam::make_section_outline(std::move(outline), std::move(concrete), section.function());
}

}  // namespace hinge::script

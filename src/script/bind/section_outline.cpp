#include "script/bind/section_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

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

/// Least part of the strength about the middle of the domain that must be left about zero.
constexpr double least_strength = 1e-3;

bool odd_crossings(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& at) {
    bool odd = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if ((a.y() > at.y()) != (b.y() > at.y()) &&
            at.x() < a.x() + (at.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            odd = !odd;
    }
    return odd;
}

double distance(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& at) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d &a = corners[i], side = corners[(i + 1) % corners.size()] - a;
        const double length = side.squaredNorm(),
                     along = length > 0 ? std::clamp((at - a).dot(side) / length, 0.0, 1.0) : 0;
        least = std::min(least, (at - a - along * side).norm());
    }
    return least;
}

bool holds(const beam::Outline& outline, const Eigen::Vector2d& at, double radius) {
    bool in = false;
    for (const auto& c : outline.circles) {
        const double off = (at - c.centre).norm();
        if (c.hole && off < c.radius + radius) return false;
        in |= !c.hole && off <= c.radius - radius;
    }
    for (const auto& p : outline.polygons) {
        const bool inside = odd_crossings(p.corners, at), clear = distance(p.corners, at) >= radius;
        if (p.hole && (inside || !clear)) return false;
        in |= !p.hole && inside && clear;
    }
    return in;
}

/// A number of at least 1e5 Pa: one below that is in MPa.
double strength(Options& o, const char* field) {
    const double stress = o.number(field, "Pa", Range::positive);
    if (stress < 1e5) o.complain(field, show(stress) + " Pa", "must be 100000 Pa or more: 1 MPa is 1e6");
    return stress;
}

/// Strains of concrete, and E of the bars (section/ultimate_states.h).
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
    if (out.bars < 1e9) s.complain("bars", show(out.bars) + " Pa", "is E of the bars: must be 1e9 Pa or more");
    if (!(out.ultimate >= out.peak && out.ultimate < 0.1))
        s.complain("ultimate", show(out.ultimate), "must be at least `peak`, " + show(out.peak) + ", and below 0.1");
    if (!(out.exponent >= 1)) s.complain("exponent", show(out.exponent), "must be 1 or more");
    if (!(out.block < out.peak))
        s.complain("block", show(out.block), "must be below `peak`, " + show(out.peak) + ", where all is pressed");
    return out;
}

beam::Reinforcement read_bars(Options& r, const beam::Outline& outline) {
    lua_State* L = r.L();
    beam::Reinforcement out;
    r.expect({"concrete", "bars", "strains"});
    out.concrete = strength(r, "concrete");
    if (r.push_field("strains") != LUA_TNIL) out.strains = read_strains(L, r.function() + ", strains");
    lua_pop(L, 1);
    const bool list = r.push_field("bars") == LUA_TTABLE;
    const int count = list ? int(lua_rawlen(L, -1)) : 0;
    if (count == 0)
        r.complain(
            "bars", list ? "empty" : show(L, -1),
            "must be a list of bars: { { x, y, area =, tension =, compression = }, ... }; without bars the section "
            "has no strength in tension");
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
        if (!(bar.compression >= out.concrete))
            b.complain("compression", show(bar.compression) + " Pa",
                       "a bar must be as strong as the concrete it displaces, " + show(out.concrete) + " Pa");
        const std::string place = "{" + show(bar.centre.x()) + ", " + show(bar.centre.y()) + "} m";
        if (!holds(outline, bar.centre, (1 - 1e-9) * bar.radius()))
            throw InputError(what + " at " + place + " is not within the outline; its radius is " + show(bar.radius()) +
                             " m, and all of the bar must be in the concrete");
        for (std::size_t k = 0; k < out.bars.size(); ++k)
            if ((out.bars[k].centre - bar.centre).norm() < (1 - 1e-9) * (out.bars[k].radius() + bar.radius()))
                throw InputError(what + " at " + place + " overlaps bar " + std::to_string(k + 1) +
                                 "; two bars must be apart by the sum of their radii");
        out.bars.push_back(bar);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return out;
}

/// All numbers of an outline with its bars.
std::vector<double> numbers_of(const beam::Outline& outline, const beam::Reinforcement& concrete) {
    std::vector<double> all = {concrete.concrete};
    for (const auto& p : outline.polygons) {
        all.insert(all.end(), {double(p.corners.size()), double(p.hole)});
        for (const auto& c : p.corners) all.insert(all.end(), {c.x(), c.y()});
    }
    for (const auto& c : outline.circles)
        all.insert(all.end(), {-1.0, c.centre.x(), c.centre.y(), c.radius, double(c.hole)});
    for (const auto& b : concrete.bars)
        all.insert(all.end(), {-2.0, b.centre.x(), b.centre.y(), b.area, b.tension, b.compression});
    if (const auto& s = concrete.strains)
        all.insert(all.end(), {-3.0, s->peak, s->ultimate, s->exponent, s->block, s->bars});
    return all;
}

/// An outline with bars: the same object for equal ones that are in use. Its domain takes up to 0.2 s.
std::shared_ptr<const beam::SectionOutline> share(beam::Outline outline, beam::Reinforcement concrete) {
    static std::mutex mutex;
    static std::map<std::vector<double>, std::weak_ptr<const beam::SectionOutline>> made;
    const std::lock_guard lock(mutex);
    std::erase_if(made, [](const auto& entry) { return entry.second.expired(); });
    auto& known = made[numbers_of(outline, concrete)];
    auto found = known.lock();
    if (!found) known = found = std::make_shared<const beam::SectionOutline>(std::move(outline), std::move(concrete));
    return found;
}

std::shared_ptr<const beam::SectionOutline> with_bars(Options& section, beam::Outline outline) {
    lua_State* L = section.L();
    Options r(L, -1, section.function() + ", reinforcement");
    beam::Reinforcement concrete = read_bars(r, outline);
    const Eigen::Vector2d centroid = outline.centroid();
    outline.move(-centroid);
    for (auto& bar : concrete.bars) bar.centre -= centroid;
    const auto made = share(std::move(outline), std::move(concrete));
    const Vec3 left = made->domain()->ellipsoid();
    if (!(left.minCoeff() > least_strength))
        section.complain("reinforcement", "too little",
                         "the bars leave less than " + show(least_strength) +
                             " of the strength in some direction of N, Mx and My; give more of them, on more sides");
    return made;
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
    const bool concrete = section.push_field("reinforcement") != LUA_TNIL;
    auto reinforced = concrete ? with_bars(section, outline) : nullptr;
    lua_pop(L, 1);
    if (reinforced) return reinforced;
    outline.move(-outline.centroid());
    return std::make_shared<const beam::SectionOutline>(std::move(outline));
}

}  // namespace hinge::script

// run:along and member:along: the resultants along a member, with the loads between its nodes.
#include "script/bind/bind_along.h"

#include <algorithm>

#include "core/bar_bending.h"
#include "run/run.h"
#include "script/lua/lua_support.h"
#include "state/configuration.h"

namespace hinge::script {
namespace {

/// The resultants along one element.
struct ElementResultants {
    BarBending about_x, about_y;
    BarBending axial, torsion;  ///< N and Mz in the place of the shear force: loads change them in the same way
};

ElementResultants resultants_of(const Run& run, int element, const std::vector<ShownLoad>& loads) {
    const Mat3 axes = axes_of(element_frame(run.structure(), element, run.state()));
    const Element& e = run.structure().elements()[element];
    const auto place = [&](int node) -> Vec3 {
        return run.structure().position()[node] + run.state().displacement[node];
    };
    const double length = run.structure().large() ? (place(e.node[1]) - place(e.node[0])).norm() : e.length;
    const SectionForces a = run.section_forces(element, -1), b = run.section_forces(element, 1);
    ElementResultants r{{{a.Mx, b.Mx}, {a.Qy, b.Qy}, 1, length},
                        {{a.My, b.My}, {a.Qx, b.Qx}, -1, length},
                        {{0, 0}, {a.N, b.N}, 1, length},
                        {{0, 0}, {a.Mz, b.Mz}, 1, length}};
    const Eigen::Vector2d compression = run.compression(element);
    r.about_x.compression = compression.x(), r.about_y.compression = compression.y();
    for (const ShownLoad& load : loads) {
        if (load.element != element) continue;
        const auto add = [&](BarBending& to, const Vec3& force, const Vec3& moment) {
            if (load.at < 0 && load.is_partial()) {
                to.parts.push_back({load.from,
                                    load.to,
                                    {force.dot(load.force[0]), force.dot(load.force[1])},
                                    {moment.dot(load.moment[0]), moment.dot(load.moment[1])}});
                return;
            }
            if (load.at < 0) {
                for (const int end : {0, 1})
                    to.q[end] += force.dot(load.force[end]), to.m[end] += moment.dot(load.moment[end]);
                return;
            }
            const double t = std::clamp(load.at, 0.0, 1.0);
            to.points.push_back({t, force.dot(load.force[0]), 0});
            to.points.push_back({t, 0, moment.dot(load.moment[0])});
        };
        const Vec3 none = Vec3::Zero(), x = axes.col(0), y = axes.col(1), z = axes.col(2);
        add(r.about_x, y, x), add(r.about_y, x, y);  // a force along y bends about x, a moment about x does, too
        add(r.axial, z, none);
        if (load.at < 0 && load.is_partial())
            r.torsion.parts.push_back({load.from, load.to, {z.dot(load.moment[0]), z.dot(load.moment[1])}, {0, 0}});
        else if (load.at < 0)
            for (const int end : {0, 1}) r.torsion.q[end] += z.dot(load.moment[end]);
        else r.torsion.points.push_back({std::clamp(load.at, 0.0, 1.0), z.dot(load.moment[0]), 0});
    }
    for (BarBending* of : {&r.about_x, &r.about_y, &r.axial, &r.torsion}) of->close();
    return r;
}

/// Where rows stand in an element, from 0 to 1: at both ends, at stations, at extreme moments, on both sides of point
/// loads, where spread loads begin and end.
std::vector<double> places_in(const ElementResultants& r, const std::vector<double>& stations) {
    std::vector<double> at{0, 1}, jumps{0};
    at.insert(at.end(), stations.begin(), stations.end());
    for (const BarBending* b : {&r.about_x, &r.about_y, &r.axial, &r.torsion})
        for (const BarBending::Point& p : b->points) jumps.push_back(p.t);
    std::vector<double> bends;
    for (const BarBending* b : {&r.about_x, &r.about_y, &r.axial, &r.torsion})
        for (const BarBending::Part& p : b->parts)
            for (const double t : {p.t0, p.t1})
                if (t > 0 && t < 1) bends.push_back(t), at.push_back(t);
    std::sort(bends.begin(), bends.end());
    std::sort(jumps.begin(), jumps.end());
    jumps.push_back(1);
    constexpr double beside = 1e-9;
    for (std::size_t i = 0; i + 1 < jumps.size(); ++i) {
        const double from = jumps[i], to = jumps[i + 1];
        if (i > 0) at.push_back(from), at.push_back(std::min(1.0, from + beside));
        if (!(to - from > 4 * beside)) continue;
        double piece = from + beside;
        const auto add_peaks = [&](double end) {
            for (const BarBending* b : {&r.about_x, &r.about_y})
                for (const double t : b->peaks(piece, end)) at.push_back(t);
            piece = end;
        };
        for (const double t : bends)
            if (t > piece && t < to) add_peaks(t);
        add_peaks(to);
    }
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end(), [](double s, double t) { return t - s < 0.5 * beside; }), at.end());
    return at;
}

void push_row(lua_State* L, const ElementResultants& r, double t, double x) {
    const auto number = [L](const char* name, double value) { lua_pushnumber(L, value), lua_setfield(L, -2, name); };
    lua_createtable(L, 0, 7);
    number("x", x);
    number("N", r.axial.shear(t));
    number("Mx", r.about_x.moment(t)), number("My", r.about_y.moment(t));
    number("Mz", r.torsion.shear(t));
    number("Qx", r.about_y.shear(t)), number("Qy", r.about_x.shear(t));
}

}  // namespace

int push_along(lua_State* L, const Run& run, int first, int count, int stations) {
    const std::vector<ShownLoad> loads = run.shown_loads();
    lua_newtable(L);
    lua_Integer row = 0;
    for (int i = 0; i < count; ++i) {
        const int element = first + i;
        if (run.state().broken[element]) continue;
        const double length = run.structure().elements()[element].length, share = 1.0 / count;
        std::vector<double> within;
        for (int k = 1; k < stations; ++k)
            if (const double t = (double(k) / stations - i * share) / share; t > 1e-9 && t < 1 - 1e-9)
                within.push_back(t);
        const ElementResultants r = resultants_of(run, element, loads);
        for (const double t : places_in(r, within)) {
            push_row(L, r, t, (i + t) * length);
            lua_rawseti(L, -2, ++row);
        }
    }
    return 1;
}

}  // namespace hinge::script

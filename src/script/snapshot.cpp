// A run at one instant: where its elements are, how they are damaged, and what they carry.
#include "script/snapshot.h"

#include <cmath>

#include "beam/yield.h"

namespace hinge::script {
namespace {

void add_forces(output::Bar& bar, const Run& run, int element) {
    const SectionForces a = run.section_forces(element, -1), b = run.section_forces(element, 1);
    bar.N = std::abs(a.N) > std::abs(b.N) ? a.N : b.N;
    bar.Mz = std::abs(a.Mz) > std::abs(b.Mz) ? a.Mz : b.Mz;
    bar.Mx[0] = a.Mx, bar.Mx[1] = b.Mx, bar.My[0] = a.My, bar.My[1] = b.My;
    const beam::YieldSurface& w = run.structure().elements()[element].yield;
    const auto plastic = [](double weight) { return weight > 0 ? 1 / std::sqrt(weight) : 0; };
    bar.N0 = plastic(w.n), bar.Mx0 = plastic(w.x), bar.My0 = plastic(w.y), bar.Mz0 = plastic(w.z);
    bar.hinges = run.state().yielded[element], bar.touched = run.state().touched[element];
}

}  // namespace

output::Snapshot make_snapshot(const Run& run) {
    const Structure& structure = run.structure();
    const State& state = run.state();
    output::Snapshot snapshot;
    snapshot.time = state.time;
    if (dynamic_cast<const Statics*>(&run)) snapshot.factor = state.factor;
    snapshot.groups = structure.model().groups();
    for (std::size_t i = 0; i < structure.position().size(); ++i) {
        const Vec3 x = structure.position()[i] + state.displacement[i];
        const Vec3& u = state.displacement[i];
        snapshot.points.push_back({x.x(), x.y(), x.z()});
        snapshot.displacement.push_back({u.x(), u.y(), u.z()});
    }
    snapshot.is_virtual.assign(snapshot.points.size(), 0);
    snapshot.held = structure.fixed();
    for (std::size_t m = 0; m < structure.model().members().size(); ++m)
        for (const int g : structure.model().members()[m].groups) snapshot.memberships.push_back({int(m) + 1, g});
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        const auto& groups = structure.model().members()[e.member].groups;
        output::Bar bar;
        bar.point[0] = e.node[0];
        bar.point[1] = e.node[1];
        bar.yield = run.yield_value(int(i));
        bar.state = state.broken[i]    ? output::BarState::broken
                    : state.yielded[i] ? output::BarState::yielded
                                       : output::BarState::elastic;
        bar.group = groups.empty() ? -1 : groups[0];
        bar.member = e.member + 1;
        bar.element = int(i) + 1;
        bar.width = 2 * e.radius;
        add_forces(bar, run, int(i));
        if (state.broken[i]) {
            const int side = state.broken[i] == 2 ? 1 : 0, carrier = e.node[1 - side];
            const Vec3 end = structure.position()[carrier] + state.displacement[carrier] +
                             state.rotation[carrier] * state.offset_arm[i];
            bar.point[side] = int(snapshot.points.size());
            const Vec3 moved = end - structure.position()[e.node[side]];
            snapshot.points.push_back({end.x(), end.y(), end.z()});
            snapshot.displacement.push_back({moved.x(), moved.y(), moved.z()});
            snapshot.is_virtual.push_back(1), snapshot.held.push_back(0);
        }
        snapshot.bars.push_back(bar);
    }
    return snapshot;
}

}  // namespace hinge::script

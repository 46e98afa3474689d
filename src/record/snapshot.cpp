// Snapshot of a run at one instant: positions, damage and section forces of its elements.
#include "record/snapshot.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "section/fracture_limits.h"
#include "section/material_law.h"
#include "section/section_outline.h"
#include "section/yield.h"
#include "effects/declared.h"
#include "effects/line_mass.h"
#include "effects/panels.h"
#include "run/run.h"
#include "record/joint_ratings.h"
#include "state/configuration.h"
#include "state/hinges.h"
#include "state/turned_ends.h"

namespace hinge {
namespace {

constexpr double drawn_compression = 0.02;  // below it moments change by a quarter of a per cent between the ends

void add_forces(output::Bar& bar, const Run& run, int element) {
    const SectionForces a = run.section_forces(element, -1), b = run.section_forces(element, 1);
    bar.N = std::abs(a.N) > std::abs(b.N) ? a.N : b.N;
    bar.Mz = std::abs(a.Mz) > std::abs(b.Mz) ? a.Mz : b.Mz;
    bar.Mx[0] = a.Mx, bar.Mx[1] = b.Mx, bar.My[0] = a.My, bar.My[1] = b.My;
    bar.Qx[0] = a.Qx, bar.Qx[1] = b.Qx, bar.Qy[0] = a.Qy, bar.Qy[1] = b.Qy;
    const Eigen::Vector2d compression = run.compression(element);
    for (const int axis : {0, 1})
        bar.compression[axis] = std::abs(compression[axis]) > drawn_compression ? compression[axis] : 0;
    const beam::YieldSurface& w = run.structure().elements()[element].yield;
    const auto plastic = [](double weight) { return weight > 0 ? 1 / std::sqrt(weight) : 0; };
    bar.N0 = plastic(w.n), bar.Mx0 = plastic(w.x), bar.My0 = plastic(w.y), bar.Mz0 = plastic(w.z);
    bar.hinges = run.state().yielded[element], bar.touched = run.state().touched[element];
    const Vec6 all = flowed(run.state(), element);
    for (const int end : {1, 2})
        bar.rotation[end - 1] = std::hypot(beam::hinge_rotation(all, end, 0), beam::hinge_rotation(all, end, 1));
}

/// A joint that has yielded is shown as a plastic hinge at its end of the element.
void add_joints(output::Snapshot& snapshot, const Run& run) {
    for (const JointRating& j : joint_ratings(run)) {
        if (j.record && std::isfinite(j.strength)) snapshot.joints = true;
        if (!j.record || !j.record->yielded) continue;
        output::Bar& bar = snapshot.bars[std::size_t(j.element)];
        bar.hinges |= std::uint8_t(j.end);
        keep_largest(bar.rotation[j.end - 1], j.now->rotation[j.which]);
    }
}

/// "exact", "eq 14, hardening"
std::string law_text(const beam::SectionLaw& law, const MemberData& member) {
    std::string text = law.ignores_shape() ? "eq 14" : law.name();
    if (!law.keeps_strength())
        for (const auto& added : member.material->laws) text += std::string(", ") + added->name();
    if (member.backbone) text += std::string(", ") + member.backbone->name();
    return text;
}

/// f_y of a bar, the larger of its sections that can yield. Of a law that is not eq 14 also along the bar: at the ends
/// and in the middle; there with the history of the end where it is larger.
void add_yields(output::Bar& bar, const Run& run, int element) {
    const Element& e = run.structure().elements()[element];
    const bool along = e.law && !(e.law->ignores_shape() && e.law->keeps_strength());
    if (run.structure().conventional()) {
        bar.yield = run.yield_value(element, 0);
        if (!along) return;
        for (const int end : {0, 2}) bar.yield_along[end] = std::min(run.yield_value(element, end - 1), bar.yield);
        bar.yield_along[1] = bar.yield;
        return;
    }
    const double ends[2] = {run.yield_value(element, -1), run.yield_value(element, 1)};
    bar.yield = std::max(ends[0], ends[1]);
    if (!along) return;
    bar.yield_along[0] = ends[0], bar.yield_along[2] = ends[1];
    // The cubic with the moments and shear forces at the ends, as distributed loads make it: dMx/dz = Qy, dMy/dz = -Qx.
    const double Mx = (bar.Mx[0] + bar.Mx[1]) / 2 + e.length * (bar.Qy[0] - bar.Qy[1]) / 8;
    const double My = (bar.My[0] + bar.My[1]) / 2 - e.length * (bar.Qx[0] - bar.Qx[1]) / 8;
    for (const int end : {-1, 1}) {
        if (end == 1 && e.law->keeps_strength()) break;  // there is no history
        bar.yield_along[1] = std::max(
            bar.yield_along[1], yield_function_at(run.structure(), run.state(), element, end, {Mx, My, bar.N, bar.Mz}));
    }
}

std::array<double, 3> numbers(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// The section's y axis in space.
Vec3 direction_up(const Run& run, int element) {
    const State& state = run.state();
    const Element& e = run.structure().elements()[element];
    if (!state.broken[element]) return axes_of(element_frame(run.structure(), element, state)).col(1);
    const int carrier = e.node[state.broken[element] == 2 ? 0 : 1];
    return state.rotation[carrier] * (e.axes * Vec3::UnitY());
}

/// As pictures show it. A section without a size is a square of its area.
output::Shape shape_of(const Section& s) {
    output::Shape shape;
    const bool circles = s.outline && s.outline->outline().polygons.empty();
    shape.kind = circles || s.shape == "pipe" || s.shape == "round" ? output::Shape::round
                 : s.web > 0 && s.flange > 0                        ? output::Shape::h
                                                                    : output::Shape::rectangle;
    shape.width = s.width > 0 ? s.width : std::sqrt(s.area);
    shape.depth = s.depth > 0 ? s.depth : std::sqrt(s.area);
    shape.web = s.web, shape.flange = s.flange;
    return shape;
}

void add_loads(output::Snapshot& snapshot, const Run& run) {
    for (const ShownLoad& l : run.shown_loads())
        for (const auto kind : {output::Load::force, output::Load::moment}) {
            const Vec3* value = kind == output::Load::force ? l.force : l.moment;
            if (value[0].isZero(0) && value[1].isZero(0)) continue;
            output::Load load{kind, l.node, l.element, l.at, {}, l.from, l.to};
            for (int end : {0, 1}) load.value[end] = numbers(value[end]);
            (l.is_weight ? snapshot.weights : snapshot.loads).push_back(load);
        }
}

/// Positions and displacements of the nodes.
void add_points(output::Snapshot& snapshot, const Run& run) {
    const Structure& structure = run.structure();
    const State& state = run.state();
    for (std::size_t i = 0; i < structure.position().size(); ++i) {
        const Vec3 x = structure.position()[i] + state.displacement[i];
        snapshot.points.push_back(numbers(x));
        snapshot.displacement.push_back(numbers(state.displacement[i]));
        snapshot.rotation.push_back(numbers(run.displacement(int(i)).tail<3>()));
    }
    snapshot.is_virtual.assign(snapshot.points.size(), 0);
    snapshot.held = structure.fixed();
}

/// Which members are in which groups, and which nodes are joined by other things than members.
void add_groups(output::Snapshot& snapshot, const Model& model) {
    snapshot.groups = model.groups();
    snapshot.declared = int(model.nodes().size());
    for (std::size_t m = 0; m < model.members().size(); ++m)
        for (const int g : model.members()[m].groups) snapshot.memberships.push_back({int(m) + 1, g});
    for (const NodeLink& link : node_links(model))
        if (link.a >= 0) snapshot.connected.push_back({link.a, link.b});
}

/// The panels of floors whose members are whole.
void add_floors(output::Snapshot& snapshot, const Run& run) {
    const auto& panels = run.structure().model().declared<FloorPanel>(floor_panels);
    if (panels.empty()) return;
    std::vector<char> whole(run.structure().model().members().size(), 1);
    for (std::size_t i = 0; i < run.structure().elements().size(); ++i)
        if (run.state().broken[i]) whole[run.structure().elements()[i].member] = 0;
    for (const FloorPanel& panel : panels)
        if (std::all_of(panel.members.begin(), panel.members.end(), [&](int m) { return whole[m] != 0; }))
            snapshot.floors.push_back({.points = panel.nodes});
}

/// Panels that are plates, with their principal forces.
void add_plates(output::Snapshot& snapshot, const Run& run) {
    const auto& panels = run.structure().model().declared<Panel>(panels_effect);
    const PanelsNow* now = panels_now(run.state());
    for (std::size_t i = 0; now && i < panels.size(); ++i) {
        const Vec3& n = now->force[i];
        const double middle = 0.5 * (n[0] + n[1]), half = std::hypot(0.5 * (n[0] - n[1]), n[2]);
        snapshot.floors.push_back({panels[i].nodes,
                                   true,
                                   {middle + half, middle - half},
                                   is_torn(*now, panels[i], i),
                                   {n[0], n[1], n[2]},
                                   now->used[i]});
    }
}

/// The end of a broken element that no node carries any more has a point of its own.
void add_loose_end(output::Snapshot& snapshot, output::Bar& bar, const Run& run, int element) {
    const Structure& structure = run.structure();
    const State& state = run.state();
    const Element& e = structure.elements()[element];
    const int side = state.broken[element] == 2 ? 1 : 0, carrier = e.node[1 - side];
    const Vec3 end = structure.position()[carrier] + state.displacement[carrier] +
                     state.rotation[carrier] * state.offset_arm[element];
    bar.point[side] = int(snapshot.points.size());
    const Vec3 moved = end - structure.position()[e.node[side]];
    snapshot.points.push_back(numbers(end));
    snapshot.displacement.push_back(numbers(moved));
    snapshot.rotation.push_back(snapshot.rotation[std::size_t(carrier)]);
    snapshot.is_virtual.push_back(1), snapshot.held.push_back(0);
}

/// The bar of an element, with its section's shape by number.
output::Bar bar_of(const Run& run, int element, int shape) {
    const State& state = run.state();
    const Element& e = run.structure().elements()[element];
    const auto& groups = run.structure().model().members()[e.member].groups;
    output::Bar bar;
    for (const int end : {0, 1}) bar.point[end] = bar.node[end] = e.node[end];
    bar.state = state.broken[element]    ? output::BarState::broken
                : state.yielded[element] ? output::BarState::yielded
                                         : output::BarState::elastic;
    bar.group = groups.empty() ? -1 : groups[0];
    bar.member = e.member + 1;
    bar.element = element + 1;
    bar.width = 2 * e.radius;
    bar.shape = shape;
    bar.up = numbers(direction_up(run, element));
    add_forces(bar, run, element);
    add_yields(bar, run, element);
    return bar;
}

/// A bar for each element, the shapes of their sections, and the names of their laws.
void add_bars(output::Snapshot& snapshot, const Run& run) {
    const Structure& structure = run.structure();
    std::map<const Section*, int> shape_at;
    std::set<std::string> laws;
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        const MemberData& member = structure.model().members()[e.member];
        const auto [shape, fresh] = shape_at.try_emplace(member.section.get(), int(snapshot.shapes.size()));
        if (fresh) snapshot.shapes.push_back(shape_of(*member.section));
        output::Bar bar = bar_of(run, int(i), shape->second);
        if (e.law) laws.insert(law_text(*e.law, member));
        if (run.state().broken[i]) add_loose_end(snapshot, bar, run, int(i));
        snapshot.bars.push_back(bar);
    }
    if (!laws.empty() && laws != std::set<std::string>{"eq 14"}) snapshot.laws.assign(laws.begin(), laws.end());
}

}  // namespace

output::Snapshot make_snapshot(const Run& run) {
    output::Snapshot snapshot;
    snapshot.time = run.state().time;
    if (run.is_static()) snapshot.factor = run.state().factor;
    add_points(snapshot, run);
    add_groups(snapshot, run.structure().model());
    add_bars(snapshot, run);
    add_joints(snapshot, run);
    add_loads(snapshot, run);
    add_floors(snapshot, run);
    add_plates(snapshot, run);
    for (const DeclaredPlane& plane : declared_planes(run.structure().model()))
        snapshot.ground.push_back({numbers(plane.point), numbers(plane.normal)});
    return snapshot;
}

}  // namespace hinge

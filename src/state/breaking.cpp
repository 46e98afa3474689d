#include "state/breaking.h"

#include <algorithm>
#include <cmath>

#include "beam/element_mass.h"
#include "state/group_momentum.h"
#include "state/hinges.h"
#include "state/lone_elements.h"

namespace hinge {
namespace {

Mat3 frame(const Structure& structure, const State& state, int index) {
    if (!structure.large()) return structure.elements()[index].axes.toRotationMatrix();
    return axes_of(element_frame(structure, index, state));
}

/// Axes in which an element's rotary inertia at an end lies: the element's, or its node's.
Mat3 rotary_axes(const Structure& structure, const State& state, int index, int end, const Mat3& axes) {
    if (!structure.at_nodes()) return axes;
    const Element& e = structure.elements()[index];
    return (state.rotation[e.node[end]] * e.axes).toRotationMatrix();
}

Mat12 mass_matrix(const Structure& structure, const State& state, int index) {
    const beam::Inertia& m = inertia_now(structure, state, index);
    if (!structure.at_nodes()) return m.matrix(frame(structure, state, index));
    Mat12 M = m.matrix(Mat3::Identity());
    for (int end : {0, 1}) {
        const Mat3 axes = rotary_axes(structure, state, index, end, {});
        M.block<3, 3>(6 * end + 3, 6 * end + 3) = axes * m.rotary[end].asDiagonal() * axes.transpose();
    }
    return M;
}

Vec12 element_velocity(const Element& e, const State& state) {
    Vec12 v;
    v << state.velocity[e.node[0]], state.velocity[e.node[1]];
    return v;
}

/// Momentum rows (linear, and angular about `about`) of nodal momenta p (12) at the element's nodes.
Vec6 momentum_of(const Vec12& p, const Vec3& x1, const Vec3& x2, const Vec3& about) {
    Vec6 h;
    h << p.segment<3>(0) + p.segment<3>(6), p.segment<3>(3) + p.segment<3>(9) +
                                                (x1 - about).cross(Vec3(p.segment<3>(0))) +
                                                (x2 - about).cross(Vec3(p.segment<3>(6)));
    return h;
}

/// A rigid bar in the place of an element.
struct Bar {
    beam::RigidOffset offset;  ///< on its carrier
    Vec6 carried;              ///< momenta of the element about the carrier
    double kinetic;            ///< J, kinetic energy that these masses had, less what others that got new ones have
};

/// An impulse on a node as one on another that `span` points away from.
Vec6 moved_to(const Vec6& impulse, const Vec3& span) {
    Vec6 moved = impulse;
    moved.tail<3>() += span.cross(Vec3(impulse.head<3>()));
    return moved;
}

/// `a`: its end (0, 1) at the carrier.
Bar consistent_bar(const Structure& structure, const State& state, int index, int a, const Vec3& span) {
    const Element& e = structure.elements()[index];
    const auto where = [&](int node) -> Vec3 { return structure.position()[node] + state.displacement[node]; };
    const Mat3 axes = frame(structure, state, index);
    const Mat12 M = mass_matrix(structure, state, index);
    const Vec12 v = element_velocity(e, state);
    const Vec6 carried = momentum_of(M * v, where(e.node[0]), where(e.node[1]), where(e.node[a]));
    const double stretch = e.length / span.norm();
    beam::Rigidity same_mass = e.rigidity;
    same_mass.rhoA *= stretch;
    same_mass.rhoIx *= stretch;
    same_mass.rhoIy *= stretch;
    return {beam::rigid_offset(same_mass, span, axes), carried, 0.5 * v.dot(M * v)};
}

Bar lumped_bar(const Structure& structure, State& state, int index, int a, const Vec3& span,
               std::vector<Vec6>& impulse) {
    const LooseElement loose = loosen(structure, state, index, impulse);
    const Vec6 near = loose.mass[a] * loose.velocity[a], far = loose.mass[1 - a] * loose.velocity[1 - a];
    return {beam::lumped_rigid_offset(loose.mass[a], loose.mass[1 - a], span), near + moved_to(far, span),
            loose.kinetic - loose.left_kinetic};
}

/// The element's partner breaks, whose elastic deformation is `of_partner`: it keeps the axial force that it had in the
/// pair, and its moments unless they are larger than what it bends by stands for. Its plastic deformation takes the
/// difference. Returns what the pair's bending and this element lose by that, less what the partner has by itself, J.
///
/// The pair has the energy of its axial forces, of bending at least that of N = 0 (S - p S' >= 1, since S falls ever
/// faster; and A alike), and of shear and torsion. The element is left with no more than its part of that.
double leave_alone(const Structure& structure, State& state, int index, const Vec6& of_partner) {
    const Element& e = structure.elements()[index];
    const beam::Stiffness k = stiffness_now(structure, state, index);
    const Vec6 before = element_deformation(structure, index, state) - state.plastic[index];
    const bool first = index < e.partner;
    const beam::ElasticPair pair =
        elastic_pair(structure, state, std::min(index, e.partner), heat_of(state.heat, index));
    const Vec6 &d1 = first ? before : of_partner, &d2 = first ? of_partner : before;
    Vec6 beyond = pair.forces_beyond(d1, d2).segment<6>(first ? 0 : 6);
    const beam::Stiffness left = in_series(k, pair.springs[first ? 0 : 1]);
    if (pair.has_springs()) {  // of both: what springs relieve is not of the bending alone, and shear is kept as it was
        const Vec6 together = k.times(before) + beyond, alone = left.times(before);
        for (int a : {0, 2}) {
            const double most = std::abs(alone[a + 1] - alone[a]) / 2, shear = (together[a] + together[a + 1]) / 2,
                         bending = std::clamp((together[a + 1] - together[a]) / 2, -most, most);
            beyond[a] += shear - bending - together[a], beyond[a + 1] += shear + bending - together[a + 1];
        }
    } else
        for (int plane : {0, 1}) {
            const double alone = pair.kind.b[plane] * (before[2 * plane + 1] - before[2 * plane]),
                         most = std::abs(alone), more = std::clamp(alone + beyond[2 * plane + 1], -most, most) - alone;
            beyond[2 * plane] = -more, beyond[2 * plane + 1] = more;
        }
    const Vec6 after = pair.has_springs() ? left.solve(k.times(before) + beyond) : Vec6(before + k.solve(beyond));
    state.plastic[index] += before - after;
    state.force[index] = left.times(after);
    return pair.energy_beyond(d1, d2) + 0.5 * (before.dot(k.times(before)) - after.dot(left.times(after)));
}

/// Of each node, whether all members that meet there are in the group; -1: all nodes.
std::vector<char> nodes_of_group(const Structure& structure, int group) {
    std::vector<char> in(structure.position().size(), group < 0), out(in.size(), 0);
    for (std::size_t i = 0; group >= 0 && i < structure.elements().size(); ++i)
        for (int node : structure.elements()[i].node) {
            std::vector<char>& has = structure.in_group(int(i), group) ? in : out;
            has[node] = 1;
            if (const int at = structure.declared_node(node); at >= 0) has[at] = 1;  // of an end with a joint
        }
    for (std::size_t i = 0; i < in.size(); ++i) in[i] = in[i] && !out[i];
    return in;
}

}  // namespace

double kinetic_energy(const Structure& structure, const State& state, int index, const Mat3& axes) {
    const Element& e = structure.elements()[index];
    const Vec6 &a = state.velocity[e.node[0]], &b = state.velocity[e.node[1]];
    const Vec3 va = a.head<3>(), vb = b.head<3>(),
               wa = rotary_axes(structure, state, index, 0, axes).transpose() * a.tail<3>(),
               wb = rotary_axes(structure, state, index, 1, axes).transpose() * b.tail<3>();
    const beam::Inertia& m = inertia_now(structure, state, index);  // eq 20a with consistent mass
    return 0.5 * (m.own[0] * va.dot(va) + m.own[1] * vb.dot(vb) + wa.dot(m.rotary[0].cwiseProduct(wa)) +
                  wb.dot(m.rotary[1].cwiseProduct(wb))) +
           m.across * va.dot(vb) + wa.dot(m.rotary_across.cwiseProduct(wb));
}

double kinetic_energy_of_offset_masses(const State& state) {
    double energy = 0;
    for (std::size_t i = 0; i < state.offset_mass.size(); ++i)
        if (state.offset_mass[i].mass > 0)
            energy += 0.5 * state.velocity[i].dot(offset_mass_in_space(state.offset_mass[i], state.rotation[i]) *
                                                  state.velocity[i]);
    return energy;
}

double kinetic_energy(const Structure& structure, const State& state) {
    double energy = 0;
    for (std::size_t i = 0; i < structure.elements().size(); ++i)
        if (!state.broken[i]) energy += kinetic_energy(structure, state, int(i), frame(structure, state, int(i)));
    return energy + kinetic_energy_of_offset_masses(state);
}

GroupMomentum momentum_of_group(const Structure& structure, const State& state, int group) {
    GroupMomentum total{{0, Vec3::Zero(), Vec3::Zero()}};
    const std::vector<char> counts = nodes_of_group(structure, group);
    Vec6 h = Vec6::Zero();
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        if (state.broken[i] || (group >= 0 && !structure.in_group(int(i), group))) continue;
        const Element& e = structure.elements()[i];
        const Mat12 M = mass_matrix(structure, state, int(i));
        h +=
            momentum_of(M * element_velocity(e, state), structure.position()[e.node[0]] + state.displacement[e.node[0]],
                        structure.position()[e.node[1]] + state.displacement[e.node[1]], Vec3::Zero());
        total.mass += is_lone(structure, state, int(i)) ? e.lone.own[0] + e.lone.own[1] : e.mass();
        total.kinetic += kinetic_energy(structure, state, int(i), frame(structure, state, int(i)));
    }
    for (std::size_t i = 0; i < state.offset_mass.size(); ++i) {
        if (state.offset_mass[i].mass == 0 || !counts[i]) continue;
        const Vec6 p = offset_mass_in_space(state.offset_mass[i], state.rotation[i]) * state.velocity[i];
        h.head<3>() += p.head<3>();
        h.tail<3>() += p.tail<3>() + (structure.position()[i] + state.displacement[i]).cross(Vec3(p.head<3>()));
        total.mass += state.offset_mass[i].mass;
        total.kinetic += 0.5 * state.velocity[i].dot(p);
    }
    total.linear = h.head<3>();
    total.angular = h.tail<3>();
    return total;
}

Momentum momentum(const Structure& structure, const State& state) { return momentum_of_group(structure, state, -1); }

BreakReport break_off(const Structure& structure, State& state, int index, int end, std::vector<Vec6>& impulse) {
    const Element& e = structure.elements()[index];
    BreakReport report;
    const int a = end == 2 ? 0 : 1, carrier = e.node[a], freed = e.node[1 - a];
    report.carrier = carrier;
    const auto where = [&](int node) -> Vec3 { return structure.position()[node] + state.displacement[node]; };
    const beam::Stiffness k = stiffness_now(structure, state, index);
    const Vec6 stretched = element_deformation(structure, index, state) - state.plastic[index];
    report.elastic = 0.5 * stretched.dot(k.times(stretched));
    if (in_pair(structure, state, index)) report.elastic += leave_alone(structure, state, e.partner, stretched);

    if (state.offset_mass.empty()) state.offset_mass.assign(structure.position().size(), {});
    if (state.offset_arm.empty()) state.offset_arm.assign(structure.elements().size(), Vec3::Zero());
    const Vec3 span = where(freed) - where(carrier);
    const Bar bar = structure.lumped() ? lumped_bar(structure, state, index, a, span, impulse)
                                       : consistent_bar(structure, state, index, a, span);
    state.broken[index] = std::int8_t(end);
    state.force[index].setZero();
    const Mat6 offset_mass = beam::offset_mass_matrix(bar.offset.mass, bar.offset.moment, bar.offset.inertia);

    // T^T M v of the element, T making its far node follow the carrier rigidly, less what the offset mass has at the
    // carrier's velocity
    const Vec6 at_carrier = offset_mass * state.velocity[carrier];
    impulse[carrier] += bar.carried - at_carrier;
    report.kinetic = bar.kinetic - 0.5 * state.velocity[carrier].dot(at_carrier);

    OffsetMass& h = state.offset_mass[carrier];
    const Mat3 back = state.rotation[carrier].toRotationMatrix().transpose();
    state.offset_arm[index] = back * span;
    h.mass += bar.offset.mass;
    h.moment += back * bar.offset.moment;
    h.inertia += back * bar.offset.inertia * back.transpose();

    bool alone = state.offset_mass[freed].mass == 0;
    for (int other : structure.elements_at(freed)) alone &= state.broken[other] != 0;
    if (alone) {
        report.orphaned = true;
        if (!impulse[freed].isZero(0)) {  // of another break in this step
            impulse[carrier] += moved_to(impulse[freed], span);
            impulse[freed].setZero();
        }
        state.gone[freed] = 1;
        state.held[freed] = 63;
        state.velocity[freed].setZero();
        state.acceleration[freed].setZero();
    }
    state.accumulated["fracture_elastic"] += report.elastic;
    state.accumulated["fracture_kinetic"] += report.kinetic;
    return report;
}

}  // namespace hinge

#include "effects/configured_joint.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "effects/all_effects.h"

namespace hinge {
namespace {

/// Stiffness of a rigid axis over that of its member, 4 EI / L or GJ / L. A cantilever whose end has such an axis is
/// softer by 3 / 4 of its inverse. With more in dynamics, conjugate gradients may not converge (they may be in single
/// precision), and explicit steps would be shorter. Statics has factors, which take more.
constexpr double rigid_part_static = 1e5, rigid_part_implicit = 1e3, rigid_part_explicit = 100;

/// Part of its strength from which on a joint counts as sliding where it is asked how it goes on (Yielded::goes_on):
/// the residual of an equilibrium, and what it turns back by in dynamics from step to step.
constexpr double at_strength = 1 - 1e-6;

double rigid_part(const Workspace& w) {
    return !w.kind.dynamic ? rigid_part_static : w.kind.explicit_steps ? rigid_part_explicit : rigid_part_implicit;
}
/// `own`: stiffness of the member about each axis, N m/rad.
void find_parts(const Workspace& w, const Joint& j, const Vec3& own, ConfiguredJoint& m) {
    m.own = own;
    for (int k = 0; k < 3; ++k) {
        const JointAxis& axis = j.is.axis[k];
        m.parts[k] = parts_of(axis);
        m.damped[k] = std::isfinite(axis.stiffness) ? axis.stiffness : 0;
        m.stiffness[k] = std::isfinite(axis.stiffness) ? axis.stiffness : rigid_part(w) * own[k];
    }
}

ConfiguredJoint at_end(const Workspace& w, const Joint& j, const std::vector<ElementDamping>& damping) {
    const Structure& s = w.structure;
    ConfiguredJoint m{
        j.member, j.end, s.model().members()[j.member].node[j.end], s.end_node(j.member, j.end), {}, {}, {}, {}, {}};
    const Element& e = s.elements()[s.elements_at(m.end)[0]];
    const double length = e.length * s.model().members()[j.member].elements;
    m.axes = e.axes.toRotationMatrix();
    m.wave = length * std::sqrt(e.rigidity.rhoA / e.rigidity.EA);
    find_parts(w, j, Vec3(4 * e.rigidity.EIx, 4 * e.rigidity.EIy, e.rigidity.GJ) / length, m);
    m.damping = joint_damping(s, damping, {m.end});
    return m;
}
/// `others`: those declared before it.
ConfiguredJoint between_nodes(const Workspace& w, const Joint& j, const std::vector<ElementDamping>& damping,
                              const std::vector<ConfiguredJoint>& others) {
    const Structure& s = w.structure;
    ConfiguredJoint m{-1, 0, j.from, j.to, {}, {}, {}, j.axes, {}};
    double stiffest = 0;
    for (const int node : {j.from, j.to}) {
        if (s.is_alone(node))
            throw InputError("model:joint: " + s.node_name(node) +
                             " has no member, so that it has neither stiffness nor mass; join nodes of members");
        const auto count = [&](int at) {
            for (const int i : s.elements_at(at)) {
                const Element& e = s.elements()[i];
                const double length = e.length * s.model().members()[e.member].elements;
                stiffest = std::max({stiffest, 4 * e.rigidity.EIx / length, 4 * e.rigidity.EIy / length});
            }
        };
        count(node);
        for (const ConfiguredJoint& other : others)
            if (!other.is_between_nodes() && other.node == node && s.hangs_on_joints(node)) count(other.end);
    }
    find_parts(w, j, Vec3::Constant(stiffest), m);
    m.damping = joint_damping(s, damping, {j.from, j.to});
    return m;
}

}  // namespace

std::vector<ConfiguredJoint> configured_joints(const Workspace& w) {
    const std::vector<ElementDamping> damping = damping_of(w.structure);
    std::vector<ConfiguredJoint> list;
    for (const Joint& j : w.structure.model().declared<Joint>(joints_effect))
        list.push_back(j.is_between_nodes() ? between_nodes(w, j, damping, list) : at_end(w, j, damping));
    return list;
}

JointMoments evaluate(const ConfiguredJoint& m, const Vec3& rotation, const JointState& from) {
    JointMoments e;
    for (int k = 0; k < 3; ++k) {
        if (m.parts[k].empty()) {
            const double turned = rotation[k] - from.offset[k];
            e.moment[k] = m.stiffness[k] * turned;
            e.slope[k] = m.stiffness[k];
            e.stored += 0.5 * e.moment[k] * turned;
            continue;
        }
        e.slid[k] = from.slid[k];
        const Resistance r = resist(m.parts[k], k < 2 ? from.left : 1, rotation[k], e.slid[k]);
        e.moment[k] = r.moment, e.slope[k] = r.slope;
        e.stored += r.stored, e.dissipated += r.dissipated, e.work[k] = r.dissipated;
    }
    return e;
}

Vec3 slope_of(const ConfiguredJoint& m, const Vec3& rotation, const JointState& from, const JointMoments& e,
              Yielded as) {
    if (as == Yielded::at_rotation) return e.slope;
    Vec3 slope = m.stiffness;
    for (int k = 0; k < 3 && as == Yielded::goes_on; ++k) {
        if (m.parts[k].empty()) continue;
        slope[k] = 0;
        for (std::size_t p = 0; p < m.parts[k].size(); ++p) {
            const auto& [stiffness, strength] = m.parts[k][p];
            const double has = std::abs(stiffness * (rotation[k] - e.slid[k][p]));
            if (has < at_strength * (k < 2 ? from.left : 1) * strength) slope[k] += stiffness;
        }
    }
    return slope;
}

ViscousMoments viscous_moments(const ConfiguredJoint& m, const JointState& from, const Vec3& rotation, const Vec3& rate,
                               double dt, const JointMoments& e, bool begins) {
    const Vec3 &k = m.damped, turned = rotation - from.rotation;
    ViscousMoments v;
    if (begins) v.elastic = from.elastic;
    for (int c = 0; c < 3 && !begins; ++c) {
        if (m.parts[c].empty() || turned[c] == 0 || dt == 0 || k[c] == 0) continue;
        double springs = 0, mean = 0;  // k x, and k (D - P) / D
        for (std::size_t p = 0; p < m.parts[c].size(); ++p) {
            const double part = 1 - (e.slid[c][p] - from.slid[c][p]) / turned[c];
            springs += m.parts[c][p].stiffness * std::clamp(part, 0.0, 1.0);
            mean += m.parts[c][p].stiffness * part;
        }
        v.elastic[c] = springs / k[c];
        v.moment[c] = m.damping * (mean - springs) * turned[c] / dt;
        v.by_rotation[c] = m.damping * (e.slope[c] - springs) / dt;
    }
    v.by_rate = m.damping * k.cwiseProduct(v.elastic);
    v.moment += v.by_rate.cwiseProduct(rate);
    return v;
}

void add_joint_blocks(const ConfiguredJoint& joint, const RelativeRotation& r, const Vec3& slope, const Vec3& by_rate,
                      const Vec3& moment, Blocks& blocks) {
    const Mat3 S = r.by_spin();
    const auto about_axes = [&S](const Vec3& of_axes) -> Mat3 { return S.transpose() * of_axes.asDiagonal() * S; };
    Mat12 K = Mat12::Zero();
    const auto put = [&K](const Mat3& aa, const Mat3& ab, const Mat3& ba, const Mat3& bb) {
        K.block<3, 3>(3, 3) = aa, K.block<3, 3>(3, 9) = ab, K.block<3, 3>(9, 3) = ba, K.block<3, 3>(9, 9) = bb;
    };
    if (!by_rate.isZero(0)) {
        const Mat3 c = about_axes(by_rate);
        put(c, -c, -c, c);
        blocks.damping(joint.node, joint.end, K);
    }
    const Mat3 k = about_axes(slope);
    if (moment.isZero(0)) put(k, -k, -k, k);
    else {
        const auto& [P, M] = moment_curvature(r, moment);
        if (blocks.yielded != Yielded::at_rotation) {  // modes take all of it
            put(k + P + M, -k - P, -k - P - M, k + P);
        } else {
            const Mat3 p = 0.5 * (P + P.transpose());  // M is skew
            const Mat3 ab = -k - p + 0.5 * M;
            put(k + p, ab, ab.transpose(), k + p);
        }
    }
    blocks.stiffness(joint.node, joint.end, K);
}

int capacity_reached(const JointProperties& is, const JointState& j) {
    int over = -1;
    for (int k = 0; k < 3; ++k)
        if (std::abs(j.rotation[k]) >= is.axis[k].capacity) over = k;
    if (j.tension >= is.tension) over = 3;
    if (j.shear >= is.shear) over = 4;
    return over;
}

void add_step(JointRecord& r, const JointProperties& is, const JointState& j) {
    double about[3] = {0, 0, 0};
    for (int k = 0; k < 3; ++k) {
        if (!is.axis[k].is_spring()) continue;
        about[k] = j.rotation[k];
        keep_largest(r.axis[k].largest, j.rotation[k]);
        keep_largest(r.axis[k].moment, j.moment[k]);
    }
    keep_largest(r.bent, std::hypot(about[0], about[1]));
    if (!(j.tension <= 0)) keep_largest(r.tension, j.tension);
    keep_largest(r.shear, j.shear);
}

}  // namespace hinge

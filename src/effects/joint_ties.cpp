#include "effects/joint_ties.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "core/errors.h"
#include "effects/declared.h"
#include "model/member_ends.h"

namespace hinge {

JointTies::JointTies(Workspace& w, const std::vector<ConfiguredJoint>& joints) : w_(w) {
    const Model& model = w_.structure.model();
    for (const MemberOffset& o : model.declared<MemberOffset>(member_offsets))
        for (const DeclaredLoad& load : declared_loads(model))
            if (load.motion && w_.kind.dynamic && load.node == model.members()[o.member].node[o.end])
                throw InputError("model:member, offset: " + w_.structure.node_name(load.node) +
                                 " is moved by model:move; that does not go together yet: let the member end at "
                                 "the node that is moved");
    for (const bool between : {true, false})  // an end may follow a node that follows another one
        for (std::size_t i = 0; i < joints.size(); ++i) {
            const ConfiguredJoint& m = joints[i];
            if (m.is_between_nodes() != between) continue;
            ties_.push_back({m.node, m.end, int(i), between,
                             between ? Vec3(Vec3::Zero()) : offset_of(model, m.member, m.side),
                             between ? "model:joint" : "model:member, ends"});
        }
    for (const MemberOffset& o : model.declared<MemberOffset>(member_offsets)) {
        const int end = w_.structure.end_node(o.member, o.end);
        if (std::none_of(joints.begin(), joints.end(), [&](const ConfiguredJoint& m) { return m.end == end; }))
            ties_.push_back({model.members()[o.member].node[o.end], end, -1, false, o.by, "model:member, offset"});
    }
}

bool JointTies::is_whole(const JointTie& t) const {
    return t.is_rigid() ? !has_lost_all(t.node) && !w_.state.gone[t.end]
                        : !w_.state.data.find<JointStates>(joints_effect)->list[std::size_t(t.joint)].broken;
}
Vec3 JointTies::arm_of(const JointTie& t, const Pose& at) const {
    return t.arm.isZero(0) || !w_.structure.large() ? t.arm : Vec3(at.rotation[t.node] * t.arm);
}

/// u' = u + w x arm of the member's own node, and w' = w where it has no joint. A node that follows another one
/// passes the end on to that one.
void JointTies::add_constraints(const Pose& at, std::vector<LinearConstraint>& list_of_all) const {
    follows_.resize(6 * w_.structure.position().size(), -1);
    const auto place = [this](const DegreeOfFreedom& of) -> int& { return follows_[6 * of.node + of.component]; };
    const std::size_t others = list_of_all.size();
    for (std::size_t i = 0; i < others; ++i) place(list_of_all[i].dependent) = int(i);
    list_of_all.reserve(others + 6 * ties_.size());
    for (const JointTie& t : ties_) {
        if (!is_whole(t)) continue;
        const Vec3 arm = arm_of(t, at);
        for (int c = 0; c < (t.is_rigid() ? 6 : 3); ++c) {
            LinearConstraint tie{t.call, {t.end, c}, {}};
            tie.terms.reserve(4);
            const auto add = [&](int component, double factor) {
                const int found = place({t.node, component});
                if (found < 0) return tie.terms.push_back({{t.node, component}, factor});
                for (const LinearConstraint::Term& term : list_of_all[std::size_t(found)].terms)
                    tie.terms.push_back({term.of, factor * term.factor});
            };
            add(c, 1);
            for (int k = 0; c < 3 && k < 3; ++k)
                if (const double lever = Vec3::Unit(k).cross(arm)[c]; lever != 0) add(3 + k, lever);
            if (t.between_nodes) place(tie.dependent) = int(list_of_all.size());
            list_of_all.push_back(std::move(tie));
        }
    }
    for (const LinearConstraint& c : list_of_all) place(c.dependent) = -1;
}
void JointTies::place(Configuration& to) const {
    for_each_whole([&](const JointTie& t) {
        to.displacement[t.end] = to.displacement[t.node];
        if (t.arm.isZero(0)) return;
        to.displacement[t.end] += w_.structure.large() ? Vec3(to.rotation[t.node] * t.arm - t.arm)
                                                       : Vec3(to.small_rotation[t.node].cross(t.arm));
    });
}
void JointTies::set_velocities(Configuration& of) const {
    for_each_whole([&](const JointTie& t) {
        const Vec6& v = of.velocity[t.node];
        of.velocity[t.end].head<3>() = v.head<3>();
        if (!t.arm.isZero(0)) of.velocity[t.end].head<3>() += Vec3(v.tail<3>()).cross(arm_of(t, of));
        if (t.is_rigid()) of.velocity[t.end].tail<3>() = v.tail<3>();
    });
}
void JointTies::set_accelerations(Configuration& of) const {
    for_each_whole([&](const JointTie& t) {
        const Vec6& a = of.acceleration[t.node];
        of.acceleration[t.end].head<3>() = a.head<3>();
        if (t.is_rigid()) of.acceleration[t.end].tail<3>() = a.tail<3>();
        if (t.arm.isZero(0)) return;
        const Vec3 r = arm_of(t, of), w = of.velocity[t.node].tail<3>();
        of.acceleration[t.end].head<3>() += Vec3(a.tail<3>()).cross(r);
        if (w_.structure.large()) of.acceleration[t.end].head<3>() += w.cross(w.cross(r));
    });
}
/// The moment arm x f of an end on its node changes as the arm rotates.
void JointTies::add_curvature(const Pose& at, const std::vector<Vec6>& unbalanced, Blocks& blocks) const {
    if (!w_.structure.large()) return;
    for (const JointTie& t : ties_) {
        if (t.arm.isZero(0) || !is_whole(t)) continue;
        Mat6 K = Mat6::Zero();
        K.block<3, 3>(3, 3) = skew(Vec3(unbalanced[t.end].head<3>())) * skew(arm_of(t, at));
        blocks.stiffness(t.node, K);
    }
}

bool JointTies::carries_node(const ConfiguredJoint& joint, std::size_t i) const {
    const int node = joint.node;
    if (!w_.structure.hangs_on_joints(node) || joint.is_between_nodes()) return false;
    for (const bool rigid : {true, false})  // an end without a joint holds the node
        for (const JointTie& t : ties_)
            if (t.is_rigid() == rigid && t.node == node && !t.between_nodes && is_whole(t)) return t.joint == int(i);
    return false;
}
void JointTies::leave_node(int node) {
    if (!w_.structure.hangs_on_joints(node) || w_.state.gone[node]) return;
    for (const JointTie& t : ties_)
        if ((t.node == node || t.end == node) && is_whole(t)) return;
    const bool heavy = !w_.state.offset_mass.empty() && w_.state.offset_mass[node].mass > 0;
    if (heavy && w_.state.offset_mass[node].inertia.trace() > 0) return;
    w_.state.held[node] |= heavy ? 56 : 63;
    if (!heavy) w_.state.gone[node] = 1;
    for (int c = heavy ? 3 : 0; c < 6; ++c)
        for (double* of : {&w_.state.velocity[node][c], &w_.state.acceleration[node][c], &w_.trial.velocity[node][c],
                           &w_.trial.acceleration[node][c]})
            *of = 0;
    w_.supported.push_back(node);
}

void JointTies::refuse_moments(const std::vector<ConfiguredJoint>& joints) const {
    for (const DeclaredLoad& load : declared_loads(w_.structure.model())) {
        const int node = load.node;
        if (load.motion || node < 0 || load.moment.isZero(0) || !w_.structure.hangs_on_joints(node)) continue;
        Mat3 held = Mat3::Zero();
        for (int c : {0, 1, 2})
            if (w_.structure.fixed()[node] >> (3 + c) & 1) held(c, c) = 1;
        for (const JointTie& t : ties_)
            if (t.is_rigid() && t.node == node) held.setIdentity();
        for (std::size_t i = 0; i < joints.size(); ++i)
            for (int k = 0; k < 3; ++k)
                if ((joints[i].node == node || joints[i].end == node) && joints[i].stiffness[k] > 0)
                    held += joints[i].axes.col(k) * joints[i].axes.col(k).transpose();
        const Vec3 M = load.moment.normalized();
        const Eigen::SelfAdjointEigenSolver<Mat3> directions(held);
        for (int i = 0; i < 3; ++i)
            if (directions.eigenvalues()[i] < 1e-6 && std::abs(M.dot(directions.eigenvectors().col(i))) > 1e-6)
                throw InputError(load.what + " has a moment, and the ends of all members at " +
                                 w_.structure.node_name(node) +
                                 " are released about its axis, so that nothing resists it; leave the release out "
                                 "at one of them, or take the moment away");
    }
}

}  // namespace hinge

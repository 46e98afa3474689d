// A declared joint in the structure of a run: its nodes, springs and sliders, and their moments.
#pragma once

#include "algebra/node_blocks.h"
#include "effects/joint_parts.h"
#include "effects/relative_rotation.h"
#include "effects/workspace.h"
#include "state/joint_records.h"

namespace hinge {

/// A declared joint in this structure.
struct ConfiguredJoint {
    int member, side;
    int node, end;   ///< the script's node, and the member's own
    Vec3 stiffness;  ///< of the elastic part about each axis, N m/rad
    Vec3 own;        ///< of the member about each axis: 4 EI / L and G J / L, N m/rad
    std::vector<JointPart> parts[3];
    Mat3 axes;  ///< columns x y z of the section
    bool is_between_nodes() const { return member < 0; }
    Vec3 damped;         ///< `stiffness` of the axes that are damped, else 0: a rigid one has no rate of its own
    double wave = 0;     ///< s, in which an axial wave runs through the member
    double damping = 0;  ///< s: beta of model:damping
};
std::vector<ConfiguredJoint> configured_joints(const Workspace& w);

/// Moments of the springs at a rotation, and where the sliders are then.
struct JointMoments {
    Vec3 moment = Vec3::Zero(), slope = Vec3::Zero();
    double stored = 0, dissipated = 0;
    double work[3] = {0, 0, 0};  ///< J: `dissipated` by axis
    std::vector<double> slid[3];
};
/// `from`: where the step begins.
JointMoments evaluate(const ConfiguredJoint& joint, const Vec3& rotation, const JointState& from);
/// Of each axis, N m/rad, as Blocks asks for those that have yielded.
Vec3 slope_of(const ConfiguredJoint& joint, const Vec3& rotation, const JointState& from, const JointMoments& e,
              Yielded as);

/// Moment of damping about each axis, N m, and its derivatives by the rate and by the rotation. `elastic`: part of
/// the rate that the springs have.
struct ViscousMoments {
    Vec3 moment = Vec3::Zero(), by_rate = Vec3::Zero(), by_rotation = Vec3::Zero(), elastic = Vec3::Ones();
};
/// `rate`: of the rotation, rad/s; `dt`: length of the step, s. `begins`: where a step begins, the joint slips on as in
/// the step before.
ViscousMoments viscous_moments(const ConfiguredJoint& joint, const JointState& from, const Vec3& rotation,
                               const Vec3& rate, double dt, const JointMoments& e, bool begins);

/// Adds the stiffness and the damping between its two nodes, N m/rad and N m s/rad about each axis. `moment`: which
/// rotates with the node, N m; zero where the geometric stiffness is left out.
void add_joint_blocks(const ConfiguredJoint& joint, const RelativeRotation& r, const Vec3& slope, const Vec3& by_rate,
                      const Vec3& moment, Blocks& blocks);
/// The capacity that a joint has reached, as JointState::over.
int capacity_reached(const JointProperties& is, const JointState& j);

/// Adds the end of a step to what the joint has gone through.
void add_step(JointRecord& record, const JointProperties& is, const JointState& j);

}  // namespace hinge

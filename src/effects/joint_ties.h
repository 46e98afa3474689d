// Ends of members and nodes at joints that follow a node of the script, as constraints.
#pragma once

#include <algorithm>

#include "effects/configured_joint.h"
#include "model/linear_constraint.h"

namespace hinge {

/// A node that follows one of the script's: a member's own end, at an offset or not, or a node at a joint.
struct JointTie {
    int node, end;
    int joint;  ///< its place in the list of joints; -1: none, the end rotates with the node
    bool between_nodes;
    Vec3 arm;  ///< from the node to the end as declared, m
    const char* call;
    bool is_rigid() const { return joint < 0; }
};

class JointTies {
public:
    /// Those of joints, of joints between nodes first; then of ends at an offset without a joint.
    JointTies(Workspace& w, const std::vector<ConfiguredJoint>& joints);

    auto begin() const { return ties_.begin(); }
    auto end() const { return ties_.end(); }
    bool is_whole(const JointTie& t) const;
    template <class F>
    void for_each_whole(F f) const {
        for (const JointTie& t : ties_)
            if (is_whole(t)) f(t);
    }
    bool has_lost_all(int node) const { return w_.state.gone[node] && !w_.structure.is_alone(node); }

    // as Constrainer (constrainer.h)
    void add_constraints(const Pose& at, std::vector<LinearConstraint>& list_of_all) const;
    bool have_arms() const {
        return std::any_of(begin(), end(), [](const JointTie& t) { return !t.arm.isZero(0); });
    }
    void place(Configuration& to) const;
    void set_velocities(Configuration& of) const;
    void set_accelerations(Configuration& of) const;
    void add_curvature(const Pose& at, const std::vector<Vec6>& unbalanced, Blocks& blocks) const;

    /// True if a node that hangs on joints rotates with the end of this one, the first of those that are whole.
    bool carries_node(const ConfiguredJoint& joint, std::size_t i) const;
    /// A node that hung on joints and offset ends, and has lost the last of them, is gone. One with a point mass flies
    /// on; where that has no rotary inertia, without a rotation.
    void leave_node(int node);
    /// Refuses a moment on a node that no member resists, where the ends of all of them are released about its axis.
    void refuse_moments(const std::vector<ConfiguredJoint>& joints) const;

private:
    Vec3 arm_of(const JointTie& t, const Pose& at) const;

    Workspace& w_;
    std::vector<JointTie> ties_;
    mutable std::vector<int> follows_;  ///< of each degree of freedom: its place in a list of constraints, -1
};

}  // namespace hinge

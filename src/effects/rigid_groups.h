// Groups of nodes that move as one rigid body: in space (rigid links) or in one plane (diaphragms).
//
// With P the translations that are tied (all, or those in the plane), w the part of the rotation that turns the group
// (all of it, or about the normal alone) and r = P (x - x_c) from the group's reference point c,
//
//   P u = P u_c + (exp w - 1) r,   P v = P v_c + w x r,   P a = P a_c + dw/dt x r + w x (w x r)
//
// The point is the centre of mass, which is where the nodes' own motions by the integrator have their mean: linear
// momentum stays exact while the group rotates. Where a support holds the first node, and in statics, it is that node.
#pragma once

#include "effects/constrainer.h"
#include "effects/effect.h"
#include "effects/roles.h"

namespace hinge {

struct RigidGroup {
    struct Follower {
        int node;
        std::uint8_t tied;      ///< six bits: its components that follow the first node
        std::uint8_t held = 0;  ///< those of them that supports hold at both: they need no constraint
    };
    int first;  ///< the node that the others follow
    std::vector<Follower> followers;
    int normal = -1;  ///< 0 to 2: rigid in the plane across x, y or z; -1: in space
};

class RigidGroups : public Effect, public Constrainer, public BreakListener {
public:
    /// `call`: the script's, for messages.
    RigidGroups(const char* name, const char* call, std::vector<RigidGroup> groups, Workspace& w, Host& host);

    void add_constraints(const Pose& at, std::vector<LinearConstraint>& list) const override;
    bool factors_vary() const override { return true; }
    void place(const Pose& from, const std::vector<Vec3>& rotation_step, Configuration& to) const override;
    void set_velocities(Configuration& of) const override;
    void set_accelerations(Configuration& of) const override;
    void add_curvature(const Pose& at, const std::vector<Vec6>& unbalanced, Blocks& blocks) const override;

    void broke(const Break& b) override;
    bool restored(std::span<const State* const> states) override;
    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override;

private:
    /// A node of a group, with its part of the weight of the reference point: 0 to 1.
    struct Weighed {
        int node;
        double part;
        std::uint8_t tied, held;
    };
    struct Body {
        RigidGroup group;
        std::vector<Weighed> nodes;  ///< the first node in front
        bool about_first;            ///< the first node is the reference point
        Vec3 in_plane(Vec3 v) const {
            if (group.normal >= 0) v[group.normal] = 0;
            return v;
        }
        /// Whether the reference point places this component of a node's displacement.
        bool places(const Weighed& n, int c) const { return c != group.normal && !(n.held >> c & 1); }
        Vec3 turning(const Vec3& w) const {
            return group.normal < 0 ? w : Vec3(w[group.normal] * Vec3::Unit(group.normal));
        }
    };
    void find_bodies();
    RigidGroup with_held(RigidGroup group) const;
    std::uint8_t held_at_both(const RigidGroup& group, const RigidGroup::Follower& f) const;
    RigidGroup without_gone(RigidGroup group) const;
    Body weigh(RigidGroup group, const std::vector<double>& mass) const;
    void refuse(const RigidGroup& group) const;
    Vec3 place_of(int node, const Pose& at) const;
    template <class Of>
    Vec3 mean(const Body& body, Of of) const;
    template <class Set>
    void for_arms(const Body& body, const Pose& at, Set set) const;

    const char* call_;
    const std::vector<RigidGroup> declared_;
    std::vector<Body> bodies_;
};

}  // namespace hinge

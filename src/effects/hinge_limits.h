// Fracture by the rotation of a hinge or by the elongation of a member: limits that do not follow the number of
// elements.
#pragma once

#include <optional>
#include <vector>

#include "effects/fracture_rule.h"
#include "effects/workspace.h"
#include "state/hinge_records.h"

namespace hinge {

/// Plastic rotations and elongations at the end of the trial step, against the limits of fracture rules.
///
/// Where two elements meet in a section, both may have a part in the rotation of its one hinge, in any proportion: the
/// moment is the same on both sides. So the rotation is the sum of both. That holds inside a member, and at a node that
/// joins two members of equal strength and rule and nothing else.
class HingeLimits {
public:
    /// `rule_of_member`: index of each member's rule, -1: none.
    HingeLimits(const Workspace& w, const std::vector<FractureRule>& rules, const std::vector<int>& rule_of_member)
        : w_(w), rules_(rules), rule_of_member_(rule_of_member) {}

    /// Rotation of the hinge at end 1 or 2 of a whole element about its x (plane 0) or y, rad; positive like curvature.
    double rotation(int element, int end, int plane) const;

    /// Adds what breaks since a limit of the element's rule is reached at one of its sections or in its member: this
    /// element, or another one with a larger part in the hinge or in the elongation. `all`: its sections that do not
    /// flow in the step as well.
    void add_reached(int element, std::vector<Break>& breaks, bool all) const;

private:
    struct End {
        int element, end;
    };
    const FractureRule* rule_of(int element) const {
        const int rule = rule_of_member_[w_.structure.elements()[element].member];
        return rule < 0 ? nullptr : &rules_[rule];
    }
    const PlasticIncrement* flow_of(int element) const;
    bool flows(int element, int end) const;
    HingeMotion own(int element, int end) const;
    std::optional<End> other_side(int element, int end) const;
    Vec3 in_space(const HingeMotion& motion, const End& of) const;
    struct Rotation {
        double sum[2] = {0, 0};           ///< rad
        bool shared[2] = {false, false};  ///< the other side has a part in it
    };
    Rotation rotation(const End& of) const;
    std::optional<Break> rotated(const End& at) const;
    std::optional<Break> elongated(int element) const;
    int weaker_end(int element) const;

    const Workspace& w_;
    const std::vector<FractureRule>& rules_;
    const std::vector<int>& rule_of_member_;
};

}  // namespace hinge

// Ends of members beside their nodes: rigid ends and insertion points.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "model/model.h"

namespace hinge {

inline constexpr const char* member_offsets = "offsets";

/// The end (0, 1) of a member stands off its node, rigidly and without mass. Declared with the member: rising by member
/// and end. Such an end has a node of its own (MemberData::has_joint).
struct MemberOffset {
    int member, end;
    Vec3 by;  ///< m, from the node to the end, in space, as declared

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.member, s.end, s.by);
    }
};

/// Zero where an end is at its node.
inline Vec3 offset_of(const Model& model, int member, int end) {
    const auto& list = model.declared<MemberOffset>(member_offsets);
    const auto at = std::lower_bound(
        list.begin(), list.end(), std::pair(member, end),
        [](const MemberOffset& o, const std::pair<int, int>& sought) { return std::pair(o.member, o.end) < sought; });
    return at != list.end() && at->member == member && at->end == end ? at->by : Vec3(Vec3::Zero());
}

/// Where an end of a member is declared, m.
inline Vec3 end_position(const Model& model, int member, int end) {
    return model.nodes()[model.members()[member].node[end]].position + offset_of(model, member, end);
}

/// Whether a member ends at a node, by a joint or at an offset too.
inline bool has_member_at(const Model& model, int node) {
    return std::any_of(model.members().begin(), model.members().end(),
                       [&](const MemberData& m) { return m.node[0] == node || m.node[1] == node; });
}

}  // namespace hinge

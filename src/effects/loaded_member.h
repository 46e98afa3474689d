// A load on the elements of a member: its nodal forces with exact fixed-end moments, and its part of the resultants of
// their sections.
#pragma once

#include "algebra/node_blocks.h"
#include "effects/clamped_member.h"
#include "effects/history_jump.h"
#include "effects/member_load_portions.h"
#include "effects/workspace.h"

namespace hinge {

/// Forces and moments of an element on its two nodes, in the load's axes, N and N m.
struct LoadShare {
    Vec3 force[2] = {Vec3::Zero(), Vec3::Zero()}, moment[2] = {Vec3::Zero(), Vec3::Zero()};
};
/// A load on the elements between two ends: the member's, or where its pairs of elements are beam-columns those of
/// each pair.
struct LoadedMember {
    MemberEnds ends, member;
    int declared;             ///< its place in the list of the model
    std::vector<int> merged;  ///< places of further loads that act as one with it (merge)
    bool local;
    History history;
    std::vector<LoadShare> shares;  ///< of the member's elements
    /// The correction's moment at each end about x and about y is linear in the load's components across: of the
    /// forces, N m, and of the moments, N m, both in the load's axes.
    Vec3 of_force[2][2], of_moment[2][2];
    /// N/m at these ends, of loads without pieces; N and N m of a point load.
    Vec3 spread[2] = {Vec3::Zero(), Vec3::Zero()}, point = Vec3::Zero(), couple = Vec3::Zero();
    double at = -1;  ///< of the point load, 0 to 1 between them
    /// A load over a part of a pair of elements, as point loads between its ends, for what N does to them.
    std::vector<Portion> pieces = {};
    std::unique_ptr<PairForces> sums = {};  ///< of pieces without moments
    double factor = 1, kept_factor = 1;     ///< of its history, on the trial and on the state
    bool held = false, may_jump = false;
    bool on_node = false;  ///< it acts on a node of the elements (is_on_node)
    StepFactor over = {};  ///< where its history may jump within a step
    bool dropped = false;  ///< nothing of it acts any longer
    void drop();
    /// Takes in another load on the same elements, where both are spread, constant and given in space. False where not.
    bool merge(const LoadedMember& other);
    /// All are merged: sums up the pieces.
    void sum_up();
};
/// Changes by N of the moments at a pair's two ends, in its axes, and in the section between its elements.
struct CompressionMoments {
    bool counts = false;
    MemberEnds pair;
    MemberEnds::Chord chord = {};
    Vec3 m[2] = {Vec3::Zero(), Vec3::Zero()};
    double middle[2] = {0, 0};
    bool is_middle(int element, int end) const { return (element == pair.first) == (end == 1); }
};

/// A load of the script, `declared` in the list of the model, on the elements from `first` to `end`.
std::vector<LoadedMember> loaded_members(const Workspace& w, const MemberLoad& load, int declared, int first, int end);

/// The correction at an end, in the member's axes; `axes`: those.
Vec3 end_moment(const LoadedMember& l, int end, const Mat3& axes);
/// The corrections at the member's ends, in its axes; none where it is not whole.
void find_moments(const Workspace& w, const LoadedMember& l, double factor, const Pose& at, Vec3 m[2]);
/// Adds a load's part of the resultants of an element, with the corrections m at its member's ends.
void add_fixed_end(const Workspace& w, const LoadedMember& l, int element, double factor, const Pose& at,
                   const Vec3 m[2], const CompressionMoments& by_N, beam::FixedEnd& to);
/// `force`: p of all elements, of which N is taken.
CompressionMoments compression_moments(const Workspace& w, const LoadedMember& l, double factor, const Pose& at,
                                       const std::vector<Vec6>& force);
/// Subtracts from the stiffness what the forces of a load in the element's axes change by as these rotate.
void add_derivative(const Workspace& w, const LoadedMember& l, const Pose& at, double factor, Blocks& blocks);

/// Calls add(node, force and moment in space) with all that a load asks of the nodes at such a place.
template <class Add>
void act(const Workspace& w, const LoadedMember& l, const Pose& at, double factor, Add add) {
    const auto& elements = w.structure.elements();
    bool broken = false;
    for (std::size_t i = 0; i < l.shares.size(); ++i) {
        const int element = l.ends.first + int(i);
        if (w.state.broken[element]) {
            broken = true;
            continue;
        }
        const LoadShare& share = l.shares[i];
        const Mat3 to_space = l.local ? Mat3(axes_of(element_frame(w.structure, element, at))) : Mat3(Mat3::Identity());
        for (int end : {0, 1}) {
            Vec6 f;
            f << factor * (to_space * share.force[end]), factor * (to_space * share.moment[end]);
            add(elements[element].node[end], f);
        }
    }
    if (broken) return;
    const MemberEnds::Chord chord = l.ends.chord(w.structure, at);
    Vec3 m[2];
    for (int end : {0, 1}) m[end] = factor * (chord.axes * end_moment(l, end, chord.axes));
    l.ends.pass_on(w.structure, chord.span, m, add);
    const bool of_state = &at.displacement == &w.state.displacement;
    const CompressionMoments by_N = compression_moments(w, l, factor, at, of_state ? w.state.force : w.force);
    if (!by_N.counts) return;
    for (int end : {0, 1}) m[end] = by_N.chord.axes * by_N.m[end];
    by_N.pair.pass_on(w.structure, by_N.chord.span, m, add);
}

}  // namespace hinge

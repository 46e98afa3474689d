// Corrects nodal weights to weight along the members (weight = "members").
//
// Weights act at the nodes of the elements. Here is what they miss of an even load along the member: the correction at
// its two end nodes (clamped_member.h), and the part of the section forces that balances the load itself. Both are
// linear in gravity, so that they are kept as masses. A member is alike from both ends: the correction is two opposite
// moments, without shear forces. That the moments along it turn its ends by nothing gives them whatever its stiffness
// is, so they are across gravity and the chord, in all directions alike.
#pragma once

#include "core/lanes.h"
#include "core/thread_pool.h"
#include "effects/clamped_member.h"

namespace hinge {

class MemberWeights {
public:
    MemberWeights() = default;
    explicit MemberWeights(const Structure& structure);

    int count() const { return int(ends_.size()); }
    const MemberEnds& ends(int member) const { return ends_[member]; }

    /// Whether a member's plastic limit load between clamped ends is above its weight: f_y of eq 14 for w L^2/16, where
    /// it is at the start. One that must fall at once does so in steps whose energy error is small against the motion,
    /// but not against that of its first instants, in which its joints would spin by the correction.
    bool carries_itself(const Structure& structure, const Vec3& g, int member) const;
    /// These members have it.
    void choose(const Structure& structure, const std::vector<int>& members);
    bool has(int member) const { return member < int(chosen_.size()) && chosen_[member]; }
    const std::vector<int>& joints() const { return joints_; }  ///< their end nodes
    /// The moment on each of the joints, N m, in space.
    /// `force`: p of all elements, of which N is taken (PressedPair). `placed`: the members are where add_fixed_ends
    /// has been told last.
    void find_moments(const Structure& structure, const Vec3& g, const Pose& at, const std::vector<Vec6>& force,
                      bool placed, std::vector<Vec3>& moments) const;
    /// Of all elements. `anew`: what `all` has does not count.
    void add_fixed_ends(const Structure& structure, ThreadPool& pool, const Vec3& g, const Pose& at,
                        const std::vector<Vec6>& force, bool anew, std::vector<beam::FixedEnd>& all) const;
    beam::FixedEnd fixed_end(const Structure& structure, const Vec3& g, const Pose& at, const std::vector<Vec6>& force,
                             int element) const;
    void add_section_forces(const Structure& structure, const State& state, const Vec3& g, int element, double side,
                            SectionForces& forces) const;

private:
    struct Kind {
        double c = 0;             ///< moment at the first end about x by gravity along y, kg m
        std::vector<double> bow;  ///< moment that the nodes' weights miss between pinned ends, at each node, kg m
        /// Of its elements, in the places of FixedEnd: each is to be multiplied by the component of gravity that it
        /// follows, y y x x z z in the member's axes and none, kg m and kg.
        std::vector<beam::FixedEnd> by_gravity;
    };
    /// Eight chosen members; where there are fewer, the last one stands for the rest.
    struct Block {
        int count;
        int member[lane_count], node[2][lane_count], joint[2][lane_count];
        Lanes span[3];  ///< from the first to the second end at the start, m
        Lanes y[3];     ///< axis at the start
        Lanes c;        ///< kg m
        // what N changes (PressedPair)
        int first[lane_count], pairs[lane_count], most_pairs;  ///< elements; pairs of each, and the most of them
        Lanes flexible[2];                                     ///< l^2/EI in the two planes, l: one element, 1/N
        beam::PairShear<Lanes> shear[2];
        Lanes a_pair;   ///< rho A l^2 / 3, divided by the number of pairs, kg m
        Lanes of_pair;  ///< rho A l^2, kg m
    };
    /// The axes x, y, z of a block's members in space.
    struct Axes {
        Lanes axis[3][3];
        void to_members(const Vec3& v, Lanes (&components)[3]) const;
    };
    Lanes find_span(const Block& b, bool large, const Pose& at, Lanes (&span)[3]) const;
    /// As by MemberEnds::axes and to the same bits.
    void find_axes(const Structure& s, const Block& b, const Pose& at, Axes& axes) const;
    static Kind kind_of(const Structure& s, const MemberEnds& ends);
    /// N of the k-th pair of its members over what heat leaves of E, N; 0 where a member has none.
    static Lanes force_of_pairs(const Block& b, int k, const std::vector<Vec6>& force, const ElementHeats& heat);
    template <class Visit>
    bool visit_pressed(const Block& b, const std::vector<Vec6>& force, const ElementHeats& heat, Visit visit) const;
    /// A pair's part of moment_by_N by gravity of 1 m/s^2 across its member, from p of PressedPair, kg m.
    static Lanes end_by_N(const Block& b, int plane, const Lanes& p);
    /// middle_by_N of its members' k-th pairs. `across`: gravity across them, with the moment's sign, m/s^2.
    static void add_middle(const Block& b, int k, int plane, const Lanes& p, const Lanes& across,
                           std::vector<beam::FixedEnd>& all);
    /// moment_by_N of its members, in two planes, by gravity of 1 m/s^2 across each. False: they are all zero.
    bool find_by_N(const Block& b, const std::vector<Vec6>& force, const ElementHeats& heat, Lanes (&of)[2]) const;
    /// Changes of the fixed-end moments by N (PressedPair), in the member's axes: the moment at its first end, the
    /// opposite one at its second; zero where nothing. Mean over its pairs, between which the moments cancel. `local`:
    /// gravity in these axes.
    Vec3 moment_by_N(const Structure& s, const Vec3& local, const std::vector<Vec6>& force, const ElementHeats& heat,
                     int member) const;
    /// Moments by N in the middle of the pair of an element, in the member's axes.
    Vec3 middle_by_N(const Structure& s, const Vec3& local, const std::vector<Vec6>& force, const ElementHeats& heat,
                     int element) const;

    std::vector<Kind> kinds_;
    std::vector<int> kind_;           ///< of each member
    std::vector<MemberEnds> ends_;    ///< likewise
    std::vector<char> chosen_;        ///< likewise
    std::vector<Block> blocks_;       ///< of those that are chosen
    mutable std::vector<Axes> axes_;  ///< of the blocks where add_fixed_ends has been told last, where N has a part
    std::vector<int> others_;         ///< elements of the other members
    std::vector<int> joints_;
};

/// Weights of lumped masses. The lumps of a pair are those of its motion as a rigid body; as weights they would bend a
/// member at rest otherwise than statics does. So carried elements have half of their weight on each node, as in
/// statics, and a run goes on from there at rest. What flies has the weight of its lumps, and falls without bending.
class EvenWeights {
public:
    /// Finds the carried elements; nothing where masses are not lumped.
    void find(const Structure& structure, const State& state, const Vec3& g);
    /// Of each node, what its weight has beyond that of its lumps, kg; empty where masses are not lumped.
    const std::vector<double>& more() const { return more_; }

private:
    std::vector<double> more_;
};

/// Of each member, whether it is whole and its body is carried (carried_bodies). What nothing carries falls, and its
/// weight bends it no more than its inertia does.
std::vector<char> carried_members(const Structure& structure, const State& state, const MemberWeights& weights,
                                  const Vec3& g);

}  // namespace hinge

// A tie between two elements: four gap elements, node to node (fig 7), that rotate together.
#pragma once

#include <vector>

#include "contact/end.h"

namespace hinge::contact {

/// A gap element: a spring on the vector that joins its two ends.
struct Gap {
    Vec3 rest = Vec3::Zero();  ///< r0, m: from a to b at binding
    double stiffness = 0;      ///< k, N/m

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.rest, s.stiffness);
    }
};

/// Bond of two elements in contact.
///
///   U = min over rotations Q of  sum over the four gaps of k/2 |r - Q r0|^2
///   r = (x_b + R_b arm_b) - (x_a + R_a arm_a)
///   f = k (r - Q r0)  [N] resists at b, -f at a; a moment arises only from an arm.
///
/// Q is the common rotation of the four points since binding. As it minimises U, it drops out of dU/du: the forces
/// above are the exact derivative, they sum to zero, and so do their moments, sum r x f = -sum k r x Q r0 = 0 being the
/// very condition that defines Q. A tie that moves as one piece stores nothing. No direction is read from the line
/// between two nodes, which flips when they pass each other.
///
/// Why Q is not the mean rotation of the two nodes of each gap: a gap of length l then follows a node that spins, and
/// since four spinning nodes can follow any shift of one element past the other, nothing but the nodes' own resistance
/// to spinning holds the tie. Two free bars passed through each other at 95 % of their speed, and any plastic hinge
/// releases likewise.
struct Tie {
    int element[2] = {-1, -1};
    int rule = 0;                ///< index of the contact rule
    double since = 0;            ///< s
    End end[4];                  ///< A1, A2, B1, B2
    Gap gap[4];                  ///< A1B1, A1B2, A2B1, A2B2
    Vec3 normal = Vec3::Zero();  ///< direction from a to b when they met
    double at[2] = {0, 0};       ///< where they met, along a and along b

    Quat rotation = Quat::Identity();  ///< Q, as of the last forces
    double energy = 0;                 ///< J, as of the last forces
    double opening = 0;  ///< m, as of the last forces: how much further apart along the normal than at binding
    Vec3 normal_now = Vec3::Zero();  ///< Q times it, as of the last forces
    Vec3 force[4] = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                     Vec3::Zero()};                                 ///< N, at each end, as of the last forces
    double energy_before = 0, opening_before = 0, energy_peak = 0;  ///< as of the last release()
    bool falling = false;                                           ///< the energy fell before the last release()

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.element, s.rule, s.since, s.end, s.gap, s.normal, s.at, s.rotation, s.energy, s.opening, s.normal_now,
          s.force, s.energy_before, s.opening_before, s.energy_peak, s.falling);
    }
};

/// The two ends of a tie that a gap element joins.
constexpr int gap_a(int gap) { return gap / 2; }
constexpr int gap_b(int gap) { return 2 + gap % 2; }

/// Stiffness of a gap element, k = EA / max(|r0|, shortest). EA is the harmonic mean of the two members' (one bar made
/// half of each, so the softer member rules); shortest is a fraction of the mean length of the two elements.
double gap_stiffness(double ea_a, double ea_b, double length, double shortest);

/// Adds the resisting forces + dU/du of a tie to `force`, and stores energy, opening and normal in the tie.
void add_tie_forces(Tie& tie, const std::vector<Vec3>& position, const std::vector<Quat>& rotation,
                    std::vector<Vec6>& force);

/// Adds the exact, symmetric tangent of a tie as six blocks between two nodes each (the four gaps, and A1A2, B1B2,
/// whose elements couple them already). For the points p of the four ends, with L_g dp = dr_g and s_g = Q r0_g:
///   K = sum k L^T L - G^T S^-1 G,   G = sum k [s] L,   S = sum k ((r.s) 1 - (r s^T + s r^T) / 2)
/// The second term is the reduction by the rotation of Q. An arm R a carries K to its node by dp = dx - [R a] dtheta,
/// and adds the symmetric part of [F][R a], F being the force at the point.
void add_tie_stiffness(const Tie& tie, const std::vector<Vec3>& position, const std::vector<Quat>& rotation,
                       const AddStiffness& add);

}  // namespace hinge::contact

// What happens when an element breaks (paper, section 2.3, figs 4 and 5): its forces go to zero, it becomes a rigid
// stub on its other node, and the mass is rebuilt so that linear and angular momentum stay what they were.
#pragma once

#include "algebra/mass.h"

namespace hinge {

struct BreakReport {
    double elastic = 0;     ///< strain energy released, J
    double kinetic = 0;     ///< kinetic energy lost as the stub is made to move as one with that node, J
    int carrier = -1;       ///< that node
    bool orphaned = false;  ///< the node at the broken end has nothing left and leaves the solve
};

/// Breaks `element` at `end` (1 or 2) in `state`; velocities stay. `impulse` (of each node, six) gets what pass_on
/// needs.
BreakReport break_off(const Structure& structure, State& state, int element, int end, std::vector<Vec6>& impulse);

/// A stub's far end was not moving as its carrier bids. Of all motions in which it does, this takes the one nearest to
/// the motion of before, the nearest in kinetic energy: M v' = T^T M v, which is M (v' - v) = impulse with M as it is
/// after the breaks. It keeps both momenta, and as a projection it cannot gain energy. (When the carrier's velocity
/// alone was made to keep the momenta, debris with little inertia was flung about: 51 MJ out of nothing in one impact
/// of 112 MJ.) Books and returns the kinetic energy that takes, J; books what supports that move do beside it.
double pass_on(State& state, Mass& mass, std::vector<Vec6>& impulse);

/// Both, for one element.
BreakReport break_element(const Structure& structure, State& state, int element, int end);

/// Linear momentum (kg m/s) and angular momentum about the origin (kg m^2/s), and the mass (kg).
struct Momentum {
    double mass;
    Vec3 linear, angular;
};
Momentum momentum(const Structure& structure, const State& state);
double kinetic_energy(const Structure& structure, const State& state);
double kinetic_energy(const Structure& structure, const State& state, int element,
                      const Mat3& axes);  ///< of one whole element, its axes in columns
double kinetic_energy_of_offset_masses(const State& state);

/// The mass hung on a node, 6 x 6 in space (kg, kg m, kg m^2).
Mat6 offset_mass_in_space(const OffsetMass& hung, const Quat& rotation);

/// A state's nodes as a pose.
Pose pose_of(const State& state);

}  // namespace hinge

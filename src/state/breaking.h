// Breaks elements (paper, section 2.3, figs 4 and 5): the forces of one go to zero, it becomes a rigid offset mass on
// its other node, and the mass is rebuilt so that linear and angular momentum stay what they were.
#pragma once

#include "state/node_mass.h"
#include "state/element_assembly.h"

namespace hinge {

struct BreakReport {
    double elastic = 0;     ///< strain energy released, J
    double kinetic = 0;     ///< kinetic energy lost as that mass is made to move as one with the node, J
    int carrier = -1;       ///< the node at the end that holds
    bool orphaned = false;  ///< the node at the broken end has nothing left and leaves the solve
};

/// Breaks `element` at `end` (1 or 2) in `state`; velocities stay. `impulse` (of each node, six) receives the input of
/// pass_on (algebra/mass_matrix.h). The other element of a pair whose bending follows N keeps its forces as far as the
/// energy allows: a break releases no more than was stored.
BreakReport break_off(const Structure& structure, State& state, int element, int end, std::vector<Vec6>& impulse);

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

}  // namespace hinge

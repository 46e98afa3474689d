// Lumped masses of elements whose partner has broken off, in explicit steps.
//
// The lumps of a pair have its mass, centre and moment of inertia together; those of one of its elements alone, 1/3 and
// 2/3, have their centre a sixth of its length too near to the pair's middle. A pair that comes apart in the middle
// would then fly off with a third less momentum in each half. Therefore both elements of a pair that breaks get their
// masses anew: a quarter at the outer node, three quarters at a third of the length from the inner node, rigidly on
// that node (Radau's points). These have the mass, the centre and the moment of inertia of a straight bar. The one that
// broke is thus a rigid bar on the node that carries it; the other is called a lone element.
#pragma once

#include "state/node_mass.h"

namespace hinge {

/// Masses of an element that breaks, in the frame of space.
struct LooseElement {
    Mat6 mass[2];         ///< at its nodes, each about its own; kg, kg m, kg m^2
    Vec6 velocity[2];     ///< m/s and rad/s that these masses have, of which both momenta are those of before
    double kinetic;       ///< J that the masses of the elements that got new ones had before
    double left_kinetic;  ///< J that those of them that do not break have at the nodes' velocities
};
/// Takes a whole element's lumped mass off the nodes of `state` before it breaks. If it has a whole partner, that
/// becomes a lone element; `impulse` (of each node, six) receives what this asks of its nodes.
///
/// The new masses of the pair move on with velocities w: the rigid motion that has its momenta, and what remains of the
/// velocities as M' w = s M v, the largest s up to 1 with which no kinetic energy is gained. Elements that share nodes
/// with them then have to follow, which only costs energy.
LooseElement loosen(const Structure& structure, State& state, int element, std::vector<Vec6>& impulse);

/// The part of a lone element's mass that its inner node carries, 6 x 6 about that node, at `arm` from it.
Mat6 lone_mass(const Element& e, const Vec3& arm);

/// Makes the masses of elements whose partners have broken those of lone elements where masses are lumped, and takes
/// the offset masses of lone elements away where they are not: a run goes on from one with other masses.
State with_lone_elements(const Structure& structure, State state);

}  // namespace hinge

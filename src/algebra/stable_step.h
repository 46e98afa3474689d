// Longest stable time step of central differences.
#pragma once

#include <span>

#include "algebra/node_blocks.h"
#include "state/state.h"

namespace hinge {

/// Stable step 2 / omega, s, for the highest frequency of any single element with its lumped mass, which no structure
/// of them exceeds (Irons 1970); `element` is the one that has it. As the script declared it, without load: contact and
/// initial stress come on top. Damping of the elements (empty: none) takes part with the velocity that a step predicts,
/// v + dt a, and shortens it to 2 / (c + sqrt(c^2 + omega^2)), c = of_mass + of_stiffness omega^2: beyond it the
/// fastest motion changes its sign with every step and grows.
struct StableStep {
    double dt;
    int element;
};
/// `breaks`: also that of elements whose partner has broken off (state/lone_elements.h).
StableStep stable_step(const Structure& structure, std::span<const ElementDamping> damping = {}, bool breaks = false);

/// Stable step where effects join nodes by stiffness and damping in addition to the elements: 2 / (c + sqrt(c^2 +
/// omega^2)), omega^2 and c the sums of the elements' highest at the nodes that are connected so and of a bound for
/// what the effects add to them there (that of the matrix of the blocks' norms, by Collatz and Wielandt: no less than
/// the highest, and the highest itself for a chain of springs). Masses are lumped, rigid offset masses with them.
/// `node`: one of those that ask for it.
struct JoinedStep {
    double dt;
    int node;
};
JoinedStep stable_step_of_joined(const Structure& structure, const State& state,
                                 std::span<const ElementDamping> damping, const Blocks& stiffness,
                                 const Blocks& of_damping);
/// The square of the highest frequency that the nodes' masses have on those blocks alone, or a bound above it, 1/s^2;
/// rotations held.
double fastest_of_joined(const Structure& structure, const State& state, const Blocks& stiffness);

}  // namespace hinge

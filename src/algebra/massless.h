// Degrees of freedom on which no mass acts: those of nodes between members without density, and rotations of nodes with
// point masses that have no rotary inertia.
//
// In M a = F - R they have no acceleration. In Newmark's method their rows of M + beta dt^2 K are those of the
// stiffness alone, so that forces at them are in balance at the end of each step: static condensation. What the method
// makes of their velocity, 2 du/dt - v, swings from step to step and counts for nothing. It is replaced by differences
// backwards of second order (settle_massless).
#pragma once

#include <vector>

#include "algebra/node_blocks.h"
#include "algebra/reduction.h"
#include "core/thread_pool.h"
#include "state/configuration.h"

namespace hinge {

struct MasslessNode {
    int node;
    std::uint8_t translations;  ///< three bits
    Mat3 rotations;             ///< projects a rotation on its massless part, in space; zero: none
    bool has_rotations() const { return !rotations.isZero(0); }
};

/// True if a structure can have such degrees of freedom.
bool may_be_massless(const Structure& structure);

/// Those of the nodes that can move, rising. `reduction`: null where no degree of freedom depends on others; what
/// depends on others is not listed, and that on which others depend has their mass.
std::vector<MasslessNode> massless_nodes(const Structure& structure, const State& state, const Reduction* reduction);

/// The state with what is massless held, and inertia where an axis without it is none of space: for solutions with M.
State with_massless_held(const State& state, const std::vector<MasslessNode>& list);

/// Leaves of a vector of all nodes what is massless in it, or all but that.
void keep_massless(const std::vector<MasslessNode>& list, std::vector<Vec6>& of);
void take_out_massless(const std::vector<MasslessNode>& list, std::vector<Vec6>& of);

/// Velocity and acceleration at the end of a step from the displacements: v' = m + (m - m_0) / 2 and
/// a' = (m - m_0) / dt, with m = du / dt over this step and m_0 = v - dt a / 2 over the one before.
void settle_massless(const std::vector<MasslessNode>& list, const State& state, double dt,
                     const std::vector<Vec3>& rotation_step, Configuration& trial);

/// Sets the velocities with which the forces on what is massless stay in balance as the other nodes move at theirs:
/// K v = 0 there. `blocks`: stiffness of effects. They stay as they are where the stiffness alone does not hold them.
void condense_velocities(const std::vector<MasslessNode>& list, const Structure& structure, const Reduction* reduction,
                         Blocks blocks, ThreadPool& pool, State& state);

}  // namespace hinge

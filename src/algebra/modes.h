// Natural frequencies, K x = w^2 M x, of a structure as declared, without load; and the rigid motions that its supports
// allow.
#pragma once

#include <string>
#include <vector>

#include "algebra/node_blocks.h"
#include "model/linear_constraint.h"
#include "model/structure.h"

namespace hinge {

/// A rigid motion of a body that strains nothing and moves no support: rotation w (rad) about `centre` (m) and the
/// shift v (m) of that point.
struct RigidMotion {
    Vec3 centre, v, w;
};

/// All independent rigid motions of the body of these nodes: six if it is free, none if its supports hold it. Members
/// join their nodes rigidly, so a body has no other motion without resistance.
std::vector<RigidMotion> free_motions(const Structure& structure, const std::vector<int>& nodes);

/// Text that names the motion of a body that its supports (nodes) do not hold: along or about an axis of space if
/// possible, else about its own line: "rotate about z through that node", that is the first of the supports.
std::string ways_to_move(const Structure& structure, const std::vector<int>& supports,
                         const std::vector<RigidMotion>& motions);

/// The lowest `count` circular frequencies (rad/s, rising) of the body that these nodes make up, after the zero ones of
/// its `rigid` free motions. Fewer where it has fewer degrees of freedom. Every element must
/// have mass.
///
/// By Spectra's Lanczos method, implicitly restarted, with K + a M in factors: a is 0 for a supported body, else 1e-9
/// of the ratio of the sums of their diagonals. Lanczos' method starts from one vector and may miss copies of a
/// repeated frequency, as symmetric frames have them. So the pivots of K - w^2 M count how many there must be below the
/// last one (a millionth of its square aside), and while one is missing the method starts again without the modes that
/// it has found. Throws std::runtime_error if it does not converge. `added`: stiffness of effects, and rigid offset
/// masses on nodes (6x6 in space, in the place of K); those at other nodes count for nothing. Where it adds stiffness,
/// `rigid` is the most that there may be: their strain energy decides (rigid_modes.h).
struct AddedToModes {
    Blocks stiffness = Blocks();
    std::vector<Blocks::Node> mass = {};
    std::vector<LinearConstraint> constraints = {};  ///< those of other nodes count for nothing
    std::vector<ElementDamping> damping = {};        ///< of each element; empty: none
    Blocks more_damping = Blocks();                  ///< of effects, in the place of stiffness, N s/m
};
std::vector<double> natural_frequencies(const Structure& structure, const std::vector<int>& nodes, int rigid, int count,
                                        const AddedToModes& added = {});

/// The same with the part of critical damping that each mode x has, x . C x / (2 w x . M x).
struct DampedMode {
    double frequency, ratio;  ///< rad/s
};
std::vector<DampedMode> damped_modes(const Structure& structure, const std::vector<int>& nodes, int rigid, int count,
                                     const AddedToModes& added);

}  // namespace hinge

// Deformation of an element beyond the range of corotation.h: its ends have twisted relative to each other by more than
// a third of a turn, up to any number of turns, or have folded towards each other.
//
// The frame of corotation.h takes its y axis from the mean of the nodes' y axes. At half a turn of twist that mean
// vanishes. Here each node's rotation in the frame is a twist about the chord followed by a swing, the shortest
// rotation that brings the chord's direction to the node's z axis. The frame's y axis lies at the mean of the two
// twists, the section half way along the element. d[5] is the difference of the twists, counted over any number of
// turns. d[0] to d[3] are the swings' rotation vectors, so a wound element bends like one whose sections all lie as its
// middle one does. Where Ix and Iy differ, more elements a member follow the turning of the sections.
//
// Between the two measures lies a range, 120 to 150 degrees of twist, in which the deformation passes smoothly from one
// to the other. So the strain energy is one twice differentiable function of the nodes' positions alone: no jump, and
// no memory but the number of turns. Forces and tangent are its derivatives, found by the rules of differentiation
// (dual numbers): few elements wind up, and for them that is fast enough.
#pragma once

#include "beam/corotation.h"
#include "core/types.h"

namespace hinge::beam {

/// Twist of the two ends relative to each other (rad) above which the number of turns must be stored: a third of a
/// turn.
inline constexpr double remembered_twist = 2.0943951023931953;

/// An element is not wound while the sum of the squares of its two end rotations in the frame of corotation.h (rad^2)
/// is below this: neither node has then rotated by 60 degrees in the frame.
inline constexpr double far_rotation = 1.0966227112321508;

/// Position of an element that may be wound, and the deformation computed by `wind`.
struct Winding {
    Triple<double> chord;             ///< from node 1 to node 2 as it is now, m
    Quadruple<double> node[2], axes;  ///< the nodes' rotations; the element's axes at the start
    double L;                         ///< length at the start, m
    double last;                      ///< twist of its ends to which the present one is near, rad

    double share;         ///< 0: measure of corotation.h; 1: measure of this file; between them in the transition
    double twist;         ///< of end 2 against end 1 about the chord, turns counted, rad
    double d[6];          ///< deformation (timoshenko.h)
    Triad<double> frame;  ///< e1 e2 e3 in space
    double open;          ///< the smaller 1 + cos(swing): 0 where an end points backwards along the chord
};

/// Computes share, twist, d, frame and open. Returns true if share > 0: d and frame are valid only then.
bool wind(Winding& w);

/// Derivative dd/du of the deformation, columns [u1 t1 u2 t2] in space, rotations as spins. Nodal forces are its
/// transpose times p.
Eigen::Matrix<double, 6, 12> rates(const Winding& w);

/// Tangent stiffness of a wound element, the exact derivative of its nodal forces; arguments as in tangent.h.
Mat12 tangent(const Winding& w, const Vec6& p, const Mat6& k, bool geometric);

}  // namespace hinge::beam

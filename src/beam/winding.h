// Large displacement, where corotation.h ends: an element whose ends have twisted against each other by more than a
// third of a turn, and by any number of turns, or have folded towards each other.
//
// The frame of corotation.h takes its y axis from the mean of the nodes' y axes. At half a turn of twist that mean
// vanishes. Here each node's rotation in the frame is a twist about the chord followed by a swing, the shortest
// rotation that brings the chord's direction to the node's z axis. The frame's y axis is where the mean of the two
// twists is: the section half way along the element. d[5] is the difference of the twists, and it is counted on over
// any number of turns. d[0] to d[3] are the swings' rotation vectors, so a wound element bends like one whose sections
// all lie as its middle one does. Where Ix and Iy differ, more elements a member follow the turning of the sections.
//
// Between the two measures lies a range, 120 to 150 degrees of twist, in which the deformation passes smoothly from one
// to the other. So the strain energy is one function of the nodes' places, twice differentiable, and of nothing else:
// no jump, and no memory but the number of turns. Forces and tangent are its derivatives, found by the rules of
// differentiation (dual numbers): few elements wind up, and for them that is fast enough.
#pragma once

#include "beam/corotation.h"
#include "core/types.h"

namespace hinge::beam {

/// Above which twist of the ends against each other (rad) the number of turns has to be remembered: a third of a turn.
inline constexpr double remembered_twist = 2.0943951023931953;

/// Where the sum of the squares of the two end rotations in the frame of corotation.h (rad^2) is below this, the
/// element is not wound: neither has a node rotated by 60 degrees in the frame.
inline constexpr double far_rotation = 1.0966227112321508;

/// An element that may be wound: where it is, and what `wind` finds.
struct Winding {
    Triple<double> chord;             ///< from node 1 to node 2 as it is now, m
    Quadruple<double> node[2], axes;  ///< the nodes' rotations; the element's axes at the start
    double L;                         ///< length at the start, m
    double last;                      ///< twist of its ends to which the present one is near, rad

    double share;         ///< 0: as corotation.h has it; 1: as above; between them in the range of passage
    double twist;         ///< of end 2 against end 1 about the chord, turns counted, rad
    double d[6];          ///< deformation (timoshenko.h)
    Triad<double> frame;  ///< e1 e2 e3 in space
    double open;          ///< the smaller 1 + cos(swing): 0 where an end points backwards along the chord
};

/// Fills in share, twist, d, frame and open. True when share > 0: only then are d and frame to be used.
bool wind(Winding& w);

/// dd/du, columns [u1 t1 u2 t2] in space, rotations as spins. Nodal forces are its transpose times p.
Eigen::Matrix<double, 6, 12> rates(const Winding& w);

/// As `tangent` of tangent.h: the exact derivative of the nodal forces.
Mat12 tangent(const Winding& w, const Vec6& p, const Mat6& k, bool geometric);

}  // namespace hinge::beam

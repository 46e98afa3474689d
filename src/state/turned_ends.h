// Element ends that hinges have turned far: the plastic rotation is moved into the reference axes of the end.
//
// An end's rotation against its element is a rotation vector, and there is none beyond half a turn. A hinge may go on
// for longer: a member folds onto itself. The elastic bending of the element stays small. So once the plastic rotation
// at an end passes two radians, both ends get new axes, in which the rotation that is left is the elastic one. Elastic
// deformation, forces p and energy are the same before and after, to rounding; the plastic deformation moved is stored,
// for the total plastic deformation of a hinge.
#pragma once

#include "state/state.h"

namespace hinge {

/// Moves the plastic rotations of an element into the axes of its ends, if they have turned an end by two radians or
/// more and the rest is elastic and small. Otherwise false, and nothing is changed. Large displacement.
bool turn_ends(const Structure& structure, State& state, int element);

/// Total plastic deformation of an element, moved or not, in d of timoshenko.h.
Vec6 flowed(const State& state, int element);
/// The part of it that was moved into the axes.
Vec6 taken_up(const State& state, int element);

}  // namespace hinge

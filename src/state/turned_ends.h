// Ends of elements that hinges have turned far: what their hinges have flowed is taken into the axes that an end is
// measured by.
//
// An end's rotation against its element is a rotation vector, and there is none beyond half a turn. A hinge may go on
// for longer: a member folds onto itself. What bends the element elastically stays small all the same. So once the
// plastic rotation at an end passes two radians, both ends get new axes, in which the rotation that is left is the
// elastic one. Elastic deformation, forces p and energy are the same before and after, to rounding; the plastic
// deformation that was taken up is kept for whoever asks what a hinge has flowed in all.
#pragma once

#include "state/state.h"

namespace hinge {

/// Takes up what the hinges of an element have flowed, where they have turned an end by two radians or more and what is
/// left is elastic and small. False, and nothing is changed, elsewhere. Large displacement.
bool turn_ends(const Structure& structure, State& state, int element);

/// All that an element has flowed, taken up or not: plastic deformation in d of timoshenko.h.
Vec6 flowed(const State& state, int element);
/// What of that was taken up.
Vec6 taken_up(const State& state, int element);

}  // namespace hinge

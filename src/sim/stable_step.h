// The longest step in which central differences stay stable.
#pragma once

#include "model/structure.h"

namespace hinge {

/// 2 / omega, s, for the highest frequency that any single element has with its lumped mass, which no structure of them exceeds
/// (Irons 1970); `element` is the one that has it. As the script declared it, without load: contact and initial stress come on top.
struct StableStep { double dt; int element; };
StableStep stable_step(const Structure& structure);

/// The part of it that a run takes of itself: room for what contact adds (a touch is as stiff as its softer element, which takes
/// a node's frequency up by the root of 3/2) and for large rotations.
inline double usual_step(const StableStep& limit, bool contact) { return (contact ? 0.7 : 0.9) * limit.dt; }

}  // namespace hinge

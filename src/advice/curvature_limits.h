// Limits of curvature as hinge rotations: they follow the length of the elements.
#pragma once

#include "effects/fracture_rule.h"
#include "advice/warning.h"
#include "state/state.h"

namespace hinge {

/// Adds a line for each rule with a limit of curvature for members that have yielded, or, without a state, that can
/// yield: the hinge rotation that it means in elements of their lengths. Members that have not yielded have no hinge:
/// there a curvature is M / (E I).
void name_curvature_limits(const Structure& structure, const State* state, std::vector<Warning>& list);

}  // namespace hinge

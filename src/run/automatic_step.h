// dt = "auto": the step that suits the elements of a structure. What effects join to them shortens it when a run is
// made (fitted_to_effects, run/step_length.h).
#pragma once

#include "algebra/stable_step.h"

namespace hinge {

/// The step of an impact, s: a whole part of the duration. A twelfth of the time in which an axial wave crosses the
/// shortest element; where members can yield, up to four times shorter, so that one solution a step is enough.
double shortest_step(const Structure& structure, double duration);

/// dt = "auto" of explicit steps, s: a whole part of the duration, within the limit of stability. `breaks`: elements
/// may break off.
double explicit_step(const Structure& structure, double duration, bool breaks);

/// The longest stable explicit step of the elements, with their damping.
StableStep explicit_limit(const Structure& structure, bool breaks);

/// Default step of explicit steps, s, a part of the stable step: room for large rotations, for stiffness of contact,
/// and for accuracy. Where hinges form, the energy error goes with the square of the step: of 68 random scenes in
/// explicit steps 10 were over 0.1 % at 0.9 and 0.7 of the limit, 2 at half of that.
double usual_step(const StableStep& limit, const Structure& structure);

}  // namespace hinge

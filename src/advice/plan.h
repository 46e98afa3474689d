// hinge plan: the effects that a run would simulate, and the reasons, without a step.
#pragma once

#include <string>

#include "advice/advised_run.h"

namespace hinge {

/// A line with the initial kinetic energy, J, of a dynamic run; "" if there is none.
std::string kinetic_at_start(const Run& run);

/// The run and its effects as a table: name, on or off, why, the script's line.
std::string plan_of(const AdvisedRun& of, const std::vector<PlanLine>& effects);

}  // namespace hinge

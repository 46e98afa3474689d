// hinge plan: what a run would simulate, and why, without a step.
#pragma once

#include <string>

#include "script/lua/objects.h"

namespace hinge::script {

/// The effects of a run, the recording that the script layer does among them.
std::vector<PlanLine> effects_of(const RunRecord& record);

/// A line with the kinetic energy, J, that a dynamic run begins with; "" where there is none.
std::string kinetic_at_start(const Run& run);

/// The run and its effects as a table: name, on or off, why, the script's line.
std::string plan_of(const RunRecord& record);

}  // namespace hinge::script

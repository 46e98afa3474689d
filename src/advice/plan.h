// hinge plan: the effects that a run would simulate, and the reasons, without a step.
#pragma once

#include <string>

#include "record/context.h"
#include "record/run_record.h"

namespace hinge {

/// The effects of a run, including recording by the script layer.
std::vector<PlanLine> effects_of(const RunRecord& record);

/// A line with the initial kinetic energy, J, of a dynamic run; "" if there is none.
std::string kinetic_at_start(const Run& run);

/// The run and its effects as a table: name, on or off, why, the script's line.
std::string plan_of(const RunRecord& record);

}  // namespace hinge

// hinge check: what a run would work on, and what in it is a likely mistake, without a step.
#pragma once

#include <string>

#include "script/objects.h"

namespace hinge::script {

/// The run's counts and mass in a line.
std::string checked_run(const RunRecord& record);

/// What it works on: its bodies with their masses and lowest natural periods, the shortest time that an axial wave
/// takes through an element, and warnings that name the culprit, the script's line and what to do.
std::string checked_model(const RunRecord& record);

}  // namespace hinge::script

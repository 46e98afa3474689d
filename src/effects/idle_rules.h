// Fracture rules that a run never came to: those that hold for no member, and functions that were never called.
#pragma once

#include "effects/reports.h"
#include "model/structure.h"

namespace hinge {

/// `called`: of each rule, how often its function was. A rule that a later one for the same group took the place of is
/// not named.
void name_idle_rules(const Structure& structure, const std::vector<long>& called, std::vector<RunWarning>& list);

}  // namespace hinge

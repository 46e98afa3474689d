// Messages on a run under way: progress, changes of state, warnings.
#pragma once

#include <chrono>

#include "record/context.h"
#include "record/run_record.h"

namespace hinge {

using Clock = std::chrono::steady_clock;
inline double seconds_of(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

/// Announces a run that takes its first step.
void tell_of_beginning(const std::shared_ptr<Context>& context, RunRecord& record);

/// Prints what is new since the last step: changes of state, warnings, findings, an instability, progress.
void tell_step(Context& context, RunRecord& record, bool over);

}  // namespace hinge

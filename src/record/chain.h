// Chains of runs that continue one another (from =): a failed run makes the later ones fail.
#pragma once

#include "record/context.h"
#include "record/run_record.h"

namespace hinge {

/// Text on a run that did not reach its requested end, or that continues such a run: which run, how far it came, where
/// it was made. "" for others, and if allow_failed = true accepts it.
std::string weak_link(const RunRecord& r);

/// True if it continues a run that did not reach its end, and nothing accepts that.
inline bool is_weak(const RunRecord& r) { return !r.weak.empty() && !r.weak_allowed; }

/// Verdict of a run. A run that has ended has failed if a run that it continues did not reach its end.
Verdict verdict_of(const RunRecord& r);

/// Why the run has failed, as a word of Cause, or "from_failed_run"; "" for one that has not.
std::string cause_of(const RunRecord& r);

/// The first failed run whose verdict the script has never read, without the last run; "" for none.
std::string unasked_failure(const Context& c);

/// Cause of that run; "" for none.
std::string unasked_cause(const Context& c);

/// Reason for the failure of a run or of the run that it continues, with a warning that may be the cause.
std::string reason_of(const RunRecord& r);

}  // namespace hinge

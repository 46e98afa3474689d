// Failures in words. Messages are for people: what decides is the cause.
#pragma once

#include <string>

#include "model/structure.h"
#include "run/run_failure.h"

namespace hinge {

/// The word of a cause in scripts and in summary.json, as "load_not_finite"; "" for none.
const char* word(Cause cause);

/// "step 3, t = 0.02 s: the load on node 4 ... is not finite". Unstable statics: Statics::text_of_cause.
std::string text_of(const Failure& failure, const Structure& structure);

/// All of it: the sentence and remarks.
std::string text_of(const RunFailure& failure, const Structure& structure);

/// Remarks that follow the sentence of the cause; `brief`: no more than where the structure gives way.
std::string text_of_rest(const RunFailure& failure, const Structure& structure, bool brief);

}  // namespace hinge

// Failures that were read from a checkpoint.
#pragma once

#include "run/run_failure.h"

namespace hinge {

class Structure;

/// Whether it can be a failure of a run of that structure, and has a text.
bool makes_sense(const RunFailure& failure, const Structure& structure);

}  // namespace hinge

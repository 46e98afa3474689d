// Checks that the parts of a snapshot are consistent, before its indices are used.
#pragma once

#include "output/picture.h"

namespace hinge::output {

/// Checks a snapshot. Throws InputError naming the first bar and field that is wrong.
void check_snapshot(const Snapshot& snapshot);

}  // namespace hinge::output

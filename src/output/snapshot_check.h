// Whether the parts of a snapshot agree with each other, checked before anything walks its indices.
#pragma once

#include "output/picture.h"

namespace hinge::output {

/// Throws InputError naming the first bar and field that is wrong.
void check_snapshot(const Snapshot& snapshot);

}  // namespace hinge::output

// Draws a snapshot as a picture.
#pragma once

#include <string>

#include "output/picture.h"

namespace hinge::output {

/// Returns the picture of a snapshot as PNG bytes.
std::string draw_snapshot(const Snapshot& snapshot, const View& view);

/// Returns snapshots side by side as PNG bytes, `columns` in a row, each of the first one's size.
std::string draw_strip(int count, const Snapshot* const* snapshots, const View* views, int columns);

}  // namespace hinge::output

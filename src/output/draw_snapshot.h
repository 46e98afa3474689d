// A snapshot as a picture.
#pragma once

#include <array>
#include <string>

#include "output/picture.h"

namespace hinge::output {

/// PNG bytes.
std::string draw_snapshot(const Snapshot& snapshot, const View& view);

/// PNG bytes: snapshots side by side, `columns` in a row, each of the first one's size.
std::string draw_strip(int count, const Snapshot* const* snapshots, const View* views, int columns);

/// xmin, xmax, ymin, ymax, zmin, zmax of what draw_snapshot would fit its camera to.
std::array<double, 6> frame_box(const Snapshot& snapshot, const View& view);

}  // namespace hinge::output

// Where a frame's bars lie, for one camera over all frames of a film.
#pragma once

#include <array>
#include <optional>

#include "output/picture.h"

namespace hinge::output {

/// xmin, xmax, ymin, ymax, zmin, zmax in m of what a picture without a box would be fitted to, but for the few ends
/// that lie farthest out; nothing without bars.
std::optional<std::array<double, 6>> frame_box(const Snapshot& snapshot, const View& view);

}  // namespace hinge::output

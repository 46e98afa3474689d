// Where a frame's bars lie, for one camera over all frames of a film.
#pragma once

#include "output/film.h"

namespace hinge::output {

/// The box holds what a picture without one would be fitted to, but for the few ends that lie farthest out.
FrameBox frame_box(const Snapshot& snapshot, const View& view);

}  // namespace hinge::output

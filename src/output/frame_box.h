// Box around the bars of a frame, for one camera over all frames of a film.
#pragma once

#include "output/film.h"

namespace hinge::output {

/// Computes the box that a picture would be fitted to, without the few ends that lie farthest out.
FrameBox frame_box(const Snapshot& snapshot, const View& view);

}  // namespace hinge::output

// Snapshot of a run at one instant, for pictures and frames.
#pragma once

#include "output/picture.h"

namespace hinge {

class Run;

/// Elements as bars; a broken one as the rigid bar from the node that carries it to its virtual node (paper, fig 4).
output::Snapshot make_snapshot(const Run& run);

}  // namespace hinge

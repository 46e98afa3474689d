// How far pairs of elements are compressed: between clamped ends their middle node does not bend out
// (beam/beam_column.h).
#pragma once

#include "state/state.h"

namespace hinge {

/// Compression of a pair, that begins with this element, over that at which it buckles between clamped ends, p' = pi^2
/// (beam/beam_column.h), in bending about x and about y. Both 0 where it is none, or is broken.
struct PairCompression {
    double force = 0;  ///< N, compression
    double part[2] = {0, 0};
    double most() const { return part[0] > part[1] ? part[0] : part[1]; }
};
PairCompression pair_compression(const Structure& structure, const State& state, const std::vector<Vec6>& force,
                                 int first);

}  // namespace hinge

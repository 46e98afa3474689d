// Which of many boxes overlap: sort and sweep.
//
// Eigen's KdBVH does the same in four times the time for a frame's bars (1.2 ms against 0.3 ms for 1698: the tree has no
// self-query, so it finds every pair twice and every bar with itself).
#pragma once

#include <vector>

#include "core/types.h"

namespace hinge::contact {

struct Box {
    Vec3 low, high;
};

struct IndexPair {
    int a, b;   ///< a < b
    bool operator==(const IndexPair&) const = default;
    auto operator<=>(const IndexPair&) const = default;
};

/// All pairs of boxes that overlap or touch, each once, sorted by (a, b).
std::vector<IndexPair> overlapping(const std::vector<Box>& boxes);

}  // namespace hinge::contact

// Helpers of loops over nodes: pieces for threads, and a node's six numbers as one vector.
#pragma once

#include "core/lanes.h"

namespace hinge {

/// Nodes that one thread takes at a time; a multiple of eight.
inline constexpr int some_nodes = 1024;

/// Numbers 3 to 5 of a row, in front.
inline Lanes second_three(const Lanes& row) { return __builtin_shufflevector(row, row, 3, 4, 5, 6, 7, 0, 1, 2); }

}  // namespace hinge

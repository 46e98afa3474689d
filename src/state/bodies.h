// Connected parts (bodies) of a structure.
#pragma once

#include <utility>
#include <vector>

#include "state/state.h"

namespace hinge {

struct Bodies {
    int count = 0;
    std::vector<int> of_node;  ///< -1: without an element
};
using BodyPairs = std::vector<std::pair<int, int>>;

/// Finds the bodies that whole elements connect in `state`, numbered by their first nodes.
Bodies find_bodies(const Structure& structure, const State& state);
/// The nodes of each body, rising.
std::vector<std::vector<int>> nodes_of(const Bodies& bodies);

}  // namespace hinge

// Storeys of a frame, found from its geometry, with z upwards.
#pragma once

#include <vector>

#include "model/structure.h"

namespace hinge {

/// The storey of each member, from 1 at the ground; 0: none. Floors are the heights of horizontal members that members
/// or connectors join to a support. A storey reaches from one floor to the next, which belongs to it. What is above the
/// last floor counts with the last storey.
std::vector<int> storeys_of(const Structure& structure);

}  // namespace hinge

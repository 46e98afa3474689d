// Momentum and kinetic energy of a part of the structure.
#pragma once

#include "state/breaking.h"

namespace hinge {

struct GroupMomentum : Momentum {
    double kinetic = 0;  ///< J
};

/// Of the members of a group; -1: of all. What nodes carry (point masses, broken elements) counts where no member
/// outside the group meets the node.
GroupMomentum momentum_of_group(const Structure& structure, const State& state, int group);

}  // namespace hinge

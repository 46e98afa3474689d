// Which effects a scene calls for, and why: decided once, when a run is made; an effect that is off has no stage in the
// step.
#pragma once

#include <string>
#include <vector>

#include "model/structure.h"

namespace hinge {

struct Effect {
    std::string name;
    bool active;
    std::string because;   ///< why it is in the step, or not
    std::string asked_at;  ///< the script's line that asks for it, "" where none does
    double seconds = 0;    ///< spent in it so far
};

/// All effects the engine knows, in the order of the step.
std::vector<Effect> effects_of(const Structure& structure, bool dynamic, bool geometric);

}  // namespace hinge

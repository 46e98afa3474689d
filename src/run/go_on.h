// A run that goes on from the state of another run of the same model.
#pragma once

#include <optional>
#include <string>

#include "run/run.h"

namespace hinge {

/// Why a run cannot go on from another one.
struct Refusal {
    std::string what;    ///< "a run of a structure with 4 nodes and 3 elements"; "" for the run before as such
    std::string advice;  ///< what to do about it
};

/// Whether a run of `structure`, made of the same model later, can go on from `before`: nothing may have been added,
/// moved or fixed since. None where it can.
std::optional<Refusal> refusal_to_go_on(const Run& before, const Structure& structure);

/// The state in which it begins: that of `before`, at step 0, with the velocities that were given since. Throws
/// InputError for a velocity of a node that has lost its last element.
State state_to_go_on(const Run& before, const Structure& structure);

/// Throws InputError for a velocity that no node can have: it belongs to no member, or supports hold it.
void refuse_idle_velocities(const Structure& structure, const State& start);

}  // namespace hinge

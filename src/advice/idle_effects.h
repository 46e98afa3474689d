// Effects that a run had in its steps and that did nothing in it.
#pragma once

#include <string>

#include "run/run.h"

namespace hinge {

/// Names contact without a touch, ground on which nothing lies, fracture without a break and damping that dissipates
/// nothing, and the part of the run's time that they took: "contact and ground did nothing in this run and took 3.1 %
/// of its time: contact 2.1 %, ground 1 %". "" where that is no more than 2 %. Damping that no member has is named
/// whatever it took. "" as well where the steps took less than a second. seconds: of the run's steps.
std::string idle_effects(const Run& run, double seconds);

}  // namespace hinge

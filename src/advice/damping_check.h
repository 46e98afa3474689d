// Damping ratios of a body's lowest modes under Rayleigh damping.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algebra/modes.h"
#include "model/structure.h"
#include "advice/warning.h"

namespace hinge {

/// Text such as "; damping ratios 5, 4.1, 5 %" of a body's modes; "" without damping.
std::string damping_ratios(const std::vector<DampedMode>& modes);

/// Warns of a first mode with far more or less damping than model:damping has at its two periods. `body`: its name.
std::optional<Warning> damped_otherwise(const Structure& structure, const std::vector<int>& nodes,
                                        const std::vector<DampedMode>& modes, const std::string& body);

}  // namespace hinge

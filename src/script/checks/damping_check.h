// What Rayleigh damping makes of a body's lowest modes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/structure.h"
#include "model/warnings.h"

namespace hinge::script {

/// "; damping ratios 5, 4.1, 5 %" of a body's circular frequencies, rad/s; "" where nothing damps it.
std::string damping_ratios(const Structure& structure, const std::vector<int>& nodes,
                           const std::vector<double>& frequencies);

/// A first mode that is damped far more or far less than model:damping asks for at its two periods. `body`: its name.
std::optional<Warning> damped_otherwise(const Structure& structure, const std::vector<int>& nodes,
                                        const std::vector<double>& frequencies, const std::string& body);

}  // namespace hinge::script

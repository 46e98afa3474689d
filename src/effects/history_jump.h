// The factor of a load whose history may jump within a step.
#pragma once

#include <algorithm>
#include <cmath>

namespace hinge {

/// A slope shorter than so many steps counts as one: what kinks miss by the trapezium rule is below 1e-3 of the impulse
/// of a pulse that is longer.
inline constexpr int steep = 20;

/// Where a history jumps, a step acts with its mean over it (History::over), and the acceleration is recomputed.
struct StepFactor {
    double kept = 1;            ///< with which the acceleration where the state is was found
    double begin = 1, end = 1;  ///< over the coming step
    /// Beyond what rounding of the times makes.
    bool jumps() const { return std::abs(begin - kept) > 1e-9 * std::max({std::abs(begin), std::abs(kept), 1e-3}); }
};

}  // namespace hinge

// Principal values and directions of a symmetric tensor in a plane.
#pragma once

#include <cmath>

#include "core/types.h"

namespace hinge::panel {

/// Of a strain or a curvature [e11, e22, 2 e12].
struct Principal {
    explicit Principal(const Vec3& e)
        : middle(0.5 * (e[0] + e[1])), half(0.5 * std::sqrt((e[0] - e[1]) * (e[0] - e[1]) + e[2] * e[2])) {
        if (half > 0) cos = 0.5 * (e[0] - e[1]) / half, sin = 0.5 * e[2] / half;
    }
    double middle, half;      ///< the principal values are middle + half and middle - half
    double cos = 1, sin = 0;  ///< of twice the angle to the first one's direction
    /// A unit value along the first direction (0) or the second (1), as a stress [s11, s22, s12].
    Vec3 direction(int i) const {
        const double c = i == 0 ? cos : -cos, s = i == 0 ? sin : -sin;
        return {0.5 * (1 + c), 0.5 * (1 - c), 0.5 * s};
    }
    /// The shear in these axes is across . e, and a unit one gives the stress `across`.
    Vec3 across() const { return {-sin, sin, cos}; }
};

}  // namespace hinge::panel

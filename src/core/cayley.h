// Rotations by Cayley vectors c = 2 tan(angle/2) along the axis: what the energy-momentum method steps with.
#pragma once

#include "core/types.h"

namespace hinge {

/// R' with R' n - R n = c x (R n + R' n)/2.
inline Quat cayley_turned(const Vec3& c, const Quat& q) {
    Quat r = Quat(1, 0.5 * c.x(), 0.5 * c.y(), 0.5 * c.z()) * q;
    r.normalize();
    return r;
}

/// The vector that the same rotation makes of v: v' = v + c x (v + v')/2.
inline Vec3 cayley_turned(const Vec3& c, const Vec3& v) {
    const double h = 0.25 * c.squaredNorm();
    const Vec3 once = c.cross(v);
    return v + (once + 0.5 * c.cross(once)) / (1 + h);
}

}  // namespace hinge

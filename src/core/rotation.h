// Finite rotations: quaternions and rotation vectors.
#pragma once

#include <cmath>

#include "core/types.h"

namespace hinge {

/// Rotates q by a rotation vector in space (rad): exp(by) * q, normalised.
inline Quat rotated(const Vec3& by, const Quat& q) {
    const double h = 0.25 * (by.x() * by.x() + by.y() * by.y() + by.z() * by.z());  // square of the half angle
    double c, s;                                                                    // cos, sin(half)/(2 half)
    if (h < 2e-4) {  // a step's rotation: series to rounding, without a division
        c = 1 - h * (1.0 / 2 - h * (1.0 / 24 - h * (1.0 / 720)));
        s = 0.5 - h * (1.0 / 12 - h * (1.0 / 240 - h * (1.0 / 10080)));
    } else if (h < 0.01) {
        c = 1 - h * (1.0 / 2 - h * (1.0 / 24 - h * (1.0 / 720 - h * (1.0 / 40320 - h * (1.0 / 3628800)))));
        s = 0.5 - h * (1.0 / 12 - h * (1.0 / 240 - h * (1.0 / 10080 - h * (1.0 / 725760 - h * (1.0 / 79833600)))));
    } else {
        const double half = std::sqrt(h);
        c = std::cos(half);
        s = 0.5 * std::sin(half) / half;
    }
    const double x = s * by.x(), y = s * by.y(), z = s * by.z();
    Quat r(c * q.w() - x * q.x() - y * q.y() - z * q.z(), c * q.x() + x * q.w() + y * q.z() - z * q.y(),
           c * q.y() - x * q.z() + y * q.w() + z * q.x(), c * q.z() + x * q.y() - y * q.x() + z * q.w());
    r.coeffs() *= 1.5 - 0.5 * ((r.x() * r.x() + r.y() * r.y()) + (r.z() * r.z() + r.w() * r.w()));
    return r;
}

/// The rotation vector of a unit quaternion, rad, at most pi long.
inline Vec3 rotation_vector(Quat q) {
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    const double sine = q.vec().norm();
    return sine > 0 ? Vec3(2 * std::atan2(sine, q.w()) / sine * q.vec()) : Vec3(Vec3::Zero());
}

}  // namespace hinge

// Rotation of a node relative to another one, or to the ground, and the moments that resist it: connectors and joints.
#pragma once

#include "core/types.h"
#include "model/structure.h"
#include "state/configuration.h"

namespace hinge {

struct RelativeRotation {
    Mat3 axes;      ///< columns x y z, as they stand: those of a
    Mat3 of_spin;   ///< d(rotation vector)/d(rotation on top of it)
    Vec3 rotation;  ///< vector of the rotation of b relative to a, in the axes, rad
    /// d(rotation)/d(spin of b in space); with a minus, of a.
    Mat3 by_spin() const { return of_spin * axes.transpose(); }
};

/// `a`: -1 for the ground. `axes`: as declared. `before`: the rotation where the last step ended; of rotations that
/// differ by multiples of 2 pi the one next to it counts.
RelativeRotation relative_rotation(const Structure& structure, const Pose& at, int a, int b, const Mat3& axes,
                                   const Vec3& before);

/// Adds what the rotation of axes and moments adds to the stiffness, 12 x 12 of nodes a and b; `moment` in the axes,
/// N m. Not symmetric.
void add_moment_curvature(const RelativeRotation& r, const Vec3& moment, Mat12& K);

}  // namespace hinge

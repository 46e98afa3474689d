// Rotation of a node relative to another one, or to the ground, and the moments that resist it: connectors and joints.
//
// It is a rotation vector, whose derivatives become infinite at a full turn. Where one axis has turned by more than two
// radians and the others by little, it is the twist about that axis, counted over any number of turns, and the swing
// across it, seen from half way of the twist. Both agree up to the square of the swing where one takes the place of the
// other.
#pragma once

#include "core/types.h"
#include "model/structure.h"
#include "state/configuration.h"

namespace hinge {

struct RelativeRotation {
    Mat3 axes;                         ///< columns x y z, as they stand: those of a
    Mat3 of_spin;                      ///< d(rotation)/d(rotation on top of it)
    Vec3 rotation;                     ///< of b relative to a, in the axes, rad
    int about = -1;                    ///< the axis of the twist; -1: a rotation vector
    Quat relative = Quat::Identity();  ///< with `about`: of b relative to a, in the axes
    /// d(rotation)/d(spin of b in space); with a minus, of a.
    Mat3 by_spin() const { return of_spin * axes.transpose(); }
};

/// `a`: -1 for the ground. `axes`: as declared. `before`: the rotation where the last step ended; of rotations that
/// differ by multiples of 2 pi the one next to it counts.
RelativeRotation relative_rotation(const Structure& structure, const Pose& at, int a, int b, const Mat3& axes,
                                   const Vec3& before);

/// The relative rotation of two nodes that was asked for last, which serves as long as the same one is asked for: a
/// step does so several times.
class LastRotation {
public:
    /// As relative_rotation.
    const RelativeRotation& at(const Structure& structure, const Pose& at, int a, int b, const Mat3& axes,
                               const Vec3& before);

private:
    Quat of_a_ = Quat(0, 0, 0, 0), of_b_ = Quat(0, 0, 0, 0);
    Vec3 before_ = Vec3::Zero();
    RelativeRotation is_;
};

/// What the rotation of axes and moments adds to the stiffness, N m/rad: P on the moment of b by the spin of b, P + M
/// on that of a by the spin of a, the same with a minus across.
struct MomentCurvature {
    Mat3 P, M;
};
MomentCurvature moment_curvature(const RelativeRotation& r, const Vec3& moment);

/// Adds what the rotation of axes and moments adds to the stiffness, 12 x 12 of nodes a and b; `moment` in the axes,
/// N m. Not symmetric.
void add_moment_curvature(const RelativeRotation& r, const Vec3& moment, Mat12& K);

}  // namespace hinge

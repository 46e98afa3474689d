#include "effects/relative_rotation.h"

#include <cmath>
#include <numbers>

#include "beam/tangent.h"
#include "core/rotation.h"

namespace hinge {

RelativeRotation relative_rotation(const Structure& structure, const Pose& at, int a, int b, const Mat3& axes,
                                   const Vec3& before) {
    if (!structure.large()) {
        const Vec3 of_a = a < 0 ? Vec3(Vec3::Zero()) : at.small_rotation[a];
        return {axes, Mat3::Identity(), axes.transpose() * (at.small_rotation[b] - of_a)};
    }
    const Quat of_a = a < 0 ? Quat::Identity() : at.rotation[a];
    RelativeRotation r;
    r.axes = of_a.toRotationMatrix() * axes;
    r.rotation = axes.transpose() * rotation_vector(of_a.conjugate() * at.rotation[b]);
    if (const double angle = r.rotation.norm(); angle > 0) {
        const double whole = 2 * std::numbers::pi;
        r.rotation += std::round((before.dot(r.rotation) / angle - angle) / whole) * whole / angle * r.rotation;
    }
    r.of_spin = beam::inverse_tangent(r.rotation);
    return r;
}

void add_moment_curvature(const RelativeRotation& r, const Vec3& moment, Mat12& K) {
    if (moment.isZero(0)) return;
    const Mat3 slope = beam::inverse_tangent_derivative(r.rotation, moment);
    const Mat3 P = r.axes * slope * r.of_spin * r.axes.transpose();
    const Mat3 M = skew(r.axes * (r.of_spin.transpose() * moment));
    K.block<3, 3>(9, 9) += P;
    K.block<3, 3>(3, 9) -= P;
    K.block<3, 3>(9, 3) -= P + M;
    K.block<3, 3>(3, 3) += P + M;
}

}  // namespace hinge

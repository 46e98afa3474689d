#include "effects/relative_rotation.h"

#include <cmath>
#include <numbers>

#include "beam/tangent.h"
#include "core/rotation.h"

namespace hinge {
namespace {

constexpr double far_twist = 2;      ///< rad, from which a rotation may be a twist and a swing
constexpr double small_swing = 0.5;  ///< rad, up to which it is
constexpr double small_sine = 0.01;  ///< of half the angle: up to it four terms of a series are exact
constexpr double whole_turn = 2 * std::numbers::pi;

/// q = p (cos t/2, sin t/2 about the axis) + (the swing's part across it): t the twist, p the swing's cosine.
struct TwistAndSwing {
    Vec3 rotation;
    Mat3 of_spin;
};

/// The twist about an axis next to what it was, rad.
double twist_about(const Quat& q, int about, double before) {
    const double twist = 2 * std::atan2(q.vec()[about], q.w());
    return twist + std::round((before - twist) / whole_turn) * whole_turn;
}

/// The axis about which a rotation is a large twist with a small swing; -1 for none. `before`: where the last step
/// ended, rad; `vector`: its rotation vector now.
int axis_of_twist(const Quat& q, const Vec3& before, const Vec3& vector) {
    // no twist is larger than the whole rotation, and one that differs from `before` by less than half a turn stays
    if (before.cwiseAbs().maxCoeff() < std::numbers::pi - far_twist && vector.norm() <= far_twist) return -1;
    int about = 0;
    if (before.cwiseAbs().maxCoeff(&about) < 0.5 * far_twist) vector.cwiseAbs().maxCoeff(&about);
    const double cosine = std::hypot(q.w(), q.vec()[about]);
    return std::abs(twist_about(q, about, before[about])) > far_twist && cosine > std::cos(0.5 * small_swing) ? about
                                                                                                              : -1;
}

/// `before`: the twist where the last step ended, rad.
TwistAndSwing twist_and_swing(const Quat& q, int about, double before) {
    const int j = (about + 1) % 3, k = (about + 2) % 3;
    const double w = q.w(), x = q.vec()[about], p2 = w * w + x * x, p = std::sqrt(p2);
    const double twist = twist_about(q, about, before);
    // q and -q are one rotation: that one counts whose twist is this one, not a turn more
    const double sign = w * std::cos(0.5 * twist) + x * std::sin(0.5 * twist) < 0 ? -1 : 1;
    const double y = sign * q.vec()[j], z = sign * q.vec()[k], u = std::sqrt(y * y + z * z);
    const double angle = u > 1e-4 ? std::asin(std::min(1.0, u)) : u * (1 + u * u / 6);
    const double G = u > 1e-4 ? 2 * angle / u : 2 + u * u / 3;
    const double slope = u > 1e-4 ? (2 / std::max(1e-9, p) - G) / (u * u) : 2.0 / 3;  // dG/du over u
    const double f = 0.5 * far_twist / std::sin(0.5 * far_twist);  // as the rotation vector has it at far_twist
    TwistAndSwing r;
    r.rotation[about] = twist;
    r.rotation[j] = f * G * y;
    r.rotation[k] = f * G * z;
    for (int c = 0; c < 3; ++c) {  // a spin about each axis on top of q
        const Vec3 spin = Vec3::Unit(c);
        const double dw = -0.5 * q.vec().dot(spin);
        const Vec3 dv = 0.5 * (w * spin + spin.cross(q.vec()));
        const double dy = sign * dv[j], dz = sign * dv[k], dG = slope * (y * dy + z * dz);
        r.of_spin(about, c) = 2 * (w * dv[about] - x * dw) / p2;
        r.of_spin(j, c) = f * (dG * y + G * dy);
        r.of_spin(k, c) = f * (dG * z + G * dz);
    }
    return r;
}

/// As hinge::rotation_vector. Of small rotations by the series of the arc sine, to rounding.
Vec3 vector_of(const Quat& q) {
    const double sine2 = q.vec().squaredNorm();
    if (!(q.w() > 0 && sine2 < small_sine * small_sine)) return rotation_vector(q);
    return (2 + sine2 * (1.0 / 3 + sine2 * (3.0 / 20 + sine2 * (5.0 / 56)))) * q.vec();
}

/// d(of_spin^T moment)/d(spin) of a twist and a swing, by differences: it is used in the stiffness alone.
Mat3 slope_of_moment(const RelativeRotation& r, const Vec3& moment) {
    constexpr double h = 1e-6;
    Mat3 slope;
    for (int c = 0; c < 3; ++c) {
        const auto at = [&](double by) -> Vec3 {
            const Quat q = rotated(by * Vec3::Unit(c), r.relative);
            return twist_and_swing(q, r.about, r.rotation[r.about]).of_spin.transpose() * moment;
        };
        slope.col(c) = (at(h) - at(-h)) / (2 * h);
    }
    return slope;
}

}  // namespace

RelativeRotation relative_rotation(const Structure& structure, const Pose& at, int a, int b, const Mat3& axes,
                                   const Vec3& before) {
    if (!structure.large()) {
        const Vec3 of_a = a < 0 ? Vec3(Vec3::Zero()) : at.small_rotation[a];
        return {axes, Mat3::Identity(), axes.transpose() * (at.small_rotation[b] - of_a)};
    }
    const Quat of_a = a < 0 ? Quat::Identity() : at.rotation[a];
    RelativeRotation r;
    r.axes = of_a.toRotationMatrix() * axes;
    const Quat q = of_a.conjugate() * at.rotation[b];
    r.rotation = axes.transpose() * vector_of(q);
    if (const double angle = r.rotation.norm(); angle > 0)
        r.rotation +=
            std::round((before.dot(r.rotation) / angle - angle) / whole_turn) * whole_turn / angle * r.rotation;
    r.relative = q;
    r.relative.vec() = axes.transpose() * q.vec();
    r.about = axis_of_twist(r.relative, before, r.rotation);
    if (r.about < 0) {
        r.of_spin = beam::inverse_tangent(r.rotation);
        return r;
    }
    const TwistAndSwing t = twist_and_swing(r.relative, r.about, before[r.about]);
    r.rotation = t.rotation, r.of_spin = t.of_spin;
    return r;
}

const RelativeRotation& LastRotation::at(const Structure& structure, const Pose& at, int a, int b, const Mat3& axes,
                                         const Vec3& before) {
    const Quat of_a = a < 0 ? Quat::Identity() : at.rotation[a], &of_b = at.rotation[b];
    if (structure.large() && of_a.coeffs() == of_a_.coeffs() && of_b.coeffs() == of_b_.coeffs() && before == before_)
        return is_;
    of_a_ = of_a, of_b_ = of_b, before_ = before;
    return is_ = relative_rotation(structure, at, a, b, axes, before);
}

MomentCurvature moment_curvature(const RelativeRotation& r, const Vec3& moment) {
    const Mat3 slope = r.about < 0 ? Mat3(beam::inverse_tangent_derivative(r.rotation, moment) * r.of_spin)
                                   : slope_of_moment(r, moment);
    return {r.axes * slope * r.axes.transpose(), skew(r.axes * (r.of_spin.transpose() * moment))};
}

void add_moment_curvature(const RelativeRotation& r, const Vec3& moment, Mat12& K) {
    if (moment.isZero(0)) return;
    const auto& [P, M] = moment_curvature(r, moment);
    K.block<3, 3>(9, 9) += P;
    K.block<3, 3>(3, 9) -= P;
    K.block<3, 3>(9, 3) -= P + M;
    K.block<3, 3>(3, 3) += P + M;
}

}  // namespace hinge

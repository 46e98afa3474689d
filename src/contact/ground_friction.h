// Coulomb friction of a point on the ground.
#pragma once

#include <algorithm>

#include "core/types.h"

namespace hinge::contact {

/// Stiffness of friction's spring over that of the point's own, k_t / k. A point of the surface of a member also
/// rotates with its node, which makes it up to 2.5 times as easy to move.
inline constexpr double tangential_part = 0.4;
/// Friction that differs by this part of the most that there can be from the one that a step was solved with asks for
/// another solution.
inline constexpr double same_friction = 0.01;

/// Friction at a point at the end of a step: the stretch of its spring, and the work dissipated by sliding.
struct Friction {
    Vec3 slip = Vec3::Zero();  ///< e, m
    bool slides = false;
    double heat = 0;  ///< J, since the step began
};

/// Coulomb friction over a step: a spring e of stiffness k, N/m, along the plane, whose force k e is limited to
/// `most_force`, N; below zero, as rounding may leave it where hardly anything presses, it is zero. A step that begins
/// with a stretch of `before` moves the surface by `moved`, m, of which `part` counts: the part after it touched. Heat:
/// the work against the mean of the forces at the step's two ends, less the change of the spring's energy.
inline Friction friction(const Vec3& before, const Vec3& moved, double part, double k, double most_force) {
    Friction f;
    const double most = std::max(0.0, most_force) / k;
    const Vec3 trial = before + part * moved;
    const double length = trial.norm();
    f.slides = length > most;
    f.slip = f.slides ? Vec3(most / length * trial) : trial;
    const double heat = 0.5 * k * ((f.slip + before).dot(moved) + before.squaredNorm() - f.slip.squaredNorm());
    f.heat = std::max(0.0, heat);  // less would be made: an error
    return f;
}

}  // namespace hinge::contact

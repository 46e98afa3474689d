// A point that presses on a surface by press_law.h and rubs on it by Coulomb's friction: what it keeps from step to
// step, and what it does in one. Where the surface is, and where force and counterforce go, its owner knows: panels
// (effects/panel_contact.cpp), the ground (effects/ground_panels.cpp).
#pragma once

#include <algorithm>
#include <limits>

#include "contact/ground_friction.h"
#include "contact/press_law.h"
#include "core/types.h"

namespace hinge::contact {

struct PressLaw {
    double stiffness = 0;  ///< k, N/m
    double damping = 0;    ///< a of press_law.h
    double friction = 0;   ///< Coulomb's coefficient
    /// That of friction's spring, N/m. Damping makes a contact shorter: the spring is stiffer as the force is, or
    /// friction would not come to what the pressure allows.
    double along() const { return tangential_part * steepest(); }
    /// The largest slope of the force, N/m.
    double steepest() const { return stiffness * (1 + damping); }
};

/// Where a step begins.
struct PressedPoint {
    double depth = 0;              ///< m; negative: apart
    double rate = 0, fastest = 0;  ///< m/s, at which it went deeper in the step before; the largest since it touched
    Vec3 slip = Vec3::Zero();      ///< stretch of friction's spring, m
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.depth, s.rate, s.fastest, s.slip);
    }
    double stored(const PressLaw& law, double now) const {
        return press(law.stiffness, law.damping, now, 0, 0, 0).stored + 0.5 * law.along() * slip.squaredNorm();
    }
};

/// At the end of a step, as far as it has been solved.
struct PressedEnd {
    double depth = -std::numeric_limits<double>::infinity(), rate = 0;
    Press press;
    Vec3 slip = Vec3::Zero();
    bool slides = false;
    double heat = 0;  ///< J, of friction in the step

    bool touches() const { return depth > 0; }
    /// Whether a step that was solved with this end leads to one with the same forces, to 1 %: a point has not come to
    /// touch or ceased to, and neither the pressure nor friction differs from what was foretold.
    bool agrees(const PressLaw& law, const PressedEnd& now) const {
        if (touches() != now.touches() || !press.foretells(now.press, now.depth - depth)) return false;
        return law.along() * (now.slip - slip).norm() <= same_friction * law.friction * now.press.force;
    }
};

/// The pressure where a step of length dt has led to that depth; dt = 0: where the step begins.
inline PressedEnd pressed(const PressLaw& law, const PressedPoint& p, double depth, double dt) {
    PressedEnd e;
    e.depth = depth, e.rate = dt > 0 ? (depth - p.depth) / dt : p.rate;
    e.press = press(law.stiffness, law.damping, depth, e.rate, p.fastest, dt);
    return e;
}

inline bool rubs(const PressLaw& law, const PressedPoint& p, const PressedEnd& e) {
    return law.friction > 0 && (e.touches() || !p.slip.isZero(0));
}
/// Adds friction. `slip`: that of the point as the surface has turned since; `moved`: along the surface, m.
inline void rub(const PressLaw& law, const PressedPoint& p, const Vec3& slip, const Vec3& moved, PressedEnd& e) {
    // of a step in which it comes to touch, the part that is left then
    const double part = p.depth > 0 || !e.touches() ? 1 : e.depth / (e.depth - p.depth);
    const Friction f = friction(slip, moved, part, law.along(), law.friction * e.press.force);
    e.slip = f.slip, e.slides = f.slides, e.heat = f.heat;
}

/// What a step that ends so has dissipated, J, and what it has missed.
struct PressedStep {
    double lost = 0;
    Missed missed;
};
inline PressedStep end_of_step(const PressLaw& law, const PressedPoint& p, const PressedEnd& e, double dt) {
    if (!e.touches() && !(p.depth > 0)) return {e.heat, {}};
    const Press before = press(law.stiffness, law.damping, p.depth, p.rate, p.fastest, 0);
    return {Press::lost(before, e.press, e.depth - p.depth) + e.heat, missed(before, p.depth, e.press, e.depth, dt)};
}

/// The next step begins there. `level`: the depth that counts as none, m; it falls as the point rises out of it.
inline void keep(const PressedEnd& e, PressedPoint& p, double& level) {
    p.depth = e.depth, p.rate = e.rate, p.fastest = e.press.fastest, p.slip = e.slip;
    const double less = std::clamp(-p.depth, 0.0, std::max(0.0, level));
    level -= less, p.depth += less;
}

/// Stiffness of the translations of a point: of the pressure along the normal, and of a friction that sticks.
inline Mat3 slope_of(const PressLaw& law, const Vec3& normal, double of_press, bool sticks) {
    Mat3 K = of_press * normal * normal.transpose();
    if (law.friction > 0 && sticks) K += law.along() * (Mat3::Identity() - normal * normal.transpose());
    return K;
}

}  // namespace hinge::contact

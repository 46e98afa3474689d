// The law by which a point presses on a surface: a spring with a damping that grows with the depth.
//
//   f = k g (1 + a r / v),  not below zero,  where g > 0
//
// g depth, r its rate, v the largest r since the point touched (Hunt and Crossley, J. Applied Mechanics 42, 1975, 440).
// The force begins and ends at zero. A mass that comes at v goes back with e v, whatever v is, where
//   a - ln(1 + a) = -e a - ln(1 - e a):
// both sides are the energy at the deepest point, of the way in and of the way out. e = 1: a = 0.
#pragma once

#include <algorithm>
#include <cmath>

namespace hinge::contact {

/// Smallest restitution that the law is used with: a is 5, so that the force begins six times as steep as the spring.
inline constexpr double least_restitution = 0.2;

/// a of a restitution from least_restitution to 1.
inline double damping_for(double restitution) {
    double low = 0, high = 1 / restitution;
    for (int i = 0; i < 100; ++i) {
        const double a = 0.5 * (low + high);
        const bool less = -restitution * a - std::log1p(-restitution * a) < a - std::log1p(a);
        (less ? low : high) = a;
    }
    return restitution < 1 ? low : 0;
}

struct Press {
    double force = 0, elastic = 0;  ///< N; elastic: that of the spring alone, the rest dissipates
    double slope = 0;               ///< N/m, of the force in a step
    double stored = 0;              ///< J
    double fastest = 0;             ///< v, m/s

    /// Whether a step that was solved with this one, and has led deeper by that, ends with the force that its slope
    /// foretells, to 1 %.
    bool foretells(const Press& now, double deeper) const {
        constexpr double same = 0.01;
        return std::abs(force + slope * deeper - now.force) <= same * std::max(force, now.force);
    }
    /// Dissipated over a step that takes the mean of the forces at its two ends and goes deeper by `change`, m; J.
    static double lost(const Press& before, const Press& now, double change) {
        return 0.5 * (before.force - before.elastic + now.force - now.elastic) * change;
    }
};
/// `rate`: mean of the step of length dt that ends there. `fastest`: v where the step begins.
inline Press press(double k, double damping, double g, double rate, double fastest, double dt) {
    Press p;
    if (!(g > 0)) return p;
    p.elastic = k * g, p.stored = 0.5 * k * g * g;
    p.fastest = std::max(fastest, rate);
    const double by_rate = p.fastest > 0 ? damping / p.fastest : 0, factor = 1 + by_rate * rate;
    if (!(factor > 0)) return p;
    p.force = p.elastic * factor;
    p.slope = k * factor + (dt > 0 ? p.elastic * by_rate / dt : 0);
    return p;
}

/// What a step misses where a point begins or ceases to touch: the mean of the forces at its two ends does not do the
/// work that the spring stores. The impulse, N s, pushes the point out; `work`, J, is what it is to do.
struct Missed {
    double impulse = 0, work = 0;
};
inline Missed missed(const Press& before, double depth_before, const Press& now, double depth, double dt) {
    if ((depth_before > 0) == (depth > 0)) return {};
    const double change = depth - depth_before;
    const double energy = now.stored - before.stored - 0.5 * (before.elastic + now.elastic) * change;
    return {energy * dt / change, -energy};
}

}  // namespace hinge::contact

// Bending of a bar about one axis, from the moments and shear forces at its ends and the loads between them, and from
// what its axial force does as the bar bows between its ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace hinge {

/// Where a cubic has extreme values strictly between t0 and t1, from its values there and at the thirds: the roots of
/// its derivative a + b u + c u^2, with u from 0 to 1 between t0 and t1. Rising.
inline std::vector<double> peaks_of_cubic(const double (&v)[4], double t0, double t1) {
    const double a = -5.5 * v[0] + 9 * v[1] - 4.5 * v[2] + v[3], b = 18 * v[0] - 45 * v[1] + 36 * v[2] - 9 * v[3],
                 c = 13.5 * (v[3] - v[0]) + 40.5 * (v[1] - v[2]);
    // Changes that rounding alone makes have no peak.
    const double noise = 1e-12 * std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2]), std::abs(v[3])});
    std::vector<double> found;
    const double root = b * b - 4 * a * c;
    if (!(std::max({std::abs(a), std::abs(b), std::abs(c)}) > noise) || !(root >= 0)) return found;
    const double q = -0.5 * (b + std::copysign(std::sqrt(root), b));
    for (const double u : {q / c, a / q})
        if (u > 0 && u < 1) found.push_back(t0 + u * (t1 - t0));
    std::sort(found.begin(), found.end());
    return found;
}

/// Solutions of f'' + p f = g on 0 <= t <= 1, for p of either sign below pi^2.
class BowedBar {
public:
    explicit BowedBar(double p) : pressed_(p > 0), u_(std::sqrt(std::abs(p))) {}

    /// g = 0, f(0) = 0, f(1) = 1.
    double of_end(double t) const { return pressed_ ? std::sin(u_ * t) / std::sin(u_) : ratio(t, 0, -1, 0); }
    /// g = a unit impulse at `at`, f(0) = f(1) = 0.
    double of_force(double t, double at) const {
        const double a = std::min(t, at), b = 1 - std::max(t, at);
        return -(pressed_ ? std::sin(u_ * a) * std::sin(u_ * b) / std::sin(u_) : ratio(a, b, -1, -1)) / u_;
    }
    /// g = the derivative of a unit impulse at `at`: f jumps by 1 there. f(0) = f(1) = 0.
    double of_moment(double t, double at) const {
        const bool before = t <= at;
        const double a = before ? t : 1 - t, b = before ? 1 - at : at, side = before ? -1 : 1;
        return side * (pressed_ ? std::sin(u_ * a) * std::cos(u_ * b) / std::sin(u_) : ratio(a, b, -1, 1));
    }

private:
    /// sinh(u a) times sinh(u b) (sign_b = -1), cosh(u b) (1) or 1 (0), over sinh(u), without overflow: a + b <= 1.
    double ratio(double a, double b, int sign_a, int sign_b) const {
        const auto part = [&](double x, int sign) { return 1 + sign * std::exp(-2 * u_ * x); };
        const double of_b = sign_b == 0 ? 1 : 0.5 * part(b, sign_b);
        return std::exp(u_ * (a + b - 1)) * part(a, sign_a) * of_b / part(1, -1);
    }
    bool pressed_;
    double u_;
};

/// dQ/dz = -q and dM/dz = sign Q - m, with z along the bar, t = z / length from 0 to 1. N, N m, m. Q is across the
/// chord. Where the axial force acts on the bow of the bar between its ends (`compression`), dM/dz has its part as
/// well.
struct BarBending {
    struct Point {
        double t, force, moment;
    };
    /// A load over a part of the bar, from t0 to t1: force and moment per length there, linear between.
    struct Part {
        double t0, t1, q[2], m[2];
        /// Integrals of a value v over the part up to t, and of that integral, over the length and its square.
        static double sum(const double (&v)[2], double s, double width) {
            return width * (v[0] * s + (v[1] - v[0]) * s * s / 2);
        }
        static double sum_of_sums(const double (&v)[2], double s, double width) {
            return width * width * (v[0] * s * s / 2 + (v[1] - v[0]) * s * s * s / 6);
        }
        double inside(double t) const { return std::clamp((t - t0) / (t1 - t0), 0.0, 1.0); }
        double force(double t) const { return sum(q, inside(t), t1 - t0); }
        double moment(double t) const { return sum(m, inside(t), t1 - t0); }
        double force_area(double t) const {
            return sum_of_sums(q, inside(t), t1 - t0) + std::max(0.0, t - t1) * force(t1);
        }
    };
    double M[2], Q[2], sign, length;      ///< sign: 1 for Mx and Qy, -1 for My and Qx
    double q[2] = {0, 0}, m[2] = {0, 0};  ///< per length, linear between the ends
    std::vector<Point> points = {};
    std::vector<Part> parts = {};
    double shear_left = 0, moment_left = 0;  ///< part of Q and M from inertia, linear from end to end
    double compression = 0;  ///< P length^2 / EI with P positive in compression; 0: P acts on the chord alone

    /// All loads are known: what they leave open at the far end is taken as a linear part.
    void close() {
        // shares of the length: a point load so near to an end stands at it; how far inside of the bar it is taken
        constexpr double at_end = 1e-6, inside = 1e-12;
        // A load at an end is inside the bar where that is what the forces at its ends say; else the node has it.
        std::vector<Point> ends;
        for (Point& p : points) {
            if (p.t > at_end && p.t < 1 - at_end) continue;
            ends.push_back({std::clamp(p.t, inside, 1 - inside), p.force, p.moment});
            p.force = p.moment = 0;
        }
        std::erase_if(points, [](const Point& p) { return p.force == 0 && p.moment == 0; });
        shear_left = moment_left = 0;
        for (const Point& p : ends) {
            const double Q_off = Q[1] - shear(1), M_off = M[1] - chord_moment(1);
            if (p.force != 0 ? std::abs(Q_off + p.force) < std::abs(Q_off)
                             : std::abs(M_off + p.moment) < std::abs(M_off))
                points.push_back(p);
        }
        shear_left = Q[1] - shear(1);
        moment_left = M[1] - chord_moment(1);
    }
    double shear(double t) const {
        double Q_t = Q[0] - length * (q[0] * t + (q[1] - q[0]) * t * t / 2) + shear_left * t;
        for (const Point& p : points)
            if (p.t < t) Q_t -= p.force;
        for (const Part& p : parts) Q_t -= length * p.force(t);
        return Q_t;
    }
    /// Integral of the shear force up to t, over the length.
    double shear_area(double t) const {
        double sum = Q[0] * t - length * (q[0] * t * t / 2 + (q[1] - q[0]) * t * t * t / 6) + shear_left * t * t / 2;
        for (const Point& p : points) sum -= p.force * std::max(0.0, t - p.t);
        for (const Part& p : parts) sum -= length * p.force_area(t);
        return sum;
    }
    /// In equilibrium with the loads, and with an axial force on the bow: M'' + p M = M_chord''.
    double moment(double t) const {
        constexpr double none = 1e-4, most = 9.5;  // M changes by p / 8 of itself; at pi^2 the bar buckles between ends
        if (!(std::abs(compression) > none)) return chord_moment(t);
        const double p = std::min(compression, most),
                     d0 = sign * length * (shear_left - length * q[0]) - length * (m[1] - m[0]),
                     d1 = -sign * length * length * (q[1] - q[0]);  // M_chord'' = d0 + d1 t, and of the points
        const BowedBar bar(p);
        double M_t =
            (d0 + d1 * t) / p + (M[0] - d0 / p) * bar.of_end(1 - t) + (chord_moment(1) - (d0 + d1) / p) * bar.of_end(t);
        for (const Point& at : points)
            M_t -= sign * length * at.force * bar.of_force(t, at.t) + at.moment * bar.of_moment(t, at.t);
        for (const Part& part : parts) M_t -= of_part(part, bar, t);
        return M_t;
    }
    /// By Gauss's rule with four points on either side of t, right to 1e-9.
    double of_part(const Part& part, const BowedBar& bar, double t) const {
        static constexpr double place[] = {0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                                           0.9305681557970263},
                                weight[] = {0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                                            0.1739274225687269};
        const double bounds[] = {part.t0, std::clamp(t, part.t0, part.t1), part.t1};
        double sum = 0;
        for (int side : {0, 1})
            for (int k = 0; k < 4; ++k) {
                const double width = bounds[side + 1] - bounds[side], at = bounds[side] + place[k] * width,
                             s = part.inside(at), dt = weight[k] * width * length;
                sum += dt * sign * length * (part.q[0] + s * (part.q[1] - part.q[0])) * bar.of_force(t, at) +
                       dt * (part.m[0] + s * (part.m[1] - part.m[0])) * bar.of_moment(t, at);
            }
        return sum;
    }
    /// Where it has extreme values strictly between t0 and t1, without a point load between them. A cubic on the chord;
    /// else by the cubics through eight pieces of it.
    std::vector<double> peaks(double t0, double t1) const {
        const int pieces = compression == 0 ? 1 : 8;
        std::vector<double> found;
        for (int i = 0; i < pieces; ++i) {
            const double from = t0 + (t1 - t0) * i / pieces, to = t0 + (t1 - t0) * (i + 1) / pieces;
            double v[4];
            for (int k = 0; k < 4; ++k) v[k] = moment(from + (to - from) * k / 3);
            for (const double t : peaks_of_cubic(v, from, to)) found.push_back(t);
        }
        return found;
    }
    /// In equilibrium on the chord.
    double chord_moment(double t) const {
        double M_t =
            M[0] + sign * length * shear_area(t) - length * (m[0] * t + (m[1] - m[0]) * t * t / 2) + moment_left * t;
        for (const Point& p : points)
            if (p.t < t) M_t -= p.moment;
        for (const Part& p : parts) M_t -= length * p.moment(t);
        return M_t;
    }
};

}  // namespace hinge

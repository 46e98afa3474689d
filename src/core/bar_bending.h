// Bending of a bar about one axis, from the moments and shear forces at its ends and the loads between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace hinge {

/// dQ/dz = -q and dM/dz = sign Q - m, with z along the bar, t = z / length from 0 to 1. N, N m, m.
struct BarBending {
    struct Point {
        double t, force, moment;
    };
    double M[2], Q[2], sign, length;      ///< sign: 1 for Mx and Qy, -1 for My and Qx
    double q[2] = {0, 0}, m[2] = {0, 0};  ///< per length, linear between the ends
    std::vector<Point> points = {};
    double shear_left = 0, moment_left = 0;  ///< part of Q and M from inertia, linear from end to end

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
            const double Q_off = Q[1] - shear(1), M_off = M[1] - moment(1);
            if (p.force != 0 ? std::abs(Q_off + p.force) < std::abs(Q_off)
                             : std::abs(M_off + p.moment) < std::abs(M_off))
                points.push_back(p);
        }
        shear_left = Q[1] - shear(1);
        moment_left = M[1] - moment(1);
    }
    double shear(double t) const {
        double Q_t = Q[0] - length * (q[0] * t + (q[1] - q[0]) * t * t / 2) + shear_left * t;
        for (const Point& p : points)
            if (p.t < t) Q_t -= p.force;
        return Q_t;
    }
    /// Integral of the shear force up to t, over the length.
    double shear_area(double t) const {
        double sum = Q[0] * t - length * (q[0] * t * t / 2 + (q[1] - q[0]) * t * t * t / 6) + shear_left * t * t / 2;
        for (const Point& p : points) sum -= p.force * std::max(0.0, t - p.t);
        return sum;
    }
    double moment(double t) const {
        double M_t =
            M[0] + sign * length * shear_area(t) - length * (m[0] * t + (m[1] - m[0]) * t * t / 2) + moment_left * t;
        for (const Point& p : points)
            if (p.t < t) M_t -= p.moment;
        return M_t;
    }
};

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

}  // namespace hinge

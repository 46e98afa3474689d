#include "beam/pair_bow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hinge::beam {

double bow_of_even_load(double p) {
    if (std::abs(p) < 1e-3) return p / 24;
    const double u = std::sqrt(std::abs(p)), T = p > 0 ? u * std::tan(0.5 * u) : -u * std::tanh(0.5 * u);
    return T / p - 0.5;
}

double bow_of_force(double p, double x) {
    const double xi = 1 - std::abs(x);
    if (std::abs(p) < 1e-3) return 0;  // less than 1e-4 of P l
    const double u = std::sqrt(std::abs(p));
    const auto of = [&](double z) { return p > 0 ? std::cos(u * z) : std::cosh(u * z); };
    const double middle = 1 - of(xi), ends = of(x) - of(1), over = p > 0 ? u * std::sin(u) : -u * std::sinh(u);
    return 0.5 * ((middle + ends) / over - xi);
}

double bow_peak(double p, double first, double middle, double second, std::span<const BowPoint> points) {
    if (points.empty() && p < 1) {
        // Without a zero of the slope between the ends: |B| >= |A| tan u or |A| tanh u, with cos u >= 1 - p/2.
        const double even = std::abs(0.5 * (first + second) - middle), odd = 0.5 * std::abs(second - first);
        if (odd >= even * (1 + 1 / (1 - 0.5 * std::max(p, 0.0)))) return 0;
    }
    constexpr int pieces = 64;  // the parabola through a piece is 1e-4 higher than its ends
    const double u = std::sqrt(std::abs(p));
    const auto sine = [&](double x) { return p > 0 ? std::sin(u * x) : std::sinh(u * x); };
    const auto cosine = [&](double x) { return p > 0 ? std::cos(u * x) : std::cosh(u * x); };
    const auto of_points = [&](double x) {
        double M = 0;
        for (const BowPoint& at : points)
            if (at.x < x) M -= at.slope * sine(x - at.x) / u + at.moment * cosine(x - at.x);
        return M;
    };
    const double in_middle = middle - of_points(0), at_second = second - of_points(1),
                 A = (in_middle - 0.5 * (first + at_second)) / (1 - cosine(1)), B = 0.5 * (at_second - first) / sine(1);
    const auto moment = [&](double x) { return in_middle + A * (cosine(x) - 1) + B * sine(x) + of_points(x); };
    // An extreme value close to that of an end is the end's: the hinge there is as near.
    double largest = middle;
    const double least = 1.02 * std::max(std::abs(first), std::abs(second));
    const auto compare = [&](double M) {
        if (M * middle > 0 && std::abs(M) > std::abs(largest) && std::abs(M) > least) largest = M;
    };
    if (points.empty()) {
        // A cos + B sin has the amplitude R, at the angle atan(B / A); A cosh + B sinh sqrt(A^2 - B^2) at -atanh(B /
        // A).
        if (p > 0) {
            const double R = std::hypot(A, B), angle = std::atan2(B, A),
                         opposite = angle - std::copysign(std::numbers::pi, angle);
            if (std::abs(angle) < u) compare(in_middle - A + R);
            if (std::abs(opposite) < u) compare(in_middle - A - R);
        } else if (std::abs(B) < std::abs(A) * std::tanh(u)) {
            compare(in_middle - A + std::copysign(std::sqrt(A * A - B * B), A));
        }
        return largest - middle;
    }
    double before = std::abs(first), here = std::abs(moment(2.0 / pieces - 1));
    for (int i = 1; i < pieces; ++i) {
        const double next = std::abs(i + 1 == pieces ? second : moment(2.0 * (i + 1) / pieces - 1));
        if (here >= before && here >= next) compare(moment(2.0 * i / pieces - 1));
        before = here, here = next;
    }
    for (const BowPoint& at : points) compare(moment(at.x));
    return largest - middle;
}

double bow_of_couple(double p, double x) {
    if (std::abs(p) < 1e-3) return 0;
    const double side = x > 0 ? 1 : x < 0 ? -1 : 0, xi = 1 - std::abs(x), u = std::sqrt(std::abs(p));
    const auto of = [&](double z) { return p > 0 ? std::sin(u * z) : std::sinh(u * z); };
    return 0.5 * (side - (side * of(xi) + of(x)) / of(1));
}

}  // namespace hinge::beam

// Curves of connectors: force over deformation, elastic and linear between the points.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace hinge {

using Curve = std::vector<std::pair<double, double>>;

/// A curve from 0 on holds for both signs. Beyond its ends it goes on as straight as it ends.
inline bool is_odd(const Curve& curve) { return curve.front().first >= 0; }

struct OnCurve {
    double force = 0, slope = 0, energy = 0;
};

inline OnCurve on_piece(const Curve& c, std::size_t i, double from, double to) {
    const double slope = (c[i].second - c[i - 1].second) / (c[i].first - c[i - 1].first);
    const auto at = [&](double d) { return c[i - 1].second + slope * (d - c[i - 1].first); };
    return {at(to), slope, 0.5 * (at(from) + at(to)) * (to - from)};
}

/// Force, slope, and the energy from no deformation on.
inline OnCurve on_curve(const Curve& curve, double d) {
    if (curve.empty()) return {};
    if (is_odd(curve) && d < 0) {
        const OnCurve mirrored = on_curve(curve, -d);
        return {-mirrored.force, mirrored.slope, mirrored.energy};
    }
    const std::size_t last = curve.size() - 1;
    const auto piece_of = [&](double x) {
        std::size_t i = 1;
        while (i < last && x > curve[i].first) ++i;
        return i;
    };
    OnCurve at;
    double energy = 0, from = 0;
    std::size_t i = piece_of(0);
    for (const std::size_t end = piece_of(d);; i < end ? ++i : --i) {
        const double to = i == end ? d : i < end ? curve[i].first : curve[i - 1].first;
        at = on_piece(curve, i, from, to);
        energy += at.energy;
        from = to;
        if (i == end) break;
    }
    at.energy = energy;
    return at;
}

inline double steepest(const Curve& curve) {
    double most = 0;
    for (std::size_t i = 1; i < curve.size(); ++i)
        most = std::max(most, std::abs(on_piece(curve, i, curve[i - 1].first, curve[i].first).slope));
    return most;
}

}  // namespace hinge

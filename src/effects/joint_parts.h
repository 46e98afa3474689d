// The curve of a joint's axis as a sum of springs, each in series with a slider.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "effects/joints.h"

namespace hinge {

/// A spring in series with a slider that holds up to `strength`.
struct JointPart {
    double stiffness, strength;  ///< N m/rad, N m
};

inline std::vector<JointPart> parts_of(const JointAxis& axis) {
    std::vector<double> slopes;
    std::pair<double, double> last{0, 0};
    for (const auto& point : axis.curve) {
        slopes.push_back((point.second - last.second) / (point.first - last.first));
        last = point;
    }
    slopes.push_back(0);
    std::vector<JointPart> parts;
    for (std::size_t i = 0; i < axis.curve.size(); ++i) {
        const double k = slopes[i] - slopes[i + 1];
        parts.push_back({k, k * axis.curve[i].first});
    }
    return parts;
}

/// Moment of an axis at a rotation.
struct Resistance {
    double moment = 0, slope = 0, stored = 0, dissipated = 0;
};

/// `slid`: where the sliders are; they are moved. `left`: part of their strength.
inline Resistance resist(const std::vector<JointPart>& parts, double left, double rotation, std::vector<double>& slid) {
    Resistance r;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double k = parts[i].stiffness, strength = left * parts[i].strength;
        if (k == 0) continue;
        double m = k * (rotation - slid[i]);
        if (std::abs(m) > strength) {
            m = std::copysign(strength, m);
            r.dissipated += m * (rotation - m / k - slid[i]);
            slid[i] = rotation - m / k;
        } else {
            r.slope += k;
        }
        r.moment += m;
        r.stored += 0.5 * m * m / k;
    }
    return r;
}

}  // namespace hinge

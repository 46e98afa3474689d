// Springs of connectors that yield: elastic, then perfectly plastic, each direction by itself, or x and y together by
// the size of their force (radial return; Simo and Hughes, Computational Inelasticity, 1998, section 1.2).
#pragma once

#include <cmath>
#include <limits>

#include "core/types.h"

namespace hinge {

/// Forces at which springs flow, N and N m, or plastic deformations at which they part, m and rad.
struct ConnectorLimits {
    Vec6 each = Vec6::Constant(std::numeric_limits<double>::infinity());
    double xy = std::numeric_limits<double>::infinity();  ///< of x and y together: the size of the two
    bool any() const { return (each.array() < std::numeric_limits<double>::infinity()).any() || std::isfinite(xy); }
    /// The first direction that has reached its limit: 0 to 5, 6 for xy, -1 for none.
    int reached(const Vec6& of) const {
        for (int k = 0; k < 6; ++k)
            if (std::abs(of[k]) >= each[k]) return k;
        return std::hypot(of[0], of[1]) >= xy ? 6 : -1;
    }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.each, s.xy);
    }
};

struct YieldingSpring {
    Vec6 force, plastic;
    Mat6 slope;
};

/// `stiffness`: N/m, N m/rad; x and y have the same where they yield together. `plastic`: where the last step ended.
inline YieldingSpring yielding_spring(const Vec6& stiffness, const ConnectorLimits& yield, const Vec6& deformation,
                                      const Vec6& plastic) {
    YieldingSpring s{stiffness.cwiseProduct(deformation - plastic), plastic, Mat6(stiffness.asDiagonal())};
    for (int k = 0; k < 6; ++k) {
        if (std::abs(s.force[k]) <= yield.each[k]) continue;
        const double to = std::copysign(yield.each[k], s.force[k]);
        s.plastic[k] += (s.force[k] - to) / stiffness[k];
        s.force[k] = to, s.slope(k, k) = 0;
    }
    const double size = std::hypot(s.force[0], s.force[1]);
    if (size <= yield.xy) return s;
    const Eigen::Vector2d along = s.force.head<2>() / size;
    s.plastic.head<2>() += (size - yield.xy) / stiffness[0] * along;
    s.force.head<2>() = yield.xy * along;
    s.slope.topLeftCorner<2, 2>() =
        stiffness[0] * yield.xy / size * (Eigen::Matrix2d::Identity() - along * along.transpose());
    return s;
}

}  // namespace hinge

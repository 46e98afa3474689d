// Rayleigh damping as a script declares it.
#pragma once

#include <numbers>

#include "core/types.h"

namespace hinge {

inline constexpr const char* damping_effect = "damping";

/// C = alpha M + beta K of a group's elements. Of several the last one that an element's groups fit counts.
struct Damping {
    double alpha = 0, beta = 0;                    ///< 1/s, s
    int group = -1;                                ///< -1: all
    bool joints = true;                            ///< beta damps joints and connectors at the elements, too
    double ratio[2] = {0, 0}, period[2] = {0, 0};  ///< that alpha and beta follow from, s; 0: given themselves
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.alpha, s.beta, s.group, s.joints);
    }
};

/// The coefficients that damp a period of `period[i]` s by `ratio[i]` of what is critical: ratio = alpha / (2 omega) +
/// beta omega / 2 at both. Either may come out negative where the ratios are far apart. Equal periods ask for equal
/// ratios.
inline Damping rayleigh(const double (&ratio)[2], const double (&period)[2]) {
    const double one = 2 * std::numbers::pi / period[0], two = 2 * std::numbers::pi / period[1];
    if (ratio[0] == ratio[1]) return {2 * ratio[0] * one * two / (one + two), 2 * ratio[0] / (one + two)};
    const double apart = (two - one) * (two + one);
    return {2 * one * two * (ratio[0] * two - ratio[1] * one) / apart, 2 * (ratio[1] * two - ratio[0] * one) / apart};
}

}  // namespace hinge

// Moment in the middle of a pair of elements whose bending follows its axial force (beam_column.h).
//
// Between its ends such a pair is the exact beam-column, but its middle node is not on that curve: where both ends
// rotate by K against the chord, the node deflects by a K l and the beam by T/p K l (l: length of one element; p, u, v,
// C, S and a of beam_column.h):
//
//   T = u tan(u/2);   in tension T = -v tanh(v/2);   T = p/2 + p^2/24 + ...
//
// The moments of the elements at that node are in balance on their chords. They lack N times the difference of the two
// deflections. In parts of EI/l for K, and of q l^2 for an even load q:
//
//   middle of the beam   D K + (T - 1 + C)/p q l^2     D = C + T = u / sin u
//   at the node          (C + a p) K + (1/2 - (1 - C)/p) q l^2
//
// Under a force P at x (-1 to 1 over the pair, xi = 1 - |x|) on a beam with clamped ends the two are, in P l/2,
//
//   middle of the beam   (1 - cos(u xi)) / (u sin u)
//   at the node          xi - (cos(u x) - cos u) / (u sin u)
//
// K follows from the mean moment at the two integration points, EI/l S K. p is p' of beam_column.h all along.
#pragma once

#include <span>

#include "beam/beam_column.h"

namespace hinge::beam {

/// v and e^-v where p is pair_least.
inline constexpr double pair_least_v = 2.684058886, pair_least_e = 0.06828543;
/// T/p and D of a pair.
template <class Real>
struct BowFunctions {
    Real share, D;
};
/// Right to 1e-7 for p from -7.2 to 6 by Lambert's continued fraction of tan h / h, h = u/2. Above, as at 6; below,
/// with e^-v to some per cent, where it is less than 0.07.
template <class Real>
[[gnu::always_inline]] inline BowFunctions<Real> bow_functions(const Real& p) {
    const auto c = [&](double v) { return spread(v, p); };
    const Real least = c(pair_least);
    Real t = p < least ? least : p;
    t = t > c(pair_most) ? c(pair_most) : t;
    const Real x = c(0.25) * t,
               tan_h = (c(10395) + x * (c(21) * x - c(1260))) / (c(10395) + x * (x * (c(210) - x) - c(4725)));
    BowFunctions<Real> of = {c(0.5) * tan_h, (c(1) + x * tan_h * tan_h) / tan_h};
    const Real v = square_root(p < least ? c(0) - p : c(0) - least), by = c(1) + c(1.0 / 16) * (v - c(pair_least_v));
    const Real by2 = by * by, by4 = by2 * by2, by8 = by4 * by4, e = c(pair_least_e) / (by8 * by8);  // e^-v
    of.share = p < least ? (c(1) - e) / ((c(1) + e) * v) : of.share;
    of.D = p < least ? c(2) * v * e / (c(1) - e * e) : of.D;
    return of;
}

/// Difference of the moment in the middle and that at the node by a rotation K of both ends, in parts of EI/l K.
template <class Real>
[[gnu::always_inline]] inline Real bow_of_rotation(const Real& p) {
    const auto c = [&](double v) { return spread(v, p); };
    constexpr double a = 0.5 * (1 - gauss_point);
    const StabilityFunctions<Real> of = stability_functions(p);
    return bow_functions(p).D - of.S + c(a * a - a) * p;
}

/// Where K follows from the moments at the integration points: beyond it S is small or negative.
inline constexpr double bow_by_moments = 2.8;
/// The same in parts of the mean moment at the two integration points; p up to bow_by_moments.
template <class Real>
[[gnu::always_inline]] inline Real bow_of_moment(const Real& p) {
    return bow_of_rotation(p) / stability_functions(p).S;
}

/// The same of an even load, in q l^2, of a force at x, in P l, and of a moment there, which is its derivative by x.
double bow_of_even_load(double p);
double bow_of_force(double p, double x);
double bow_of_couple(double p, double x);

/// A load at a place x of a pair (-1 to 1): by what the slope dM/dx and the moment M fall there, N m.
struct BowPoint {
    double x, slope, moment;
};
/// The extreme moment between the ends beyond the one in the middle, from the moments at both ends and there, under
/// loads at points and an even one: A cos(u x) + B sin(u x) + constant beside the points. 0 where there is none beyond
/// it, of the same sign, and by 2 % beyond both ends.
double bow_peak(double p, double first, double middle, double second, std::span<const BowPoint> points);

}  // namespace hinge::beam

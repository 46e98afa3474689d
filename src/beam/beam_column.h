// Second-order bending of a pair of elements under axial force: the exact beam-column between the ends of the pair.
//
// A pair of elements of formulation asi-gauss has the bending stiffness of the exact beam between its ends, and the
// chords of its two elements carry the axial force N. The chords alone give too small a second-order effect: the middle
// node of the pair deflects by 0.4226 theta l where a half sine deflects by 0.6366 theta l, and a pinned column of two
// elements buckles at 22.4 EI/L^2.
//
// With p = -N l^2 / EI (l: one element; p > 0 is compression) the exact beam-column between the ends of the pair has
// two numbers, for symmetric and antisymmetric rotations of its ends (the stability functions, Livesley and Chandler
// 1956), in EI/l:
//
//   symmetric      C                 C = u cot u, u^2 = p;   in tension C = v coth v, v^2 = -p
//   antisymmetric  p / (1 - C)
//
// The bending energy of the pair has two such numbers, S and A. kappa = t2 - t1 is the bending of an element:
//
//   W = EI/l (S (kappa_1 + kappa_2)^2 + A (kappa_1 - kappa_2)^2) / 4,    S = A = 1 at N = 0
//
// The integration points stay where they are, a l from the outer ends, a = 1/(3 + sqrt 3) * 2 = (1 - s)/2. Where shear
// is stiff, the pair then has
//
//   symmetric      S - a^2 p         (the middle node goes a theta l, and the chords carry N)
//   antisymmetric  3 A               (the middle node stays; 1 / (1 - a)^2 = 3)
//
// so that S = C + a^2 p and A = p / (3 (1 - C)) make it exact. N is that of the pair's mean extension e and of the
// shortening by bowing, -dW/dN / 2 an element:
//
//   U = the greatest over N of  2 N e - N^2 l / EA + W(N, kappa)
//
// S and A fall ever faster as p grows, so there is one such N. U depends on the deformations of the two elements alone:
// energy is conserved, a rigid motion strains nothing. A pair that is clamped at both ends buckles at p = pi^2 by its
// middle node, which cannot follow without rotation of the ends: that takes four elements.
//
// Shear makes the bow softer (Engesser 1891): with P = -N and s = EI/(GA l^2) the slope of the deflection follows from
// the section's rotation psi and the transverse force V by w' (1 - P/GA) = psi + V/GA, and psi from EI psi'' (1 - P/GA)
// =
// -(V + P psi). So all of this holds with p / (1 - s p) in the place of p: of the pair with S(p') and A(p'), the middle
// node gives a^2 p' / p of the sag, and the elements' own shear strain the rest.
//
// C comes from the continued fraction p / (3 - p / (5 - p / (7 - p / (9 - p / 11)))) of 1 - C (Lambert 1761), right to
// 2.5e-5 for p between -7.2 and 4.5 and to 3e-4 at 6. Beyond -7.2 and 6 S and A go on as straight lines.
#pragma once

#include "beam/timoshenko.h"
#include "section/yield.h"
#include "core/lanes.h"

namespace hinge::beam {

/// Stability functions S and A of a pair, with first and second derivatives with respect to p.
template <class Real>
struct StabilityFunctions {
    Real S, S1, S2, A, A1, A2;
};

/// Range of p outside of which S and A are straight lines. At `pair_least` the slope of S is zero.
inline constexpr double pair_least = -7.204172103970679, pair_most = 6;
/// a^2, where a l is the distance of the integration points from the outer ends of the pair.
inline constexpr double pair_sag = 0.25 * (1 - gauss_point) * (1 - gauss_point);
/// Of an even load q on a pair between clamped ends, what comes to an end by the elements alone: half of the force q l
/// on the middle node times a l, in q l^2.
inline constexpr double arm_of_pair = 0.25 * (1 - gauss_point);

/// Stability functions of a pair at p = -N l^2 / EI of one element.
template <class Real>
[[gnu::always_inline]] inline StabilityFunctions<Real> stability_functions(const Real& p) {
    const auto c = [&](double v) { return spread(v, p); };
    const Real least = c(pair_least), most = c(pair_most);
    Real t = p < least ? least : p;
    t = t > most ? most : t;
    // f = p/(5 - p/(7 - p/(9 - p/11))) = n/d;  A = 1 - f/3,  C = 1 - p/(3 - f) = 1 - p d/m,  m = 3 d - n
    const Real n = t * (c(693) - c(18) * t), n1 = c(693) - c(36) * t, d = c(3465) + t * (t - c(189)),
               d1 = t + t - c(189), m = c(3) * d - n, m1 = c(3) * d1 - n1;
    const Real both = c(1) / (d * m), of_d = both * m, of_m = both * d;
    const Real f = n * of_d, f1 = (n1 - f * d1) * of_d, f2 = (c(-36) - c(2) * f1 * d1 - c(2) * f) * of_d;
    const Real g = t * d * of_m, g1 = (d + t * d1 - g * m1) * of_m,
               g2 = (c(2) * d1 + c(2) * t - c(2) * g1 * m1 - c(42) * g) * of_m;
    const Real past = p - t, third = c(-1.0 / 3), none = c(0);
    StabilityFunctions<Real> out;
    out.S1 = c(pair_sag) - g1;
    out.A1 = third * f1;
    out.S = c(1) - g + c(pair_sag) * t + out.S1 * past;
    out.A = c(1) + third * f + out.A1 * past;
    out.S2 = past != none ? none : none - g2;
    out.A2 = past != none ? none : third * f2;
    return out;
}

/// Shear of a pair in one plane, and where p' is pair_least and pair_most. Without a shear area that counts, the second
/// and the third are those themselves.
template <class Real>
struct PairShear {
    Real flexible, least, most;  ///< s = EI/(GA l^2); values of p
};
inline PairShear<double> pair_shear(double s) {
    constexpr double far = -1e30;  // p' stays above pair_least
    return {s, 1 + s * pair_least > 0 ? pair_least / (1 + s * pair_least) : far, pair_most / (1 + s * pair_most)};
}

/// Puts the shear of one element in a lane.
inline void put(PairShear<Lanes>& to, int lane, const PairShear<double>& from) {
    to.flexible[lane] = from.flexible, to.least[lane] = from.least, to.most[lane] = from.most;
}

/// p' = p / (1 - s p), up to pair_most.
template <class Real>
[[gnu::always_inline]] inline Real softened_by_shear(const Real& p, const PairShear<Real>& shear) {
    const Real t = p > shear.most ? shear.most : p;
    return t / (spread(1.0, p) - shear.flexible * t);
}

/// S and A at p' as functions of p: derivatives with respect to p. Where p' is pair_least and pair_most they go on as
/// straight lines in p.
template <class Real>
[[gnu::always_inline]] inline StabilityFunctions<Real> stability_functions(const Real& p,
                                                                           const PairShear<Real>& shear) {
    const auto c = [&](double v) { return spread(v, p); };
    Real t = p < shear.least ? shear.least : p;
    t = t > shear.most ? shear.most : t;
    const Real r = c(1) / (c(1) - shear.flexible * t), r2 = r * r, bend = c(2) * shear.flexible * r * r2, past = p - t,
               none = c(0);
    StabilityFunctions<Real> of = stability_functions(Real(t * r));
    of.S2 = past != none ? none : r2 * r2 * of.S2 + bend * of.S1;
    of.A2 = past != none ? none : r2 * r2 * of.A2 + bend * of.A1;
    of.S1 = r2 * of.S1;
    of.A1 = r2 * of.A1;
    of.S = of.S + of.S1 * past;
    of.A = of.A + of.A1 * past;
    return of;
}

/// Stiffness and length of the two equal elements of a pair. Index 0: bending about x; 1: about y. All zero but
/// `axial`: an element without a partner.
template <class Real>
struct PairKind {
    Real axial, length;  ///< EA/l, N/m; l, m
    Real b[2], c[2];     ///< EI/l, N m; l^2/EI, 1/N
    PairShear<Real> shear[2];
};
/// The pair kind of elements of length L with these rigidities.
PairKind<double> pair_kind(const Rigidity& c, double L);
/// The same where E is `factor` times as large: so are its forces and its energy.
inline PairKind<double> operator*(double factor, PairKind<double> k) {
    k.axial *= factor;
    for (int plane : {0, 1}) k.b[plane] *= factor, k.c[plane] /= factor;
    return k;
}

/// S and A of one plane at axial force N.
inline StabilityFunctions<double> stability_functions(const PairKind<double>& k, int plane, double N) {
    return stability_functions(-k.c[plane] * N, k.shear[plane]);
}
/// p' of the compression P, N, in one plane, up to pair_most.
inline double pressed_pair(const PairKind<double>& k, int plane, double P) {
    return softened_by_shear(k.c[plane] * P, k.shear[plane]);
}

/// S and A of both planes at axial force N. Of eight, lanes 2 i and 2 i + 1 are the elements of one pair and have the
/// same N: the even lanes compute one plane, the odd lanes the other.
[[gnu::always_inline]] inline void both_planes(const PairKind<double>& k, double N,
                                               StabilityFunctions<double> (&of)[2]) {
    for (int plane : {0, 1}) of[plane] = stability_functions(k, plane, N);
}
[[gnu::always_inline]] inline void both_planes(const PairKind<Lanes>& k, const Lanes& N,
                                               StabilityFunctions<Lanes> (&of)[2]) {
    const auto pick = [&](Lanes PairShear<Lanes>::*field) {
        return even_and_odd(k.shear[0].*field, k.shear[1].*field);
    };
    const PairShear<Lanes> shear = {pick(&PairShear<Lanes>::flexible), pick(&PairShear<Lanes>::least),
                                    pick(&PairShear<Lanes>::most)};
    const StabilityFunctions<Lanes> m = stability_functions<Lanes>(-even_and_odd(k.c[0], k.c[1]) * N, shear);
    of[0] = {evens(m.S), evens(m.S1), evens(m.S2), evens(m.A), evens(m.A1), evens(m.A2)};
    of[1] = {odds(m.S), odds(m.S1), odds(m.S2), odds(m.A), odds(m.A1), odds(m.A2)};
}

/// Forces of a pair in addition to those of its separate elements.
template <class Real>
struct PairForces {
    Real N;             ///< on the extension of each element, N
    Real N_whole;       ///< of the pair, N
    Real moment[2];     ///< on the bending of the first element, N m
    Real symmetric[2];  ///< part of it that acts on both elements; the rest acts on the second with the other sign
};

/// Deformations on which the axial force N of a pair depends: mean elastic extension, and bending kappa of its
/// elements.
template <class Real>
struct PairShape {
    Real straight, bowing;       ///< EA/l e, N; -EA/8
    Real sum[2], difference[2];  ///< of kappa of the two elements, first less second, rad
    Real square[2], difference_square[2];
};

/// One step of Newton's method for N = EA/l (e + bow(N)), and the forces at the new N. Returns the change, old N less
/// new N.
template <class Real>
[[gnu::always_inline]] inline Real step_to_N(const PairKind<Real>& k, const PairShape<Real>& y, const Real& N,
                                             PairForces<Real>& out) {
    const auto c = [&](double v) { return spread(v, N); };
    const Real one = c(1);
    StabilityFunctions<Real> of[2];
    both_planes(k, N, of);
    Real bow = c(0), slope = c(0);
    for (int plane : {0, 1}) {
        bow += of[plane].S1 * y.square[plane] + of[plane].A1 * y.difference_square[plane];
        slope += k.c[plane] * (of[plane].S2 * y.square[plane] + of[plane].A2 * y.difference_square[plane]);
    }
    const Real change = (N - y.straight - y.bowing * bow) / (one + y.bowing * slope);
    out.N_whole = N - change;
    out.N = out.N_whole - y.straight;
    for (int plane : {0, 1}) {  // S and A where the change leads
        const Real by = k.c[plane] * change, b = c(0.5) * k.b[plane];
        out.symmetric[plane] = b * (of[plane].S + of[plane].S1 * by - one) * y.sum[plane];
        out.moment[plane] = out.symmetric[plane] + b * (of[plane].A + of[plane].A1 * by - one) * y.difference[plane];
    }
    return change;
}

/// True while the error of N may exceed rounding.
template <class Real>
[[gnu::always_inline]] inline auto still_open(const PairKind<Real>& k, const Real& N, const Real& change) {
    const auto c = [&](double v) { return spread(v, N); };
    const Real size = change < c(0) ? c(0) - change : change, whole = N < c(0) ? c(0) - N : N;
    return size > c(1e-6) * whole + c(1e-18) * k.axial;
}

/// Iterates N to convergence by Newton's method with bisection; `out`: the result of the first step from N. N - EA/l (e
/// + bow(N)) grows with N, and the slopes of S and A are bounded where they become straight lines, so there is one N
/// between known bounds. The interval is halved where a step would leave it, or is not half of the step before.
/// Converged lanes keep their N.
template <class Real>
[[gnu::noinline]] void find_N(const PairKind<Real>& k, const PairShape<Real>& y, Real N, Real change,
                              PairForces<Real>& out) {
    const auto c = [&](double v) { return spread(v, N); };
    const auto size = [&](const Real& v) { return Real(v < c(0) ? c(0) - v : v); };
    Real low = y.straight, high = y.straight;
    for (int plane : {0, 1}) {
        const PairShear<Real>& shear = k.shear[plane];
        const StabilityFunctions<Real> ends[2] = {stability_functions(shear.least, shear),
                                                  stability_functions(shear.most, shear)};
        low += y.bowing * (ends[0].S1 * y.square[plane] + ends[0].A1 * y.difference_square[plane]);
        high += y.bowing * (ends[1].S1 * y.square[plane] + ends[1].A1 * y.difference_square[plane]);
    }
    auto open = still_open(k, out.N_whole, change);
    Real last = high - low;
    for (int i = 0; i < 200 && any_true(open); ++i) {
        low = change < c(0) && N > low ? N : low;
        high = change > c(0) && N < high ? N : high;
        const Real middle = c(0.5) * (low + high);
        Real next = N - change;
        next = next < low ? middle : next;
        next = next > high ? middle : next;
        next = size(change) > c(0.5) * last ? middle : next;
        last = size(next - N);
        N = open ? next : N;
        PairForces<Real> there;
        change = step_to_N(k, y, N, there);
        out.N_whole = open ? there.N_whole : out.N_whole;
        out.N = open ? there.N : out.N;
        for (int plane : {0, 1}) {
            out.moment[plane] = open ? there.moment[plane] : out.moment[plane];
            out.symmetric[plane] = open ? there.symmetric[plane] : out.symmetric[plane];
        }
        open = open & still_open(k, there.N_whole, change);
    }
}

/// Forces of a pair in addition to those of its elements. `e`: mean elastic extension, m; `sum`, `difference`: of kappa
/// of the two elements, first less second, rad.
template <class Real>
[[gnu::always_inline]] inline PairForces<Real> pair_forces(const PairKind<Real>& k, const Real& e, const Real (&sum)[2],
                                                           const Real (&difference)[2]) {
    const auto c = [&](double v) { return spread(v, e); };
    constexpr double S1 = pair_sag - 1.0 / 3, A1 = -1.0 / 15, S2 = -2.0 / 45, A2 = -2.0 / 525;  // at p = 0
    const PairShape<Real> y = {k.axial * e,
                               c(-0.125) * k.axial * k.length,
                               {sum[0], sum[1]},
                               {difference[0], difference[1]},
                               {sum[0] * sum[0], sum[1] * sum[1]},
                               {difference[0] * difference[0], difference[1] * difference[1]}};
    Real bow = c(0), slope = c(0);  // by the first terms of the series of S and A
    for (int plane : {0, 1}) {
        bow += c(S1) * y.square[plane] + c(A1) * y.difference_square[plane];
        const Real twice = k.shear[plane].flexible + k.shear[plane].flexible;
        slope += k.c[plane] *
                 ((c(S2) + c(S1) * twice) * y.square[plane] + (c(A2) + c(A1) * twice) * y.difference_square[plane]);
    }
    const Real N = (y.straight + y.bowing * bow) / (c(1) + y.bowing * slope);
    PairForces<Real> out;
    const Real change = step_to_N(k, y, N, out);
    if (any_true(still_open(k, out.N_whole, change))) find_N(k, y, N, change, out);
    return out;
}

/// Sum and difference of the bending kappa of the two elements, first less second, about x and about y, rad.
struct PairShapeNumbers {
    double sum[2], difference[2];
};
/// The bending of a pair from the deformations of its elements.
PairShapeNumbers shape_of(const Vec6& d1, const Vec6& d2);

using PairMatrix = Eigen::Matrix<double, 12, 12>;
/// Energy U of a pair less the energies of its separate elements, J. d1 and d2: elastic deformations of the two
/// elements. Forces and stiffness below are its derivatives with respect to d1 and d2.
double pair_energy(const PairKind<double>& k, const Vec6& d1, const Vec6& d2);
/// Forces of a pair in addition to those of its elements, N and N m. `N`, if not null, receives the axial force of the
/// pair, N.
Vec12 pair_forces(const PairKind<double>& k, const Vec6& d1, const Vec6& d2, double* N = nullptr);
/// Stiffness of a pair in addition to that of its elements, 12 x 12, symmetric.
PairMatrix pair_stiffness(const PairKind<double>& k, const Vec6& d1, const Vec6& d2);
/// The same where the axial force N of the pair is known.
PairMatrix pair_stiffness(const PairKind<double>& k, const Vec6& d1, const Vec6& d2, double N);

}  // namespace hinge::beam

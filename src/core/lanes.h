// The scalar type of element kernels: one double, or eight doubles in a vector register.
//
// A kernel is a template over Real: `double` for one element, `Lanes` for a block of eight. Both do the same operations
// in the same order, so the results of an element do not depend on the other elements of its block.
#pragma once

#include <cmath>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

namespace hinge {

inline constexpr int lane_count = 8;
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));
/// Eight doubles at any place in an array, without alignment. (Attributes in this order: clang passes over aligned() in
/// the other.)
using LanesAnywhere __attribute__((vector_size(lane_count * sizeof(double)), aligned(8), may_alias)) = double;

inline double square_root(double a) { return std::sqrt(a); }
inline Lanes square_root(Lanes a) {
#ifdef __AVX512F__
    return reinterpret_cast<Lanes>(_mm512_sqrt_pd(reinterpret_cast<__m512d>(a)));
#endif
    Lanes r;
    for (int i = 0; i < lane_count; ++i) r[i] = std::sqrt(a[i]);
    return r;
}

/// A constant in all lanes; the second argument only selects the type.
inline double spread(double a, double) { return a; }
inline Lanes spread(double a, Lanes) { return Lanes{a, a, a, a, a, a, a, a}; }

/// Replaces a by f(lane) in each lane where pick(lane) is true.
template <class Pick, class F>
inline double replace_where(double a, Pick pick, F f, int = 0) {
    return pick(0) ? f(0) : a;
}
template <class Pick, class F>
inline Lanes replace_where(Lanes a, Pick pick, F f, int = 0) {
    for (int i = 0; i < lane_count; ++i)
        if (pick(i)) a[i] = f(i);
    return a;
}

/// The sum of all lanes.
inline double sum_of(const Lanes& a) {
    const auto half = __builtin_shufflevector(a, a, 0, 1, 2, 3) + __builtin_shufflevector(a, a, 4, 5, 6, 7);
    const auto two = __builtin_shufflevector(half, half, 0, 1) + __builtin_shufflevector(half, half, 2, 3);
    return two[0] + two[1];
}

/// The value of one lane.
inline double lane(double a, int) { return a; }
inline double lane(const Lanes& a, int i) { return a[i]; }
/// True if any lane exceeds the limit, or is not a number.
inline bool any_above(double a, double limit) { return !(a <= limit); }
inline bool any_above(const Lanes& a, double limit) {
#ifdef __AVX512F__
    return _mm512_cmp_pd_mask(reinterpret_cast<__m512d>(a), _mm512_set1_pd(limit), _CMP_NLE_UQ) != 0;
#endif
    const auto above = ~(a <= spread(limit, a));
    long long any = 0;
    for (int i = 0; i < lane_count; ++i) any |= above[i];
    return any != 0;
}

/// True if any lane is at or above the limit, or is not a number.
inline bool any_not_below(double a, double limit) { return !(a < limit); }
inline bool any_not_below(const Lanes& a, double limit) {
#ifdef __AVX512F__
    return _mm512_cmp_pd_mask(reinterpret_cast<__m512d>(a), _mm512_set1_pd(limit), _CMP_NLT_UQ) != 0;
#endif
    bool any = false;
    for (int i = 0; i < lane_count; ++i) any |= !(a[i] < limit);
    return any;
}

/// True if a comparison holds in any lane.
inline bool any_true(bool a) { return a; }
template <class Mask>
inline bool any_true(const Mask& a) {
#ifdef __AVX512DQ__
    return _mm512_movepi64_mask(reinterpret_cast<__m512i>(a)) != 0;
#endif
    long long any = 0;
    for (int i = 0; i < lane_count; ++i) any |= a[i];
    return any != 0;
}

/// Swaps lanes 0 and 1, 2 and 3, and so on.
[[gnu::always_inline]] inline Lanes neighbours(const Lanes& a) {
    return __builtin_shufflevector(a, a, 1, 0, 3, 2, 5, 4, 7, 6);
}

/// Combines the even lanes of a with the odd lanes of b.
[[gnu::always_inline]] inline Lanes even_and_odd(const Lanes& a, const Lanes& b) {
    return __builtin_shufflevector(a, b, 0, 9, 2, 11, 4, 13, 6, 15);
}
/// evens copies each even lane to the odd lane after it; odds copies each odd lane to the even lane before it.
[[gnu::always_inline]] inline Lanes evens(const Lanes& a) {
    return __builtin_shufflevector(a, a, 0, 0, 2, 2, 4, 4, 6, 6);
}
[[gnu::always_inline]] inline Lanes odds(const Lanes& a) {
    return __builtin_shufflevector(a, a, 1, 1, 3, 3, 5, 5, 7, 7);
}

/// Transposes an 8 x 8 matrix given by its rows.
[[gnu::always_inline]] inline void transpose(const Lanes (&r)[lane_count], Lanes (&out)[lane_count]) {
    const auto half = [&]<int c>() {  // columns c, c + 2, c + 4, c + 6
        const auto pick = [](const Lanes& a, const Lanes& b) {
            return __builtin_shufflevector(a, b, c, c + 8, c + 2, c + 10, c + 4, c + 12, c + 6, c + 14);
        };
        const auto first = [](const Lanes& a, const Lanes& b) {
            return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
        };
        const auto second = [](const Lanes& a, const Lanes& b) {
            return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
        };
        const auto low = [](const Lanes& a, const Lanes& b) {
            return __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
        };
        const auto high = [](const Lanes& a, const Lanes& b) {
            return __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
        };
        const Lanes rows01 = pick(r[0], r[1]), rows23 = pick(r[2], r[3]), rows45 = pick(r[4], r[5]),
                    rows67 = pick(r[6], r[7]);
        const Lanes upper = first(rows01, rows23), lower = first(rows45, rows67), upper2 = second(rows01, rows23),
                    lower2 = second(rows45, rows67);
        out[c] = low(upper, lower);
        out[c + 2] = low(upper2, lower2);
        out[c + 4] = high(upper, lower);
        out[c + 6] = high(upper2, lower2);
    };
    half.template operator()<0>();
    half.template operator()<1>();
}

/// Loads n numbers from p and sets the other lanes to zero. store_row stores the first n lanes.
template <int n>
inline Lanes load_row(const double* p) {
#ifdef __AVX512F__  // no wider than it must be: an access that crosses from one cache line to the next counts twice
    if constexpr (n == 3) return reinterpret_cast<Lanes>(_mm512_zextpd256_pd512(_mm256_maskz_loadu_pd(7, p)));
    if constexpr (n == 4) return reinterpret_cast<Lanes>(_mm512_zextpd256_pd512(_mm256_loadu_pd(p)));
    if constexpr (n == 6)
        return reinterpret_cast<Lanes>(_mm512_insertf64x4(_mm512_zextpd256_pd512(_mm256_loadu_pd(p)),
                                                          _mm256_zextpd128_pd256(_mm_loadu_pd(p + 4)), 1));
    return reinterpret_cast<Lanes>(_mm512_maskz_loadu_pd((1 << n) - 1, p));
#else
    Lanes v{};
    for (int i = 0; i < n; ++i) v[i] = p[i];
    return v;
#endif
}
template <int n>
inline void store_row(double* p, const Lanes& v) {
#ifdef __AVX512F__
    const __m512d w = reinterpret_cast<__m512d>(v);
    if constexpr (n == 4) return _mm256_storeu_pd(p, _mm512_castpd512_pd256(w));
    if constexpr (n == 6)
        return _mm256_storeu_pd(p, _mm512_castpd512_pd256(w)),
               _mm_storeu_pd(p + 4, _mm256_castpd256_pd128(_mm512_extractf64x4_pd(w, 1)));
    if constexpr (n == 3)
        return _mm_storeu_pd(p, _mm512_castpd512_pd128(w)),
               _mm_store_sd(p + 2, _mm256_extractf128_pd(_mm512_castpd512_pd256(w), 1));
    _mm512_mask_storeu_pd(p, (1 << n) - 1, w);
#else
    for (int i = 0; i < n; ++i) p[i] = v[i];
#endif
}

/// Adds the first six lanes to the numbers at p, in stores of four and two: the next element at the same node would
/// have to wait for a masked store.
inline void add_six(double* p, const Lanes& v) {
    using Four __attribute__((vector_size(32), aligned(8), may_alias)) = double;
    using BarPair __attribute__((vector_size(16), aligned(8), may_alias)) = double;
    *reinterpret_cast<Four*>(p) += Four{v[0], v[1], v[2], v[3]};
    *reinterpret_cast<BarPair*>(p + 4) += BarPair{v[4], v[5]};
}

/// Gathers n numbers of each of eight nodes or elements into n vectors. Rows lie `stride` numbers apart; they are read
/// whole and transposed.
template <int n>
[[gnu::always_inline]] inline void pick_rows(const double* from, const int* index, int stride,
                                             Lanes (&out)[lane_count]) {
    Lanes row[lane_count];
    for (int i = 0; i < lane_count; ++i) row[i] = load_row<n>(from + index[i] * stride);
    transpose(row, out);
}

/// Gathers n numbers of each of eight consecutive rows into n vectors. If there are fewer rows, the last one is
/// repeated.
template <int n>
[[gnu::always_inline]] inline void transpose_rows(const double* from, int rows, Lanes (&out)[lane_count]) {
    Lanes row[lane_count];
    for (int i = 0; i < lane_count; ++i) row[i] = load_row<n>(from + n * (i < rows ? i : rows - 1));
    transpose(row, out);
}

}  // namespace hinge

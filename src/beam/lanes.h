// One element or eight at once: the scalar that the element kernels are written in, and triples of it.
//
// A kernel is a template over Real: `double` for one element, `Lanes` for a block of eight (one vector register). Both do
// the same operations in the same order, so an element's bits do not depend on the company it keeps.
#pragma once

#include <cmath>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

namespace hinge::beam {

inline constexpr int lane_count = 8;
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));

inline double square_root(double a) { return std::sqrt(a); }
inline Lanes square_root(Lanes a) {
#ifdef __AVX512F__
    return reinterpret_cast<Lanes>(_mm512_sqrt_pd(reinterpret_cast<__m512d>(a)));
#endif
    Lanes r;
    for (int i = 0; i < lane_count; ++i) r[i] = std::sqrt(a[i]);
    return r;
}

inline double spread(double a, double) { return a; }
inline Lanes spread(double a, Lanes) { return Lanes{a, a, a, a, a, a, a, a}; }

/// f(lane) for each lane in which `pick` holds; the other lanes keep `a`.
template <class Pick, class F>
inline double replace_where(double a, Pick pick, F f, int = 0) { return pick(0) ? f(0) : a; }
template <class Pick, class F>
inline Lanes replace_where(Lanes a, Pick pick, F f, int = 0) {
    for (int i = 0; i < lane_count; ++i)
        if (pick(i)) a[i] = f(i);
    return a;
}

inline double lane(double a, int) { return a; }
inline double lane(const Lanes& a, int i) { return a[i]; }
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

/// Whether any lane is not below the limit (a lane that is no number is not).
inline bool any_not_below(double a, double limit) { return !(a < limit); }
inline bool any_not_below(const Lanes& a, double limit) {
#ifdef __AVX512F__
    return _mm512_cmp_pd_mask(reinterpret_cast<__m512d>(a), _mm512_set1_pd(limit), _CMP_NLT_UQ) != 0;
#endif
    bool any = false;
    for (int i = 0; i < lane_count; ++i) any |= !(a[i] < limit);
    return any;
}

/// One number of each of eight nodes or elements, `stride` numbers apart. A gather, where the processor has one: numbers put one by
/// one into a vector go through memory, and the vector waits for all of them.
inline Lanes pick(const double* from, const int* index, int stride) {
#ifdef __AVX512F__
    const __m256i at = _mm256_mullo_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(index)), _mm256_set1_epi32(stride));
    return reinterpret_cast<Lanes>(_mm512_i32gather_pd(at, from, 8));
#else
    Lanes v;
    for (int i = 0; i < lane_count; ++i) v[i] = from[index[i] * stride];
    return v;
#endif
}

/// Puts them back.
inline void put(double* to, const int* index, int stride, const Lanes& v) {
#ifdef __AVX512F__
    const __m256i at = _mm256_mullo_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(index)), _mm256_set1_epi32(stride));
    _mm512_i32scatter_pd(to, at, reinterpret_cast<__m512d>(v), 8);
#else
    for (int i = 0; i < lane_count; ++i) to[index[i] * stride] = v[i];
#endif
}

template <class Real>
struct Triple {
    Real x, y, z;
};

template <class Real> inline Triple<Real> operator+(const Triple<Real>& a, const Triple<Real>& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <class Real> inline Triple<Real> operator-(const Triple<Real>& a, const Triple<Real>& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <class Real> inline Triple<Real> operator*(const Real& s, const Triple<Real>& a) { return {s * a.x, s * a.y, s * a.z}; }
template <class Real> inline Real dot(const Triple<Real>& a, const Triple<Real>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class Real> inline Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace hinge::beam

// Products of 6x6 blocks with six numbers a node, as vectors of eight.
#pragma once

#include <cstring>

#include "core/lanes.h"
#include "core/types.h"

namespace hinge::blocks {

/// A vector of eight doubles read from an array with six per node; the last two belong to the next node and are masked
/// out. Arrays end with room for two more.
using Wide = LanesAnywhere;
constexpr Wide six = {1, 1, 1, 1, 1, 1, 0, 0};

/// Numbers per node in vectors that are read and written in turn, the last two unused: a load of eight over two stores
/// of six waits until both have left the core.
constexpr int stride = 8;

inline Wide load(const double* p) { return *reinterpret_cast<const Wide*>(p); }
/// Reads eight numbers in single precision.
inline Wide load(const float* p) {
#ifdef __AVX512F__
    return reinterpret_cast<Wide>(_mm512_cvtps_pd(_mm256_loadu_ps(p)));  // the compiler makes two halves of it
#endif
    using Narrow __attribute__((vector_size(32), aligned(4), may_alias)) = float;
    return __builtin_convertvector(*reinterpret_cast<const Narrow*>(p), Wide);
}
/// Reads six numbers and none behind them.
inline Wide load_six(const double* p) {
#ifdef __AVX512F__
    return reinterpret_cast<Wide>(_mm512_maskz_loadu_pd(0x3f, p));
#endif
    Wide v{};
    std::memcpy(&v, p, 6 * sizeof(double));
    return v;
}
inline void store_six(double* p, const Wide& v) { std::memcpy(p, &v, 6 * sizeof(double)); }
inline void store(double* p, const Wide& v) { *reinterpret_cast<Wide*>(p) = v; }
inline double sum(const Wide& v) { return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7])); }

/// Four numbers: a column of a 3x3 block, and a zero.
using Narrow __attribute__((vector_size(4 * sizeof(double)), aligned(8), may_alias)) = double;
inline Narrow load_narrow(const double* p) { return *reinterpret_cast<const Narrow*>(p); }
inline Wide widened(const Narrow& v) { return __builtin_shufflevector(v, Narrow{}, 0, 1, 2, 3, 4, 5, 6, 7); }

/// Product of a row of blocks and a vector, as two independent sums: neither waits for the other.
struct Row {
    Wide even = {}, odd = {};
    /// Adds B x for a 6x6 block stored by columns.
    template <class Number>
    void add(const Number* B, const double* x) {
        even += load(B) * x[0];
        odd += load(B + 6) * x[1];
        even += load(B + 12) * x[2];
        odd += load(B + 18) * x[3];
        even += load(B + 24) * x[4];
        odd += load(B + 30) * x[5];
    }
    Wide sum() const { return even + odd; }
};

/// B x.
template <class Number>
inline Wide times(const Number* B, const double* x) {
    Row row;
    row.add(B, x);
    return row.sum();
}

/// Product B^T x; x is masked: its last two numbers are zero.
template <class Number>
inline Wide times_transposed(const Number* B, const Wide& x) {
    const Wide p0 = load(B) * x, p1 = load(B + 6) * x, p2 = load(B + 12) * x, p3 = load(B + 18) * x,
               p4 = load(B + 24) * x, p5 = load(B + 30) * x;
    const auto by_twos = [](const Wide& a, const Wide& b) {
        return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14) +
               __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    };
    const auto by_fours = [](const Wide& a, const Wide& b) {
        return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13) +
               __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    };
    const Wide s45 = by_twos(p4, p5), q = by_fours(by_twos(p0, p1), by_twos(p2, p3)), r = by_fours(s45, s45);
    return __builtin_shufflevector(q, r, 0, 1, 2, 3, 8, 9, 8, 9) +
           __builtin_shufflevector(q, r, 4, 5, 6, 7, 12, 13, 12, 13);
}

}  // namespace hinge::blocks

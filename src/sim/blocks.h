// Products of 6x6 blocks with six numbers a node, as vectors of eight.
#pragma once

#include <cstring>

#include "core/types.h"

namespace hinge::blocks {

/// Eight doubles from a place in an array of sixes; of a node's six, the last two belong to the next node and are masked out.
/// Arrays end with room for two more.
using Wide = double __attribute__((vector_size(64), aligned(8), may_alias));
constexpr Wide six = {1, 1, 1, 1, 1, 1, 0, 0};

inline Wide load(const double* p) { return *reinterpret_cast<const Wide*>(p); }
inline void store_six(double* p, const Wide& v) { std::memcpy(p, &v, 6 * sizeof(double)); }
inline double sum(const Wide& v) { return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7])); }

/// B x for a 6x6 block stored by columns.
inline Wide times(const double* B, const double* x) {
    Wide even = load(B) * x[0], odd = load(B + 6) * x[1];
    even += load(B + 12) * x[2];
    odd += load(B + 18) * x[3];
    even += load(B + 24) * x[4];
    odd += load(B + 30) * x[5];
    return even + odd;
}

/// The inverse of a symmetric positive matrix from its 3x3 quarters, which Eigen inverts without loops.
inline Mat6 inverse_by_halves(const Mat6& A) {
    const Mat3 P = A.topLeftCorner<3, 3>().inverse(), Q = A.topRightCorner<3, 3>(), PQ = P * Q;
    const Mat3 S = (A.bottomRightCorner<3, 3>() - Q.transpose() * PQ).inverse();
    Mat6 out;
    out.topRightCorner<3, 3>() = -PQ * S;
    out.topLeftCorner<3, 3>() = P - out.topRightCorner<3, 3>() * PQ.transpose();
    out.bottomLeftCorner<3, 3>() = out.topRightCorner<3, 3>().transpose();
    out.bottomRightCorner<3, 3>() = S;
    return 0.5 * (out + out.transpose());
}

}  // namespace hinge::blocks

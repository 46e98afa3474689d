// Small systems of equations with a positive definite matrix. At these sizes plain loops beat a library's blocks.
#pragma once

#include <Eigen/Core>

namespace hinge {

/// x of A x = b, by A = L D L^T without a choice of pivots. `A` is lost; `b` becomes x. False: A is not positive
/// definite.
template <int n>
inline bool solve_positive(Eigen::Matrix<double, n, n>& A, Eigen::Matrix<double, n, 1>& b) {
    for (int j = 0; j < n; ++j) {
        if (!(A(j, j) > 0)) return false;
        const double inverse = 1 / A(j, j);
        for (int i = j + 1; i < n; ++i) {
            const double l = A(i, j) * inverse;
            for (int k = i; k < n; ++k) A(k, i) -= l * A(k, j);
            b[i] -= l * b[j];
        }
    }
    for (int j = n - 1; j >= 0; --j) {
        double sum = b[j];
        for (int i = j + 1; i < n; ++i) sum -= A(i, j) * b[i];
        b[j] = sum / A(j, j);
    }
    return true;
}

}  // namespace hinge

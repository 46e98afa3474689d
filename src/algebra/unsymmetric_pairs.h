// Lowest eigenvalues of K x = v M x where K is not symmetric, of small matrices.
#pragma once

#include <complex>

#include "algebra/eigenpairs.h"

namespace hinge {

struct UnsymmetricPairs {
    std::vector<std::complex<double>> values;  ///< by rising real part; of a pair a + ib, a - ib both
    Eigen::MatrixXd vectors;                   ///< columns, of x . M x = 1; real parts
};

/// The `wanted` values of the lowest real part. K has all its entries, M the lower half. K + a M is regular: with a
/// symmetric part that is positive definite it is, and no value has a real part below -a (Bendixson). By dense matrices
/// of (K + a M)^-1, in which the lowest values have the digits, and a time of size^3.
UnsymmetricPairs lowest_of_unsymmetric(const SparseMatrix& K, const SparseMatrix& M, double a, int wanted);

/// Most unknowns: ten seconds.
inline constexpr int most_unsymmetric = 2000;

/// How much the part of K that is not symmetric changes the values of the symmetric one, at most, as a part of
/// |value| + a; `found`: those of the symmetric part, with vectors. By second-order perturbation, with the pairs of
/// values in it that are close.
double change_by_unsymmetric(const SparseMatrix& K, const SparseMatrix& symmetric, const SparseMatrix& M, double a,
                             const Eigenpairs& found);

}  // namespace hinge

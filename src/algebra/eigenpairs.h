// Lowest eigenvalues of K x = v M x, with their vectors, by Spectra's Lanczos method.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace hinge {

/// Indices unlike those of direct_factors.h: what Eigen compiles for it is then another template (see there).
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::ptrdiff_t>;

struct Eigenpairs {
    std::vector<double> values;  ///< rising
    Eigen::MatrixXd vectors;     ///< columns, of x . M x = 1; none where they were not asked for
};

/// The `wanted` values nearest to -a, of matrices given by their lower halves. K + a M is to be regular; where it is
/// positive definite they are the lowest. K and M have traces near 1: Spectra compares with fixed small numbers. The
/// pivots of K - v M count how many there must be below the last one, a millionth aside, so that no copy of a repeated
/// value is missing. Throws std::runtime_error if it does not converge.
///
/// Unknowns on which M does not act have values that are infinite: there are no more pairs than M has others. They are
/// condensed statically, and the vectors have them as the stiffness moves them.
Eigenpairs lowest_eigenpairs(const SparseMatrix& K, const SparseMatrix& M, double a, int wanted, bool with_vectors);

/// Of a small symmetric matrix; its lower half counts.
double largest_eigenvalue(const Eigen::MatrixXd& symmetric);

/// Number of negative pivots of a symmetric matrix, given by its lower half. Throws std::runtime_error where it is
/// singular.
int negative_pivots(const SparseMatrix& K);

/// x of K x = right. Throws std::runtime_error where K is singular.
Eigen::VectorXd solution(const SparseMatrix& K, const Eigen::VectorXd& right);

/// Vectors of the `count` eigenvalues of K nearest to zero, by inverse iteration; columns of length 1. K is regular.
Eigen::MatrixXd vectors_next_to_zero(const SparseMatrix& K, int count);

}  // namespace hinge

// The matrix and the factors of DirectFactors as Eigen has them. Only for direct_factors.cpp and direct_solution.cpp.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <vector>

#include "algebra/direct_factors.h"

// The dense triangles of SparseLU, without fused products: direct_factors.cpp has them.
// NOLINTNEXTLINE(bugprone-macro-parentheses): a keyword, or nothing
#define HINGE_TRIANGLES(keyword)                                                                                     \
    keyword template struct Eigen::internal::triangular_solve_vector<double, double, Eigen::Index, Eigen::OnTheLeft, \
                                                                     Eigen::Upper, false, Eigen::ColMajor>;          \
    keyword template struct Eigen::internal::triangular_solve_vector<double, double, Eigen::Index, Eigen::OnTheLeft, \
                                                                     Eigen::UnitLower, false, Eigen::ColMajor>;
HINGE_TRIANGLES(extern)

namespace hinge {

struct DirectFactors::Factors {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd diagonal;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt;
    /// SparseLU takes the place of each column, where AMDOrdering tells which column has a place.
    struct Ordering {
        using PermutationType = Eigen::AMDOrdering<int>::PermutationType;
        template <class Matrix>
        void operator()(const Matrix& A, PermutationType& place) const {
            PermutationType columns;
            Eigen::AMDOrdering<int>()(A, columns);
            place = columns.inverse();
        }
    };
    /// Ordered by its pattern, which is symmetric even where the values are not.
    using Unsymmetric = Eigen::SparseLU<Eigen::SparseMatrix<double>, Ordering>;
    std::unique_ptr<Unsymmetric> lu;
};

}  // namespace hinge

// The matrix and the factors of DirectFactors as Eigen has them. Only for direct_factors.cpp and direct_solution.cpp.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <vector>

#include "algebra/direct_factors.h"

namespace hinge {

struct DirectFactors::Factors {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd diagonal;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt;
    std::unique_ptr<Eigen::SparseLU<Eigen::SparseMatrix<double>>> lu;
};

}  // namespace hinge

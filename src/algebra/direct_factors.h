// Sparse direct factors of a symmetric or unsymmetric matrix of six rows a node, by Eigen.
//
// Eigen's sparse solvers are templates that take seconds to compile, so no other file includes them: they stand in
// direct_factors_eigen.h. Where two files compile the same template with different options, the linker takes one of the
// two, and the last bits of every static result would hang on the order in which files are linked. So the factors are
// made in direct_factors.cpp, without fused products like nearly all of the engine; the solution is in
// direct_solution.cpp, which is compiled with them (CMakeLists.txt).
#pragma once

#include <memory>

#include "core/types.h"

namespace hinge {

class DirectFactors {
public:
    explicit DirectFactors(bool unsymmetric);
    ~DirectFactors();

    /// Adds a 6x6 block of the matrix at these nodes; blocks at the same place add up. Of a symmetric matrix the lower
    /// half counts.
    void add(int row_node, int column_node, const Mat6& block);
    /// Factorises what was added since the last call, a matrix of that many nodes. False when it is singular.
    bool factorise(int nodes);
    bool good() const;
    /// x = A^-1 right, six numbers a node. False where x is not finite.
    bool solve(const double* right, double* x, int nodes) const;
    /// Of the symmetric factors: the degree of freedom (6 node + component) whose pivot is the smallest part, below
    /// `ratio`, of its diagonal entry: it can move with next to no resistance. -1 when there is none.
    int loosest_degree_of_freedom(double ratio) const;
    /// Of the symmetric factors: how many eigenvalues of the matrix are negative. Pivots within rounding of zero, 1e-12
    /// of their diagonal entry, count as positive.
    int negative_pivots() const;
    /// Of the symmetric factors: x with x^T A x < 0, by the last negative pivot. Empty where there is none.
    Eigen::VectorXd negative_direction() const;
    /// Of the unsymmetric factors: whether the determinant is negative, an odd number of its eigenvalues.
    bool negative_determinant() const;

private:
    struct Factors;
    bool unsymmetric_;
    std::unique_ptr<Factors> factors_;
};

}  // namespace hinge

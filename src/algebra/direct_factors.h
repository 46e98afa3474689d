// Sparse direct factors of a symmetric or unsymmetric matrix of six rows a node, by Eigen.
//
// Eigen's sparse solvers are templates that take seconds to compile, so no other file includes them: they are in
// direct_factors_eigen.h. The factors are made in direct_factors.cpp, without fused products like nearly all of the
// engine; the solution is in direct_solution.cpp, which is compiled with them (fused_files in CMakeLists.txt).
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
    /// Factorises the matrix added since the last call, of that many nodes. False when it is singular.
    bool factorise(int nodes);
    bool good() const;
    /// Solves x = A^-1 right, six numbers a node. False where x is not finite.
    bool solve(const double* right, double* x, int nodes) const;
    /// The degree of freedom (6 node + component) that moves with next to no resistance: its pivot is the smallest
    /// part, below `ratio`, of its diagonal entry. -1 if there is none. Symmetric factors.
    int loosest_degree_of_freedom(double ratio) const;
    /// Number of negative eigenvalues, from the symmetric factors. Pivots within rounding of zero, 1e-12 of their
    /// diagonal entry, count as positive.
    int negative_pivots() const;
    /// A vector x with x^T A x < 0, from the last negative pivot; empty if none. Symmetric factors.
    Eigen::VectorXd negative_direction() const;
    /// True if the determinant is negative (odd number of negative eigenvalues). Unsymmetric factors.
    bool negative_determinant() const;
    /// How many numbers the factors hold: of L, or of L and U.
    long size() const;

private:
    struct Factors;
    bool unsymmetric_;
    std::unique_ptr<Factors> factors_;
};

}  // namespace hinge

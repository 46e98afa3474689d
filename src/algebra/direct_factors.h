// Sparse direct factors of a symmetric or unsymmetric matrix of six rows a node, by Eigen.
//
// Eigen's sparse solvers are templates. Where two files compile the same template with different options, the linker
// takes one of the two, and the last bits of every static result would hang on the order in which files are linked. So
// each template stands in one kind of file: factors are made in direct_factors.cpp, without fused products like nearly
// all of the engine; solve() is only for effective_stiffness.cpp, which is compiled with them (CMakeLists.txt).
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <memory>
#include <vector>

#include "core/types.h"

namespace hinge {

class DirectFactors {
public:
    explicit DirectFactors(bool unsymmetric) : unsymmetric_(unsymmetric) {}

    /// Adds a 6x6 block of the matrix at these nodes; blocks at the same place add up. Of a symmetric matrix the lower
    /// half counts.
    void add(int row_node, int column_node, const Mat6& block);
    /// Factorises what was added since the last call, a matrix of that many nodes. False when it is singular.
    bool factorise(int nodes);
    bool good() const { return unsymmetric_ ? lu_ && lu_->info() == Eigen::Success : ldlt_.info() == Eigen::Success; }
    /// x = A^-1 right, six numbers a node. False where x is not finite.
    bool solve(const double* right, double* x, int nodes) const {
        const Eigen::Map<const Eigen::VectorXd> b(right, 6 * nodes);
        Eigen::Map<Eigen::VectorXd> out(x, 6 * nodes);
        if (unsymmetric_) out = lu_->solve(b);
        else out = ldlt_.solve(b);
        return out.allFinite();
    }
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
    bool unsymmetric_;
    std::vector<Eigen::Triplet<double>> entries_;
    Eigen::VectorXd diagonal_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt_;
    std::unique_ptr<Eigen::SparseLU<Eigen::SparseMatrix<double>>> lu_;
};

}  // namespace hinge

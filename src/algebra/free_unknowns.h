// Sparse symmetric matrices of the degrees of freedom that can move, with linear constraints eliminated.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "algebra/eigenpairs.h"
#include "model/linear_constraint.h"

namespace hinge {

class FreeUnknowns {
public:
    using Triplets = std::vector<Eigen::Triplet<double>>;

    /// `free`: of each node, the bits of its degrees of freedom that can move. Constraints of degrees of freedom that
    /// cannot move count for nothing.
    FreeUnknowns(const std::vector<std::uint8_t>& free, const std::vector<LinearConstraint>& constraints);
    /// Number of unknowns that are left where constraints are eliminated.
    int size() const { return int(T_.cols()); }

    /// Adds the symmetric part of a block, 6 x 6 of node a or 12 x 12 of both nodes: its lower half.
    template <class Block>
    void add(Triplets& to, int a, int b, const Block& block) const {
        for (int i = 0; i < block.rows(); ++i)
            for (int j = 0; j < block.cols(); ++j) {
                const int row = place_[std::size_t(6 * (i < 6 ? a : b) + i % 6)],
                          column = place_[std::size_t(6 * (j < 6 ? a : b) + j % 6)];
                if (row >= column && column >= 0 && block(i, j) != 0)
                    to.emplace_back(row, column, 0.5 * (block(i, j) + block(j, i)));
            }
    }
    /// Adds all of a block, which need not be symmetric: for `reduced_unsymmetric`.
    template <class Block>
    void add_unsymmetric(Triplets& to, int a, int b, const Block& block) const {
        for (int i = 0; i < block.rows(); ++i)
            for (int j = 0; j < block.cols(); ++j) {
                const int row = place_[std::size_t(6 * (i < 6 ? a : b) + i % 6)],
                          column = place_[std::size_t(6 * (j < 6 ? a : b) + j % 6)];
                if (row >= 0 && column >= 0 && block(i, j) != 0) to.emplace_back(row, column, block(i, j));
            }
    }
    /// Adds a block between two nodes, and its transposed.
    void add_between(Triplets& to, int a, int b, const Mat6& block) const;

    SparseMatrix whole(const Triplets& of) const;                ///< of all degrees of freedom that can move
    SparseMatrix reduced(const Triplets& of) const;              ///< T^T A T, its lower half
    SparseMatrix reduced_unsymmetric(const Triplets& of) const;  ///< T^T A T, all of it
    /// The motion of all nodes, of a vector of unknowns: m and rad.
    std::vector<Vec6> at_nodes(const Eigen::VectorXd& x) const;
    /// The motion of nodes, and a unit displacement along an axis, as vectors of all degrees of freedom that can move.
    Eigen::VectorXd of_nodes(const std::vector<Vec6>& motion) const;
    Eigen::VectorXd along(int axis) const { return of_nodes(std::vector<Vec6>(place_.size() / 6, Vec6::Unit(axis))); }

private:
    int rows_ = 0;
    std::vector<int> place_;  ///< of each degree of freedom: its row, or -1
    SparseMatrix T_;          ///< what moves, from the unknowns
};

}  // namespace hinge

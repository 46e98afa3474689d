// The left side of a step: A = m M + k K by blocks of 6x6, rebuilt only where something changed, and its solution by
// conjugate gradients on the joints (condensed.h), with each one's own block as preconditioner.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <memory>
#include <vector>

#include "sim/condensed.h"
#include "sim/sweep.h"

namespace hinge {

struct SolverSettings {
    bool direct = false;        ///< sparse LDLT in place of conjugate gradients
    double tolerance = 1e-8;    ///< of the residual, relative to the right side, in the norm of the preconditioner
    int max_iterations = 500;
    double floor = 0;           ///< of r . A^-1 r: below it nothing is left to solve
};

struct SolveReport { int iterations = 0; bool converged = true; };

class Operator {
public:
    Operator(const Structure& structure, double mass_factor, double stiffness_factor, bool geometric);

    /// Builds the part of these elements for the state at `pose`; `tangents` gives dp/dd of those that yield (null: elastic).
    void build(const std::vector<int>& elements, const State& state, const Pose& pose, const std::vector<const Mat6*>& tangents);
    /// Keeps the tangent's unsymmetric part too (an applied moment is not conservative); solved directly, by LU.
    void keep_unsymmetric() { unsymmetric_ = true; }
    /// For a direct solver: initial stress stays in, whatever it does to an element's part.
    void allow_indefinite() { keep_positive_ = false; }
    void remove(int element);
    /// Replaces everything that joins nodes beside the elements: bonds (12x12, already a stiffness) and hung masses.
    struct Coupling { int a, b; Mat12 K; };
    void set_couplings(std::vector<Coupling> couplings);
    void set_hung(int node, const Mat6& mass);
    void set_held(const std::vector<std::uint8_t>& held);   ///< rows and columns taken out; all elements are marked for assembly

    /// Sums what changed into the blocks.
    void assemble();
    SolveReport solve(const std::vector<Vec6>& right, std::vector<Vec6>& x, const SolverSettings& settings);
    /// y = A x for arrays of six a node, two numbers of room behind them. Returns x . y.
    double multiply(const double* x, double* y) const;
    /// Factorises A as it stands. False when it is singular.
    bool factorise();
    /// After factorise: the freedom (6 node + component) that can move with next to no resistance, -1 when there is none.
    int loosest_freedom(double ratio) const;
    const Mat12& element_part(int element) const { return part_[element]; }

    struct Counts { long built = 0, iterations = 0, solves = 0, factorisations = 0; };
    const Counts& counts() const { return counts_; }

private:
    void mark(int node);
    void condense();
    double add_couplings(const double* x, double* y) const;
    SolveReport solve_iteratively(const double* right, double* solution, const SolverSettings& settings);
    Mat6 masked(int a, int b, const Mat6& block) const;

    const Structure& structure_;
    double mass_factor_, stiffness_factor_;
    bool geometric_;
    std::vector<std::uint8_t> held_;
    std::vector<Mat12> part_;                   // of each element, unmasked
    std::vector<Mat6> hung_;                    // of each node, empty if none
    std::vector<Coupling> couplings_;
    // block rows: diagonal first
    std::vector<int> row_, column_;             // row_[i]..row_[i+1]
    std::vector<double> value_;                 // 36 a block, column major, padded at the end
    std::vector<std::array<int, 2>> slot_;      // of each element: (1,2) and (2,1)
    std::unique_ptr<Condensed> condensed_;
    std::vector<int> stale_;                    // nodes whose rows changed since condensed_ saw them
    std::vector<Mat6> inverse_;                 // of each diagonal block of what is left, couplings included
    long arrangement_ = -1;                     // of condensed_, for which inverse_ is laid out
    std::vector<int> dirty_;
    std::vector<char> is_dirty_;
    bool factor_valid_ = false;
    bool unsymmetric_ = false, keep_positive_ = true;
    std::unique_ptr<Eigen::SparseLU<Eigen::SparseMatrix<double>>> lu_;
    Eigen::VectorXd diagonal_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
    std::vector<double> x_, r_, z_, d_, q_;         // six a node, padded at the end
    Counts counts_;
};

}  // namespace hinge

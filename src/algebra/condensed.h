// Conjugate gradients with condensed inner nodes and two colours of joints.
//
// An inner node of a member has two neighbours. Every other one (`between`) is condensed exactly,
//   S = A_kk - A_km A_mm^-1 A_mk,   x_m = A_mm^-1 (r_m - A_mk x_k),
// which leaves the joints alone if a member has two elements. Of these, a walk over the frame colours as many `red` as
// it finds without two neighbours, the rest `black`. Every vector satisfies the red rows, d_r = -D_r^-1 S_rb d_b, so
// the iteration runs on the black nodes: it has the same cost per product and half as many steps (Reid 1972), each time
// for half of the vectors.
#pragma once

#include <vector>

#include "core/large_pages.h"
#include "core/thread_pool.h"
#include "algebra/coupled_rows.h"
#include "algebra/element_matrices.h"

namespace hinge {

struct SolverSettings {
    bool direct = false;      ///< sparse LDLT in place of conjugate gradients
    double tolerance = 1e-8;  ///< of the residual, relative to the right side, in the norm of the preconditioner
    int max_iterations = 500;
    double floor = 0;  ///< of r . A^-1 r: the iteration ends below it
};

struct SolveReport {
    int iterations = 0;
    bool converged = true;
    bool indefinite = false;  ///< not converged because d . A d <= 0 for the search direction d (Condensed::direction)
};

/// Solver of A x = b. Number: type of the blocks; vectors are double.
template <class Number>
class Condensed {
public:
    Condensed(const Structure& structure, ThreadPool& pool);

    /// Sets the couplings, held degrees of freedom removed. Their nodes are not condensed; nodes whose rows must be
    /// renewed for this are added to `changed`.
    void couple(const std::vector<Coupling>& couplings, std::vector<int>& changed);
    /// Excludes these nodes: their right side is zero and nothing couples them to others.
    void leave_out(const std::vector<int>& resting);
    /// Recomputes all that depends on the blocks of these nodes (each once, rising).
    void renew(const std::vector<int>& nodes, const ElementMatrices& parts);
    /// Solves A x = right by preconditioned conjugate gradients from x = 0; six numbers a node.
    SolveReport solve(const double* right, double* x, const SolverSettings& settings);
    /// Search direction d with d . A d <= 0 of an indefinite solution, six numbers a node.
    void direction(double* d) const;

private:
    enum class Colour : char { between, red, black };
    struct Bridge {
        int first, a, b, middle;  ///< first element of the pair; its outer nodes and its middle one
        Mat6 K;
        void add_to(CoupledRows& rows, const std::vector<int>& place) const {
            rows.add(place[a], place[b], K), rows.add(place[b], place[a], K.transpose());
        }
    };
    struct CondensedNode {
        int node, count;         ///< number of its neighbours, 0 to 2
        int side[2];             ///< its neighbours
        int element[2];          ///< that joins it to that neighbour
        bool excluded = false;   ///< coupled, so not condensed
        Number inverse[38];      ///< A_mm^-1; blocks are read two numbers past their end
        Number coupling[2][38];  ///< A_mm^-1 A_m,side
    };

    void paint();
    void lay_out();
    std::vector<CoupledRows::Pair> coupled_pairs() const;
    void take_couplings();
    void renew_between(CondensedNode& m, const ElementMatrices& parts) const;
    void renew_row(int place, const ElementMatrices& parts);
    void renew_inverse(int place);
    void reduce(const double* right);
    void solve_back(const double* right, double* x) const;
    double multiply();
    void add_row(blocks::Row& row, int place, int from, const double* x) const;
    void keep_worst_block();
    void follow(double alpha);
    double begin_iterations();
    double step_along(double alpha);
    void turn_direction(double beta);
    int far(int place, int entry) const;
    int pair_about(int node) const;
    int joints() const { return int(colour_.size()); }
    bool takes_part(int node) const { return resting_.empty() || resting_[node] < 0; }

    const Structure& structure_;
    ThreadPool& pool_;
    LargeVector<CondensedNode> between_;
    std::vector<int> which_;      ///< of each node: its place in between_, -1
    std::vector<Colour> colour_;  ///< of each joint's place, while it is not coupled
    std::vector<Coupling> couplings_;
    std::vector<int> coupled_;     ///< nodes, rising
    std::vector<Bridge> bridges_;  ///< of pairs whose middle node is coupled: such a node is not taken out
    // rows of S: the joints', in order, and behind them those of coupled nodes that would be `between`
    std::vector<int> order_, place_;  ///< node of each place; place of each node, -1
    // rows in compressed form (CSR); the first entry of a row is its own block, the others one for each element there
    std::vector<int> row_begin_;        ///< of each place: its first entry
    std::vector<int> column_;           ///< of each entry: place of its column; its own if zero (without far node)
    std::vector<int> condensed_side_;   ///< of each entry through a condensed node: 2 index in between_ + side; else -1
    LargeVector<Number> value_;         ///< of each entry, 36
    CoupledRows coupled_rows_;          ///< what couplings and bridges add to these rows
    LargeVector<Number> inverse_;       ///< of each place, 36: of its own block, couplings included
    std::vector<int> red_, black_;      ///< places of active rows
    std::vector<int> staying_, going_;  ///< likewise: places of all that stay; of between_ that are taken out
    std::vector<int> resting_;          ///< of each node, not negative where it does not take part; empty: all do
    LargeVector<double> x_, r_, d_, q_;  ///< eight a place; q: S d, then the preconditioned r
};

extern template class Condensed<float>;
extern template class Condensed<double>;

}  // namespace hinge

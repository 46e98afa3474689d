// The system that conjugate gradients work on, and they themselves: a frame's nodes in three colours.
//
// A member's inner nodes hang between two neighbours each. Every other one of them (`between`) is taken out exactly,
//   S = A_kk - A_km A_mm^-1 A_mk,   x_m = A_mm^-1 (r_m - A_mk x_k),
// which leaves, at two elements a member, the joints alone. Of those, `red` are as many as a walk finds without two
// being neighbours, the rest `black`. Every vector is held where the red rows are zero, d_r = -D_r^-1 S_rb d_b, so that
// the iteration is one on the black nodes: it costs the same product and takes half as many steps (Reid 1972), each
// time for half of the vectors.
#pragma once

#include <vector>

#include "core/large_pages.h"
#include "core/thread_pool.h"
#include "algebra/element_matrices.h"

namespace hinge {

struct SolverSettings {
    bool direct = false;      ///< sparse LDLT in place of conjugate gradients
    double tolerance = 1e-8;  ///< of the residual, relative to the right side, in the norm of the preconditioner
    int max_iterations = 500;
    double floor = 0;  ///< of r . A^-1 r: below it nothing is left to solve
};

struct SolveReport {
    int iterations = 0;
    bool converged = true;
    bool indefinite = false;  ///< not converged because d . A d <= 0 for the search direction d (Condensed::direction)
};

/// Number: of the blocks; vectors are double.
template <class Number>
class Condensed {
public:
    Condensed(const Structure& structure, ThreadPool& pool);

    /// These couplings, with what is held taken out. Their nodes stay, whatever else they are; nodes whose rows must be
    /// renewed for it are added to `changed`.
    void couple(const std::vector<Coupling>& couplings, std::vector<int>& changed);
    /// Passes over these nodes, whose right side is zero and which nothing couples to others.
    void leave_out(const std::vector<int>& resting);
    /// Renews what depends on the blocks of these nodes (each once, rising).
    void renew(const std::vector<int>& nodes, const ElementMatrices& parts);
    /// A x = right by preconditioned conjugate gradients from x = 0; six numbers a node.
    SolveReport solve(const double* right, double* x, const SolverSettings& settings);
    /// After a solution that ended as indefinite: d with d . A d <= 0, six numbers a node.
    void direction(double* d) const;

private:
    enum class Colour : char { between, red, black };
    struct CondensedNode {
        int node, count;  ///< of its neighbours, 0 to 2
        int side[2];      ///< which they are
        int element[2];   ///< that leads there
        bool kept = false;
        Number inverse[38];  ///< A_mm^-1; blocks are read two numbers past their end
        Number pull[2][38];  ///< A_mm^-1 A_m,side
    };

    void paint();
    void lay_out();
    void renew_between(CondensedNode& m, const ElementMatrices& parts) const;
    void renew_row(int place, const ElementMatrices& parts);
    void renew_inverse(int place);
    void reduce(const double* right);
    void solve_back(const double* right, double* x) const;
    double multiply();
    void keep_worst_block();
    void follow(double alpha);
    int far(int place, int entry) const;
    int pair_about(int node) const;
    bool takes_part(int node) const { return resting_.empty() || resting_[node] < 0; }

    const Structure& structure_;
    ThreadPool& pool_;
    LargeVector<CondensedNode> between_;
    std::vector<int> which_;      ///< of each node: its place in between_, -1
    std::vector<Colour> colour_;  ///< of each place, while it is not coupled
    std::vector<Coupling> couplings_;
    std::vector<int> coupled_;  ///< nodes, rising
    struct Bridge {
        int first, a, b, middle;  ///< first element of the pair; its outer nodes and its middle one
        Mat6 K;
    };
    std::vector<Bridge> bridges_;  ///< of pairs whose middle node is coupled: such a node is not taken out
    // rows of S: the joints', in order, and behind them those of coupled nodes that would be `between`
    int joints_ = 0;
    std::vector<int> order_, place_;  ///< node of each place; place of each node, -1
    std::vector<int> first_;  ///< of each place: its entries, its own block first, then one for each element there
    std::vector<int>
        at_;  ///< of each entry: place of its column; its own, with a block of zeros, where it leads nowhere
    std::vector<int>
        via_;  ///< of each entry: 2 times the node between that is taken out, and which of its sides this is; -1
    LargeVector<Number> value_;          ///< of each entry, 36
    LargeVector<Number> inverse_;        ///< of each place, 36: of its own block, couplings included
    std::vector<int> red_, black_;       ///< places, of what takes part
    std::vector<int> staying_, going_;   ///< likewise: places of all that stay; of between_ that are taken out
    std::vector<int> resting_;           ///< of each node, not negative where it does not take part; empty: all do
    LargeVector<double> x_, r_, d_, q_;  ///< eight a place; q: S d, then what the preconditioner makes of r
};

extern template class Condensed<float>;
extern template class Condensed<double>;

}  // namespace hinge

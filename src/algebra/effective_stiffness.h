// Effective stiffness A = m M + k K in blocks of 6x6, rebuilt only where something changed, and its solution by
// conjugate gradients (condensed.h) or by factors.
#pragma once

#include <memory>
#include <vector>

#include "algebra/condensed.h"
#include "algebra/direct_factors.h"
#include "algebra/tied_members.h"
#include "algebra/node_blocks.h"
#include "algebra/reduction.h"
#include "state/element_assembly.h"

namespace hinge {

/// Storage of A, which decides how it can be solved.
enum class MatrixStorage : std::uint8_t {
    direct,            ///< for factors; includes initial stress, even if an element's part is indefinite
    unsymmetric,       ///< with the tangent's unsymmetric part (an applied moment is not conservative); for LU
    iterative,         ///< for conjugate gradients; without initial stress where a part would be indefinite
    single_precision,  ///< likewise, in single precision: half the memory to go through. Good where inertia rules A
                       ///< (steps no longer than the fastest waves need): the solution is a change of the
                       ///< accelerations, and the next step corrects its error
};

/// Tangent dp/dd of an element that yields, or whose partner yields.
struct ElementTangent {
    int element;
    Mat6 own;
    Mat6 partner;               ///< d(its p)/d(its partner's d); zero where its bending does not follow the axial force
    bool with_damping = false;  ///< both include the derivative of the forces of damping by stiffness
};

class EffectiveStiffness {
public:
    EffectiveStiffness(const Structure& structure, ThreadPool& pool, double mass_factor, double stiffness_factor,
                       bool geometric, MatrixStorage keeping);

    /// Builds the part of these elements (rising) for the state at `pose`; `given`, rising, in the place of the elastic
    /// tangent. Of a pair whose bending follows its axial force both elements are to be in the list, or none.
    void build(const std::vector<int>& elements, const State& state, const Configuration& pose,
               const std::vector<ElementTangent>& given);
    void remove(int element);
    /// Sets the damping of each element, empty for none; `by_damping`: factor of C in the matrix, gamma dt. Then every
    /// element must be built again.
    void set_damping(std::vector<ElementDamping> damping, double by_damping) {
        damping_ = std::move(damping), by_damping_ = by_damping;
    }
    void set_damping_factor(double by_damping) { by_damping_ = by_damping; }
    /// Changes k: every element must be built again, and couplings set.
    void set_stiffness_factor(double k) { stiffness_factor_ = k; }
    /// Replaces all blocks of effects, given as stiffness (except offset masses, set one by one).
    void set_blocks(Blocks blocks) { exchange_blocks(blocks); }
    /// Replaces the blocks that join two nodes.
    void set_couplings(std::vector<Coupling> couplings) { exchange_couplings(couplings); }
    /// As set_blocks; the lists of `blocks` are left with the memory of those before, for the next ones: a step that
    /// lists a thousand blocks would else ask the system for a megabyte, and give it back.
    void exchange_blocks(Blocks& blocks);
    void exchange_couplings(std::vector<Coupling>& couplings);
    void set_offset_mass(int node, const Mat6& mass);
    void set_held(const std::vector<std::uint8_t>& held);  ///< rows and columns taken out
    /// Eliminates degrees of freedom that depend on others: A becomes T^T A T, with the factors that `reduction` has
    /// where A is assembled and solved. To be called before set_held.
    void set_reduction(const Reduction* reduction);

    /// Excludes the nodes of which `resting` is not negative from conjugate gradients: nothing acts on them, nothing
    /// couples them to others, and their solution is zero. Empty: none.
    void leave_out(const std::vector<int>& resting);

    /// Updates the solver after changes.
    void assemble();
    /// Solves A x = right, six numbers a node.
    SolveReport solve(const std::vector<Vec6>& right, std::vector<Vec6>& x, const SolverSettings& settings);
    /// Subtracts K u, u the displacements of few nodes, from `from`: K of the elements as it was built, with the rows
    /// and columns of supports, and `blocks` of effects.
    void subtract_stiffness(const std::vector<Vec6>& u, const Blocks& blocks, const State& state,
                            const Configuration& pose, std::vector<Vec6>& from) const;
    /// The element or block with the most negative part of d . A d, after an indefinite solution.
    struct Weakest {
        int node = -1;     ///< the node of the part that moves most in d
        int element = -1;  ///< -1: a block of effects at the node, or between it and `other`
        int other = -1;
    };
    Weakest weakest_part() const;
    /// Factorises the present A. False when it is singular.
    bool factorise();
    const DirectFactors& factors() const { return factors_; }
    /// Number of negative eigenvalues of the factorised A, that is of unstable modes; only real ones if A is not
    /// symmetric.
    int negative_modes();
    /// Of the modes that negative_modes has counted, if A is not symmetric: the eigenvalue next to zero, without its
    /// sign. 0 for a symmetric A, or where there is none.
    double nearest_negative() const { return nearest_negative_; }
    /// True if there are more unstable modes than `known`; if A is not symmetric, if their number differs from it by
    /// one, three, five. Costs next to nothing.
    bool more_negative_modes(int known) const;
    /// Size of the eigenvalue of the factorised A next to zero, as a scale.
    double smallest_eigenvalue();
    /// The unstable mode nearest to stability, no component larger than 1. All zero if there is none.
    std::vector<Vec6> negative_mode();
    /// Seconds that one product of A, all its nodes in blocks of 6x6 in double precision, takes with a vector: the
    /// yardstick of a step.
    double time_product(int repeats) const;

    /// Part of one element in A, without supports. `given`: as in build.
    ElementPart part(int element, const State& state, const Configuration& pose,
                     const std::vector<ElementTangent>& given) const;

    struct Counts {
        long built = 0, iterations = 0, solves = 0, factorisations = 0;
    };
    const Counts& counts() const { return counts_; }

    /// Fields of a checkpoint: the blocks as they were built. All that follows from them is computed again.
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.stiffness_factor_, s.by_damping_, s.matrices_, s.couplings_, s.counts_.built, s.counts_.iterations,
          s.counts_.solves, s.counts_.factorisations);
        if (s.reduction_) a(s.given_.pairs, s.given_.nodes, s.reduced_by_);
        if (s.tied_members_) a(*s.tied_members_);
        if constexpr (A::reading) a.must(s.finish_restore());
    }

private:
    class Sums;
    using ReducedBy = Reduction::ReducedBy;
    struct PairPart {
        Mat12 A[2];
        Mat6 bridge;
    };
    Mat12 single_part(int element, const State& state, const Configuration& pose, const ElementTangent* given) const;
    PairPart pair_part(int first, const State& state, const Configuration& pose,
                       const std::vector<ElementTangent>& given) const;
    Mat12 inertia_part(int element, const State& state, const ElementFrame& place, const ElementTangent* given) const;
    const DirectFactors& symmetric_factors();
    void add_to(DirectFactors& factors, bool symmetric_part, const Vec6& on_diagonal) const;
    bool factorise_shifted(DirectFactors& factors, bool symmetric_part, const Vec6& on_diagonal);
    bool solve_by(const DirectFactors& factors, const std::vector<Vec6>& right, std::vector<Vec6>& x);
    int real_negative_modes(int most);
    void mark(int node);
    bool finish_restore();
    SolveReport solve_reduced(const std::vector<Vec6>& right, std::vector<Vec6>& x, const SolverSettings& settings);
    void take_out_held(std::vector<Vec6>& v) const;
    void take_couplings(std::vector<Coupling>& couplings);
    void take_node_blocks(std::vector<Blocks::Node>& blocks);
    Blocks reduced_blocks() const;
    void reduce();
    bool take_factors();
    bool any_given() const;
    void condense_tied();
    void leave_out();

    const Structure& structure_;
    ThreadPool& pool_;
    double mass_factor_, stiffness_factor_, by_damping_ = 0;
    std::vector<ElementDamping> damping_;
    bool geometric_;
    MatrixStorage keeping_;
    ElementMatrices matrices_;
    std::vector<Coupling> couplings_;
    const Reduction* reduction_ = nullptr;       ///< null where no degree of freedom depends on others
    std::unique_ptr<TiedMembers> tied_members_;  ///< for conjugate gradients with a reduction
    std::vector<int> resting_;                   ///< of each node, not negative where it is left out; empty: none
    Blocks given_;                               ///< with a reduction: the blocks of effects before it
    bool given_changed_ = false, has_given_ = true;
    std::vector<ReducedBy> reduced_by_;
    std::unique_ptr<Condensed<double>> condensed_;  // one of the two, for conjugate gradients
    std::unique_ptr<Condensed<float>> single_;
    std::vector<int> dirty_;  // nodes
    std::vector<char> is_dirty_;
    bool factor_valid_ = false;
    DirectFactors factors_;
    double nearest_negative_ = 0;
    std::unique_ptr<DirectFactors> symmetric_;  // of the symmetric part, made when asked for
    Counts counts_;
};

}  // namespace hinge

// The left side of a step: A = m M + k K by blocks of 6x6, rebuilt only where something changed, and its solution: by
// conjugate gradients (condensed.h), or by factors.
#pragma once

#include <memory>
#include <vector>

#include "algebra/condensed.h"
#include "algebra/direct_factors.h"
#include "algebra/node_blocks.h"
#include "state/element_assembly.h"

namespace hinge {

/// How A is kept, and so how it can be solved.
enum class MatrixStorage : std::uint8_t {
    direct,            ///< for factors: initial stress stays in, whatever it does to an element's part
    unsymmetric,       ///< the tangent's unsymmetric part too (an applied moment is not conservative); for LU
    iterative,         ///< for conjugate gradients: initial stress stays out of a part that it would make indefinite
    single_precision,  ///< likewise, in single precision: half the memory to go through. Good where inertia rules A
                       ///< (steps no longer than the fastest waves need): the solution is a change of the
                       ///< accelerations, and what it lacks the next step sees
};

/// dp/dd of an element that flows, or whose partner does.
struct ElementTangent {
    int element;
    Mat6 own;
    Mat6 partner;  ///< d(its p)/d(its partner's d); zero where its bending does not follow the axial force
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
    /// Of each element, empty for none; `by_damping`: what C counts for in the matrix, gamma dt. Elements must be built
    /// anew.
    void set_damping(std::vector<ElementDamping> damping, double by_damping) {
        damping_ = std::move(damping), by_damping_ = by_damping;
    }
    void set_damping_factor(double by_damping) { by_damping_ = by_damping; }
    /// Another k: every element must be built anew, and couplings set.
    void set_stiffness_factor(double k) { stiffness_factor_ = k; }
    /// Replaces all that effects add beside the elements, already as a stiffness (but offset masses, set one by one).
    void set_blocks(Blocks blocks);
    /// Of those, what joins two nodes.
    void set_couplings(std::vector<Coupling> couplings);
    void set_offset_mass(int node, const Mat6& mass);
    void set_held(const std::vector<std::uint8_t>& held);  ///< rows and columns taken out

    /// Conjugate gradients pass over the nodes of which `resting` is not negative: nothing acts on them and nothing
    /// couples them to others, and their solution is zero. Empty: none.
    void leave_out(const std::vector<int>& resting);

    /// Takes up what changed.
    void assemble();
    /// A x = right, six numbers a node.
    SolveReport solve(const std::vector<Vec6>& right, std::vector<Vec6>& x, const SolverSettings& settings);
    /// After a solution that ended as indefinite: what has the most negative part in d . A d.
    struct Weakest {
        int node = -1;     ///< that moves most in d, of those that the part is attached to
        int element = -1;  ///< -1: what effects add at the node, or between it and `other`
        int other = -1;
    };
    Weakest weakest_part() const;
    /// Factorises A as it stands. False when it is singular.
    bool factorise();
    const DirectFactors& factors() const { return factors_; }
    /// How many ways of moving A, factorised, does not resist but drives on: its negative eigenvalues, real ones where
    /// A is not symmetric.
    int negative_modes();
    /// Whether there are more of them than `known`; where A is not symmetric, whether their number differs from it by
    /// one, three, five: that costs next to nothing.
    bool more_negative_modes(int known) const;
    /// One of these, the one nearest to resisting, no component larger than 1. All zero where there is none.
    std::vector<Vec6> negative_mode();
    /// Seconds that one product of A, all its nodes in blocks of 6x6 in double precision, takes with a vector: the
    /// yardstick of a step.
    double time_product(int repeats) const;

    /// An element's part, nothing of it held. `given`: as in build.
    ElementPart part(int element, const State& state, const Configuration& pose,
                     const std::vector<ElementTangent>& given) const;

    struct Counts {
        long built = 0, iterations = 0, solves = 0, factorisations = 0;
    };
    const Counts& counts() const { return counts_; }

    /// What a checkpoint holds: the blocks as they were built, at one time or another. What follows from them is found
    /// anew.
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.stiffness_factor_, s.by_damping_, s.matrices_, s.couplings_, s.counts_.built, s.counts_.iterations,
          s.counts_.solves, s.counts_.factorisations);
        if constexpr (A::reading) a.must(s.take_up_all());
    }

private:
    struct PairPart {
        Mat12 A[2];
        Mat6 bridge;
    };
    Mat12 single_part(int element, const State& state, const Configuration& pose, const Mat6& k) const;
    PairPart pair_part(int first, const State& state, const Configuration& pose,
                       const std::vector<ElementTangent>& given) const;
    Mat12 inertia_part(int element, const State& state, const ElementFrame& place) const;
    const DirectFactors& symmetric_factors();
    void add_to(DirectFactors& factors, bool symmetric_part, const Vec6& on_diagonal) const;
    bool factorise_shifted(DirectFactors& factors, bool symmetric_part, const Vec6& on_diagonal);
    bool solve_by(const DirectFactors& factors, const std::vector<Vec6>& right, std::vector<Vec6>& x);
    int real_negative_modes(int most);
    void mark(int node);
    bool take_up_all();

    const Structure& structure_;
    ThreadPool& pool_;
    double mass_factor_, stiffness_factor_, by_damping_ = 0;
    std::vector<ElementDamping> damping_;
    bool geometric_;
    MatrixStorage keeping_;
    ElementMatrices matrices_;
    std::vector<Coupling> couplings_;
    std::unique_ptr<Condensed<double>> condensed_;  // one of the two, for conjugate gradients
    std::unique_ptr<Condensed<float>> single_;
    std::vector<int> dirty_;  // nodes
    std::vector<char> is_dirty_;
    bool factor_valid_ = false;
    DirectFactors factors_;
    std::unique_ptr<DirectFactors> symmetric_;  // of the symmetric part, made when asked for
    Counts counts_;
};

}  // namespace hinge

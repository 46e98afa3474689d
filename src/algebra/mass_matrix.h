// Mass matrix M alone: changes of velocity from impulses. Needed whenever forces begin or end at once, and in every
// explicit step.
//
// Consistent (paper, after eq 15): the first solution, at a run's start, assembles nothing; a run that needs more
// stores M in blocks (element_matrices.h) and solves on its joints (condensed.h). Lumped
// (beam/element_mass.h): the rotary inertia is the section's polar one about every axis, so that a node's spin needs no
// frame and no gyroscopic moment.
#pragma once

#include <memory>

#include "algebra/condensed.h"
#include "algebra/reduction.h"
#include "state/element_assembly.h"

namespace hinge {

class Mass {
public:
    /// Mass of all whole elements and rigid offset masses, at the positions of `state`.
    Mass(const Structure& structure, const State& state);
    /// Degrees of freedom that depend on others: solutions are those of T^T M T, moved by T, from now on.
    void set_reduction(const Reduction* reduction);

    /// Computes again the mass of these elements at `pose`, and that of the rigid offset masses. A broken element has
    /// no mass but that of its offset mass. Before its first call, solutions use the element positions of `state`.
    void renew(const std::vector<int>& elements, const State& state, const Configuration& pose);
    /// Computes the offset masses alone again, as rotated at `pose`.
    void rotate_offset_masses(const State& state, const Configuration& pose);
    /// Solves change = M^-1 impulse (N s, N m s -> m/s, rad/s), zero where `state` holds a degree of freedom.
    /// `tolerance`: of the residual, relative; lumped masses need none. Without an answer the report says so (an
    /// indefinite M, a right side that is not finite, 500 iterations), and `change` is not to be used.
    SolveReport solve(const std::vector<Vec6>& impulse, std::vector<Vec6>& change, const State& state,
                      double tolerance);

    /// Inverse lumped mass of each node's elements and of a mass at the node itself, for each degree of freedom, 1/kg
    /// and 1/(kg m^2); zero where it is held or no mass is left.
    const std::vector<Vec6>& lumped_inverse() const { return lumped_inverse_; }
    /// Lumped mass of a node with offset masses that are not at the node itself: mass of its elements, its offset mass,
    /// and the inverse of the sum; 6x6 in space. The inverse is of the free degrees of freedom; one for those that are
    /// held.
    struct Heavy {
        int node;
        Mat6 elements, offsets, inverse;
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.node, s.elements, s.offsets, s.inverse);
        }
    };
    const std::vector<Heavy>& heavy() const { return heavy_; }
    /// Lumped: solves for the nodes that constraints join, which lumped_inverse leaves out. Other nodes of `change`
    /// stay as they are. `impulse` is zero where `state` holds a degree of freedom.
    void solve_joined(const std::vector<Vec6>& impulse, std::vector<Vec6>& change, const State& state) const;

    /// Fields of a checkpoint.
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        const std::size_t nodes = s.lumped_inverse_.size();
        bool in_blocks = s.blocks_ != nullptr;
        a(s.lumped_inverse_, s.heavy_, in_blocks);
        if constexpr (A::reading) {
            a.must(s.lumped_inverse_.size() == nodes && !(in_blocks && s.structure_.lumped()));
            for (const Heavy& h : s.heavy_) a.must(h.node >= 0 && std::size_t(h.node) < nodes);
            s.blocks_.reset();
            if (in_blocks) s.make_blocks();
        }
        if (in_blocks) a(s.blocks_->parts);
    }

private:
    void renew_lumped(const std::vector<int>& elements, const State& state, const Configuration& pose);
    void keep_blocks(const State& state);
    void make_blocks();
    void update_supports(const State& state);
    void mark(int node);
    void leave_out_joined();
    Mat6 lumped_at(int node, const State& state) const;
    SolveReport solve_reduced(const std::vector<Vec6>& right, std::vector<Vec6>& change, const State& state);

    const Structure& structure_;
    const Reduction* reduction_ = nullptr;  ///< null where no degree of freedom depends on others
    std::unique_ptr<Configuration> pose_;   ///< consistent, with a reduction: where it was renewed last
    std::vector<Vec6> lumped_inverse_;
    std::vector<Heavy> heavy_;  ///< in order of their nodes
    struct Blocks {
        ElementMatrices parts;
        Condensed<double> condensed;
        std::vector<int> dirty;
        std::vector<char> is_dirty;
    };
    ThreadPool alone_;
    std::unique_ptr<Blocks> blocks_;  ///< consistent, from the first renew on
};

/// Makes the free ends of broken elements move rigidly with their carriers. Of all such motions, this takes the one
/// nearest to the motion before in kinetic energy: M v' = T^T M v, which is M (v' - v) = impulse with M as it is after
/// the breaks. It keeps both momenta, and as a projection it cannot gain energy. (When the carrier's velocity alone was
/// made to keep the momenta, debris with little inertia was flung about: 51 MJ out of nothing in one impact of 112 MJ.)
/// Counts and returns the kinetic energy lost in this, J; counts the work of moving supports too. Not a number, and
/// nothing is changed, where M v' - M v = impulse could not be solved.
double pass_on(State& state, Mass& mass, std::vector<Vec6>& impulse);

}  // namespace hinge

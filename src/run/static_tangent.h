// Tangent stiffness of a static run at the configuration that is tried: its factors, the displacements that it gives,
// and its negative eigenvalues.
#pragma once

#include <memory>

#include "algebra/effective_stiffness.h"
#include "run/stages.h"
#include "run/static_forces.h"

namespace hinge {

class StaticTangent {
public:
    StaticTangent(const StaticProblem& problem, StaticForces& forces, Stages& stages);

    /// Keeps the unsymmetric part of the stiffness too, from now on.
    void keep_unsymmetric();
    /// Builds and factorises the tangent. False where it is singular. `off_balance`: the out-of-balance force relative
    /// to the forces at work; `hinge_stiffness`: minimum fraction of the elastic stiffness kept at hinges.
    bool renew(double off_balance, double hinge_stiffness = 0);
    /// Displacements by forces on the nodes. False where none are found.
    bool solve(const std::vector<Vec6>& forces, std::vector<Vec6>& displacements);

    /// The forces on the nodes, by this tangent, where the supports alone move as they do per unit of the load factor.
    /// Empty where none does.
    const std::vector<Vec6>& forces_of_supports() const { return forces_of_supports_; }

    /// Number of negative eigenvalues of the tangent, and with those that pairs of elements cannot show.
    int negative_modes_of_matrix() { return matrix_->negative_modes(); }
    int negative_modes() { return matrix_->negative_modes() + modes_within_pairs(); }
    /// See EffectiveStiffness.
    double nearest_negative() const { return matrix_->nearest_negative(); }
    double smallest_eigenvalue() { return matrix_->smallest_eigenvalue(); }
    /// True if it has more of them than `known`.
    bool more_negative_modes(int known);
    /// Member whose compression was found to exceed most what a pair of its elements can show; -1: none does.
    int overloaded_member() const { return overloaded_member_; }
    std::vector<Vec6> negative_mode() { return matrix_->negative_mode(); }
    const DirectFactors& factors() const { return matrix_->factors(); }
    EffectiveStiffness::Counts counts() const { return matrix_->counts(); }

    // The tangent of the trial becomes that of the state when the trial is committed, and need not be built again.
    void holds_for_trial() { of_trial_ = w_.yielding.empty() && !had_blocks_; }
    void commit(bool points_moved) { of_state_ = of_trial_ && !points_moved; }
    /// True, once, if the tangent of the state is factorised.
    bool take_that_of_state();

private:
    std::vector<int> elements_to_build() const;
    std::vector<ElementTangent> plastic_tangents(const std::vector<int>& elements, double hinge_stiffness);
    void find_forces_of_supports(const std::vector<ElementTangent>& plastic, const Blocks& blocks);
    int modes_within_pairs();
    void add_curvature_of_constraints(Blocks& blocks) const;

    const StaticProblem& problem_;
    Workspace& w_;
    StaticForces& forces_;
    std::unique_ptr<EffectiveStiffness> matrix_;
    std::vector<Vec6> forces_of_supports_;
    std::vector<int> was_yielding_;  ///< elements built with a plastic tangent
    bool built_ = false, had_blocks_ = false, unsymmetric_ = false;
    bool of_state_ = false, of_trial_ = false;  ///< what is factorised is the elastic tangent there
    int overloaded_member_ = -1;
    Stages& stages_;
    int build_stage_, factorise_stage_;
};

}  // namespace hinge

// Loads and internal forces of a static run, at the configuration and the load factor that are tried.
#pragma once

#include "algebra/effective_stiffness.h"
#include "run/stages.h"
#include "run/static_problem.h"

namespace hinge {

class StaticForces {
public:
    StaticForces(const StaticProblem& problem, Stages& stages);

    /// Finds the loads at factor 1. Follower loads depend on the configuration that is tried.
    void find_loads();
    /// Recovers stresses and finds the internal forces; follower loads are found again.
    void recover();
    /// Finds what yielded elements resist per unit of load factor because of loads between their nodes. `tangents`:
    /// those of the yielded elements.
    void find_yielding_by_load(const std::vector<ElementTangent>& tangents);

    /// Load on a node at a load factor: forces in N, moments in N m.
    Vec6 load(std::size_t node, double factor) const;
    /// Derivative of out-of-balance force by load factor.
    Vec6 load_rate(std::size_t node) const;
    /// Derivative of the internal forces by load factor at constant displacements, N and N m: what heat and loads
    /// between nodes make of them. By a difference of two recoveries of stresses, after which the trial is as before.
    std::vector<Vec6> internal_rates();
    bool are_heated() const { return !problem_.effects.heaters.empty(); }
    /// Load minus internal force on a node; zero where it is supported.
    Vec6 out_of_balance(std::size_t node) const;
    /// Norm of the out-of-balance forces (N), and of the loads and internal forces that they are compared with.
    struct Residual {
        double norm = 0, scale = 0;
        double relative() const { return norm / scale; }
    };
    Residual residual() const;
    /// Adds the work that loads, and supports that move, do from the state, where the load factor is `begun`, to the
    /// configuration that is tried, J.
    void add_work(double begun, double& work) const;
    /// The load factor with which the start is in equilibrium: that of the run that this one goes on from, with the
    /// same loads. 0 where there is none.
    double factor_at_start() const;
    /// Forces of the supports, at a load factor.
    void find_reactions(double factor);
    /// What supports move by per unit of the load factor, of each node: m and rad. Empty where none does.
    const std::vector<Vec6>& support_rates() const { return support_rates_; }
    /// True if a load's tangent is unsymmetric: a moment, or a load that follows the rotation of its member.
    bool are_unsymmetric() const;

private:
    void add_steady_and_static(std::vector<Vec6>& potential, std::vector<Vec6>& others) const;
    void find_support_rates();
    void add_held(std::vector<Vec6>& weights, std::vector<Vec6>& others) const;
    void add_resistance_of_effects();
    bool any_follows() const;

    const StaticProblem& problem_;
    Workspace& w_;
    const bool follow_;                   ///< a load depends on the configuration
    std::vector<Vec6> potential_;         ///< loads whose work is in a potential energy account: weights
    std::vector<Vec6> support_rates_;     ///< of effects (StaticPrescriber); empty for none
    std::vector<Vec6> yielding_by_load_;  ///< find_yielding_by_load; empty for none
    Stages& stages_;
    int recover_stage_;
};

}  // namespace hinge

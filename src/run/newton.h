// Newton's method for one step of statics: from the last equilibrium to the next, on the path that a control
// prescribes.
#pragma once

#include "run/path_control.h"
#include "run/static_tangent.h"

namespace hinge {

/// How the last solution went, and the displacements that it found.
struct NewtonResult {
    int iterations = 0;
    std::vector<Vec6> displacements;  ///< of the step
    std::vector<Vec6> response;       ///< those that the loads at factor 1 ask for, by the last tangent
    double asked = 0;  ///< size of what the tangent at the start asked for, where it is known to ask for too much; m
};

class Newton {
public:
    Newton(const StaticProblem& problem, StaticForces& forces, StaticTangent& tangent);
    /// Number of negative eigenvalues of the tangent where the run begins.
    void set_modes_at_start(int modes) { modes_at_start_ = modes; }

    /// Finds the equilibrium that lies an increment of the control beyond the state; leaves it as the trial
    /// configuration. False where there is none. `hinge_stiffness`: see StaticTangent::renew; where it is not 0, the
    /// method converges slowly and gets many iterations.
    /// `start`: displacements from the state at which it begins, in the place of the state itself; empty: none.
    bool find(PathControl& control, double increment, double hinge_stiffness = 0, const std::vector<Vec6>& start = {});
    /// The same from the trial configuration, with all elements elastic at first.
    bool find_from_trial(PathControl& control, double increment);
    /// The trial has become the state.
    void commit();

    const NewtonResult& result() const { return result_; }
    void set_result(NewtonResult result) { result_ = std::move(result); }
    /// Finds the response of the tangent that is factorised. False where there is none. Under load control it does not
    /// include what heat does; path_rate does.
    bool find_response();
    /// Displacements per unit of the load factor along the path at the trial, of loads, settlements and heat. Empty
    /// where there are none.
    std::vector<Vec6> path_rate();
    /// Recovers the stresses and the forces of all effects at the trial.
    void recover();
    /// True if an iteration of find had a tangent with more negative eigenvalues than where the run begins.
    bool passed_unstable() const { return passed_unstable_; }
    /// Elements that yield at the last equilibrium.
    const std::vector<PlasticIncrement>& hinges() const { return hinges_; }
    /// True if an element yields there or on the way to the trial.
    bool yields() const { return !hinges_.empty() || !w_.yielding.empty(); }
    /// Size of the displacements that the loads at factor 1 ask for, m; and that of the run's first iteration.
    double softness() const;
    double first_softness() const { return first_softness_; }

private:
    struct Iteration;
    bool iterate(PathControl& control, double increment, double hinge_stiffness, bool yielding_goes_on,
                 const std::vector<Vec6>& start = {});
    bool find_correction();
    bool is_unstable(double off_balance, double hinge_stiffness);
    bool find_rate(bool with_heat, std::vector<Vec6>& rate);
    bool find_step(double factor_change, Iteration& at);
    void move_by_step(double factor);
    void place_dependent_nodes(const Pose& from);
    bool search_line(double factor_change, bool whole_steps, Iteration& at);
    bool search_work(double factor_change, Iteration& at);
    bool end_search(Iteration& at);
    bool has_converged(const Iteration& at) const;
    bool is_hopeless(const Iteration& at) const;

    const StaticProblem& problem_;
    Workspace& w_;
    StaticForces& forces_;
    StaticTangent& tangent_;
    int modes_at_start_ = 0;
    std::vector<PlasticIncrement> hinges_;  ///< of the last equilibrium
    std::vector<Vec6> right_, correction_;  ///< out-of-balance forces, and the displacements that they ask for
    std::vector<Vec6> total_, step_;        ///< displacements so far, and of the iteration
    NewtonResult result_;
    bool passed_unstable_ = false;
    const bool stiffens_;       ///< EffectTraits::stiffens of an effect
    bool heat_counts_ = false;  ///< the control finds the load factor, of which the temperatures are a part
    double first_softness_ = 0;
};

}  // namespace hinge

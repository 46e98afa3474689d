// Statics: equilibrium step by step, along a load path that load, displacement or arc length controls.
//
// A step of the run is one or more substeps, each an equilibrium: Newton's method (newton.h) finds it on the path of
// the control (path_control.h), the stability monitor (stability_monitor.h) judges it, and where there is none the
// substep is halved (step_halving.h).
#pragma once

#include <functional>

#include "run/load_control.h"
#include "run/newton.h"
#include "run/run.h"
#include "run/stability_monitor.h"
#include "run/step_halving.h"

namespace hinge {

class Statics : public Run {
public:
    /// Throws InputError when the structure can move without resistance, naming the node.
    Statics(std::shared_ptr<const Structure> structure, State start, StaticSettings settings);

    bool advance() override;
    long planned_steps() const override { return settings().steps; }
    const char* kind() const override { return "static"; }
    bool is_static() const override { return true; }
    const Statics* statics() const override { return this; }
    std::vector<StageTime> stage_times() const override { return stages_.times(); }
    std::vector<PlanLine> effects() const override;
    EffectiveStiffness::Counts solver_counts() const override { return tangent_.counts(); }
    long substeps() const override { return substeps_; }  ///< a step that was halved takes several
    long rejected() const override { return halving_.rejected(); }
    bool limit() const override { return limit_; }
    bool short_of_target() const override { return verdict_ == Verdict::completed && path_->short_of_target(); }
    const StaticSettings& settings() const { return problem_.settings; }
    /// Degrees of freedom that supports and this run hold, six bits a node.
    const std::vector<std::uint8_t>* held() const override { return &problem_.held; }
    const Instability* instability() const override {
        return stability_.instability() ? &*stability_.instability() : nullptr;
    }
    /// Of the instability: where, how many, by what motion and in which members; "" for none.
    std::string instability_text() const override { return instability() ? text_of(*instability(), *structure_) : ""; }
    /// Force and moment of the loads on a node where the state is, N and N m.
    Vec6 load_on(int node) const { return forces_.load(std::size_t(node), state_.factor); }
    /// The part of the way to factor 1, to the target, or of the steps, that is done: 0 to 1.
    double part_done() const override { return path_->part_done(state_.factor, steps_done()); }
    std::string way_done() const override;
    /// A step that is halved has many tries.
    void on_each_try(std::function<void()> call) override { on_try_ = std::move(call); }

private:
    /// An equilibrium that has been tried: by which control, and how far beyond the state.
    struct Substep {
        PathControl* control;
        double increment;
    };
    struct Equilibrium {
        double factor;
        std::vector<Vec3> displacement;
        std::vector<Quat> rotation;
    };
    void take_substep();
    std::optional<Substep> find_equilibrium();
    Found try_step(PathControl& control, double increment, double hinge_stiffness = 0);
    std::vector<Vec6> start_of(const PathControl& control, double increment) const;
    std::optional<double> exchange_mechanisms(double increment);
    Substep step_to_target(const Substep& passing);
    bool is_on_path(double increment) const;
    bool pass_instability(const Substep& substep);
    void commit(const Substep& substep);
    void commit_state();
    bool is_over() const { return path_->is_over(state_.factor, steps_done()); }

    // statics_branches.cpp: branches of equilibria beside the path
    void note_unheld();
    std::optional<double> reach_unheld();
    std::vector<Vec6> way_to(const Equilibrium& there) const;
    bool goes_on_before_leap(double part) const;
    std::vector<int> slack_elements() const;
    bool leans_on_slack_members();

    // statics_ends.cpp: the end of a run
    void end_at_limit(const Failure& why);
    std::string text_of_cause(const Failure& failure) const override;
    std::string reason_at_end() const override;
    bool is_soft() const;
    std::optional<Remark> limit_point() const;
    std::vector<Remark> remarks_at_limit();
    std::vector<Remark> remarks_under_load();
    Remark control_that_goes_on(bool unstable);
    std::vector<Remark> remarks_when_driven();

    // statics_refusals.cpp: what is refused before a run begins
    std::unique_ptr<PathControl> make_path() const;
    void refuse_idle_loads() const;
    double way_to_target() const;
    void refuse_mechanism();
    std::string loosely_held_body(int node) const;

    Stages stages_;
    const StaticProblem problem_;
    StaticForces forces_;
    StaticTangent tangent_;
    Newton newton_;
    StabilityMonitor stability_;
    const std::unique_ptr<PathControl> path_;
    LoadControl load_to_target_;  ///< for the step that ends a path of arc length
    StepHalving halving_;
    long substeps_ = 0;
    std::optional<Equilibrium> unheld_;  ///< the last one that a step was too long for, and that cannot be held
    double to_unheld_ = 0;               ///< increment of the step that begins Newton's method there; 0: none
    int branches_left_ = 0;              ///< in a row: parts of steps after which the step itself lay on another branch
    double factor_at_start_ = 0;         ///< StaticForces::factor_at_start
    bool limit_ = false;
    std::function<void()> on_try_;
};

}  // namespace hinge

// Statics: load steps, each brought to equilibrium by Newton's method; load, displacement or arc length controls the
// path.
#pragma once

#include "algebra/effective_stiffness.h"
#include "run/stages.h"

namespace hinge {

enum class Control : std::uint8_t { load, displacement, arc };

struct StaticSettings {
    int steps =
        10;  ///< load control: equal steps to factor 1; arc: at most so many; displacement: equal steps to `target`
    Control control = Control::load;
    int node = -1, component = 0;  ///< displacement control: what is driven (0..5: ux uy uz rx ry rz)
    double target = 0;             ///< its value at the end, m or rad
    int iterations = 30;           ///< Newton iterations before a step is halved
    double tolerance =
        1e-9;  ///< out-of-balance force relative to the forces at work (moments over a mean element length)
    std::vector<std::uint8_t> held;  ///< extra supports for this run only (six bits a node), or empty
};

class Statics : public Run {
public:
    /// Throws InputError when the structure can move without resistance, naming the node.
    Statics(std::shared_ptr<const Structure> structure, State start, StaticSettings settings);

    bool advance() override;
    long planned_steps() const override { return settings_.steps; }
    const char* kind() const override { return "static"; }
    std::vector<StageTime> stage_times() const override { return stages_.times(); }
    std::vector<PlanLine> effects() const override;
    EffectiveStiffness::Counts solver_counts() const { return effective_->counts(); }

private:
    enum class Outcome { converged, diverged };
    Outcome equilibrate(double increment, bool flowing_on);
    void find_loads();
    void recover();
    bool renew_and_factorise(double off_balance);
    double out_of_balance(double& scale) const;
    void move(double factor, const std::vector<Vec6>& by);
    void commit(double factor);
    void refuse_mechanism();

    StaticSettings settings_;
    std::vector<std::uint8_t> held_;
    std::unique_ptr<EffectiveStiffness> effective_;
    double trial_factor_ = 0, step_size_, progress_ = 0, last_arc_ = 0, arc_scale_ = 1, mean_length_ = 1, reach_ = 1e-3,
           noise_ = 0;
    int converged_in_ = 0;
    std::vector<Vec6> potential_;       ///< the part of F that has a potential energy in an account of its own
    std::vector<Vec6> right_, change_;  ///< F - R, and the move that it asks for
    std::vector<Vec6> response_;        ///< the move that F at factor 1 asks for
    std::vector<Vec6> last_move_;
    std::vector<Yielding> hinges_;  ///< of the last equilibrium
    std::vector<int> was_yielding_;
    bool built_ = false, loads_follow_ = false, had_blocks_ = false;
    Stages stages_;
    int recover_stage_ = stages_.add("recover stresses", "large displacement"),
        stiffness_stage_ = stages_.add("stiffness", ""), solve_stage_ = stages_.add("solve", "");
};

}  // namespace hinge

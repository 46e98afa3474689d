// Statics: load steps, each brought to equilibrium by Newton's method; load, displacement or arc length controls the
// path.
#pragma once

#include <functional>
#include <optional>

#include "algebra/effective_stiffness.h"
#include "run/stages.h"

namespace hinge {

enum class Control : std::uint8_t { load, displacement, arc };

struct StaticSettings {
    int steps = 10;  ///< load and displacement control: equal steps to factor 1, to `target`; arc: at most so many
    Control control = Control::load;
    int node = -1, component = 0;  ///< displacement control: what is driven (0..5: ux uy uz rx ry rz)
    double target = 1;    ///< at the end: the displacement (Run::displacement), m or rad; of arc length the load factor
    int iterations = 30;  ///< Newton iterations before a step is halved
    double tolerance =
        1e-9;  ///< out-of-balance force relative to the forces at work (moments over a mean element length)
    std::vector<std::uint8_t> held;  ///< extra supports for this run only (six bits a node), or empty
    bool past_unstable = false;      ///< load control goes on where the structure has become unstable
    bool to_limit = false;           ///< load control: a run that ends at a limit load has completed
};

/// Where a run came past a limit point or a branching point: its tangent has more negative eigenvalues than where the
/// run began, and the equilibria beyond cannot be held at constant load.
struct Instability {
    double factor = 0, beyond = 0;  ///< load factors of the last equilibrium before it and of the first one after
    int count = 0;                  ///< ways of moving that are not resisted; the most so far
    int node = -1, component = 0;   ///< the largest motion of the first of these (0..5: ux uy uz rx ry rz)
    bool by_compression = true;     ///< or, where moments drive it, as a beam that turns over sideways, by bending
    std::vector<int> members;       ///< that this drives on in it, the first one most; at most three
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
    long substeps() const { return substeps_; }  ///< equilibria found: a step that was halved takes several
    long rejected() const { return rejected_; }  ///< tries that found none and were halved
    bool limit() const { return limit_; }        ///< it has ended at a limit load
    /// Control by arc length has ended before its load factor.
    bool short_of_target() const {
        return settings_.control == Control::arc && !at_target_ && verdict_ == Verdict::completed;
    }
    const StaticSettings& settings() const { return settings_; }
    const std::vector<std::uint8_t>& held() const {
        return held_;
    }  ///< what supports and this run hold, six bits a node
    const std::optional<Instability>& instability() const { return instability_; }
    static const char* component_name(int component);  ///< ux uy uz rx ry rz
    /// The part of the way to factor 1, to the target, or of the steps, that is done: 0 to 1.
    double part_done() const;
    std::function<void()> on_try;  ///< called before each try of a step; a step that is halved has many
    /// Of the instability: where, how many, by what motion and in which members.
    std::string instability_text() const;

private:
    /// Of the whole: a step halved below this ends the run, at the limit load.
    static constexpr double smallest_step = 1e-5;
    enum class Outcome { converged, diverged };
    Outcome equilibrate(double increment, bool flowing_on);
    Outcome go_on_from_trial(double increment, bool flowing_on);
    bool leads_back(double increment);
    void find_loads();
    Vec6 load_at(std::size_t node, double factor) const;
    void recover();
    bool renew_and_factorise(double off_balance);
    void find_flow_by_load(const std::vector<ElementTangent>& given);
    Vec6 unit_load(std::size_t node) const;
    double out_of_balance(double& scale) const;
    void move(double factor, const std::vector<Vec6>& by);
    enum class Found { nothing, stable, unstable };
    Found try_step(double increment);
    bool past_exchange(double increment);
    void commit(double before);
    void take_reactions(double factor);
    void note_leap(double increment, double before);
    void look_at_pairs();
    void tell_end();
    bool passes_target() const;
    void refuse_mechanism();
    std::string loosely_held_body(int node) const;
    void refuse_idle_loads() const;
    void find_way();
    int negative_modes();
    int modes_within_pairs();
    int modes_under_control();
    double locate(double increment, const std::vector<Vec6>& arrived_by);
    void describe_mode();
    double softness() const;
    void end_at_limit(const std::string& why, const std::string& advice);
    std::string advice_at_end();
    std::string limit_point() const;

    StaticSettings settings_;
    std::vector<std::uint8_t> held_;
    std::unique_ptr<EffectiveStiffness> effective_;
    double trial_factor_ = 0, step_size_, progress_ = 0, last_arc_ = 0, arc_scale_ = 1, mean_length_ = 1, reach_ = 1e-3,
           noise_ = 0;
    int converged_in_ = 0;
    double way_ = 0;  ///< displacement control: from where the run begins to the target, m or rad
    int modes_at_start_ = 0, modes_ = 0, most_modes_ = 0;  ///< negative eigenvalues of the tangent: first, last, most
    int pressed_ = -1;                          ///< the member of the last modes within pairs that is pressed most
    int free_modes_ = 0, most_free_modes_ = 0;  ///< of the last and the most, those that displacement control leaves
    double stiffening_ = 0;      ///< a share of the stiffness without hinges that they keep in the tangent, at least
    double tried_ = 0;           ///< the step by which an exchange of mechanisms was passed
    double first_response_ = 0;  ///< of what is driven, to the loads at factor 1
    double first_softness_ = 0;  ///< m, size of the first move that the loads at factor 1 ask for
    std::optional<double> branching_;  ///< load factor where displacement control can no longer hold it
    long substeps_ = 0, rejected_ = 0;
    bool limit_ = false;
    bool at_target_ = false;  ///< arc length has come to its load factor
    bool leap_told_ = false;
    bool doubtful_ = false;          ///< the step that was tried may have leapt over a snap
    bool wavered_ = false;           ///< a tangent on the way of Newton's iteration had more
    bool tangent_known_ = false;     ///< what is factorised is the tangent where the state is
    bool tangent_of_trial_ = false;  ///< or where the step that was tried has arrived
    std::optional<Instability> instability_;
    std::vector<Vec6> potential_;       ///< the part of F that has a potential energy in an account of its own
    std::vector<Vec6> held_loads_;      ///< beside w_.external, in full from the start on; empty for none
    std::vector<Vec6> flow_by_load_;    ///< find_flow_by_load; empty for none
    std::vector<Vec6> right_, change_;  ///< F - R, and the move that it asks for
    std::vector<Vec6> response_;        ///< the move that F at factor 1 asks for
    std::vector<Vec6> last_move_;
    std::vector<PlasticIncrement> hinges_;  ///< of the last equilibrium
    std::vector<int> was_yielding_;
    bool built_ = false, loads_follow_ = false, had_blocks_ = false;
    Stages stages_;
    int recover_stage_ = stages_.add("recover stresses", "large displacement"),
        stiffness_stage_ = stages_.add("stiffness", ""), solve_stage_ = stages_.add("solve", "");
};

}  // namespace hinge

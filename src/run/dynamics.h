// Dynamics: steps in time, each in the words of the paper (section 2.2): loads, predict, [contact], recover stresses,
// [yield], solve, correct, [fracture], commit. What is in brackets is an effect that a scene may not call for.
//
// This class knows the order of a step and what effects may ask of it, and no effect by name. How forces become motion
// is the integrator's (integrator.h), how long a step is StepSize's, whether the run may go on the energy monitor's.
#pragma once

#include "run/energy_monitor.h"
#include "run/integrator.h"
#include "run/settings.h"

namespace hinge {

class Dynamics : public Run {
public:
    Dynamics(std::shared_ptr<const Structure> structure, State start, DynamicSettings settings);

    bool advance() override;
    long planned_steps() const override { return steps_done() + size_.left(); }
    const char* kind() const override { return "dynamic"; }
    bool is_static() const override { return false; }
    std::span<const Break> broken_last() const override { return step_.breaks; }
    std::vector<StageTime> stage_times() const override { return stages_.times(); }
    std::vector<PlanLine> effects() const override;
    const DynamicSettings& settings() const { return settings_; }
    double dt() const { return size_.dt(); }  ///< s, of the coming step

    /// Appends all that the bits of later steps depend on, and what was counted so far. Changes nothing.
    void save(std::string& to) const;
    /// Takes back what save() made of a run of the same structure with the same settings, before this run's first step
    /// or between two; the number of threads may be another. Throws Damaged (core/archive.h) where that makes no sense;
    /// the run is then as it was.
    void restore(std::string_view saved);
    /// Goes on as `before` would have: with its acceleration, stiffness, contacts and length of steps. Its energies,
    /// warnings and counts stay its own. Before this run's first step; `before` is a run of the same structure and
    /// settings, but for the duration, of which this run began with the state.
    void go_on_as(const Dynamics& before);

    EffectiveStiffness::Counts solver_counts() const override;
    long substeps() const override { return steps_done(); }
    double part_done() const override;
    std::string way_done() const override;
    double shortest() const { return size_.own(); }  ///< s: dt, with "auto" the shortest, before any is halved
    double shortest_taken() const { return size_.least_taken(); }  ///< s
    long rejected() const override { return size_.rejected(); }
    std::optional<double> shortest_controlled() const override;
    long own_steps() const { return size_.whole() / size_.own_length(); }  ///< of length dt in the whole run
    bool explicit_steps() const { return settings_.explicit_steps(); }
    double largest_energy() const override { return largest_energy_.most(); }
    /// Of a run whose energy balance no longer closed: the moment at which this was seen.
    const LostBalance* lost() const override { return energy_monitor_.lost() ? &*energy_monitor_.lost() : nullptr; }
    /// Of the state: the energy error as a part of the largest energy.
    double energy_error_share() const;
    const LargestError& largest_error() const { return energy_monitor_.largest_error(); }
    /// The part of the largest energy that the balance may miss before the run ends, failed; 0: it never does.
    double tolerance() const { return settings_.energy_tolerance.value_or(energy_may_miss()); }
    const StepControl& step_control() const { return control_; }
    const Fastest& fastest() const { return integrator_->fastest; }
    const Fastest* fastest_node() const override { return fastest().node < 0 ? nullptr : &fastest(); }
    const Dynamics* dynamics() const override { return this; }
    Dynamics* dynamics() override { return this; }
    /// Seconds that one product of this run's effective stiffness, block by block and uncondensed, with a vector takes:
    /// the yardstick of a step.
    double time_product(int repeats) const;

private:
    // Host
    void stiffness_changed(int element) override { integrator_->stiffness_changed(element); }
    void blocks_changed(const Pose& at) override;
    void set_offset_mass(int node, const Mat6& mass) override;
    void leave_out(const std::vector<int>& resting) override;
    void accelerations_anew() override { anew_ = true; }
    void constraints_changed() override { constraints_due_ = true; }
    void mass_changed(int element) override { mass_.changed(element); }
    ImpulseResponse respond(const std::vector<Vec6>& impulse) override;
    bool has_effective_stiffness() const override { return !explicit_steps(); }

    // a step
    void take_step();
    template <class F>
    void stage(int stage, F f);
    void begin_step();
    void predict();
    void keep_constraints(bool moved);
    void meet();
    void restart();
    void recover(double time);
    bool correct();
    void settle();
    Failure failure_of_elements() const;
    void end_contacts();
    void decide();
    void control_step();
    bool is_abrupt();
    double motion_of_trial() const;
    bool calls_for_control() const;
    void commit();
    void break_elements();
    void rebuild_constraints();
    void watch_effects();

    void choose_length();
    void take_steps_of(long length);
    void set_length(long length);
    void save_step();
    void roll_back();
    bool again_shorter();
    Failure crushed() const;
    double energy_may_miss() const;
    void check_energy();
    void look_between();
    void add_inertia_to_reactions();
    void must_be_solved(const SolveReport& report);
    void find_acceleration(std::vector<Vec6>& out_of_balance);
    void return_to_yield_surface();
    double work_of_supports(const std::vector<Vec6>& supports, const std::vector<Vec6>& velocity) const;
    Energy energy_of_trial();
    DynamicSettings fitted(DynamicSettings settings) const;

    template <class Self, class A>
    static void fields(Self& s, A& a);
    void save_run(std::string& to) const;  ///< without its watches
    void read(Reader& reader);
    bool makes_sense() const;

    const DynamicSettings settings_;
    Stages stages_;
    struct {
        int loads, contact, restart, predict, recover, correct, ends, control, decide, commit;
    } at_;  ///< places of the stages
    StepSize size_;
    KeptMass mass_;
    std::unique_ptr<Integrator> integrator_;
    LargestEnergy largest_energy_;
    EnergyMonitor energy_monitor_;
    StepControl control_;
    bool meets_ = false, breaks_or_parts_ = false, decides_ = false;  ///< what effects of this scene do in a step
    Step step_;
    bool constraints_due_ = false;  ///< constraints have ended in the step
    bool anew_ = false;             ///< the next step begins with the acceleration found anew
    std::vector<double> motions_;   ///< J, motion_of_trial() of the last two steps; with control by default
    double motion_ = 0;             ///< of the step that is tried
    bool unseen_ = false;           ///< step control has not looked at the step that is tried
    std::vector<double> lumped_;    ///< kg, at each node
    bool rejected_ = false;         ///< the step failed in a way that a shorter one may mend
    struct Sleep {
        bool awake = false;
        long quiet = 0;
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.awake, s.quiet);
        }
    };
    std::vector<Sleep> sleepers_;  ///< of each effect that sleeps
    struct {
        Accounts accumulated;
        std::optional<StepSize> size;
        bool anew = false;
        Fastest fastest;
    } before_;  ///< the step, for one that is taken back
};

}  // namespace hinge

// Dynamics: steps in time, each in the words of the paper (section 2.2): loads, predict, [contact], recover stresses,
// [yield], solve, correct, [fracture], commit. What is in brackets is an effect that a scene may not call for.
//
// This class knows the order of a step and what effects may ask of it, and no effect by name. Forces and the first
// acceleration are in dynamic_forces.h, how they become motion in integrator.h, how long a step is and whether it is
// kept in step_length.h, what follows from breaks in element_breaks.h, whether the run may go on in energy_check.h.
#pragma once

#include "run/element_breaks.h"
#include "run/effect_times.h"
#include "run/energy_check.h"
#include "run/sleepers.h"
#include "run/step_length.h"

namespace hinge {

class Dynamics : public Run {
public:
    Dynamics(std::shared_ptr<const Structure> structure, State start, DynamicSettings settings);

    bool advance() override;
    long planned_steps() const override { return steps_done() + length_.size().left(); }
    const char* kind() const override { return "dynamic"; }
    bool is_static() const override { return false; }
    std::span<const Break> broken_last() const override { return step_.breaks; }
    std::vector<StageTime> stage_times() const override { return stages_.times(); }
    std::vector<PlanLine> effects() const override;
    const DynamicSettings& settings() const { return settings_; }
    double dt() const { return length_.size().dt(); }  ///< s, of the coming step

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
    double shortest() const { return length_.size().own(); }  ///< s: dt, with "auto" the shortest, before any is halved
    double shortest_taken() const { return length_.size().least_taken(); }  ///< s
    long rejected() const override { return length_.size().rejected(); }
    std::optional<double> shortest_controlled() const override;
    long own_steps() const {
        return length_.size().whole() / length_.size().own_length();
    }  ///< of length dt in the whole run
    bool explicit_steps() const { return settings_.explicit_steps(); }
    double largest_energy() const override { return energy_check_.largest().most(); }
    /// Of a run whose energy balance no longer closed: the moment at which this was seen.
    const LostBalance* lost() const override { return energy_check_.lost() ? &*energy_check_.lost() : nullptr; }
    /// Of the state: the energy error as a part of the largest energy.
    double energy_error_share() const { return energy_check_.error_share(*this); }
    const LargestError& largest_error() const { return energy_check_.largest_error(); }
    /// The part of the largest energy that the balance may miss before the run ends, failed; 0: it never does.
    double tolerance() const { return energy_check_.tolerance(); }
    const StepControl& step_control() const { return length_.control(); }
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
    void rest_changed() override;
    void accelerations_anew() override { forces_.acceleration_due = true; }
    void constraints_changed() override { element_breaks_.constraints_due = true; }
    void mass_changed(int element) override { mass_.changed(element); }
    ImpulseResponse respond(const std::vector<Vec6>& impulse) override { return forces_.respond(impulse); }
    bool has_effective_stiffness() const override { return !explicit_steps(); }

    // a step
    void take_step();
    template <class F>
    void stage(int stage, F f);
    void begin_step();
    void predict();
    void keep_constraints(bool moved);
    void detect_contacts();
    void restart();
    bool correct();
    void recover_last();
    void end_contacts();
    bool effects_act() const;
    void control_step();
    void decide_breaks();
    void commit();
    void break_elements();

    void add_stages();
    void choose_length();
    void take_steps_of(long length);
    void set_length(long length);
    void save_step();
    void roll_back();
    bool try_shorter();
    Energy energy_of_trial();

    template <class Self, class A>
    static void fields(Self& s, A& a);
    void save_run(std::string& to) const;  ///< without its watches
    void read(Reader& reader);
    bool makes_sense() const;

    const DynamicSettings settings_;
    Stages stages_;
    EffectTimes times_;
    struct {
        int loads, contact, restart, predict, recover, correct, ends, control, decide, commit;
    } at_;  ///< places of the stages
    StepLength length_;
    EnergyCheck energy_check_;
    KeptMass mass_;
    std::unique_ptr<Integrator> integrator_;
    Step step_;
    Blocks blocks_;  ///< of effects, in memory that each step uses again
    DynamicForces forces_;
    ElementBreaks element_breaks_;
    Sleepers sleepers_;
    const bool has_contacts_, forces_may_vanish_, has_breakers_;  ///< effects of this scene
    bool rejected_ = false;  ///< the step failed in a way that a shorter one may mend
    struct {
        Accounts accumulated;
        std::optional<StepSize> size;
        bool acceleration_due = false;
        Fastest fastest;
    } before_;  ///< the step, for one that is taken back
};

}  // namespace hinge

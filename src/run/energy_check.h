// The energy balance of a dynamic run after each step: the largest energy, and whether the run may go on.
#pragma once

#include "run/energy_monitor.h"
#include "run/integrator.h"

namespace hinge {

class EnergyCheck {
public:
    /// `tolerance`: the part of the largest energy that the balance may miss before the run ends; 0: it never does.
    /// `steps`: of the run.
    EnergyCheck(const Structure& structure, double tolerance, long steps)
        : tolerance_(tolerance), largest_(structure), monitor_(tolerance, steps) {}
    /// The state that the run begins with is good; errors of an earlier run are forgotten.
    void begin(const State& state, long steps) { monitor_ = EnergyMonitor(tolerance_, steps), monitor_.begin(state); }

    /// After a step that went well, or one that failed: why the run fails, none where the balance closes or there is
    /// nothing to add to its failure. `state` becomes the last good one where the balance is lost. `initial`: J, at the
    /// start.
    std::optional<RunFailure> check(const Run& run, State& state, const Integrator& integrator, double initial);
    /// Of the run's state: the energy error as a part of the largest energy.
    double error_share(const Run& run) const;
    /// The energy error of a step that is kept was computed elsewhere.
    void note_error(double share, double time) { monitor_.note_error(share, time); }

    double tolerance() const { return tolerance_; }
    LargestEnergy& largest() { return largest_; }
    const LargestEnergy& largest() const { return largest_; }
    const std::optional<LostBalance>& lost() const { return monitor_.lost(); }
    const LargestError& largest_error() const { return monitor_.largest_error(); }
    const State* good_state() const { return monitor_.good_state(); }
    /// Before its fields are read: room for a state with the same data of effects.
    void make_room(const State& like) { monitor_.make_room(like); }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.largest_, s.monitor_);
    }

private:
    void check_between(const Run& run, double swing, double initial);

    double tolerance_;
    LargestEnergy largest_;
    EnergyMonitor monitor_;
};

/// The default of energy_tolerance.
double default_energy_tolerance(const Structure& structure, const DynamicSettings& settings);

}  // namespace hinge

#include "run/energy_check.h"

#include <algorithm>

#include "run/settings.h"

namespace hinge {
namespace {

/// Part of the largest energy that the balance may miss before a run with explicit steps is ended, whose energy swings
/// with the fastest vibrations and whose runs then hold. Implicit steps: large_error.
constexpr double may_swing = 0.1;

}  // namespace

double default_energy_tolerance(const Structure& structure, const DynamicSettings& settings) {
    return structure.model().options().shift == Shift::elastic_and_plastic ? 0
           : settings.explicit_steps()                                     ? may_swing
                                                                           : large_error;
}

double EnergyCheck::error_share(const Run& run) const {
    LargestEnergy largest = largest_;  // it grows at the checks of the energy monitor alone
    return largest.share(run.energy(), run.accounts());
}

/// The largest error of explicit steps is that of a few steps, which the energy monitor may miss between two checks.
void EnergyCheck::check_between(const Run& run, double swing, double initial) {
    const double most = std::max(largest_.most(), initial);
    if (run.verdict() != Verdict::running || !monitor_.may_miss(swing, most)) return;
    LargestEnergy largest = largest_;
    const double share = largest.share(run.energy(), run.accounts());
    if (largest.most() <= 2 * most) monitor_.note_error(share, run.state().time);
}

std::optional<RunFailure> EnergyCheck::check(const Run& run, State& state, const Integrator& integrator,
                                             double initial) {
    const bool running = run.verdict() == Verdict::running, failed = run.verdict() == Verdict::failed;
    const bool due = monitor_.due(state, running);
    if (!due && !failed) return check_between(run, integrator.swing(), initial), std::nullopt;
    Failure lost;
    if (due)
        lost =
            monitor_.check(state, run.energy(), run.accounts(), largest_, running, EnergyMonitor::may_grow(tolerance_));
    if (!lost) return {};
    RunFailure failure = failed ? *run.failure() : RunFailure{lost};
    if (failed) failure.remarks.push_back({Remark::Kind::before, lost});
    if (const Fastest& fast = integrator.fastest; fast.node >= 0)
        failure.remarks.push_back({Remark::Kind::fastest, {.node = fast.node, .value = fast.speed, .time = fast.time}});
    if (const LostBalance& balance = *monitor_.lost(); balance.went_back)
        failure.remarks.push_back(
            {Remark::Kind::went_back, {.value = balance.good_share, .count = state.step, .time = state.time}});
    return failure;
}

}  // namespace hinge

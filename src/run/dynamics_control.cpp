// Dynamics, whether a step is kept: step control.
//
// A step may lose its share of what the run may lose, or whatever the steps before it have left over. One that would
// lose more, turns a node too far, or cannot be solved is taken back before anything was told of it, and tried again
// half as long.
#include <algorithm>
#include <cmath>

#include "run/dynamics.h"

namespace hinge {
namespace {

constexpr double most_turn = 0.5;     ///< rad: of a node in a step
constexpr int most_easy = 1 << 20;    ///< more is not counted
constexpr double advance_part = 0.1;  ///< of what may be lost, there from the beginning

}  // namespace

/// The ledger of what is tried; the state is as before afterwards.
Energy Dynamics::energy_of_trial() {
    const Accumulated accumulated = state_.accumulated;
    std::vector<Vec6> plastic;
    const auto exchange = [this] {
        state_.displacement.swap(trial_.displacement), state_.rotation.swap(trial_.rotation),
            state_.turn.swap(trial_.turn), state_.velocity.swap(trial_.velocity);
    };
    state_.accumulated.work += work_of_loads() + work_of_supports();
    state_.accumulated.numerical += numerical_;
    for (const Yielding& y : yielding_) {
        plastic.push_back(state_.plastic[y.element]);
        state_.plastic[y.element] += y.flow.plastic;
        state_.accumulated.plastic += y.flow.dissipation;
    }
    exchange();
    const Energy energy = ledger_.balance(state_);
    exchange();
    for (std::size_t i = 0; i < yielding_.size(); ++i) state_.plastic[yielding_[i].element] = plastic[i];
    state_.accumulated = accumulated;
    return energy;
}

/// Whether the step is kept.
void Dynamics::weigh() {
    if (structure_->large())
        for (std::size_t i = 0; i < increment_.size(); ++i)
            if (const double turn = increment_[i].norm(); !(turn <= most_turn)) {
                char what[120];
                std::snprintf(what, sizeof what, " would turn by %.3g rad in a step, more than %.2g", turn, most_turn);
                failure_ = structure_->node_name(int(i)) + what;
                return;
            }
    const double before = turned_over_;
    const Energy energy = energy_of_trial();
    const double share = remainder_share(energy), of_run = double(pace_.length) / double(pace_.whole),
                 so_far = double(pace_.done) / double(pace_.whole);
    const double may = settings_.step_control * turned_over_,
                 lost = std::abs(energy.remainder) - std::abs(kept_remainder_);
    const bool within = std::abs(energy.remainder) <= may * (advance_part + (1 - advance_part) * (so_far + of_run));
    if (share == 0 || (std::isfinite(share) && (within || lost <= may * of_run))) {
        kept_remainder_ = energy.remainder;
        pace_.easy = lost <= 0.25 * may * of_run ||
                             std::abs(energy.remainder) <= 0.5 * may * (advance_part + (1 - advance_part) * so_far)
                         ? std::min(pace_.easy + 1, most_easy)
                         : 0;
        return;
    }
    char what[160];
    if (!std::isfinite(share)) std::snprintf(what, sizeof what, "its energy would no longer be finite");
    else
        std::snprintf(what, sizeof what,
                      "the step would lose %.3g %% of the energy turned over, its share of step_control is %.3g %%",
                      100 * lost / turned_over_, 100 * settings_.step_control * of_run);
    failure_ = what;
    turned_over_ = before;
}

/// The step is taken back and halved; false when it is the finest already: the run ends.
bool Dynamics::again_shorter() {
    const std::string why = std::move(failure_);
    failure_.clear();
    const long tried = pace_.length;
    take_back();
    if (tried > 1) {
        halve(tried, why);
        remember();
        return true;
    }
    char finest[80];
    std::snprintf(finest, sizeof finest, "; dt was halved down to %.3g s, and no shorter step is tried", settings_.dt);
    fail(why + finest);
    return false;
}

}  // namespace hinge

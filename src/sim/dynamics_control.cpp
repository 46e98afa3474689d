// Dynamics, whether a step is kept: step control.
//
// A step may lose its share of what the run may lose, or whatever the steps before it have left over. One that would lose more,
// turns a node too far, or cannot be solved is taken back before anything was told of it, and tried again half as long.
#include <algorithm>
#include <cmath>

#include "sim/dynamics.h"
#include "sim/hinges.h"

namespace hinge {
namespace {

constexpr double most_turn = 0.5;    ///< rad: of a node in a step
constexpr double advance_part = 0.1; ///< of what may be lost, there from the beginning

}  // namespace

/// The ledger of what is tried: whether the step is kept.
void Dynamics::weigh() {
    if (structure_->large())
        for (std::size_t i = 0; i < increment_.size(); ++i)
            if (const double turn = increment_[i].norm(); !(turn <= most_turn)) {
                char what[120];
                std::snprintf(what, sizeof what, " would turn by %.3g rad in a step, more than %.2g", turn, most_turn);
                failure_ = structure_->node_name(int(i)) + what;
                return;
            }
    tried_ = state_;
    tried_.displacement = trial_.displacement;
    tried_.rotation = trial_.rotation;
    tried_.turn = trial_.turn;
    tried_.velocity = trial_.velocity;
    tried_.force = force_;
    std::vector<int> flowing = flowing_;
    commit_flow(*structure_, tried_, yielding_, flowing);
    tried_.booked.work += work_of_loads() + work_of_supports();
    tried_.booked.numerical += numerical_;

    const double before = turned_over_;
    const Energy energy = ledger_.balance(tried_);
    const double share = remainder_share(energy), of_run = double(pace_.length) / double(pace_.whole), so_far = double(pace_.done) / double(pace_.whole);
    const double may = settings_.step_control * turned_over_, lost = std::abs(energy.remainder) - std::abs(kept_remainder_);
    const bool within = std::abs(energy.remainder) <= may * (advance_part + (1 - advance_part) * (so_far + of_run));
    if (share == 0 || (std::isfinite(share) && (within || lost <= may * of_run))) {
        kept_remainder_ = energy.remainder;
        pace_.easy = lost <= 0.25 * may * of_run || std::abs(energy.remainder) <= 0.5 * may * (advance_part + (1 - advance_part) * so_far) ? pace_.easy + 1 : 0;
        return;
    }
    char what[160];
    std::snprintf(what, sizeof what, "the step would lose %.3g %% of the energy turned over, its share of step_control is %.3g %%", 100 * lost / turned_over_, 100 * settings_.step_control * of_run);
    failure_ = what;
    turned_over_ = before;
}

/// The step is taken back and halved; false when it is the finest already: the run ends.
bool Dynamics::again_shorter() {
    const std::string why = std::move(failure_);
    failure_.clear();
    take_back();
    if (halve(why)) return remember(), true;
    char finest[80];
    std::snprintf(finest, sizeof finest, "; dt was halved down to %.3g s, and no shorter step is tried", settings_.dt);
    fail(why + finest);
    return false;
}

}  // namespace hinge

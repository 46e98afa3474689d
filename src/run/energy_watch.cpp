#include "run/energy_watch.h"

#include <algorithm>
#include <cmath>

namespace hinge {
namespace {

constexpr long most_between = 100;          ///< steps from one look to the next: the balance costs half a step
constexpr std::size_t most_kept = 200'000;  ///< elements of a model whose last good state is kept, at 300 bytes each
constexpr double advance_part = 0.1;        ///< of what may be lost, there from the beginning
constexpr double easy_part = 0.25;          ///< of its share that an easy step loses at most

}  // namespace

/// A strain of 1e-11 all over: rounding of the positions alone makes such energies.
LargestEnergy::LargestEnergy(const Structure& structure) {
    for (const Element& e : structure.elements()) floor_ += 1e-22 * e.rigidity.EA * e.length;
}

double LargestEnergy::share(const Energy& energy, const AccountList& accounts) {
    if (!std::isfinite(energy.initial)) return energy.initial;
    double held = 0, given = 0;            // all that is held or was dissipated; all that was there or came in
    double most_held = 0, most_given = 0;  // the largest account of each
    const auto take = [](double account, double& all, double& most) { all += account, most = std::max(most, account); };
    for (const AccountInfo& info : accounts) {
        if (!info.part_of.empty()) continue;
        const double account = energy[info.name];
        if (!std::isfinite(account)) return account;
        const bool in = (info.name == supplied_account) == (account > 0);
        if (in) take(std::abs(account), given, most_given);
        else take(std::abs(account), held, most_held);
    }
    most_ = std::max({most_, energy.initial, std::min(most_held, energy.initial + given), std::min(most_given, held)});
    return most_ > floor_ ? energy.error / most_ : 0;
}

void Guard::begin(const State& state) {
    if (tolerance_ > 0 && state.broken.size() <= most_kept) good_ = {state, 0};
}

bool Guard::due(const State& state, bool running) const {
    if (!(tolerance_ > 0)) return false;
    return !running || state.step - looked_at_ >= std::clamp((steps_ - 1) / 20, 1L, most_between);
}

std::optional<std::string> Guard::look(State& state, const Energy& energy, const AccountList& accounts,
                                       LargestEnergy& largest, bool running, double may_grow,
                                       const std::string& fastest) {
    const double before = largest.most(), share = largest.share(energy, accounts);
    const double grown = share == 0 ? 0 : (energy.error - error_) / largest.most();
    // while the energy of the run is still coming in, an error is compared with what will soon be little
    const bool coming_in = largest.most() > 2 * before;
    const bool closes = std::abs(share) <= tolerance_, steady = coming_in || std::abs(grown) <= may_grow;
    const long since = looked_at_;
    looked_at_ = state.step;
    if (closes && steady) {
        error_ = energy.error;
        if (running && state.broken.size() <= most_kept) good_ = {state, share};
        return {};
    }
    lost_ = {state.step, state.time, state.factor, energy, share, false};
    largest.set_most(before);
    char what[400];
    if (closes)
        std::snprintf(
            what, sizeof what,
            "step %ld, t = %.6g s: the error of the energy balance has grown by %.3g %% of the largest energy "
            "since step %ld, more than %.3g %% (energy_tolerance %.3g %%)",
            state.step, state.time, 100 * std::abs(grown), since, 100 * may_grow, 100 * tolerance_);
    else
        std::snprintf(what, sizeof what,
                      "step %ld, t = %.6g s: the energy balance no longer closes, its error is %.3g %% of the largest "
                      "energy (energy_tolerance %.3g %%)",
                      state.step, state.time, 100 * share, 100 * tolerance_);
    std::string why = what + fastest;
    if (good_) {
        lost_->went_back = true;
        state = std::move(good_->state);
        std::snprintf(what, sizeof what, ". The state is that of step %ld, t = %.6g s, where it was %.3g %%",
                      state.step, state.time, 100 * good_->share);
        why += what;
        good_.reset();
    }
    return why;
}

std::optional<std::string> StepControl::refuse(const Energy& energy, const AccountList& accounts,
                                               LargestEnergy& largest, StepSize& size) {
    const double before = largest.most();
    const double share = largest.share(energy, accounts), of_run = size.of_run(), so_far = size.so_far();
    const double may = tolerance_ * largest.most(), lost = std::abs(energy.error) - std::abs(kept_error_);
    const auto allowed = [&](double part) { return may * (advance_part + (1 - advance_part) * part); };
    const bool within = std::abs(energy.error) <= allowed(so_far + of_run);
    if (share == 0 || (std::isfinite(share) && (within || lost <= may * of_run))) {
        kept_error_ = energy.error;
        size.count_easy(lost <= easy_part * may * of_run || std::abs(energy.error) <= 0.5 * allowed(so_far));
        return {};
    }
    char what[160];
    if (!std::isfinite(share)) std::snprintf(what, sizeof what, "its energy would no longer be finite");
    else
        std::snprintf(what, sizeof what,
                      "the step would lose %.3g %% of the largest energy, its share of step_control is %.3g %%",
                      100 * lost / largest.most(), 100 * tolerance_ * of_run);
    largest.set_most(before);
    return what;
}

}  // namespace hinge

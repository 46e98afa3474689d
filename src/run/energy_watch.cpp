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
    const auto take = [&](double account) {
        if (std::isfinite(account)) most_ = std::max(most_, std::abs(account));
        return std::isfinite(account);
    };
    if (!take(energy.initial)) return energy.initial;
    for (const AccountInfo& info : accounts)
        if (info.part_of.empty() && !take(energy[info.name])) return energy[info.name];
    return most_ > floor_ ? energy.error / most_ : 0;
}

bool Guard::due(const State& state, bool running) const {
    if (!(tolerance_ > 0)) return false;
    return !running || state.step - looked_at_ >= std::clamp((steps_ - 1) / 20, 1L, most_between);
}

std::optional<std::string> Guard::look(State& state, double share, bool running, const std::string& fastest) {
    looked_at_ = state.step;
    if (std::abs(share) <= tolerance_) {
        if (running && state.broken.size() <= most_kept) good_ = {state, share};
        return {};
    }
    char what[400];
    std::snprintf(what, sizeof what,
                  "step %ld, t = %.6g s: the energy balance no longer closes, its error is %.3g %% of the largest "
                  "energy (energy_tolerance %.3g %%)",
                  state.step, state.time, 100 * share, 100 * tolerance_);
    std::string why = what + fastest;
    if (good_) {
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

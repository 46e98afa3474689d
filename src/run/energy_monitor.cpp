#include "run/energy_monitor.h"

#include <algorithm>
#include <cmath>

namespace hinge {
namespace {

constexpr long most_between = 100;          ///< steps from one check to the next: the balance costs half a step
constexpr std::size_t most_kept = 200'000;  ///< elements of a model whose last good state is kept, at 300 bytes each
constexpr double expected_part = 0.5;       ///< of a large error: a swing of a step's error that asks for a check
constexpr double expected_growth = 1.25;    ///< where a larger one is known: by which it must be exceeded
constexpr double advance_part = 0.1;        ///< of what may be lost, there from the beginning
constexpr double advance_by_default = 0.5;  ///< and by default
constexpr double most_left = 0.01;          ///< of the largest energy, that what no shorter step mends may come to
constexpr double most_coming_in = 0.5;      ///< of that: for what is lost while the energy of the run still comes in
constexpr double rate_part = 0.1;       ///< of a refused loss: what the shortest step loses of one that goes with time
constexpr double rate_room = 1.5;       ///< for a known rate, before steps are taken back again
constexpr double rate_share = 0.8;      ///< of what the rest of the run may still lose: for losses at a known rate
constexpr double easy_part = 0.25;      ///< of its share that an easy step loses at most
constexpr double abrupt_part = 0.5;     ///< of what may be lost: a change of the motion that may hide a loss
constexpr long most_skipped = 32;       ///< steps from one check of step control to the next, by default
constexpr long most_skipped_short = 4;  ///< and while they are halved

/// The share of an error, none where it may be rounding: no step, however short, makes that smaller.
double beyond_rounding(double share, const Energy& energy) {
    return std::isfinite(share) && std::abs(energy.error) <= energy.rounding ? 0 : share;
}

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
        const bool supplied = info.name == supplied_account, in = supplied == (account > 0);
        if (in && !supplied && !info.may_give) continue;
        if (in) take(std::abs(account), given, most_given);
        else take(std::abs(account), held, most_held);
    }
    most_ = std::max({most_, energy.initial, std::min(most_held, energy.initial + given), std::min(most_given, held)});
    return most_ > floor_ ? energy.error / most_ : 0;
}

void EnergyMonitor::begin(const State& state) {
    if (tolerance_ > 0 && state.broken.size() <= most_kept) good_ = {state, 0};
}

bool EnergyMonitor::due(const State& state, bool running) const {
    return !running || state.step - checked_ >= std::clamp((steps_ - 1) / 20, 1L, most_between);
}

Failure EnergyMonitor::check(State& state, const Energy& energy, const AccountList& accounts, LargestEnergy& largest,
                             bool running, double may_grow) {
    const double before = largest.most(), share = beyond_rounding(largest.share(energy, accounts), energy);
    if (!(tolerance_ > 0)) {
        if (largest.most() <= 2 * before || !running) largest_error_.include(share, state.time);
        checked_ = state.step;
        error_ = energy.error;
        return {};
    }
    const double grown = share == 0 ? 0 : (energy.error - error_) / largest.most();
    // while the energy of the run is still coming in, an error is compared with what will soon be little
    const bool coming_in = largest.most() > 2 * before;
    const bool closes = std::abs(share) <= tolerance_, steady = coming_in || std::abs(grown) <= may_grow;
    const long since = checked_;
    checked_ = state.step;
    if (closes && steady) {
        error_ = energy.error;
        if (!coming_in || !running) largest_error_.include(share, state.time);
        if (running && state.broken.size() <= most_kept) good_ = {state, share};
        return {};
    }
    lost_ = {state.step, state.time, state.factor, energy, share};
    largest.set_most(before);
    Failure why{.tolerance = tolerance_, .step = state.step, .time = state.time};
    if (closes) {
        why.cause = Cause::energy_error_grown;
        why.value = std::abs(grown), why.limit = may_grow, why.count = since;
    } else {
        why.cause = Cause::energy_error;
        why.value = share;
    }
    if (good_) {
        lost_->went_back = true, lost_->good_share = good_->share;
        state = std::move(good_->state);
        good_.reset();
    }
    return why;
}

bool EnergyMonitor::may_miss(double swing, double most) const {
    const double known = std::abs(largest_error_.share), last = std::abs(error_) / most, swings = swing / most;
    if (!(most > 0)) return false;
    return known > large_error ? last + swings > expected_growth * known
                               : std::max(last, known) + swings / expected_part > large_error;
}

bool StepControl::due(bool abrupt, const StepSize& size) const {
    if (!by_default_ || abrupt) return true;
    const bool halved = size.length() < size.own_length();
    return since_ + 1 >= (halved ? std::min(between_, most_skipped_short) : between_);
}

/// By default shorter steps may lose more: an eighth of dt twice, dt / 64 five times as much. What is gained by them
/// costs ever more time.
double StepControl::tolerance(const StepSize& size) const {
    return by_default_ ? tolerance_ * std::max(1.0, double(size.halvings() - 1)) : tolerance_;
}

double StepControl::abrupt() const { return abrupt_part * tolerance_; }

void StepControl::skip(StepSize& size) {
    ++since_;
    since_units_ += size.length();
    size.count_easy(true);
}

void StepControl::start_from(double error) {
    kept_error_ = error;
    since_ = since_units_ = 0;
}

void StepControl::leave_behind(double error) {
    left_ += error;
    kept_error_ += error;
}

/// What is expected to be lost whatever the steps are long, J, and is kept: no more of it than the rest of the run can
/// bear. `left`: what all of it may still lose.
double StepControl::known_loss(double left, const StepSize& size) const {
    const double units = double(since_units_ + size.length()), rest = double(size.units_left() + since_units_);
    return std::min(rate_ * units, rate_share * std::max(0.0, left) * units / rest);
}

void StepControl::begin_from(double error) {
    kept_error_ = error;
    since_ = since_units_ = 0;
    between_ = 1;
}

Failure StepControl::compare(const Energy& energy, const AccountList& accounts, LargestEnergy& largest,
                             StepSize& size) {
    const double before = largest.most(), share = beyond_rounding(largest.share(energy, accounts), energy),
                 so_far = size.so_far();
    const double of_run = size.part_of_run(since_units_ + size.length());
    const double error = energy.error - left_, may = tolerance(size) * largest.most(),
                 lost = std::abs(error) - std::abs(kept_error_ - left_);
    const double advance = by_default_ ? advance_by_default : advance_part;
    const auto allowed = [&](double part) { return may * (advance + (1 - advance) * part); };
    const bool within = std::abs(error) <= allowed(so_far + size.of_run()), finite = std::isfinite(share);
    const bool little = std::abs(energy.error) <= most_left * largest.most();
    const double known = little ? known_loss(most_left * largest.most() - std::abs(energy.error), size) : 0;
    const bool closes = share == 0 || (finite && (within || lost <= std::max(may * of_run, rate_room * known)));
    // while the energy of the run is still coming in, an error is compared with what will soon be little
    const bool coming_in = by_default_ && finite &&
                           std::abs(energy.error) <= most_coming_in * most_left * largest.most() &&
                           largest.most() > 2 * before;
    const bool in_vain = by_default_ && finite && size.fine() && little;
    if (closes || coming_in || in_vain) {
        if (!closes) left_ += energy.error - kept_error_;
        if (!closes && !coming_in && lost < rate_part * first_refused_)
            rate_ = std::max(rate_, lost / double(since_units_ + size.length()));
        kept_error_ = energy.error;
        kept_share_ = largest.most() > 2 * before ? 0 : share;
        first_refused_ = 0;
        since_ = since_units_ = 0;
        const bool easy =
            lost <= std::max(easy_part * may * of_run, rate_room * known) || std::abs(error) <= 0.5 * allowed(so_far);
        between_ = easy && closes ? std::min(2 * between_, most_skipped) : 1;
        size.count_easy(easy || !closes);
        return {};
    }
    if (first_refused_ == 0) first_refused_ = lost;
    Failure why{.cause = finite ? Cause::energy_lost_in_step : Cause::energy_not_finite,
                .value = lost / largest.most(),
                .limit = tolerance(size) * of_run};
    largest.set_most(before);
    return why;
}

}  // namespace hinge

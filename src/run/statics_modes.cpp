// Where a structure becomes unstable in statics: negative eigenvalues of its tangent, and the load factor at which the
// first appears.
#include "run/pressed_pairs.h"
#include "run/statics.h"

namespace hinge {

/// Of the tangent where a step has been brought to equilibrium, not kept yet. In small displacement it has none ever.
int Statics::negative_modes() {
    if (!structure_->large()) return modes_at_start_;
    if (!renew_and_factorise(1)) return most_modes_ + 1;
    tangent_of_trial_ = w_.yielding.empty() && !had_blocks_;
    return effective_->negative_modes() + modes_within_pairs();
}

/// The middle node of a pair of elements cannot bend out between ends that are clamped, which is what a beam does from
/// four times Euler's load of the pair on. The tangent does not show it, so that it is counted here (as in Wittrick and
/// Williams, Q. J. Mech. Appl. Math. 24, 1971). Two elements have it in one member, four or more between its nodes.
int Statics::modes_within_pairs() {
    int modes = 0;
    double worst = 1;
    pressed_ = -1;
    for (std::size_t i = 0; i + 1 < structure_->elements().size(); i += 2) {
        for (const double part : pressed(*structure_, state_, w_.force, int(i)).part) {
            if (!(part > 1)) continue;
            ++modes;
            if (part > worst) worst = part, pressed_ = structure_->elements()[i].member;
        }
    }
    return modes;
}

/// Of the negative eigenvalues of the tangent just factorised, those that are left where displacement control holds
/// what it drives: it takes one away beyond a limit load, where what is driven moves on as the load falls.
int Statics::modes_under_control() {
    if (settings_.control != Control::displacement || modes_ <= modes_at_start_) return modes_;
    std::vector<Vec6> load(w_.external.size());
    for (std::size_t i = 0; i < load.size(); ++i) {
        load[i] = unit_load(i);
        for (int c = 0; c < 6; ++c)
            if (held_[i] >> c & 1) load[i][c] = 0;
    }
    SolverSettings direct;
    direct.direct = true;
    if (!effective_->solve(load, response_, direct).converged) return modes_;
    return modes_ - (response_[settings_.node][settings_.component] * first_response_ < 0);
}

/// The tangent at the end of a try has more negative eigenvalues than at the start of the run: halves the step until
/// that is known closely where. Returns how far the last stable equilibrium is; what is tried is then the whole step
/// again. `arrived_by`: the last move before it.
double Statics::locate(double increment, const std::vector<Vec6>& arrived_by) {
    const auto try_anew = [&](double part) {
        last_move_ = arrived_by;
        return try_step(part);
    };
    Instability found;
    double stable = 0, unstable = increment;
    found.factor = state_.factor;
    const double close = settings_.control == Control::arc ? 1e-4 * increment : 0.1 * smallest_step;
    bool at_unstable = true;
    while (unstable - stable > close) {
        const double middle = 0.5 * (stable + unstable);
        const Found there = try_anew(middle);
        at_unstable = there == Found::unstable;
        if (there == Found::stable) stable = middle, found.factor = trial_factor_;
        else unstable = middle;
    }
    // and the first equilibrium beyond: there may be none close to it
    for (double gap = unstable - stable; !at_unstable; gap *= 2) {
        const double part = std::min(stable + gap, increment);
        at_unstable = try_anew(part) == Found::unstable || part == increment;
    }
    found.beyond = trial_factor_;
    found.count = std::max(1, modes_ - modes_at_start_);
    instability_ = found;
    describe_mode();
    try_anew(increment);
    return stable;
}

}  // namespace hinge

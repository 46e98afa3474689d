// Dynamics, whether to go on: now and then the energy ledger is looked at, and a run in which it no longer closes ends
// by itself.
//
// The remainder is held against the energy that has been turned over: the most that any one account of the ledger has
// had so far.
#include <algorithm>
#include <cmath>

#include "run/dynamics.h"

namespace hinge {
namespace {

constexpr long most_between = 100;          ///< steps from one look to the next: the ledger costs half a step
constexpr std::size_t most_kept = 200'000;  ///< elements of a model whose last good state is kept, at 300 bytes each

}  // namespace

/// The remainder as a part of the energy turned over; not finite where the state is not. Below ledger_floor_ all is
/// rounding.
double Dynamics::remainder_share(const Energy& e) {
    if (ledger_floor_ == 0)
        for (const Element& e : structure_->elements()) ledger_floor_ += 1e-22 * e.rigidity.EA * e.length;
    for (double account :
         {e.initial, e.kinetic, e.gravity, e.elastic, e.plastic, e.fracture, e.contact, e.numerical, e.work}) {
        if (!std::isfinite(account)) return account;
        turned_over_ = std::max(turned_over_, std::abs(account));
    }
    return turned_over_ > ledger_floor_ ? e.remainder / turned_over_ : 0;
}

/// After a step that went well, or one that failed: whether the ledger still closes.
void Dynamics::guard() {
    const double most =
        settings_.energy_tolerance.value_or(structure_->model().options().shift == Shift::whole ? 0 : 0.1);
    if (!(most > 0)) return;
    const bool failed = verdict_ == Verdict::failed;
    const long between = std::clamp((pace_.whole - 1) / 20, 1L, most_between);
    if (verdict_ == Verdict::running && state_.step - looked_at_ < between) return;
    looked_at_ = state_.step;
    const double share = remainder_share(energy());
    if (std::abs(share) <= most) {
        if (verdict_ == Verdict::running && structure_->elements().size() <= most_kept) good_ = {state_, share};
        return;
    }
    char what[400];
    const Fastest fast = fastest();
    std::snprintf(what, sizeof what,
                  "step %ld, t = %.6g s: the energy ledger no longer closes, its remainder is %.3g %% of the energy "
                  "turned over (energy_tolerance %.3g %%)",
                  state_.step, state_.time, 100 * share, 100 * most);
    std::string why = what;
    if (fast.node >= 0) {
        std::snprintf(what, sizeof what, "; fastest was %s with %.3g m/s at t = %.6g s",
                      structure_->node_name(fast.node).c_str(), fast.speed, fast.time);
        why += what;
    }
    if (failed) why = reason_ + "; before it, " + why;
    if (good_) {
        state_ = std::move(good_->state);
        std::snprintf(what, sizeof what, ". The state is that of step %ld, t = %.6g s, where it was %.3g %%",
                      state_.step, state_.time, 100 * good_->share);
        why += what;
        good_.reset();
    }
    why += "; a shorter dt";
    if (!controlled()) why += " or step_control";
    if (!explicit_steps() && settings_.alpha() == 0) why += " or rho_infinity below 1";
    fail(why + " may hold");
}

}  // namespace hinge

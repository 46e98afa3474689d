// Dynamics, how long the next step is: dt = "auto" of Newmark's method.
//
// The shortest step lets an axial wave cross the shortest element in twelve; it is the step of an impact. In free flight, and
// while nothing yields, breaks or touches, steps are eight times that, as long as the accelerations change little within one: where
// something vibrates, they do not. Touches and loads are foreseen: a long step in which a touch would begin, or a load changes, is
// not taken.
#include <algorithm>
#include <cmath>

#include "sim/dynamics.h"

namespace hinge {
namespace {

constexpr long long_step = 8;       ///< of the shortest
constexpr int calm_steps = 20;      ///< before steps are long: K anew costs as much as ten steps
constexpr double jump_limit = 1e-3; ///< dt |da| against |v| in a long step, weighted by mass: its error is a twelfth of that

}  // namespace

double Dynamics::shortest_step(const Structure& structure, double duration) {
    double waves = 0;  // crossings a second
    for (const Element& e : structure.elements()) waves = std::max(waves, std::sqrt(e.rigidity.EA / e.rigidity.rhoA) / e.length);
    return duration / std::ceil(duration * std::max(12 * waves, crossing(structure, 1) / 0.9));
}

/// Whether a load of the script changes in the coming long step, looked at as often as the shortest steps would.
bool Dynamics::loads_change() const {
    for (const NodalLoad& load : structure_->model().loads()) {
        if (!load.history || state_.gone[load.node]) continue;
        const double now = load.history(state_.time);
        for (int i = 1; i <= int(long_step); ++i)
            if (load.history(state_.time + i * pace_.shortest) != now) return true;
    }
    return false;
}

void Dynamics::choose_step() {
    const double longer = long_step / double(pace_.length);  // da grows with dt: what a short step says of a long one
    const bool calm = !in_contact() && yielding_.empty() && !restart_ && moved_.empty() && rule_loads_.empty() && jump_ * longer * longer <= jump_limit;
    pace_.calm = calm ? pace_.calm + 1 : 0;
    const bool fits = pace_.done + long_step <= pace_.whole;
    take_steps_of(fits && calm && (pace_.length > 1 || pace_.calm >= calm_steps) && !loads_change() ? long_step : 1);
}

void Dynamics::take_steps_of(long length) {
    if (length == pace_.length) return;
    note_waking("long steps", length > 1, length > 1 ? "nothing yields, breaks or touches" : "back to the shortest");
    pace_.length = length;
    if (length == 1) pace_.calm = 0;  // what ended the long steps is still ahead, or has just happened
    settings_.dt = pace_.shortest * double(length);
    operator_->set_stiffness_factor(settings_.beta * settings_.dt * settings_.dt);
    for (int e = 0; e < int(state_.broken.size()); ++e)
        if (!state_.broken[e]) wants_rebuild(e);
    if (in_contact()) place_contact(state_.displacement), renew_couplings(state_.rotation);
}

}  // namespace hinge

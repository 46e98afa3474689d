// Dynamics, how long the next step is: dt = "auto" of Newmark's method.
//
// The shortest step lets an axial wave cross the shortest element in twelve; it is the step of an impact. In free
// flight, and while nothing yields, breaks or touches, steps are eight times that, as long as the accelerations change
// little within one: where something vibrates, they do not. Touches and loads are foreseen: a long step in which a
// touch would begin, or a load changes, is not taken.
//
// With step control, a step that was taken back is halved, and steps grow again once that has gone well for a while.
#include <algorithm>
#include <cmath>

#include "run/dynamics.h"

namespace hinge {
namespace {

constexpr long long_step = 8;   ///< of the shortest
constexpr int calm_steps = 20;  ///< before steps are long: K anew costs as much as ten steps
constexpr int first_patience =
    8;  ///< halved steps that must go well before they are doubled; twice as many after each that does not
constexpr int most_patience = 512;
constexpr double jump_limit =
    1e-3;  ///< dt |da| against |v| in a long step, weighted by mass: its error is a twelfth of that

}  // namespace

double Dynamics::shortest_step(const Structure& structure, double duration) {
    double waves = 0;  // crossings a second
    for (const Element& e : structure.elements())
        waves = std::max(waves, std::sqrt(e.rigidity.EA / e.rigidity.rhoA) / e.length);
    return duration / std::ceil(duration * std::max(12 * waves, crossing(structure, 1) / 0.9));
}

/// Whether a load of the script changes in the coming long step, looked at as often as the shortest steps would.
bool Dynamics::loads_change() const {
    for (const NodalLoad& load : structure_->model().loads()) {
        if (!load.history || state_.gone[load.node]) continue;
        const double now = load.history(state_.time);
        for (int i = 1; i <= int(long_step); ++i)
            if (load.history(state_.time + i * shortest()) != now) return true;
    }
    return false;
}

void Dynamics::choose_step() {
    if (pace_.length < pace_.own) {
        if (pace_.easy < pace_.patience || pace_.done % (2 * pace_.length) != 0) return;
        pace_.easy = 0;
        return take_steps_of(2 * pace_.length);
    }
    if (pace_.easy >= pace_.patience) pace_.patience = first_patience;
    if (!settings_.automatic) return;
    const long longest = long_step * pace_.own;
    const double longer =
        double(longest) / double(pace_.length);  // da grows with dt: what a short step says of a long one
    const bool calm = !in_contact() && yielding_.empty() && !restart_ && moved_.empty() && rule_loads_.empty() &&
                      jump_ * longer * longer <= jump_limit;
    pace_.calm = calm ? pace_.calm + 1 : 0;
    const bool fits = pace_.done + longest <= pace_.whole;
    take_steps_of(fits && calm && (pace_.length > pace_.own || pace_.calm >= calm_steps) && !loads_change()
                      ? longest
                      : pace_.own);
}

void Dynamics::take_steps_of(long length) {
    if (length == pace_.length) return;
    if (std::max(length, pace_.length) > pace_.own)
        note_waking("long steps", length > pace_.own,
                    length > pace_.own ? "nothing yields, breaks or touches" : "back to the shortest");
    else if (length == pace_.own) note_waking("short steps", false, "back to dt");
    set_length(length);
}

void Dynamics::set_length(long length) {
    if (length == pace_.length) return;
    pace_.length = length;
    pace_.least = std::min(pace_.least, length);
    if (length <= pace_.own) pace_.calm = 0;  // what ended the long steps is still ahead, or has just happened
    settings_.dt = pace_.unit * double(length);
    if (effective_) {
        effective_->set_stiffness_factor(settings_.beta * settings_.dt * settings_.dt);
        for (int e = 0; e < int(state_.broken.size()); ++e)
            if (!state_.broken[e]) wants_rebuild(e);
    }
    if (in_contact()) place_contact(state_.displacement), renew_couplings(state_.rotation);
}

/// After a step of that length was taken back.
void Dynamics::halve(long tried, const std::string& why) {
    ++pace_.rejected;
    pace_.calm = pace_.easy = 0;
    pace_.patience = std::min(2 * pace_.patience, most_patience);
    if (tried == pace_.own) note_waking("short steps", true, why);
    set_length(tried > pace_.own ? pace_.own : tried / 2);
}

}  // namespace hinge

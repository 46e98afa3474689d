#include "run/step_size.h"

#include <algorithm>
#include <cmath>

namespace hinge {
namespace {

constexpr int most_easy = 1 << 20;     ///< more is not counted
constexpr int most_counted = 1 << 29;  ///< of what a run counts step by step

/// Times by which dt = "auto" is shorter than a twelfth of a wave's time for one solution a step to be safe from
/// hinges. Beyond it steps are that twelfth, and Newton's method solves them (newmark.cpp). A blow, a swing and a pull
/// on round bars, 2 and 8 elements, yielding: four short steps take the time of one with Newton's method at 3 to 6
/// times.
constexpr double most_shortened = 4;

}  // namespace

double axial_courant_number(const Structure& structure, double dt) {
    double most = 0;
    for (const Element& e : structure.elements()) {
        const beam::Rigidity& c = e.rigidity;
        most = std::max(most, dt * std::sqrt(c.EA / c.rhoA) / e.length);
        if (!e.yield.elastic()) most = std::max(most, dt * std::sqrt(std::max(c.GAy / c.rhoIx, c.GAx / c.rhoIy)));
    }
    return most;
}

double shortest_step(const Structure& structure, double duration) {
    double courant = 0;                            // largest axial Courant number of a step of 1 s
    for (const Element& e : structure.elements())  // no wave runs along one without mass
        if (e.mass() > 0) courant = std::max(courant, std::sqrt(e.rigidity.EA / e.rigidity.rhoA) / e.length);
    const double wave = 12 * courant, hinges = axial_courant_number(structure, 1) / 0.9;
    return duration / std::ceil(duration * (hinges > most_shortened * wave ? wave : std::max(wave, hinges)));
}

StepSize::StepSize(double dt, double duration, bool automatic, bool controlled, double start)
    : unit_(controlled ? dt / finest_part : dt),
      own_(controlled ? finest_part : 1),
      whole_(own_ * std::llround(duration / dt)),
      automatic_(automatic),
      start_(start) {}

bool StepSize::set_length(long length) {
    if (length == length_) return false;
    length_ = length;
    least_ = std::min(least_, length);
    if (length <= own_) calm_ = 0;  // what ended the long steps is still ahead, or has just happened
    return true;
}

void StepSize::count_easy(bool easy) { easy_ = easy ? std::min(easy_ + 1, most_easy) : 0; }

long StepSize::halved(long tried) {
    ++rejected_;
    calm_ = easy_ = 0;
    if (grew_) patience_ = std::min(2 * patience_, most_patience);
    grew_ = false;
    return tried > own_ ? own_ : tried / 2;
}

bool StepSize::makes_sense() const {
    const auto counts = [](int n) { return n >= 0 && n <= most_counted; };
    return counts(calm_) && counts(easy_) && counts(patience_) && length_ >= 1 && least_ >= 1 && done_ >= 0 &&
           done_ <= whole_;
}

}  // namespace hinge

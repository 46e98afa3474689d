#include "run/step_size.h"

#include <algorithm>
#include <cmath>

namespace hinge {
namespace {

constexpr int most_easy = 1 << 20;     ///< more is not counted
constexpr int most_counted = 1 << 29;  ///< of what a run counts step by step

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

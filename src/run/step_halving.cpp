#include "run/step_halving.h"

#include <algorithm>
#include <cmath>

namespace hinge {
namespace {

/// A rest of a step that is no more than rounding.
constexpr double next_to_nothing = 1e-9;

/// Iterations of a substep after which the next one may be longer, and that adapted steps aim at.
constexpr int few_iterations = 6;
constexpr double aimed_iterations = 5;

}  // namespace

void StepHalving::begin_step(double rest) {
    left_ = rule_.equal ? std::min(rule_.most, rest) : size_;
    if (rule_.equal && rest - left_ < next_to_nothing) left_ = rest;
}

double StepHalving::next() const {
    if (!rule_.equal) return size_;
    const double increment = std::min(size_, left_);
    return left_ - increment < next_to_nothing ? left_ : increment;
}

bool StepHalving::halve(double& increment) {
    ++rejected_;
    increment /= 2;
    if (increment < smallest) return false;
    size_ = increment;
    return true;
}

void StepHalving::go_on_with(double increment) {
    if (!rule_.equal) size_ = increment;
}

void StepHalving::commit(double increment, int iterations) {
    left_ = !rule_.equal || increment == left_ ? 0 : left_ - increment;
    if (!rule_.equal)
        size_ = std::min(size_ * std::clamp(std::sqrt(aimed_iterations / iterations), 0.5, 1.5), rule_.most);
    else if (iterations <= few_iterations) size_ = std::min(2 * size_, rule_.most);
}

}  // namespace hinge

// A factor over time: a function, or points between which it is linear and at which it may jump.
#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace hinge {

/// Empty: constant 1. Of a function nobody can tell where it jumps.
class History {
public:
    using Points = std::vector<std::pair<double, double>>;  ///< time (s), factor; times never fall, two alike: a jump

    History() = default;
    template <std::invocable<double> F>
    History(F function) : function_(std::move(function)) {}
    explicit History(Points points);

    const Points* points() const { return points_.get(); }  ///< null for a function, and for constant 1
    explicit operator bool() const { return bool(function_); }
    /// At a jump the value up to there.
    double operator()(double time) const { return function_(time); }
    /// At a jump the value from there on.
    double from(double time) const;

    /// The factor over a step.
    struct Over {
        double begin, end;
    };
    /// With a jump or a kink within the step: the mean over the step at both ends. One where it begins or ends (to 1e-6
    /// of it) is not in it.
    Over over(double begin, double end) const;
    /// Whether it jumps, or a slope may lie within a step of this length. If not, what the ends of steps make of it by
    /// the trapezium rule misses no more than a part of second order.
    bool may_jump_in(double dt) const;
    /// Whether a jump or a kink lies after `begin` and not after `end`.
    bool bends_within(double begin, double end) const;

private:
    double mean(double begin, double end) const;
    std::function<double(double)> function_;
    std::shared_ptr<const Points> points_;  ///< null for a function
};

}  // namespace hinge

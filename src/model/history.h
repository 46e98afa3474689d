// Time history of a factor: a function, or points with linear interpolation, at which it may jump.
#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace hinge {

/// A factor over time; empty: constant 1. Jumps are known for points, not for a function.
class History {
public:
    using Points = std::vector<std::pair<double, double>>;  ///< time (s), factor; times never fall, two alike: a jump

    History() = default;
    template <std::invocable<double> F>
    History(F function) : function_(std::move(function)) {}
    explicit History(Points points);

    const Points* points() const { return points_.get(); }  ///< null for a function, and for constant 1
    explicit operator bool() const { return bool(function_); }
    /// Value at a time; at a jump the value before it.
    double operator()(double time) const { return function_(time); }
    /// Value at a time; at a jump the value after it.
    double from(double time) const;

    /// The factor at the two ends of a step.
    struct Over {
        double begin, end;
    };
    /// Factor over a step. With a jump or a kink within the step: the mean over the step at both ends. A jump at the
    /// step's start or end (to 1e-6 of its length) is not within it.
    Over over(double begin, double end) const;
    /// True if it jumps, or a slope may lie within a step of this length. If false, the trapezium rule with the values
    /// at the ends of steps has an error of second order.
    bool may_jump_in(double dt) const;
    /// True if a jump or a kink lies after `begin` and not after `end`.
    bool bends_within(double begin, double end) const;

    /// For the fingerprint of a checkpoint: all points; of a function, that there is one.
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(bool(s.function_), s.points_ ? *s.points_ : Points());
    }

private:
    double mean(double begin, double end) const;
    std::function<double(double)> function_;
    std::shared_ptr<const Points> points_;  ///< null for a function
};

}  // namespace hinge

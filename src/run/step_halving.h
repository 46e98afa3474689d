// Step sizes of a static run: a step for which no equilibrium is found is halved, and steps grow again while Newton's
// method converges fast.
#pragma once

namespace hinge {

/// How long steps are, in the unit of the control of the path.
struct StepRule {
    double first, most;
    bool equal;  ///< a step of the run has a given length, and is divided into substeps where it is halved

    static StepRule equal_steps(int number) { return {1.0 / number, 1.0 / number, true}; }
    /// As long as five iterations suffice.
    static StepRule adapted_steps() { return {1, 30, false}; }
};

class StepHalving {
public:
    /// A step that is halved below this ends the run.
    static constexpr double smallest = 1e-5;

    explicit StepHalving(StepRule rule) : rule_(rule), size_(rule.first) {}

    /// Begins a step of the run. `rest`: the part of the path that is not done yet.
    void begin_step(double rest);
    /// What the step still lacks; 0: it is complete.
    double left() const { return left_; }
    /// Length of the substep to be tried next.
    double next() const;
    /// Halves a substep that has failed. False where it is below the smallest.
    bool halve(double& increment);
    /// A substep much shorter or longer than those that failed has been found.
    void go_on_with(double increment);
    void commit(double increment, int iterations);

    double size() const { return size_; }
    long rejected() const { return rejected_; }  ///< substeps that were halved

private:
    const StepRule rule_;
    double size_;  ///< of the next substep, at most
    double left_ = 0;
    long rejected_ = 0;
};

}  // namespace hinge

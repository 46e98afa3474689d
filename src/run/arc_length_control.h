// Arc-length control: a step moves the nodes by a given length along the curve of equilibria, whether the load rises or
// falls (Crisfield, Computers & Structures 13, 1981: a sphere of displacements; translations only).
#pragma once

#include "run/path_control.h"

namespace hinge {

/// The unit of its increments is the arc of the first step, which is a step of load.
class ArcLengthControl : public PathControl {
public:
    /// At most so many steps, to a load factor. `first_step`: the load factor of the first one. `direction`:
    /// displacements in whose direction the path goes on; empty: those of the load.
    ArcLengthControl(int steps, double target, double first_step, std::vector<Vec6> direction = {})
        : steps_(steps), target_(target), first_step_(first_step), direction_(std::move(direction)) {}
    Control kind() const override { return Control::arc; }
    StepRule step_rule() const override { return StepRule::adapted_steps(); }

    std::optional<double> factor_change(const PathIteration& at) override;

    double part_done(double factor, long steps) const override;
    bool is_over(double, long steps) const override { return at_target_ || steps >= steps_; }
    bool reaches_target(double from, double to) const override {
        return (from < target_ && to >= target_) || (from > target_ && to <= target_);
    }
    bool short_of_target() const override { return !at_target_; }
    void commit(double, const std::vector<Vec6>& displacements, bool at_target) override {
        direction_ = displacements, at_target_ = at_target;
    }

private:
    const int steps_;
    const double target_, first_step_;
    double unit_ = 0;              ///< m, arc of the first step
    std::vector<Vec6> direction_;  ///< displacements of the last step
    bool at_target_ = false;
};

}  // namespace hinge

// Load control: a step adds a given part of the load.
#pragma once

#include "run/path_control.h"

namespace hinge {

/// The unit of its increments is the load factor.
class LoadControl : public PathControl {
public:
    explicit LoadControl(int steps) : steps_(steps) {}
    Control kind() const override { return Control::load; }
    StepRule step_rule() const override { return StepRule::equal_steps(steps_); }

    std::optional<double> factor_change(const PathIteration& at) override { return at.number == 1 ? at.increment : 0; }
    double part_done(double factor, long) const override { return factor; }

private:
    const int steps_;
};

}  // namespace hinge

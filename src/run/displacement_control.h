// Displacement control: a step moves one node in one direction by a given part of the way to a target.
#pragma once

#include "run/path_control.h"

namespace hinge {

/// The unit of its increments is the whole way.
class DisplacementControl : public PathControl {
public:
    /// `component`: 0..5, ux uy uz rx ry rz; `way`: from where the run begins to the target, m or rad.
    DisplacementControl(int steps, int node, int component, double way)
        : steps_(steps), node_(node), component_(component), way_(way) {}
    Control kind() const override { return Control::displacement; }
    StepRule step_rule() const override { return StepRule::equal_steps(steps_); }

    double along(const std::vector<Vec6>& shape, double increment) const override {
        return increment * way_ / shape[node_][component_];
    }
    std::optional<double> factor_change(const PathIteration& at) override;
    /// Beyond a limit load, where the driven displacement grows as the load falls, one.
    int stabilised_modes(const std::vector<Vec6>& response) const override {
        return response[node_][component_] * first_response_ < 0;
    }
    bool can_stabilise() const override { return true; }

    double part_done(double, long) const override { return done_; }
    void commit(double increment, const std::vector<Vec6>&, bool) override { done_ += increment; }

private:
    const int steps_, node_, component_;
    const double way_;
    double first_response_ = 0;  ///< of what is driven, to the loads at factor 1; m or rad
    double done_ = 0;            ///< part of the way
};

}  // namespace hinge

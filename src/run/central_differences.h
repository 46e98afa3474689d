// The central difference method: with beta 0 and lumped masses K drops out of eq 15, and the acceleration follows node
// by node.
#pragma once

#include "run/integrator.h"

namespace hinge {

class CentralDifferences : public Integrator {
public:
    CentralDifferences(Workspace& w, KeptMass& mass, Stages& stages)
        : Integrator(w, mass, stages), accelerate_(stages.add("accelerate")) {
        w.assembly.set_return_tolerance(one_solution);
    }

    void predict(const Step& step) override;
    void solve(Step& step) override {
        stages_.timed(accelerate_, [&] { accelerate(step); });
    }
    int correct_stage() override { return accelerate_; }
    bool correct(Step& step) override { return ++step.iteration, false; }
    const std::vector<Vec6>& change() const override { return w_.trial.acceleration; }
    double swing() const override { return swing_; }
    void save(Writer& to) const override { to(fastest); }
    void restore(Reader& from) override { from(fastest); }

private:
    void accelerate(Step& step);
    std::vector<Vec6> of_joined(const std::vector<Vec6>& of) const;
    void solve_joined();
    int accelerate_;
    std::vector<double> power_of_;  ///< a^T F of each piece of the nodes, N m / s^2
    /// J, of the last step: dt^2 a^T M a / 8. In a linear model the velocities half a step before and after conserve
    /// v^T M v / 2 + u^T K u / 2; with the velocity between them the energy differs by this.
    double swing_ = 0;
    std::vector<Vec6> joined_force_, joined_change_;  ///< of nodes that constraints join: F - R, and T q
};

}  // namespace hinge

// Control of the load path of a static run: the condition that, beside equilibrium, fixes the load factor of a step.
#pragma once

#include <memory>
#include <optional>

#include "core/types.h"
#include "run/static_settings.h"
#include "run/step_halving.h"

namespace hinge {

/// An iteration of Newton's method, for which a control finds the change of the load factor. Displacements: six numbers
/// a node, translations and rotation vector.
struct PathIteration {
    int number;                           ///< 1, 2, ...
    double increment;                     ///< of the step, in the unit of the control
    const std::vector<Vec6>& total;       ///< displacements of the step so far
    const std::vector<Vec6>& correction;  ///< those that the out-of-balance forces ask for
    const std::vector<Vec6>& response;    ///< those that the loads at factor 1 ask for
};

class PathControl {
public:
    virtual ~PathControl() = default;
    virtual Control kind() const = 0;
    virtual StepRule step_rule() const = 0;

    /// By how much of a shape a step of `increment` sets off along it.
    virtual double along(const std::vector<Vec6>& shape, double increment) const {
        return (void)shape, (void)increment, 0;
    }
    /// Change of the load factor in an iteration; none where no equilibrium meets the condition.
    virtual std::optional<double> factor_change(const PathIteration& at) = 0;
    /// Number of negative eigenvalues that the condition takes away from the tangent. `response`: as in PathIteration.
    virtual int stabilised_modes(const std::vector<Vec6>& response) const { return (void)response, 0; }
    /// True if stabilised_modes can be other than 0.
    virtual bool can_stabilise() const { return false; }

    /// The part of the path that is done, 0 to 1.
    virtual double part_done(double factor, long steps) const = 0;
    virtual bool is_over(double factor, long steps) const { return part_done(factor, steps) >= 1 - 1e-12; }
    /// True if the path ends at a load factor that a step between these two reaches: the rest is a step of load.
    virtual bool reaches_target(double from, double to) const { return (void)from, (void)to, false; }
    /// True if the path has not come to that load factor.
    virtual bool short_of_target() const { return false; }
    /// A step has become part of the path. `at_target`: it was the step of load that ends the path.
    virtual void commit(double increment, const std::vector<Vec6>& displacements, bool at_target) {
        (void)increment, (void)displacements, (void)at_target;
    }
};

/// `way`: from where the run begins to the target, of displacement control.
std::unique_ptr<PathControl> make_path_control(const StaticSettings& settings, double way);

}  // namespace hinge

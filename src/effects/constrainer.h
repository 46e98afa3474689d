// The role of an effect that ties degrees of freedom to each other: rigid links, diaphragms.
#pragma once

#include "algebra/node_blocks.h"
#include "model/linear_constraint.h"
#include "state/configuration.h"

namespace hinge {

/// Declares degrees of freedom that depend on others. The run eliminates them (run/constraints.h), so that what is
/// solved for keeps the constraints, and the effect sets what a linear solution leaves out: finite rotations.
class Constrainer {
public:
    virtual ~Constrainer() = default;
    /// Adds the constraints with the factors that they have in a configuration. Always the same degrees of freedom.
    virtual void add_constraints(const Pose& at, std::vector<LinearConstraint>& list) const = 0;
    /// Whether these factors change as the nodes move.
    virtual bool factors_vary() const = 0;
    /// Sets the displacements in `to`, which the nodes have reached from `from` by these rotation vectors.
    virtual void place(const Pose& from, const std::vector<Vec3>& rotation_step, Configuration& to) const = 0;
    /// Sets the velocities; the accelerations, with those towards the centre of rotation.
    virtual void set_velocities(Configuration& of) const = 0;
    virtual void set_accelerations(Configuration& of) const = 0;
    /// Adds the change of the forces on the nodes that the factors' own change with the configuration makes.
    /// `unbalanced`: R - F of each dependent node.
    virtual void add_curvature(const Pose& at, const std::vector<Vec6>& unbalanced, Blocks& blocks) const = 0;
};

}  // namespace hinge

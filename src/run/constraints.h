// The linear constraints of a run: collects them from its effects, keeps their factors as the structure rotates, moves
// dependent nodes with those on which they depend, and passes their forces on.
#pragma once

#include "algebra/reduction.h"
#include "effects/effect_list.h"

namespace hinge {

class Constraints {
public:
    Constraints(Workspace& w, const EffectList& effects);

    const Reduction& reduction() const { return reduction_; }

    /// Gives dependent nodes the velocity that follows from the others. Throws InputError where they have another one.
    void begin();

    /// Nodes have lost their last member, or a checkpoint was read: the constraints that are left, where the state is.
    void rebuild();
    /// Takes the factors of the trial configuration.
    void renew();
    /// Sets the displacements of the trial, which the nodes have reached from `from` by these rotation vectors.
    void place(const Pose& from, const std::vector<Vec3>& rotation_step);
    /// Sets the velocities of the trial.
    void set_velocities();
    /// Sets the accelerations of the trial. `of_step`: they are those of a step that is tried, Bossak's weighted ones.
    void set_accelerations(bool of_step);
    /// Passes the out-of-balance forces of dependent nodes on to the nodes on which they depend, as forces of the
    /// constraint that are part of R. `load`: F of a node. Explicit steps: what the acceleration of the trial resists
    /// is added first.
    template <class F>
    void balance(F load) {
        if (w_.kind.explicit_steps) add_inertia();
        for (const Reduction::Dependent& d : reduction_.dependents())
            unbalanced_[d.node] = w_.resisting[d.node] - load(d.node);
        pass_on();
    }
    /// Adds the constraints' own part of the tangent stiffness, by the forces of the last balance.
    void add_curvature(const Pose& at, Blocks& blocks) const;

    /// The trial of the last balance becomes the state: keeps its forces.
    void commit() { of_state_ = unbalanced_, has_state_ = true; }
    /// The same part by `factor` times the forces of the state. False where no step has been done since the run was
    /// made or read, so that nobody knows them, and there would be such a part.
    bool add_curvature_of_state(const Pose& at, double factor, Blocks& blocks) const;

    /// All constraints, with their factors in a configuration.
    std::vector<LinearConstraint> list_at(const Pose& at) const;

private:
    void add_inertia();
    void pass_on();

    Workspace& w_;
    const RoleList<Constrainer>& constrainers_;
    Reduction reduction_;
    std::vector<Vec6> unbalanced_;  ///< R - F of dependent nodes before they are balanced
    std::vector<Vec6> of_state_;    ///< the same where the last step that was kept ended
    bool has_state_ = false;
    const bool factors_vary_;  ///< as the nodes move
};

}  // namespace hinge

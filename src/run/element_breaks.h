// What follows when elements break, and when constraints end: masses and velocities of the nodes that are left.
#pragma once

#include "run/constraints.h"
#include "run/dynamic_forces.h"

namespace hinge {

class ElementBreaks {
public:
    ElementBreaks(Workspace& w, const EffectList& effects, KeptMass& mass,
                  const std::unique_ptr<Integrator>& integrator, const DynamicForces& forces, Host& host)
        : w_(w), effects_(effects), mass_(mass), integrator_(integrator), forces_(forces), host_(host) {}

    /// Each element becomes an offset mass, and what that asks of the nodes is passed on to all velocities. False where
    /// M has no solution.
    bool apply(const std::vector<Break>& breaks);
    /// Constraints of nodes that are left; a node that is no longer joined has its own mass again.
    void rebuild_constraints();
    bool constraints_due = false;  ///< constraints have ended in the step

private:
    Workspace& w_;
    const EffectList& effects_;
    KeptMass& mass_;
    const std::unique_ptr<Integrator>& integrator_;
    const DynamicForces& forces_;
    Host& host_;
};

}  // namespace hinge

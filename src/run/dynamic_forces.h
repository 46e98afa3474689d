// Forces and accelerations of dynamics: R at a pose, M a = F - R where a run or a step begins, and what impulses do.
#pragma once

#include <optional>

#include "effects/effect_list.h"
#include "run/constraints.h"
#include "run/effect_times.h"
#include "run/integrator.h"
#include "run/notice.h"

namespace hinge {

class DynamicForces {
public:
    /// `step`: the one that is tried; its failure is set. `integrator` is made later.
    DynamicForces(Workspace& w, const EffectList& effects, KeptMass& mass,
                  const std::unique_ptr<Integrator>& integrator, Host& host, Step& step, EffectTimes& times)
        : w_(w), effects_(effects), mass_(mass), integrator_(integrator), host_(host), step_(step), times_(times) {}

    /// A step begins: whether blocks may lag in it follows from the iterations of the one before.
    void begin_step();
    /// Internal and inertia forces where the nodes are now (eqs 3, 10, 13); p of each element.
    void recover(double time);
    Failure failure_of_elements() const;
    /// M a = F - R: at the start, and again whenever a force has vanished at once. With the acceleration of before,
    /// half a step of a force that is no longer there would go into the velocities.
    void find_acceleration(std::vector<Vec6>& out_of_balance);
    /// What strains elements at once where a run begins (heat, prestress) may put them beyond yield. They begin with
    /// the forces on the yield surface, at the deformation that they have. So does a bar between fixed ends that is
    /// heated slowly: initial energy is what it stores then and its plastic work, not what it would store without
    /// yield. Loads between nodes that act at once may bring other elements beyond yield, by work that nothing
    /// supplies: these stay. None where nothing flows.
    std::optional<Notice> return_to_yield_surface();
    /// Reactions where the run begins: what holds the supports' share of the mass of elements that accelerate at once.
    /// In explicit steps a support has no such share. Effects have found what they need in them without it.
    void add_inertia_to_reactions();
    /// Host::respond.
    ImpulseResponse respond(const std::vector<Vec6>& impulse);
    double work_of_supports(const std::vector<Vec6>& supports, const std::vector<Vec6>& velocity) const;

    bool acceleration_due = false;  ///< a force has vanished: the next step begins with the acceleration found anew

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.acceleration_due, s.iterations_, s.may_lag_);
    }

private:
    void renew_blocks();
    void require_solved(const SolveReport& report);

    Workspace& w_;
    const EffectList& effects_;
    KeptMass& mass_;
    const std::unique_ptr<Integrator>& integrator_;
    Host& host_;
    Step& step_;
    EffectTimes& times_;
    int iterations_ = 0;    ///< of this step: recoveries of its stresses
    bool may_lag_ = false;  ///< Force::blocks_may_lag in this step
};

}  // namespace hinge

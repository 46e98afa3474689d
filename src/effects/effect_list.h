// The effects of a run, and for each role the list of effects that have it. Each list has the order of
// list.inc.
#pragma once

#include "effects/constrainer.h"
#include "effects/effect.h"
#include "effects/roles.h"

namespace hinge {

/// An effect in one of its roles.
template <class Role>
struct InRole {
    Effect* effect;
    Role* role;
    Role* operator->() const { return role; }
};
template <class Role>
using RoleList = std::vector<InRole<Role>>;

struct EffectList {
    EffectList(Workspace& w, Host& host);
    /// Whether one of the effects has this trait.
    bool any(bool EffectTraits::*trait) const;
    bool has(std::string_view name) const;
    /// The facts of this kind that an effect has of the run, for advice (facts.h); null where no effect has them.
    template <class Facts>
    const Facts* facts() const {
        for (const auto& effect : all)
            if (const auto* found = dynamic_cast<const Facts*>(effect.get())) return found;
        return nullptr;
    }

    std::vector<std::unique_ptr<Effect>> all;
    RoleList<Load> loads;
    RoleList<Force> forces;
    RoleList<SectionForceSource> section_forces;
    RoleList<Prescriber> prescribers;
    RoleList<Constrainer> constrainers;
    RoleList<MatrixWatcher> matrix_watchers;
    RoleList<ContactLaw> contact_laws;
    RoleList<Breaker> breakers;
    RoleList<BreakListener> break_listeners;
    RoleList<StepLimiter> step_limiters;
    RoleList<Sleeper> sleepers;
    RoleList<RestKeeper> rest_keepers;
    RoleList<Heater> heaters;
    RoleList<StaticPrescriber> static_prescribers;
};

/// True if a function of the role is true for one of the list.
template <class Role>
bool any_of(const RoleList<Role>& list, bool (Role::*says)() const) {
    return std::any_of(list.begin(), list.end(), [&](const InRole<Role>& r) { return (r.role->*says)(); });
}

/// The accounts of the energy balance: those that are always there, and those of effects that the scene calls for.
AccountList accounts_of(const EffectList& effects);

}  // namespace hinge

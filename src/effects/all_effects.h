// All effects that the engine knows, in the order in which they act in a step: a new one is a line in list.inc.
#pragma once

#include "effects/effect.h"

namespace hinge {

const std::vector<EffectKind>& all_effects();

/// Those that the scene calls for.
using EffectList = std::vector<std::unique_ptr<Effect>>;
EffectList effects_of(Workspace& w, Host& host);

/// The accounts of the energy balance: those that are always there, and those of effects that the scene calls for.
AccountList accounts_of(const EffectList& effects);

/// What all effects damp each element by; empty where none does.
std::vector<ElementDamping> damping_of(const Structure& structure);

/// What is simulated and what is not, and why.
std::vector<PlanLine> plan_of(const Structure& structure, const RunKind& kind);

}  // namespace hinge

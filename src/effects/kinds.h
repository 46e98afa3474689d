// What the files of this folder share: each gives one kind of effect, and all_effects.cpp lists them.
#pragma once

#include "effects/effect.h"

namespace hinge {

/// Why an effect that acts in dynamics alone is on, or is not: the call that declares it.
inline std::string only_in_dynamics(const RunKind& run, const std::string& call) {
    return run.dynamic ? call : "declared by " + call + ", but acts in dynamics only";
}

EffectKind inertia_kind();
EffectKind loads_kind();
EffectKind gravity_kind();
EffectKind large_displacement_kind();
EffectKind plasticity_kind();
EffectKind fracture_kind();
EffectKind broken_members_kind();
EffectKind contact_kind();
EffectKind moving_supports_kind();
EffectKind rest_kind();
EffectKind script_functions_kind();

}  // namespace hinge

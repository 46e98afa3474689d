// What the files of this folder share: each gives one kind of effect, and list.inc lists them.
#pragma once

#include "core/built.h"
#include "effects/effect.h"
#include "effects/roles.h"

namespace hinge {

/// Why an effect that acts in dynamics alone is on, or is not: the call that declares it.
inline std::string only_in_dynamics(const RunKind& run, const std::string& call) {
    return run.dynamic ? call : "declared by " + call + ", but acts in dynamics only";
}

#define HINGE_EFFECT(name) EffectKind name##_kind();
#include "effects/list.inc"
#undef HINGE_EFFECT

}  // namespace hinge

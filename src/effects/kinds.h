// The functions that make the kinds of effects, one a file; list.inc lists them. Helpers that these files share.
#pragma once

#include "core/built.h"
#include "effects/effect.h"
#include "effects/roles.h"

namespace hinge {

/// Reason in the plan why statics does not have what a call declares.
inline std::string only_in_dynamics(const std::string& call) {
    return "declared by " + call + ", but acts in dynamics only";
}

/// EffectKind::leave_out of an effect that is declared by Model::declare under this name.
template <const auto& name>
void leave_out_declared(Model& model) {
    model.undeclare(name);
}

#define HINGE_EFFECT(name) EffectKind name##_kind();
#include "effects/list.inc"
#undef HINGE_EFFECT

}  // namespace hinge

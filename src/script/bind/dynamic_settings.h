// The options of model:dynamic as the settings of a dynamic run.
#pragma once

#include "run/settings.h"
#include "script/lua/options.h"

namespace hinge::script {

enum class IntegratorKind { newmark, energy_momentum, explicit_steps };

/// The field integrator.
IntegratorKind read_integrator(Options& o);

/// All other settings. Throws InputError, naming the field, where one is out of range or has no meaning beside others.
DynamicSettings read_dynamic_settings(Options& o, const Model& model, const Structure& structure, IntegratorKind kind);

}  // namespace hinge::script

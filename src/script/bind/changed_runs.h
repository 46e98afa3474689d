// Runs with other settings than a script's own: hinge run --within varies them to see what they change in the answers.
#pragma once

#include "run/settings.h"
#include "script/lua/lua_support.h"

namespace hinge {
class Model;
}

namespace hinge::script {

/// Replaces the options of model:static or model:dynamic, the table at index 2, by what the function of
/// core.change_runs returns for them.
void change_options(lua_State* L, const char* kind);

/// True if runs have other models than the script's own just now.
bool models_change(lua_State* L);

/// Multiplies the elements of each member, and the stiffness and the strength of its material. `copy`: the run's own.
void change_model(lua_State* L, Model& copy);

/// Multiplies the step that dt = "auto" has chosen, and what step control accepts by default.
void change_steps(lua_State* L, DynamicSettings& settings);

/// Adds core.change_runs and what is read from such runs to the module on top of the stack.
void add_changed_runs(lua_State* L);

}  // namespace hinge::script

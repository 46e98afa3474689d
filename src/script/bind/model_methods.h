// The methods of a model and of its load cases. A function that adds one includes this header alone.
#pragma once

#include "script/bind/load_options.h"
#include "script/bind/model_box.h"

namespace hinge::script {

#define HINGE_MODEL_METHOD(name, function) int function(lua_State* L);
#define HINGE_MODEL_RUN(name, function) int function(lua_State* L);
#include "script/bind/model_methods.inc"
#undef HINGE_MODEL_METHOD
#undef HINGE_MODEL_RUN
int set_gravity(lua_State* L);
int add_mass_on_member(lua_State* L);
#define HINGE_LOAD_ON(target, function, ...) int function(lua_State* L);
#include "script/bind/load_targets.inc"
#undef HINGE_LOAD_ON

/// Calls body, which changes its model: runs made before are then refused (advance).
int declaring(lua_State* L, const char* name, Body body);
void note_change(lua_State* L, ScriptModel& model, const char* name);
template <Name name, int most, Body body>
int declares(lua_State* L) {
    return taking(L, name.text, most, [](lua_State* inner) { return declaring(inner, name.text, body); });
}

}  // namespace hinge::script

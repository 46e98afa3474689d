// The module for a host that runs scripts, and its context.
#pragma once

#include <lua.hpp>
#include <memory>

namespace hinge::script {

struct ScriptContext;

/// Makes `require "hinge"` work in this state, and returns its context, for the host's settings. Once per state.
std::shared_ptr<ScriptContext> prepare(lua_State* L);

}  // namespace hinge::script

extern "C" int luaopen_hinge(lua_State* L);

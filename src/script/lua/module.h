// What a host that runs scripts needs: the module, and the context behind it.
#pragma once

#include <lua.hpp>
#include <memory>

namespace hinge::script {

struct Context;

/// Makes `require "hinge"` work in this state, and returns what the host may set before a script runs. Once per state.
std::shared_ptr<Context> prepare(lua_State* L);

}  // namespace hinge::script

extern "C" int luaopen_hinge(lua_State* L);

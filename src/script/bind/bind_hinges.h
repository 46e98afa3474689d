// Binding of the method run:hinges (lua/hinge/results/hinges.lua).
#pragma once

#include <lua.hpp>

namespace hinge::script {

void open_hinges(lua_State* L, int module);

}  // namespace hinge::script

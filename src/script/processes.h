// Cases of a study in processes of their own (bind_processes.cpp).
#pragma once

#include <lua.hpp>

namespace hinge::script {

void open_processes(lua_State* L, int module);  ///< adds its functions to the table at that place of the stack

}  // namespace hinge::script

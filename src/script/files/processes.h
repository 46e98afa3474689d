// Cases of a study in processes of their own (bind_processes.cpp), and what those of hinge render share
// (bind_film.cpp).
#pragma once

#include <lua.hpp>

namespace hinge::script {

void open_processes(lua_State* L, int module);  ///< adds its functions to the table at that place of the stack
void open_film(lua_State* L, int module);       ///< as well

}  // namespace hinge::script

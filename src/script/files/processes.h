// Bindings for separate processes: cases of a study (bind_processes.cpp) and shared data of hinge render
// (bind_film.cpp).
#pragma once

#include <lua.hpp>

namespace hinge::script {

void open_processes(lua_State* L, int module);  ///< adds its functions to the table at that place of the stack
void open_film(lua_State* L, int module);       ///< as well

}  // namespace hinge::script

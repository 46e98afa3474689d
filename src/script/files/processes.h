// Bindings for separate processes: cases of a study (bind_processes.cpp), shared data of hinge render (bind_film.cpp),
// and interpreters of other languages behind walls (bind_interpreters.cpp).
#pragma once

#include <lua.hpp>

namespace hinge::script {

void open_processes(lua_State* L, int module);     ///< adds its functions to the table at that place of the stack
void open_film(lua_State* L, int module);          ///< as well
void open_interpreters(lua_State* L, int module);  ///< as well

}  // namespace hinge::script

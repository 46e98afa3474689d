// Pictures, frames and plots: drawn by this process, or for a script in the sandbox by one outside its walls.
#pragma once

#include <lua.hpp>

#include "record/drawing_order.h"

namespace hinge::script {

/// Draws or writes what the order says. Throws InputError or OutsideError.
void draw(lua_State* L, const DrawingOrder& order);

/// True if another process draws for this one.
bool drawn_elsewhere();

/// Starts the process that draws from now on. It takes orders alone, writes into the output folder and where an X
/// server needs it, and ends with this process. To be called before walls stand around this process; its Lua state
/// must not have run anything of the script.
void start_drawer(lua_State* L);

}  // namespace hinge::script

// Limits of a script that is not trusted. Calls that it may use are in lua/hinge/program/sandbox.lua; folders that it
// may write to, in output_file.
#pragma once

#include <lua.hpp>

namespace hinge::script {

/// Resources that the whole process may use from here on.
struct Limits {
    double memory = 1 << 30;    ///< bytes
    double seconds = 60;        ///< of wall time
    double instructions = 1e9;  ///< of Lua's machine, in all coroutines together
};

/// Applies the limits to the process. An allocation beyond `memory` fails as if there were no more; beyond the other
/// two the process prints a message and ends with status 1, even inside a native call. Once per process, before the
/// script is loaded.
void confine(lua_State* L, const Limits& limits);

}  // namespace hinge::script

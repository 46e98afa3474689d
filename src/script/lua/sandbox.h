// The limits of a script that is not trusted. What it may call is in lua/hinge/sandbox.lua; where it may write, in
// output_file.
#pragma once

#include <lua.hpp>

namespace hinge::script {

/// What the process may use from here on, whichever part of it does.
struct Limits {
    double memory = 1 << 30;    ///< bytes
    double seconds = 60;        ///< of wall time
    double instructions = 1e9;  ///< of Lua's machine, in all coroutines together
};

/// Holds the process to the limits. An allocation beyond `memory` fails as if there were no more; past the other two
/// the process says so and ends with status 1, in the midst of a native call too. Once per process, before the script
/// is loaded.
void confine(lua_State* L, const Limits& limits);

}  // namespace hinge::script

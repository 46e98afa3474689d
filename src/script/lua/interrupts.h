// Ctrl-C and SIGTERM: the first one ends the script, or prints why it has to wait; the second one ends the program at
// once.
#pragma once

#include "script/lua/context.h"

namespace hinge::script {

/// Makes signals end the script: a run under way after its step, with its checkpoint; a script's own loop at its
/// present line, or in ten seconds if a run is under way. Longer operations are named on stderr after a second.
void end_on_signals(lua_State* L);
void forget_signals();

/// Sets whether Lua runs the script itself, not a study of it, which checks signals itself. Returns the old value.
bool script_runs(bool is_script);

/// Sets whether the script steps a run, which checks signals before each step.
void run_is_under_way(bool is);

/// Message if abandoned work (Interrupted without a text) or the script's own line ends the script.
std::string ended_halfway(lua_State* L);

/// "interrupted by Ctrl-C"
const char* interrupted_by(const ScriptContext& c);

void open_interrupts(lua_State* L, int module);

}  // namespace hinge::script

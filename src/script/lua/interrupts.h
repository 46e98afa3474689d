// Ctrl-C and SIGTERM: the first one ends the script, or says what it waits for; the second one ends the program at
// once.
#pragma once

#include "script/lua/objects.h"

namespace hinge::script {

/// From now on. A run that is under way ends after its step, with its checkpoint. A script's own loop ends at the line
/// where it is; if a run is under way, in ten seconds. What takes longer than a second is named on stderr.
void end_on_signals(lua_State* L);
void forget_signals();

/// Whether Lua works on the script itself, not on a study of it, which looks for signals by itself. Returns what was.
bool script_runs(bool is_script);

/// Whether the script steps a run, which looks for signals before each step.
void run_is_under_way(bool is);

/// What is said where work that was left halfway (Interrupted without a text) or the script's own line ends the script.
std::string ended_halfway(lua_State* L);

/// "interrupted by Ctrl-C"
const char* interrupted_by(const Context& c);

void open_interrupts(lua_State* L, int module);

}  // namespace hinge::script

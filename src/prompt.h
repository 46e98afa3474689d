// What the program adds to lua/hinge/prompt.lua: lines from a terminal, and Ctrl-C.
#pragma once

struct lua_State;

namespace hinge {

/// Pushes read(ask, complete): a line, or nil at the end of the input; and whether it was given up with Ctrl-C.
/// complete(line) gives a list of what the line's last word may become. Pushes nil where nobody sits at a terminal.
void push_line_reader(lua_State* L);

/// From now on Ctrl-C ends what Lua is doing in this state with the error "interrupted", not the program.
void stop_on_interrupt(lua_State* L);

}  // namespace hinge

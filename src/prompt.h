// Functions of the program for lua/hinge/program/prompt.lua: reading lines from a terminal, and Ctrl-C.
#pragma once

struct lua_State;

namespace hinge {

/// Pushes read(ask, complete): a line, or nil at the end of the input; and whether it was given up with Ctrl-C.
/// complete(line) gives a list of what the line's last word may become. Pushes nil if the input is no terminal.
void push_line_reader(lua_State* L);

/// After this call Ctrl-C raises the error "interrupted" in this Lua state and does not end the program.
void stop_on_interrupt(lua_State* L);

}  // namespace hinge

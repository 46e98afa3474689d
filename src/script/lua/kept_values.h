// Converts a table of the script to bytes and back: booleans, numbers, strings, and tables of them.
#pragma once

#include <string>

#include "script/lua/lua_support.h"

namespace hinge::script {

/// Packs the table at `index`. Throws InputError, naming `what`.field, if it contains anything else.
std::string pack_table(lua_State* L, int index, const std::string& what);

/// Throws Damaged (core/archive.h) if these are not the bytes of a table.
void check_packed_table(const std::string& bytes);

/// Replaces the contents of the table at `index`.
void unpack_table(lua_State* L, int index, const std::string& bytes);

}  // namespace hinge::script

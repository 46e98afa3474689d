// A table of the script's own values as bytes, and back: booleans, numbers, strings, and tables of them.
#pragma once

#include <string>

#include "script/lua/lua_support.h"

namespace hinge::script {

/// The table at `index`. Throws InputError, naming the place as `what`.field, where it holds anything else.
std::string pack_table(lua_State* L, int index, const std::string& what);

/// Throws Damaged (core/archive.h) where these are not the bytes of a table.
void check_packed_table(const std::string& bytes);

/// The table at `index` gets these contents in the place of its own.
void unpack_table(lua_State* L, int index, const std::string& bytes);

}  // namespace hinge::script

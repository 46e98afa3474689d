// Lua values as JSON.
#pragma once

#include <lua.hpp>

#include "record/events.h"

namespace hinge::script {

/// A Lua value as JSON: tables with items are lists, others objects with their keys in order; a number that is not
/// finite is its text.
Json to_json(lua_State* L, int index, int depth = 0);

}  // namespace hinge::script

// hinge run --json: messages of a run as JSON objects, one a line.
#pragma once

#include <nlohmann/json.hpp>

#include "script/lua/objects.h"

namespace hinge::script {

using Json = nlohmann::ordered_json;

/// Writes { "event": kind, ... } as a line, if --json is on.
void write_event(const Context& c, const char* kind, const Json& fields);

/// A Lua value as JSON: tables with items are lists, others objects with their keys in order; a number that is not
/// finite is its text.
Json to_json(lua_State* L, int index, int depth = 0);

}  // namespace hinge::script

// hinge run --json: messages of a run as JSON objects, one a line.
#pragma once

#include <nlohmann/json.hpp>

#include "record/context.h"

namespace hinge {

using Json = nlohmann::ordered_json;

/// Writes { "event": kind, ... } as a line, if --json is on.
void write_event(const Context& c, const char* kind, const Json& fields);

/// The text of a JSON value, as files have it: indented by two, or on one line; bytes that are no UTF-8 are replaced.
std::string whole_text(const Json& value);
std::string line_text(const Json& value);

}  // namespace hinge

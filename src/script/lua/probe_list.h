// The numbers of a probe as a Lua table that is filled only where a script changes it.
#pragma once

#include <lua.hpp>

#include <memory>

#include "record/probe.h"

namespace hinge::script {

struct ProbeBox {
    static constexpr const char* lua_name = "hinge.probe";
    std::shared_ptr<Probe> value;
};

/// For `probe.time` and `probe.value`, the probe at index 1: pushes a new table that reads the first n numbers, those
/// recorded so far, without a copy. It works like a list for #, ipairs, pairs and the functions of `table`, and becomes
/// one when it is written to or pairs is called.
int push_probe_list(lua_State* L, bool times);

/// Makes the table at `index` a plain list if it is one of those: for readers without metamethods.
void fill_probe_list(lua_State* L, int index);

}  // namespace hinge::script

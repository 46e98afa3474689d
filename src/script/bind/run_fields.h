// The fields of a run that a script reads: run.time, run.energy, run.verdict, ...
#pragma once

#include "script/lua/lua_support.h"

namespace hinge::script {

/// __index of a run: pushes a method, or the value of a field. Other names raise an error.
int run_fields(lua_State* L);

/// Registers the names of the fields, for messages ("did you mean") and for completion.
void name_run_fields(lua_State* L);

}  // namespace hinge::script

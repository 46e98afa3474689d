// core.shape: the properties of a section by its dimensions (section/shapes.h), as hinge.section.general takes them.
#pragma once

#include <lua.hpp>

namespace hinge::script {

/// shape(kind, { depth =, width =, ... }, what) returns a table. `what`: what the messages of errors begin with.
int push_shape(lua_State* L);

}  // namespace hinge::script

// Members of a model: model:member, model:line and model:defaults; and what hinge.model shares with them.
#pragma once

#include "model/model.h"
#include "script/lua/options.h"

namespace hinge::script {

struct Elements {
    int number;
    bool automatic;
};

/// A whole number, or 'auto'.
Elements read_elements(Options& o, const char* field, Formulation formulation, Elements fallback);

/// The script's line for each node, member and support: only for hinge check, which names it.
void note_line(lua_State* L, Model& m, const char* kind, int index);

}  // namespace hinge::script

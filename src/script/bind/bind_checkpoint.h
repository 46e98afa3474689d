// Checkpoints of a script's runs.
#pragma once

#include "script/bind/run_box.h"
#include "script/lua/options.h"

namespace hinge::script {

/// Reads the field `checkpoint` of model:dynamic: a file name, or { file =, every =, keep = }.
std::optional<CheckpointPlan> read_checkpoint_plan(Options& o, const Model& model);

/// Between two steps: ends the run with an error if a signal came.
void mind_interrupts(lua_State* L, ScriptContext& c, RunRecord& r);

}  // namespace hinge::script

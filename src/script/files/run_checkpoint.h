// Checkpoints of a script's runs: run, probes, history and frames in one file, and the moments at which it is written.
#pragma once

#include "script/lua/objects.h"

namespace hinge::script {

/// The field `checkpoint` of model:dynamic: a file name, or { file =, every =, keep = }.
std::optional<CheckpointPlan> read_checkpoint_plan(Options& o, const Model& model);

/// Before a run's first step: where the program is to resume, the run goes on from its checkpoint, if there is one;
/// else the first one is written, to know before hours have passed that it can be.
void begin_checkpoints(lua_State* L, Context& c, RunRecord& r);

/// Between two steps: ends the run with an error if a signal came.
void mind_interrupts(lua_State* L, Context& c, RunRecord& r);

/// Between two steps, with all that the script did after the last one: writes the checkpoint if it is due, and once the
/// run is over.
void keep_if_due(lua_State* L, Context& c, RunRecord& r);

void open_checkpoint(lua_State* L, int module);  ///< run:checkpoint, run:resume, hinge.resume

}  // namespace hinge::script

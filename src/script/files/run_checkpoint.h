// Checkpoints of a script's runs: run, probes, history and frames in one file, and when it is written.
#pragma once

#include "script/lua/objects.h"

namespace hinge::script {

/// Reads the field `checkpoint` of model:dynamic: a file name, or { file =, every =, keep = }.
std::optional<CheckpointPlan> read_checkpoint_plan(Options& o, const Model& model);

/// Before a run's first step: with resume, continues from the run's checkpoint, if there is one; else writes the first
/// one, to find out before hours of work whether it can be written.
void begin_checkpoints(lua_State* L, Context& c, RunRecord& r);

/// Between two steps: ends the run with an error if a signal came.
void mind_interrupts(lua_State* L, Context& c, RunRecord& r);

/// Between two steps, after the script's own work on the last one: writes the checkpoint if it is due, and at the end
/// of the run.
void keep_if_due(lua_State* L, Context& c, RunRecord& r);

void open_checkpoint(lua_State* L, int module);  ///< run:checkpoint, run:resume, hinge.resume

}  // namespace hinge::script

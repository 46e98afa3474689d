// Checkpoints of recorded runs: run, probes, history and frames in one file, and when it is written.
#pragma once

#include "record/context.h"
#include "record/run_record.h"

namespace hinge {

/// A name without a folder is in the output folder. A script that is not trusted has no other.
std::string checkpoint_path(const Context& c, const std::string& name);

/// Writes the checkpoint of a dynamic run between two of its steps.
void write_checkpoint(const Context& c, const RunRecord& r, const std::string& path);

/// Before its first step, the run goes on from there: either with all of it, or nothing has changed. Throws
/// OutsideError for a file that is damaged, InputError for one of another run.
void read_checkpoint(Context& c, RunRecord& r, const std::string& path);

/// Before a run's first step: with resume, continues from the run's checkpoint, if there is one; else writes the first
/// one, to find out before hours of work whether it can be written.
void begin_checkpoints(Context& c, RunRecord& r);

/// Between two steps, after the program's own work on the last one: writes the checkpoint if it is due, and at the end
/// of the run.
void keep_if_due(Context& c, RunRecord& r);

/// "step 20, t = 0.02 s"
std::string place_text(const Run& run);

}  // namespace hinge

// Events of the elements, joints and connectors of a run, in order: events.csv, and the damage in summary.json.
#pragma once

#include "record/events.h"
#include "record/run_record.h"

namespace hinge {

/// Records elements that have been in contact, yielded or broken for the first time, after a step, joints that have
/// yielded about an axis, reached a limit of their own in statics or broken, and connectors that have broken. Before
/// the first step: excludes events before this run.
void note_happenings(RunRecord& record);

/// The columns of events.csv, and the text of one event in each; "" for nothing.
std::vector<std::string> event_columns(const Run& run);
std::vector<std::string> event_fields(const Run& run, const ElementEvent& happening);

/// Opens events.csv of a run, with the events that a run from a checkpoint already has. There is no file without
/// events.
void begin_happenings(RunRecord& record, const std::string& path);

/// Writes events that are not yet in the file, if the run has one.
void write_happenings(RunRecord& record);

/// Writes the final events.csv in the output folder, also for a run without history.
void leave_happenings(const Context& c, RunRecord& record);

/// Damage of each group: members, elastic, yielded, broken, and touched (also if elastic or not).
Json damage_by_group(const Run& run);

}  // namespace hinge

// What happened to the elements of a run, in order: events.csv, and the damage in summary.json.
#pragma once

#include "script/record/events.h"

namespace hinge::script {

/// After a step: elements that have been in contact, flowed or broken for the first time. Before the first step: what
/// has happened before this run does not count.
void note_happenings(RunRecord& record);

/// The columns of events.csv, and what it has in them of one event: text, "" for nothing.
std::vector<std::string> event_columns(const Run& run);
std::vector<std::string> event_fields(const Run& run, const ElementEvent& happening);

/// From now on the run's events go to that file, with those that it has already: it may go on from a checkpoint. There
/// is no file where nothing has happened.
void begin_happenings(RunRecord& record, const std::string& path);

/// Events that are not yet in the file, where the run has one.
void write_happenings(RunRecord& record);

/// events.csv in the output folder as it is at the end, also of a run that kept no history.
void leave_happenings(const Context& c, RunRecord& record);

/// Of each group: members, elastic, yielded, broken, and touched, whatever else they are.
Json damage_by_group(const Run& run);

}  // namespace hinge::script

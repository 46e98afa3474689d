// What happened to the elements of a run, in order: events.csv, and the damage in summary.json.
#pragma once

#include "script/events.h"

namespace hinge::script {

/// After a step: elements that have been in contact, flowed or broken for the first time. Before the first step: what
/// has happened before this run does not count.
void note_happenings(RunRecord& record);

/// events.csv in the output folder, where anything has happened.
void write_happenings(const Context& c, const RunRecord& record);

/// Of each group: members, elastic, yielded, broken, and touched, whatever else they are.
Json damage_by_group(const Run& run);

}  // namespace hinge::script

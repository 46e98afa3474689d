// hinge check: what a run would work on, and what in it is a likely mistake, without a step.
#pragma once

#include <string>

#include "model/warnings.h"
#include "script/lua/objects.h"

namespace hinge::script {

/// The run's counts and mass in a line.
std::string checked_run(const RunRecord& record);

/// What it works on: its bodies with their masses and lowest natural periods, the shortest time that an axial wave
/// takes through an element, and warnings that name the culprit, the script's line and what to do.
std::string checked_model(const RunRecord& record);

/// What of that is found quickly, beside hinge::warnings of its model: what was seen where the run was made
/// (RunRecord::likely_mistakes), mechanisms, a long step, loads that are far too large, columns that may buckle (the
/// last two of models of at most `most_solved` nodes, by a linear solution; periods of bodies of as many). `all`: a
/// long step also where nothing strikes, and members whose axial force makes eq 14 unsafe, which a run tells of its own
/// forces; `loads`: those that are too large.
std::vector<Warning> warnings_of_run(const RunRecord& record, int most_solved, bool all, bool loads);

/// Pairs of nodes that connectors join.
std::vector<std::pair<int, int>> joined_by_connectors(const Model& model);

/// "what (line, and 3 more like it); advice"
std::string warning_text(const Warning& d);

/// What a run says of itself, with the line of the member that it speaks of.
Warning warning_of(const Run& run, const RunWarning& w);

/// Tells of a likely mistake, once.
void tell(Context& c, const Warning& w);

/// Tells what effects say of a run as a whole, where it ends or is left; nothing of one that has taken no step.
void tell_findings(Context& c, const RunRecord& r);

/// hinge run: tells of likely mistakes, each once, in ten lines at most; of a model before it is run, and of the run.
void look_over(Context& c, const Model& model);
void look_over(Context& c, RunRecord& record);

}  // namespace hinge::script

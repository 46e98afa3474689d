// hinge check: summary of the model of a run and its likely mistakes, without a step.
#pragma once

#include <string>

#include "model/warnings.h"
#include "record/context.h"
#include "record/run_record.h"

namespace hinge {

/// Line with the run's counts and mass.
std::string checked_run(const RunRecord& record);

/// Summary of the model: its bodies with their masses and lowest natural periods, the shortest time that an axial wave
/// takes through an element, and warnings that name the culprit, the script's line and what to do.
std::string checked_model(const RunRecord& record);

/// Warnings that are found quickly, in addition to hinge::warnings of its model: those from the start of the run
/// (RunRecord::likely_mistakes), mechanisms, a long step, loads that are far too large, columns that may buckle (the
/// last two of models of at most `most_solved` nodes, by a linear solution; periods of bodies of as many). `all`: a
/// long step also without impact, and members whose axial force makes eq 14 unsafe, which a run checks by its forces;
/// `loads`: those that are too large.
std::vector<Warning> warnings_of_run(const RunRecord& record, int most_solved, bool all, bool loads);

/// Pairs of nodes that are joined other than by members (node_links), the ground left out.
std::vector<std::pair<int, int>> linked_nodes(const Model& model);

/// "what (line, and 3 more like it); advice"
std::string warning_text(const Warning& d);

/// A run's own warning, with the line of the member concerned.
Warning warning_of(const Run& run, const RunWarning& w);

/// Prints a likely mistake, once.
void tell(Context& c, const Warning& w);

/// Prints the findings of effects on a run as a whole, when it ends or is left; nothing for a run without a step.
void tell_findings(Context& c, const RunRecord& r);

/// hinge run: prints likely mistakes, each once, in ten lines at most; of a model before its run, and of the run.
void look_over(Context& c, const Model& model);
void look_over(Context& c, RunRecord& record);

}  // namespace hinge

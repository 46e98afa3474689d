// hinge check: summary of the model of a run and its likely mistakes, without a step.
#pragma once

#include <string>

#include "advice/model_warnings.h"
#include "advice/advised_run.h"

namespace hinge {

/// Line with the run's counts and mass.
std::string checked_run(const AdvisedRun& of);

/// Summary of the model: its bodies with their masses and lowest natural periods, the shortest time that an axial wave
/// takes through an element, and warnings that name the culprit, the script's line and what to do.
std::string checked_model(const AdvisedRun& of);

/// Warnings that are found quickly, in addition to hinge::warnings of its model: those from the start of the run
/// (AdvisedRun::likely_mistakes), mechanisms, a long step, loads that are far too large, columns that may buckle (the
/// last two of models of at most `most_solved` nodes, by a linear solution; periods of bodies of as many). `all`: a
/// long step also without impact, and members whose axial force makes eq 14 unsafe, which a run checks by its forces;
/// `loads`: those that are too large.
std::vector<Warning> warnings_of_run(const AdvisedRun& of, int most_solved, bool all, bool loads);

/// Pairs of nodes that are joined other than by members (node_links), the ground left out.
std::vector<std::pair<int, int>> linked_nodes(const Model& model);

}  // namespace hinge

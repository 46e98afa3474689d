// Contents of summary.json for a run.
#pragma once

#include "record/events.h"
#include "record/run_record.h"

namespace hinge {

/// Adds the fields of summary.json from "kind" to "instability", for the present state of the run.
void describe_run(Json& j, const RunRecord& record);

/// The effects of a run, with its recording.
std::vector<PlanLine> effects_of(const RunRecord& record);

/// Description of the run's probes for probes.json and summary.json: a list of { name, node, quantity, unit }.
Json probes_json(const RunRecord& record);

/// What a program adds to summary.json of its own; null for nothing.
struct OwnSummary {
    Json head = Json::object();  ///< fields before those of the run: script, case, parameters
    Json whole;                  ///< verdict and reason where the program says how all its runs went
    Json results, notes;
};

/// Verdict of the program, and why.
struct Outcome {
    std::string verdict = "completed", reason, cause;
};

/// Writes summary.json of the last run into the output folder, if there is one, and the final events.csv.
Outcome write_summary(Context& c, const OwnSummary& own);

}  // namespace hinge

// Contents of summary.json for a run.
#pragma once

#include "record/events.h"

namespace hinge::script {

/// Adds the fields of summary.json from "kind" to "instability", for the present state of the run.
void describe_run(Json& j, const RunRecord& record);

/// Description of the run's probes for probes.json and summary.json: a list of { name, node, quantity, unit }.
Json probes_json(const RunRecord& record);

}  // namespace hinge::script

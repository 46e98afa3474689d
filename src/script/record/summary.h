// What summary.json says of a run.
#pragma once

#include "script/record/events.h"

namespace hinge::script {

/// Adds the fields of summary.json from "kind" to "instability", as the run stands.
void describe_run(Json& j, const RunRecord& record);

/// What the run's probes record, for probes.json and summary.json: a list of { name, node, quantity, unit }.
Json probes_json(const RunRecord& record);

}  // namespace hinge::script

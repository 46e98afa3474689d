// A run, and what is kept of it for advice.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "advice/warning.h"
#include "run/run.h"

namespace hinge {

struct AdvisedRun {
    std::shared_ptr<Run> run;
    std::string asked_at;                  ///< the script's line that made the run
    std::vector<Warning> likely_mistakes;  ///< found when it was made
    std::optional<Warning> of_units;       ///< of its model: a value that looks as if in another unit
};

}  // namespace hinge

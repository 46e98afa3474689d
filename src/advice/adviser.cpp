#include "advice/adviser.h"

#include <algorithm>

#include "run/dynamics.h"

namespace hinge {

bool is_time_to_check(const Run& run) {
    constexpr long checks = 20, most_between = 100;
    const auto* dynamics = run.dynamics();
    if (!dynamics || run.verdict() != Verdict::running) return run.verdict() != Verdict::failed;
    return run.steps_done() % std::clamp(dynamics->own_steps() / checks, 1L, most_between) == 0;
}

void advise(Run& run) {
    auto log = std::make_unique<WarningLog>();
    WarningLog& warnings = *log;
    run.attach(std::move(log));
    for (auto* make : {
#define HINGE_ADVISER(make) make,
#include "advice/advisers.inc"
#undef HINGE_ADVISER
         })
        if (auto adviser = make(run, warnings)) run.attach(std::move(adviser));
}

const std::vector<Warning>& warnings_of(const Run& run) {
    static const std::vector<Warning> none;
    for (const auto& watch : run.watches())
        if (const auto* log = dynamic_cast<const WarningLog*>(watch.get())) return log->list();
    return none;
}

std::vector<Warning> findings_of(const Run& run) {
    std::vector<Warning> list;
    for (const auto& watch : run.watches())
        if (const auto* adviser = dynamic_cast<const Adviser*>(watch.get())) adviser->list_findings(run, list);
    return list;
}

std::string reason_with_advice(const Run& run) {
    std::string reason = run.reason();
    for (const auto& watch : run.watches())
        if (const auto* adviser = dynamic_cast<const Adviser*>(watch.get())) reason += adviser->remedy(run);
    return reason;
}

}  // namespace hinge

// The plan's line of functions of the script that a step calls. Whatever calls them is an effect of its own.
#include <algorithm>

#include "effects/declared.h"
#include "effects/kinds.h"

namespace hinge {
namespace {

std::vector<PlanLine> script_functions_plan(const Structure& s, const RunKind& run) {
    const std::vector<ScriptFunctions> list = script_functions(s.model());
    if (list.empty()) return {{"script functions", false, "not declared", ""}};
    const auto acts = [&](const ScriptFunctions& f) { return run.takes(f.dynamic_only); };
    const ScriptFunctions& first = list.front();
    return {{"script functions", std::any_of(list.begin(), list.end(), acts),
             acts(first) ? first.call : only_in_dynamics(first.call), first.asked_at}};
}

}  // namespace

EffectKind script_functions_kind() { return {.name = "script functions", .plan = script_functions_plan}; }

}  // namespace hinge

// The plan's line of functions of the script that a step calls. Whatever calls them is an effect of its own.
#include <algorithm>

#include "effects/kinds.h"

namespace hinge {
namespace {

std::vector<PlanLine> plan(const Structure& s, const RunKind& run) {
    const Model& m = s.model();
    const auto any = [](const auto& list, auto has) { return std::any_of(list.begin(), list.end(), has); };
    const bool fracture = any(m.fracture(), [](const FractureRule& r) { return r.hook || r.batch; });
    const bool contact = any(m.contact(), [](const ContactRule& r) { return r.pairs || r.on_contact || r.on_release; });
    const bool load = any(m.loads(), [](const NodalLoad& l) { return l.follows_state(); });
    const bool history = any(m.loads(), [](const NodalLoad& l) { return bool(l.history); });
    const bool rule = fracture || contact || load;
    return {{"hooks", (run.dynamic && rule) || history,
             fracture  ? only_in_dynamics(run, "a function in model:fracture")
             : contact ? only_in_dynamics(run, "a function in model:contact")
             : load    ? only_in_dynamics(run, "a load that is a function")
             : history ? "a load's history"
                       : "not declared",
             fracture          ? m.asked_at("fracture")
             : contact         ? m.asked_at("contact")
             : rule || history ? m.asked_at("loads")
                               : ""}};
}

}  // namespace

EffectKind script_functions_kind() { return {"hooks", {}, plan, nullptr}; }

}  // namespace hinge

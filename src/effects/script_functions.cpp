// The plan's line of functions of the script that a step calls. Whatever calls them is an effect of its own.
#include <algorithm>

#include "effects/connectors.h"
#include "effects/kinds.h"
#include "effects/member_loads.h"

namespace hinge {
namespace {

std::vector<PlanLine> plan(const Structure& s, const RunKind& run) {
    const Model& m = s.model();
    const auto any = [](const auto& list, auto has) { return std::any_of(list.begin(), list.end(), has); };
    const bool fracture = any(m.fracture(), [](const FractureRule& r) { return r.hook || r.batch; });
    const bool contact = any(m.contact(), [](const ContactRule& r) { return r.pairs || r.on_contact || r.on_release; });
    const bool load = any(m.loads(), [](const NodalLoad& l) { return l.follows_state(); });
    const bool history = any(m.loads(), [](const NodalLoad& l) { return bool(l.history); });
    const bool along =
        any(m.declared<MemberLoad>(member_loads_effect), [](const MemberLoad& l) { return l.has_history; });
    const bool law = any(m.declared<Connector>(connectors_effect), [](const Connector& c) {
        return std::any_of(std::begin(c.law), std::end(c.law), [](const ConnectorLaw& l) { return bool(l); });
    });
    const bool rule = fracture || contact || load;
    return {{"script functions", (run.dynamic && rule) || history || along || law,
             fracture           ? only_in_dynamics(run, "a function in model:fracture")
             : contact          ? only_in_dynamics(run, "a function in model:contact")
             : load             ? only_in_dynamics(run, "a load that is a function")
             : history || along ? "a load's history"
             : law              ? "a connector's law"
                                : "not declared",
             fracture          ? m.asked_at("fracture")
             : contact         ? m.asked_at("contact")
             : load || history ? m.asked_at("loads")
             : along           ? m.asked_at(member_loads_effect)
             : law             ? m.asked_at(connectors_effect)
                               : ""}};
}

}  // namespace

EffectKind script_functions_kind() { return {"script functions", {}, plan, nullptr}; }

}  // namespace hinge

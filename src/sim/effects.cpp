#include "sim/effects.h"

#include <algorithm>

namespace hinge {

std::vector<Effect> effects_of(const Structure& structure, bool dynamic, bool geometric) {
    const Model& model = structure.model();
    const auto asked_at = [&](const char* name) { return model.asked_at(name); };
    const auto only = [&](bool declared, const char* call) { return !declared ? std::string("not declared") : dynamic ? std::string(call) : "declared by " + std::string(call) + ", but acts in dynamics only"; };
    const bool rules = !model.fracture().empty(), contact = model.contact().has_value();
    const bool friction = contact && model.contact()->settings.rule == contact::ContactRuleKind::surface && model.contact()->settings.friction > 0;
    const auto& elements = structure.elements();
    const bool breakable = std::any_of(elements.begin(), elements.end(), [](const Element& e) { return e.fracture >= 0; });
    const bool hook = std::any_of(model.fracture().begin(), model.fracture().end(), [](const FractureRule& r) { return bool(r.hook); });
    const bool history = std::any_of(model.loads().begin(), model.loads().end(), [](const NodalLoad& l) { return bool(l.history); });
    const bool could_yield = std::any_of(elements.begin(), elements.end(), [](const Element& e) { return !e.yield.elastic(); });

    std::vector<Effect> list;
    list.push_back({"inertia", dynamic, dynamic ? "model:dynamic" : "statics", ""});
    list.push_back({"loads", !model.loads().empty(), model.loads().empty() ? "not declared" : std::to_string(model.loads().size()) + " on nodes", asked_at("loads")});
    list.push_back({"gravity", model.gravity().has_value(), model.gravity() ? "model:gravity" : "not declared", asked_at("gravity")});
    list.push_back({"large displacement", structure.large(), structure.large() ? "the default; displacement = \"small\" leaves it out" : "displacement = \"small\"", structure.large() ? "" : asked_at("model")});
    list.push_back({"geometric stiffness", geometric && structure.large(), !structure.large() ? "displacement is small" : geometric ? "part of large displacement" : "geometric = false", ""});
    list.push_back({"plasticity", structure.can_yield(), structure.can_yield() ? "a material has a yield stress" : could_yield ? "plasticity = false" : "no section can yield", asked_at("plasticity")});
    list.push_back({"fracture", dynamic && breakable, rules && !breakable ? "no member is in the rule's group" : only(rules, "model:fracture"), asked_at("fracture")});
    list.push_back({"contact", dynamic && contact, only(contact, "model:contact"), asked_at("contact")});
    list.push_back({"friction", dynamic && friction, friction ? only(true, "model:contact with friction") : contact ? "no friction given to model:contact" : "no contact", friction ? asked_at("contact") : ""});
    list.push_back({"damping", false, "not offered", ""});
    list.push_back({"ground", false, "supports do not move", ""});
    list.push_back({"hooks", (dynamic && hook) || history, hook ? only(true, "a function in model:fracture") : history ? "a load's history" : "not declared", hook ? asked_at("fracture") : history ? asked_at("loads") : ""});
    return list;
}

}  // namespace hinge

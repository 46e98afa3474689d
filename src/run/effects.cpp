#include "run/effects.h"

#include <algorithm>

namespace hinge {

std::vector<Effect> effects_of(const Structure& structure, bool dynamic, bool geometric) {
    const Model& model = structure.model();
    const auto asked_at = [&](const char* name) { return model.asked_at(name); };
    const auto only = [&](bool declared, const char* call) {
        return !declared ? std::string("not declared")
               : dynamic ? std::string(call)
                         : "declared by " + std::string(call) + ", but acts in dynamics only";
    };
    const bool rules = !model.fracture().empty(), contact = !model.contact().empty();
    const bool friction = std::any_of(model.contact().begin(), model.contact().end(), [](const ContactRule& r) {
        return r.settings.rule == contact::ContactRuleKind::surface && r.settings.friction > 0;
    });
    const auto& elements = structure.elements();
    const bool breakable =
        std::any_of(elements.begin(), elements.end(), [](const Element& e) { return e.fracture >= 0; });
    const bool hook = std::any_of(model.fracture().begin(), model.fracture().end(),
                                  [](const FractureRule& r) { return r.hook || r.batch; });
    const bool touch_hook = std::any_of(model.contact().begin(), model.contact().end(),
                                        [](const ContactRule& r) { return r.pairs || r.on_touch || r.on_release; });
    const bool load_rule =
        std::any_of(model.loads().begin(), model.loads().end(), [](const NodalLoad& l) { return l.follows_state(); });
    const bool history =
        std::any_of(model.loads().begin(), model.loads().end(), [](const NodalLoad& l) { return bool(l.history); });
    const bool could_yield =
        std::any_of(elements.begin(), elements.end(), [](const Element& e) { return !e.yield.elastic(); });

    std::vector<Effect> list;
    list.push_back({"inertia", dynamic, dynamic ? "model:dynamic" : "statics", ""});
    list.push_back({"loads", !model.loads().empty(),
                    model.loads().empty() ? "not declared" : std::to_string(model.loads().size()) + " on nodes",
                    asked_at("loads")});
    list.push_back({"gravity", model.gravity().has_value(), model.gravity() ? "model:gravity" : "not declared",
                    asked_at("gravity")});
    list.push_back(
        {"large displacement", structure.large(),
         structure.large() ? "the default; displacement = \"small\" leaves it out" : "displacement = \"small\"",
         structure.large() ? "" : asked_at("model")});
    list.push_back({"geometric stiffness", geometric && structure.large(),
                    !structure.large() ? "displacement is small"
                    : geometric        ? "part of large displacement"
                                       : "geometric = false",
                    ""});
    list.push_back({"plasticity", structure.can_yield(),
                    structure.can_yield() ? "a material has a yield stress"
                    : could_yield         ? "plasticity = false"
                                          : "no section can yield",
                    asked_at("plasticity")});
    list.push_back({"fracture", dynamic && breakable,
                    rules && !breakable ? "no member is in the rule's group" : only(rules, "model:fracture"),
                    asked_at("fracture")});
    list.push_back({"contact", dynamic && contact, only(contact, "model:contact"), asked_at("contact")});
    list.push_back({"friction", dynamic && friction,
                    friction  ? only(true, "model:contact with friction")
                    : contact ? "no friction given to model:contact"
                              : "no contact",
                    friction ? asked_at("contact") : ""});
    list.push_back({"damping", false, "not offered", ""});
    const bool ground = !model.motions().empty();
    list.push_back({"ground", dynamic && ground, ground ? only(true, "model:move") : "supports do not move",
                    ground ? asked_at("ground") : ""});
    const bool rule = hook || touch_hook || load_rule;
    list.push_back({"hooks", (dynamic && rule) || history,
                    hook         ? only(true, "a function in model:fracture")
                    : touch_hook ? only(true, "a function in model:contact")
                    : load_rule  ? only(true, "a load that is a function")
                    : history    ? "a load's history"
                                 : "not declared",
                    hook              ? asked_at("fracture")
                    : touch_hook      ? asked_at("contact")
                    : rule || history ? asked_at("loads")
                                      : ""});
    return list;
}

}  // namespace hinge

#include "model/section_laws.h"

#include <algorithm>
#include <set>

#include "section/material_law.h"
#include "section/section_law.h"
#include "model/structure.h"

namespace hinge {

std::vector<std::string> optional_laws(const Structure& structure) {
    std::set<std::string> names;
    for (const Element& e : structure.elements()) {
        if (!e.law) continue;
        const MemberData& member = structure.model().members()[e.member];
        if (std::string(e.law->name()).starts_with("exact")) names.insert("exact");
        else if (e.law->ignores_shape() && has_exact_law(*member.section, e.yield)) names.insert("eq 14");
        if (!e.law->keeps_strength())
            for (const auto& law : member.material->laws) names.insert(law->name());
        if (member.backbone && !e.law->keeps_strength()) names.insert(member.backbone->name());
        if (member.law && !e.law->keeps_strength()) names.insert(member.law->name());
    }
    for (const OmittedLaw& law : structure.model().declared<OmittedLaw>(omitted_laws)) names.erase(law.name);
    return {names.begin(), names.end()};
}

void leave_out_law(const std::string& name, Model& model) {
    const auto& members = model.members();
    const bool known =
        name == "exact" || name == "eq 14" || std::ranges::any_of(members, [&](const MemberData& m) {
            return (m.backbone && name == m.backbone->name()) || (m.law && name == m.law->name()) ||
                   std::ranges::any_of(m.material->laws, [&](const auto& l) { return name == l->name(); });
        });
    if (known) model.declare<OmittedLaw>(omitted_laws, {name});
}

}  // namespace hinge

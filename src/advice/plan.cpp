#include "advice/plan.h"

#include <algorithm>

#include "core/text.h"
#include "run/element_count.h"

namespace hinge {

std::string kinetic_at_start(const Run& run) {
    const double kinetic = std::string_view(run.kind()) == "dynamic" ? run.energy()["kinetic"] : 0;
    return kinetic > 0 ? "  begins with " + number_text(kinetic, 4) + " J of kinetic energy\n" : "";
}

std::string plan_of(const AdvisedRun& of, const std::vector<PlanLine>& effects) {
    const Run& run = *of.run;
    const Structure& s = run.structure();
    std::string text = std::string(run.kind()) + " run" + (of.asked_at.empty() ? "" : ", " + of.asked_at) + ": " +
                       count_text(long(s.model().members().size()), "member") + ", " +
                       count_text(long(s.elements().size()), "element") + ", " + std::to_string(s.free_dofs()) +
                       (s.free_dofs() == 1 ? " degree" : " degrees") + " of freedom, " +
                       count_text(run.planned_steps(), "step") + "\n" + kinetic_at_start(run);
    std::size_t name = 0, why = 0;
    for (const PlanLine& e : effects) name = std::max(name, e.name.size()), why = std::max(why, e.because.size());
    for (const PlanLine& e : effects)
        text += "  " + e.name + std::string(name - e.name.size() + 2, ' ') + (e.active ? "on   " : "off  ") +
                e.because + (e.asked_at.empty() ? "" : std::string(why - e.because.size() + 2, ' ') + e.asked_at) +
                "\n";
    if (const auto groups = element_groups(s.model()); !groups.empty()) {
        text +=
            "  elements = \"auto\", elements_accuracy = " + number_text(s.model().options().elements_accuracy) + ":\n";
        for (const ElementGroup& g : groups)
            text += "    " + std::to_string(g.elements) + " in " + count_text(g.members, "member") + ": " + g.because +
                    "\n";
    }
    return text;
}

}  // namespace hinge

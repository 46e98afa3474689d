#include "effects/fracture_rule.h"

#include <algorithm>

#include "core/errors.h"
#include "effects/fracture.h"

namespace hinge {
namespace {

/// Of two rules for the same members the later one holds. Refuses one that would so take the place of another without a
/// word: limits that of a function, and a group's that of a group within it.
void refuse_replacing(const Model& model, const FractureRule& rule) {
    const auto at = [](const FractureRule& r) { return r.asked_at.empty() ? "" : " of " + r.asked_at; };
    const auto name = [&](const FractureRule& r) { return "'" + model.groups()[r.group] + "'"; };
    const std::vector<FractureRule>& rules = fracture_rules(model);
    const auto same =
        std::find_if(rules.rbegin(), rules.rend(), [&](const FractureRule& r) { return r.group == rule.group; });
    if (same != rules.rend() && same->hook && !rule.hook)
        throw InputError(std::string("model:fracture: this would replace the function") + at(*same) + " for " +
                         (rule.group < 0 ? "all members" : "the members of group " + name(rule)) +
                         "; where both are meant to hold, give the limits and the function in one call");
    if (rule.group < 0) return;  // those of groups hold beside it
    std::vector<int> members(model.groups().size(), 0), shared = members;
    for (const MemberData& m : model.members()) {
        const bool meant = std::find(m.groups.begin(), m.groups.end(), rule.group) != m.groups.end();
        for (int g : m.groups) ++members[g], shared[g] += meant;
    }
    for (const FractureRule& r : rules)
        if (r.group >= 0 && r.group != rule.group && members[r.group] > 0 && shared[r.group] == members[r.group])
            throw InputError("model:fracture: group " + name(rule) + " has all members of group " + name(r) +
                             ", so this would replace the rule" + at(r) +
                             " for all of them; declare the rule for group " + name(r) + " after this one");
}

}  // namespace

void add_fracture(Model& model, FractureRule rule) {
    auto& rules = model.change_declared<FractureRule>(fracture_effect);
    if (model.options().mass == MassShape::cubic)
        throw InputError(
            "model:fracture: a model with mass = 'cubic' cannot break, for half a pair of elements has no shape of its "
            "own; declare it with mass = 'linear'");
    refuse_replacing(model, rule);
    rules.push_back(std::move(rule));
}

int fracture_rule_of(const std::vector<FractureRule>& rules, const MemberData& member) {
    int found = -1;
    for (std::size_t r = 0; r < rules.size(); ++r) {
        const int group = rules[r].group;
        const bool fits = group < 0
                              ? found < 0 || rules[found].group < 0
                              : std::find(member.groups.begin(), member.groups.end(), group) != member.groups.end();
        if (fits) found = int(r);
    }
    return found;
}

const std::vector<std::string> section_field_names = {"curvature_x",
                                                      "curvature_y",
                                                      "axial_strain",
                                                      "twist",
                                                      "plastic_curvature_x",
                                                      "plastic_curvature_y",
                                                      "plastic_axial_strain",
                                                      "plastic_twist",
                                                      "curvature_rate_x",
                                                      "curvature_rate_y",
                                                      "axial_strain_rate",
                                                      "twist_rate",
                                                      "Mx",
                                                      "My",
                                                      "N",
                                                      "Mz",
                                                      "f_y",
                                                      "plastic_work",
                                                      "shear_x",
                                                      "shear_y",
                                                      "hinge_rotation_x",
                                                      "hinge_rotation_y",
                                                      "member",
                                                      "element",
                                                      "end",
                                                      "node",
                                                      "plastic",
                                                      "time",
                                                      "dt",
                                                      "step"};

double value_of(const SectionView& v, SectionField field) {
    switch (field) {
        case SectionField::curvature_x: return v.strain.curvature_x;
        case SectionField::curvature_y: return v.strain.curvature_y;
        case SectionField::axial_strain: return v.strain.axial;
        case SectionField::twist: return v.strain.twist;
        case SectionField::plastic_curvature_x: return v.plastic_strain.curvature_x;
        case SectionField::plastic_curvature_y: return v.plastic_strain.curvature_y;
        case SectionField::plastic_axial_strain: return v.plastic_strain.axial;
        case SectionField::plastic_twist: return v.plastic_strain.twist;
        case SectionField::curvature_rate_x: return v.strain_rate.curvature_x;
        case SectionField::curvature_rate_y: return v.strain_rate.curvature_y;
        case SectionField::axial_strain_rate: return v.strain_rate.axial;
        case SectionField::twist_rate: return v.strain_rate.twist;
        case SectionField::Mx: return v.force.Mx;
        case SectionField::My: return v.force.My;
        case SectionField::N: return v.force.N;
        case SectionField::Mz: return v.force.Mz;
        case SectionField::f_y: return v.f_y;
        case SectionField::plastic_work: return v.plastic_work;
        case SectionField::shear_x: return v.shear_x;
        case SectionField::shear_y: return v.shear_y;
        case SectionField::hinge_rotation_x: return v.hinge_rotation_x;
        case SectionField::hinge_rotation_y: return v.hinge_rotation_y;
        case SectionField::member: return v.member + 1;
        case SectionField::element: return v.element + 1;
        case SectionField::end: return v.end;
        case SectionField::node: return v.node + 1;
        case SectionField::plastic: return v.plastic;
        case SectionField::time: return v.time;
        case SectionField::dt: return v.dt;
        case SectionField::step: return v.step;
    }
    return 0;
}

}  // namespace hinge

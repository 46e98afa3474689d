// Fracture rules that a run never came to: those that hold for no member, and functions that were never called. And
// limits of curvature as hinge rotations.
#include <algorithm>

#include "advice/adviser.h"
#include "advice/curvature_limits.h"
#include "effects/effect_list.h"
#include "effects/facts.h"
#include "effects/fracture.h"

namespace hinge {
namespace {

/// `called`: of each rule, how often its function was. A rule that a later one for the same group took the place of is
/// not named.
void name_idle_rules(const Structure& structure, const std::vector<long>& called, std::vector<Warning>& list) {
    const auto& rules = fracture_rules(structure.model());
    std::vector<int> members(rules.size(), 0);
    int last = -1;
    for (const Element& e : structure.elements())
        if (e.member != last) {
            last = e.member;
            if (const int rule = fracture_rule_of(rules, structure.model().members()[last]); rule >= 0) ++members[rule];
        }
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const FractureRule& rule = rules[i];
        const bool function = bool(rule.hook);
        const bool replaced = std::any_of(rules.begin() + long(i) + 1, rules.end(),
                                          [&](const FractureRule& r) { return r.group == rule.group; });
        if (replaced || (function ? called[i] > 0 : members[i] > 0 || rule.group < 0)) continue;
        const std::string name = std::string("the ") + (function ? "function" : "limits") + " of model:fracture" +
                                 (rule.asked_at.empty() ? "" : " at " + rule.asked_at),
                          group = rule.group < 0 ? "" : structure.model().groups()[rule.group];
        if (members[i] > 0)
            list.push_back({Warning::Kind::fracture,
                            name + " was called 0 times: it is asked of sections that " +
                                (rule.where == FractureRule::Where::yielded ? "have ever been" : "are") +
                                " fully plastic, and none was",
                            "where = 'all'? With it the function is called for every section at every step"});
        else
            list.push_back({Warning::Kind::fracture,
                            name + (function ? " was called 0 times, for it holds" : " hold") + " for no member" +
                                (rule.group < 0 ? "" : " of group '" + group + "'"),
                            rule.group < 0 ? "every member has a rule of one of its groups"
                                           : "put members into the group, or declare its rule after those of other "
                                             "groups that the same members are in"});
    }
}

class FractureRules : public Adviser {
public:
    void list_findings(const Run& run, std::vector<Warning>& list) const override {
        name_idle_rules(run.structure(), run.effect_list().facts<RuleCalls>()->calls(), list);
        name_curvature_limits(run.structure(), &run.state(), list);
    }
};

}  // namespace

std::unique_ptr<Adviser> advise_of_fracture_rules(const Run& run, WarningLog&) {
    if (!run.effect_list().facts<RuleCalls>()) return nullptr;
    return std::make_unique<FractureRules>();
}

}  // namespace hinge

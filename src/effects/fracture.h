// Fracture, as a script declares it.
#pragma once

#include "effects/fracture_rule.h"
#include "model/model.h"

namespace hinge {

inline constexpr const char* fracture_effect = "fracture";

/// Declares a rule. Raises InputError where it would replace another one without notice, or where members cannot break.
void add_fracture(Model& model, FractureRule rule);

inline const std::vector<FractureRule>& fracture_rules(const Model& model) {
    return model.declared<FractureRule>(fracture_effect);
}
/// Index of the rule of a member: the last one for one of its groups, else the last one for all members; -1: none.
int fracture_rule_of(const std::vector<FractureRule>& rules, const MemberData& member);

}  // namespace hinge

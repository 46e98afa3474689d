// Contact between members: its declaration, and the events that other parts read.
#pragma once

#include <functional>

#include "contact/member_contacts.h"
#include "model/model.h"
#include "state/state.h"

namespace hinge {

inline constexpr const char* contact_effect = "contact";

/// Contact rule between members. Of several rules, the last one for the groups of both members applies, else the last
/// one for all members.
struct ContactRule {
    contact::ContactSettings settings;
    std::vector<int> groups;  ///< both members are in one of these; empty: all members
    bool between = false;     ///< one member in the first of two groups, one in the second
    std::function<std::optional<contact::ContactSettings>(int member_a, int member_b)>
        pairs;  ///< called once for a pair of members: its settings, or none
    std::function<void(const contact::ContactEvent&, int member_a, int member_b)> on_contact, on_release;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.settings, s.groups, s.between, bool(s.pairs), bool(s.on_contact), bool(s.on_release));
    }
};

inline void add_contact(Model& model, ContactRule rule) { model.declare(contact_effect, std::move(rule)); }
inline const std::vector<ContactRule>& contact_rules(const Model& model) {
    return model.declared<ContactRule>(contact_effect);
}
/// Index of the rule for two members; -1: none.
int contact_rule(const std::vector<ContactRule>& rules, const MemberData& a, const MemberData& b);
/// True if a rule holds for the member and others.
bool can_collide(const std::vector<ContactRule>& rules, const MemberData& member);

/// Null in a scene without contact.
inline const contact::Contact* contact_of(const State& state) {
    return state.data.find<contact::Contact>(contact_effect);
}

}  // namespace hinge

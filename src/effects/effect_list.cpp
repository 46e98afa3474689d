#include "effects/effect_list.h"

#include <algorithm>

#include "effects/all_effects.h"

namespace hinge {
namespace {

template <class Role>
void list_those(const std::vector<std::unique_ptr<Effect>>& all, RoleList<Role>& list) {
    for (const auto& effect : all)
        if (Role* role = dynamic_cast<Role*>(effect.get())) list.push_back({effect.get(), role});
}

}  // namespace

EffectList::EffectList(Workspace& w, Host& host) {
    for (const EffectKind& kind : all_effects())
        if (kind.make && kind.acts_in(w.kind))
            if (auto effect = kind.make(w, host)) all.push_back(std::move(effect));
    list_those(all, loads), list_those(all, forces), list_those(all, section_forces), list_those(all, prescribers);
    list_those(all, constrainers), list_those(all, matrix_watchers), list_those(all, contact_laws);
    list_those(all, breakers), list_those(all, break_listeners), list_those(all, step_limiters),
        list_those(all, sleepers);
    list_those(all, rest_keepers), list_those(all, heaters);
    list_those(all, static_prescribers);
}

bool EffectList::any(bool EffectTraits::*trait) const {
    return std::any_of(all.begin(), all.end(), [&](const auto& effect) { return effect->traits().*trait; });
}

bool EffectList::has(std::string_view name) const {
    return std::any_of(all.begin(), all.end(), [&](const auto& effect) { return effect->name() == name; });
}

AccountList accounts_of(const EffectList& effects) {
    AccountList list;
    for (const EffectKind& kind : all_effects()) {
        const bool called_for = std::any_of(effects.all.begin(), effects.all.end(),
                                            [&](const auto& e) { return e->name() == std::string(kind.name); });
        for (const AccountInfo& account : kind.accounts)
            if (account.always || called_for) list.push_back(account);
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const AccountInfo& a, const AccountInfo& b) { return a.place < b.place; });
    return list;
}

}  // namespace hinge

// Rigid links: a node moves with another one as a rigid body, however far both rotate.
#include "effects/rigid_link.h"

#include <algorithm>

#include "core/text.h"
#include "effects/kinds.h"
#include "effects/rigid_groups.h"

namespace hinge {
namespace {

const std::vector<RigidLink>& links_of(const Model& model) { return model.declared<RigidLink>(rigid_link_effect); }

/// Links that begin at one node make one group.
std::vector<RigidGroup> groups_of_links(const Model& model) {
    std::vector<RigidGroup> groups;
    for (const RigidLink& link : links_of(model)) {
        auto at = std::find_if(groups.begin(), groups.end(), [&](const RigidGroup& g) { return g.first == link.from; });
        if (at == groups.end()) at = groups.insert(at, {link.from, {}, -1});
        at->followers.push_back({link.to, link.tied});
    }
    return groups;
}

std::vector<PlanLine> rigid_link_plan(const Structure& s, const RunKind&) {
    const std::size_t n = links_of(s.model()).size();
    return {{rigid_link_effect, n > 0, n > 0 ? count_text(long(n), "link") : "not declared",
             s.model().asked_at(rigid_link_effect)}};
}

}  // namespace

EffectKind rigid_link_kind() {
    return {.name = rigid_link_effect,
            .plan = rigid_link_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                std::vector<RigidGroup> groups = groups_of_links(w.structure.model());
                if (groups.empty()) return nullptr;
                return std::make_unique<RigidGroups>(rigid_link_effect, "model:rigid_link", std::move(groups), w, host);
            },
            .leave_out = leave_out_declared<rigid_link_effect>,
            .declarer = {.links = [](const Model& model) {
                std::vector<NodeLink> list;
                for (const RigidLink& link : links_of(model)) list.push_back({link.from, link.to});
                return list;
            }}};
}

}  // namespace hinge

// Rigid diaphragms: floors that are rigid in their plane and have no stiffness across it.
#include "effects/diaphragm.h"

#include "core/text.h"
#include "effects/kinds.h"
#include "effects/rigid_groups.h"

namespace hinge {
namespace {

const std::vector<Diaphragm>& diaphragms_of(const Model& model) { return model.declared<Diaphragm>(diaphragm_effect); }

std::vector<RigidGroup> groups_of_floors(const Model& model) {
    std::vector<RigidGroup> groups;
    for (const Diaphragm& d : diaphragms_of(model)) {
        groups.push_back({d.nodes[0], {}, d.normal});
        const auto tied = std::uint8_t((7 & ~(1 << d.normal)) | 8 << d.normal);
        for (std::size_t i = 1; i < d.nodes.size(); ++i) groups.back().followers.push_back({d.nodes[i], tied});
    }
    return groups;
}

std::vector<PlanLine> diaphragm_plan(const Structure& s, const RunKind&) {
    const auto& list = diaphragms_of(s.model());
    long nodes = 0;
    for (const Diaphragm& d : list) nodes += long(d.nodes.size());
    const bool on = !list.empty();
    return {{diaphragm_effect, on,
             on ? count_text(long(list.size()), "diaphragm") + " of " + count_text(nodes, "node") : "not declared",
             s.model().asked_at(diaphragm_effect)}};
}

}  // namespace

EffectKind diaphragm_kind() {
    return {.name = diaphragm_effect,
            .plan = diaphragm_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                std::vector<RigidGroup> groups = groups_of_floors(w.structure.model());
                if (groups.empty()) return nullptr;
                return std::make_unique<RigidGroups>(diaphragm_effect, "model:diaphragm", std::move(groups), w, host);
            },
            .leave_out = leave_out_declared<diaphragm_effect>,
            .declarer = {.links = [](const Model& model) {
                std::vector<NodeLink> list;
                for (const Diaphragm& d : diaphragms_of(model))
                    for (std::size_t i = 1; i < d.nodes.size(); ++i) list.push_back({d.nodes[0], d.nodes[i]});
                return list;
            }}};
}

}  // namespace hinge

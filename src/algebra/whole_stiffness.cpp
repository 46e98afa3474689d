// Forces of the whole stiffness, with the rows and columns of supports, against a motion of few nodes.
#include <algorithm>

#include "algebra/effective_stiffness.h"

namespace hinge {

void EffectiveStiffness::subtract_stiffness(const std::vector<Vec6>& u, const Blocks& blocks, const State& state,
                                            const Configuration& pose, std::vector<Vec6>& from) const {
    std::vector<int> elements, pairs;
    for (int node = 0; node < int(u.size()); ++node) {
        if (u[node].isZero(0)) continue;
        for (const int e : structure_.elements_at(node)) {
            if (matrices_.is_cleared(e)) continue;
            elements.push_back(e);
            if (const int partner = structure_.elements()[e].partner; matrices_.has_bridges() && partner >= 0)
                pairs.push_back(std::min(e, partner));
        }
    }
    for (std::vector<int>* list : {&elements, &pairs}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    const auto subtract = [&](int a, int b, const Mat12& K) {
        Vec12 of_nodes;
        of_nodes << u[a], u[b];
        const Vec12 force = K * of_nodes;
        from[a] -= force.head<6>(), from[b] -= force.tail<6>();
    };
    for (const int e : elements) {
        const auto& node = structure_.elements()[e].node;
        const Mat12 K = matrices_.whole_part(e) - inertia_part(e, state, element_frame(structure_, e, pose), nullptr);
        subtract(node[0], node[1], K / stiffness_factor_);
    }
    for (const int first : pairs) {
        const int outer = structure_.elements()[first].node[0], far = structure_.elements()[first + 1].node[1];
        const Mat6 between = matrices_.whole_bridge(first) / stiffness_factor_;
        from[outer] -= between * u[far];
        from[far] -= between.transpose() * u[outer];
    }
    for (const Coupling& c : blocks.pairs) subtract(c.a, c.b, c.K);
    for (const Blocks::Node& n : blocks.nodes) from[n.node] -= n.K * u[n.node];
}

}  // namespace hinge

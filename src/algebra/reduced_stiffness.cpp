// T^T A T of the effective stiffness, where degrees of freedom depend on others.
#include <algorithm>
#include <map>

#include "algebra/effective_stiffness.h"

namespace hinge {

void EffectiveStiffness::take_out_held(std::vector<Vec6>& v) const {
    for (std::size_t i = 0; i < v.size(); ++i)
        for (int c = 0; c < 6; ++c)
            if (matrices_.held()[i] >> c & 1) v[i][c] = 0;
}

/// The blocks of effects, and what T^T A T adds to A without the degrees of freedom that depend on others.
Blocks EffectiveStiffness::reduced_blocks() const {
    std::map<std::pair<int, int>, Mat6> sums;
    const auto add = [&](int a, int b, const Mat6& block) {
        const auto [at, fresh] = sums.try_emplace({a, b}, block);
        if (!fresh) at->second += block;
    };
    const auto spread = [&](const int node[2], const Mat12& K) {
        for (int i : {0, 1})
            for (int j : {0, 1}) reduction_->spread(node[i], node[j], K.block<6, 6>(6 * i, 6 * j), add);
    };
    std::vector<int> elements, pairs;
    for (const Reduction::Dependent& d : reduction_->dependents()) {
        for (const int e : structure_.elements_at(d.node)) {
            if (!matrices_.empty(e)) elements.push_back(e);
            if (matrices_.has_bridges() && structure_.elements()[e].partner >= 0)
                pairs.push_back(std::min(e, structure_.elements()[e].partner));
        }
        reduction_->spread(d.node, d.node, matrices_.offset_mass(d.node), add);
    }
    for (std::vector<int>* list : {&elements, &pairs}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    for (const int e : elements) spread(structure_.elements()[e].node, matrices_.whole_part(e));
    for (const int first : pairs) {
        const int outer[2] = {structure_.elements()[first].node[0], structure_.elements()[first + 1].node[1]};
        const Mat6 K = matrices_.whole_bridge(first);
        reduction_->spread(outer[0], outer[1], K, add);
        reduction_->spread(outer[1], outer[0], K.transpose(), add);
    }
    for (const Coupling& c : given_.pairs) {
        const int node[2] = {c.a, c.b};
        spread(node, c.K);
    }
    for (const Blocks::Node& n : given_.nodes) reduction_->spread(n.node, n.node, n.K, add);
    Blocks blocks;
    blocks.pairs = given_.pairs, blocks.nodes = given_.nodes;
    for (const auto& [at, block] : sums) {
        const auto [a, b] = at;
        if (a == b) blocks.nodes.push_back({a, block});
        if (a >= b) continue;
        Coupling c{a, b, Mat12::Zero()};
        c.K.topRightCorner<6, 6>() = block;
        c.K.bottomLeftCorner<6, 6>() = sums.at({b, a});
        blocks.pairs.push_back(c);
    }
    return blocks;
}

}  // namespace hinge

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

namespace {

/// Sums of T^T A T over blocks of A, without those parts that stay where they are.
class Sums {
public:
    explicit Sums(const Reduction& reduction, std::size_t nodes) : of_node_(nodes, nullptr) {
        for (const Reduction::Dependent& d : reduction.dependents()) of_node_[d.node] = &d;
    }

    void spread(int a, int b, const Mat6& block) {
        const Reduction::Dependent *of_a = of_node_[a], *of_b = of_node_[b];
        if (!of_a && !of_b) return;
        Mat6 free_rows = block;
        for (int c = 0; of_a && c < 6; ++c)
            if (of_a->tied >> c & 1) free_rows.row(c).setZero();
        spread_columns(a, b, free_rows, false);
        if (of_a)
            for (const Reduction::Part& p : of_a->parts)
                spread_columns(p.node, b, p.factors.transpose().lazyProduct(block), true);
    }
    void spread(const int node[2], const Mat12& K) {
        for (int i : {0, 1})
            for (int j : {0, 1}) spread(node[i], node[j], K.block<6, 6>(6 * i, 6 * j));
    }
    const std::map<std::pair<int, int>, Mat6>& blocks() const { return blocks_; }

private:
    /// `own`: with the columns of b itself that are free.
    void spread_columns(int row, int b, const Mat6& block, bool own) {
        const Reduction::Dependent* of_b = of_node_[b];
        if (own) {
            Mat6& sum = at(row, b);
            for (int c = 0; c < 6; ++c)
                if (!of_b || !(of_b->tied >> c & 1)) sum.col(c) += block.col(c);
        }
        if (of_b)
            for (const Reduction::Part& q : of_b->parts) at(row, q.node) += block.lazyProduct(q.factors);
    }
    Mat6& at(int a, int b) {
        const auto [found, fresh] = blocks_.try_emplace({a, b});
        if (fresh) found->second.setZero();
        return found->second;
    }

    std::vector<const Reduction::Dependent*> of_node_;
    std::map<std::pair<int, int>, Mat6> blocks_;
};

}  // namespace

/// The blocks of effects, and what T^T A T adds to A without the degrees of freedom that depend on others.
Blocks EffectiveStiffness::reduced_blocks() const {
    Sums sums(*reduction_, is_dirty_.size());
    const bool tied = tied_members_ && !tied_members_->none();
    std::vector<int> elements, pairs;
    for (const Reduction::Dependent& d : reduction_->dependents()) {
        if (tied && tied_members_->takes_out_node(d.node)) continue;
        for (const int e : structure_.elements_at(d.node)) {
            if (!matrices_.empty(e)) elements.push_back(e);
            if (matrices_.has_bridges() && !matrices_.empty(e) && structure_.elements()[e].partner >= 0)
                pairs.push_back(std::min(e, structure_.elements()[e].partner));
        }
        sums.spread(d.node, d.node, matrices_.offset_mass(d.node));
    }
    for (std::vector<int>* list : {&elements, &pairs}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    for (const int e : elements) sums.spread(structure_.elements()[e].node, matrices_.whole_part(e));
    for (const int first : pairs) {
        const int outer[2] = {structure_.elements()[first].node[0], structure_.elements()[first + 1].node[1]};
        const Mat6 K = matrices_.whole_bridge(first);
        sums.spread(outer[0], outer[1], K);
        sums.spread(outer[1], outer[0], K.transpose());
    }
    Blocks blocks;
    for (const Coupling& c : given_.pairs)
        if (!tied || !tied_members_->takes_in(c)) blocks.pairs.push_back(c);
    for (const Blocks::Node& n : given_.nodes)
        if (!tied || !tied_members_->takes_out_node(n.node)) blocks.nodes.push_back(n);
    if (tied) tied_members_->add_to(blocks);
    for (const Coupling& c : blocks.pairs) {
        const int node[2] = {c.a, c.b};
        sums.spread(node, c.K);
    }
    for (const Blocks::Node& n : blocks.nodes) sums.spread(n.node, n.node, n.K);
    for (const auto& [at, block] : sums.blocks()) {
        const auto [a, b] = at;
        if (a == b) blocks.nodes.push_back({a, block});
        if (a >= b) continue;
        Coupling c{a, b, Mat12::Zero()};
        c.K.topRightCorner<6, 6>() = block;
        c.K.bottomLeftCorner<6, 6>() = sums.blocks().at({b, a});
        blocks.pairs.push_back(c);
    }
    return blocks;
}

}  // namespace hinge

// T^T A T of the effective stiffness, where degrees of freedom depend on others.
#include <algorithm>
#include <utility>

#include "algebra/effective_stiffness.h"

namespace hinge {

void EffectiveStiffness::take_out_held(std::vector<Vec6>& v) const {
    for (std::size_t i = 0; i < v.size(); ++i)
        for (int c = 0; c < 6; ++c)
            if (matrices_.held()[i] >> c & 1) v[i][c] = 0;
}

namespace {

bool is_same(const Mat6& a, const Mat6& b, double within) {
    return !((a - b).cwiseAbs().maxCoeff() > within * std::max(1.0, b.cwiseAbs().maxCoeff()));
}

}  // namespace

/// Takes the factors of the reduction where they are others than those that A was reduced with. Returns whether.
bool EffectiveStiffness::take_factors() {
    const std::vector<Reduction::Dependent>& now = reduction_->dependents();
    const double within = single_ || condensed_ ? Reduction::same_factors : 0;  // factors tell stability, too
    bool same = now.size() == reduced_by_.size();
    for (std::size_t i = 0; same && i < now.size(); ++i) {
        const ReducedBy& used = reduced_by_[i];
        same = used.node == now[i].node && used.tied == now[i].tied && used.parts.size() == now[i].parts.size();
        for (std::size_t k = 0; same && k < used.parts.size(); ++k)
            same = used.parts[k].node == now[i].parts[k].node &&
                   is_same(now[i].parts[k].factors, used.parts[k].factors, within);
    }
    if (same) return false;
    reduced_by_.clear();
    for (const Reduction::Dependent& d : now) reduced_by_.push_back({d.node, d.tied, d.parts});
    return true;
}

/// Sums of T^T A T over blocks of A, without those parts that stay where they are.
class EffectiveStiffness::Sums {
public:
    Sums(const std::vector<ReducedBy>& dependents, std::size_t nodes) : of_node_(nodes, nullptr), rows_(nodes) {
        for (const ReducedBy& d : dependents) of_node_[d.node] = &d;
    }

    void spread(int a, int b, const Mat6& block) {
        const ReducedBy *of_a = of_node_[a], *of_b = of_node_[b];
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
    void add_to(Blocks& blocks) const {
        for (int a = 0; a < int(rows_.size()); ++a)
            for (const auto& [b, block] : rows_[a]) {
                if (a == b) blocks.nodes.push_back({a, block});
                if (a >= b) continue;
                Coupling c{a, b, Mat12::Zero()};
                c.K.topRightCorner<6, 6>() = block;
                for (const auto& [back, other] : rows_[b])
                    if (back == a) c.K.bottomLeftCorner<6, 6>() = other;
                blocks.pairs.push_back(c);
            }
    }

private:
    /// `own`: with the columns of b itself that are free.
    void spread_columns(int row, int b, const Mat6& block, bool own) {
        const ReducedBy* of_b = of_node_[b];
        if (own) {
            Mat6& sum = at(row, b);
            for (int c = 0; c < 6; ++c)
                if (!of_b || !(of_b->tied >> c & 1)) sum.col(c) += block.col(c);
        }
        if (of_b)
            for (const Reduction::Part& q : of_b->parts) at(row, q.node) += block.lazyProduct(q.factors);
    }
    Mat6& at(int a, int b) {
        for (auto& [column, block] : rows_[a])
            if (column == b) return block;
        return rows_[a].emplace_back(b, Mat6::Zero()).second;
    }

    std::vector<const ReducedBy*> of_node_;
    std::vector<std::vector<std::pair<int, Mat6>>> rows_;
};

/// T^T A T, as far as something has changed.
void EffectiveStiffness::reduce() {
    const bool other_factors = take_factors();
    if (!other_factors && !given_changed_ && dirty_.empty()) return;
    if (tied_members_) condense_tied();
    const bool had = std::exchange(has_given_, any_given());
    const bool others = given_changed_ && (had || has_given_);
    given_changed_ = false;
    if (!other_factors && !others && dirty_.empty()) return;
    Blocks blocks = reduced_blocks();
    take_couplings(blocks.pairs);
    take_node_blocks(blocks.nodes);
}

/// Whether effects give blocks that are not within condensed members.
bool EffectiveStiffness::any_given() const {
    if (!tied_members_ || tied_members_->none()) return true;
    return std::any_of(given_.pairs.begin(), given_.pairs.end(),
                       [this](const Coupling& c) { return !tied_members_->takes_in(c); }) ||
           std::any_of(given_.nodes.begin(), given_.nodes.end(),
                       [this](const Blocks::Node& n) { return !tied_members_->takes_out_node(n.node); });
}

/// The blocks of effects, and what T^T A T adds to A without the degrees of freedom that depend on others.
Blocks EffectiveStiffness::reduced_blocks() const {
    Sums sums(reduced_by_, is_dirty_.size());
    const bool tied = tied_members_ && !tied_members_->none();
    std::vector<int> elements, pairs;
    for (const ReducedBy& d : reduced_by_) {
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
    sums.add_to(blocks);
    return blocks;
}

}  // namespace hinge

// Stiffness between the translations of nodes that panels join, summed over the panels before it is listed.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "algebra/node_blocks.h"

namespace hinge {

/// Blocks of 3x3: one of each node, one of each pair of nodes. The pairs are joined first, and have a place each.
class TranslationBlocks {
public:
    /// All pairs of these nodes.
    void join(const std::vector<int>& nodes) {
        for (const int a : nodes)
            for (const int b : nodes)
                if (a < b) pairs_.push_back({a, b});
        nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
    }
    /// After the last pair, before the first sum.
    void joined() {
        const auto sort = [](auto& list) {
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
        };
        sort(nodes_), sort(pairs_);
    }
    /// The places of the pairs of some nodes: that of the j-th and the k-th at n j + k; for j = k that of the node.
    std::vector<int> places(const std::vector<int>& nodes) const {
        std::vector<int> list;
        for (const int a : nodes)
            for (const int b : nodes)
                list.push_back(a == b ? find(nodes_, a) : find(pairs_, std::pair(std::min(a, b), std::max(a, b))));
        return list;
    }
    void begin() {
        own_.assign(nodes_.size(), Mat3::Zero());
        across_.assign(pairs_.size(), Mat3::Zero());
    }
    void add_own(int place, const Mat3& K) { own_[std::size_t(place)] += K; }
    /// `in_order`: K has the row of the lower node.
    void add(int place, const Mat3& K, bool in_order) {
        if (in_order) across_[std::size_t(place)] += K;
        else across_[std::size_t(place)] += K.transpose();
    }
    /// Those of nodes for which takes_part(node) is true; all that are joined do, or none.
    template <class TakesPart>
    void list(Blocks& to, TakesPart takes_part) const {
        to.pairs.reserve(to.pairs.size() + pairs_.size()), to.nodes.reserve(to.nodes.size() + nodes_.size());
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (!takes_part(nodes_[i])) continue;
            Mat6 K = Mat6::Zero();
            K.topLeftCorner<3, 3>() = own_[i];
            to.stiffness(nodes_[i], K);
        }
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            if (!takes_part(pairs_[i].first)) continue;
            Mat12 K = Mat12::Zero();
            K.block<3, 3>(0, 6) = across_[i], K.block<3, 3>(6, 0) = across_[i].transpose();
            to.stiffness(pairs_[i].first, pairs_[i].second, K);
        }
    }

private:
    template <class List, class T>
    static int find(const List& list, const T& value) {
        return int(std::lower_bound(list.begin(), list.end(), value) - list.begin());
    }
    std::vector<int> nodes_;                  ///< rising
    std::vector<std::pair<int, int>> pairs_;  ///< the lower first, rising
    std::vector<Mat3> own_, across_;
};

}  // namespace hinge

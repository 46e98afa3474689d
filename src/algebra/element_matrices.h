// Blocks of A = m M + k K for each element, supports taken out: the input of every solver.
#pragma once

#include <cstdint>
#include <vector>

#include "algebra/node_blocks.h"
#include "core/large_pages.h"
#include "model/structure.h"

namespace hinge {

class ElementMatrices {
public:
    /// Blocks of zero. `single_precision`: storage. `symmetric`: half of each part is stored.
    ElementMatrices(const Structure& structure, bool single_precision, bool symmetric);

    void set(int element, const Mat12& A);
    void clear(int element);  ///< it broke
    /// Sets the block between the outer ends of a pair of elements that share a middle node: rows of the first
    /// element's node, columns of the second one's.
    void set_bridge(int first, const Mat6& between);
    /// That block in the row of the node at `end` (0, 1) of the pair; zero if there is none.
    Mat6 bridge(int first, int end) const;
    bool has_bridges() const { return !double_bridge_.empty() || !single_bridge_.empty(); }
    /// Whether its blocks are zero: cleared, or taken out.
    bool empty(int element) const { return empty_[element] || is_out(elements_out_, element); }
    bool is_cleared(int element) const { return empty_[element]; }
    /// Takes nodes and elements out of own, across and bridge (tied_members.h): a node that is out has the unit
    /// matrix. The lists are referred to; empty ones take out none.
    void take_out(const std::vector<char>& nodes, const std::vector<char>& elements) {
        nodes_out_ = &nodes, elements_out_ = &elements;
    }
    void set_offset_mass(int node, const Mat6& mass);
    /// As they were set, with the rows and columns of what is held: an element's part, the block between the outer ends
    /// of a pair, the offset mass of a node.
    Mat12 whole_part(int element) const;
    Mat6 whole_bridge(int first) const;
    Mat6 offset_mass(int node) const { return offset_mass_.empty() ? Mat6(Mat6::Zero()) : offset_mass_[node]; }
    /// Replaces the blocks that effects add to single nodes; several of one node add up.
    void exchange_node_blocks(std::vector<Blocks::Node>& blocks) { node_blocks_.swap(blocks); }
    const std::vector<Blocks::Node>& node_blocks() const { return node_blocks_; }
    void set_held(const std::vector<std::uint8_t>& held) { held_ = held; }
    const std::vector<std::uint8_t>& held() const { return held_; }

    /// The diagonal block of a node: of all its elements, its offset mass and its blocks; one for a degree of freedom
    /// that is held.
    Mat6 own(int node) const;
    /// The block in the row of the element's node at `end` (0, 1) and the column of its other node.
    Mat6 across(int element, int end) const;
    /// Product x . A x of an element's own part, with half of the block between the outer ends of its pair; x: six
    /// numbers a node, zero where held.
    double product(int element, const double* x) const;
    /// Product x . A x of the offset mass of a node.
    double product_of_offset_mass(int node, const double* x) const;
    const Structure& structure() const { return structure_; }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        const std::size_t numbers[] = {s.double_part_.size(), s.single_part_.size(), s.empty_.size(), s.held_.size()};
        a(s.double_part_, s.single_part_, s.double_bridge_, s.single_bridge_, s.empty_, s.offset_mass_, s.held_,
          s.node_blocks_);
        if constexpr (A::reading)
            a.must(s.double_part_.size() == numbers[0] && s.single_part_.size() == numbers[1] &&
                   s.empty_.size() == numbers[2] && s.held_.size() == numbers[3] &&
                   (s.double_bridge_.empty() || s.double_bridge_.size() == s.bridge_numbers()) &&
                   (s.single_bridge_.empty() || s.single_bridge_.size() == s.bridge_numbers()) &&
                   (s.offset_mass_.empty() || s.offset_mass_.size() == s.held_.size()));
        if constexpr (A::reading)
            for (const auto& block : s.node_blocks_)
                a.must(block.node >= 0 && std::size_t(block.node) < s.held_.size());
    }

private:
    template <class Number>
    Mat6 own_of(const Number* part, int end) const;
    template <class Number>
    Mat6 across_of(const Number* part, int end) const;
    Mat6 masked(int a, int b, const Mat6& block) const;
    static bool is_out(const std::vector<char>* list, int i) { return list && !list->empty() && (*list)[i]; }
    std::size_t bridge_numbers() const { return empty_.size() / 2 * 36; }

    const Structure& structure_;
    bool single_precision_, symmetric_;
    int stride_;  // numbers a part: two halves of own blocks and the block across, or all 144
    LargeVector<double> double_part_;
    LargeVector<float> single_part_;
    LargeVector<double> double_bridge_;  // 36 numbers of each pair; empty while no pair has any
    LargeVector<float> single_bridge_;
    std::vector<char> empty_;
    std::vector<Mat6> offset_mass_;  // of each node, empty if none
    std::vector<Blocks::Node> node_blocks_;
    std::vector<std::uint8_t> held_;
    const std::vector<char>*nodes_out_ = nullptr, *elements_out_ = nullptr;
};

}  // namespace hinge

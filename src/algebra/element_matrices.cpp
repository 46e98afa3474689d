#include "algebra/element_matrices.h"

#include <algorithm>

namespace hinge {
namespace {

constexpr int half = 21, square_block = 36, packed = 2 * half + square_block, full = 144;

}  // namespace

ElementMatrices::ElementMatrices(const Structure& structure, bool single_precision, bool symmetric)
    : structure_(structure),
      single_precision_(single_precision),
      symmetric_(symmetric),
      stride_(symmetric ? packed : full),
      held_(structure.held()) {
    const std::size_t numbers = stride_ * structure.elements().size();
    empty_.assign(structure.elements().size(), 0);
    if (single_precision) single_part_.assign(numbers, 0);
    else double_part_.assign(numbers, 0);
}

void ElementMatrices::set(int element, const Mat12& A) {
    const auto fill = [&](auto* to) {
        using Number = std::remove_reference_t<decltype(*to)>;
        if (!symmetric_) {
            for (int i = 0; i < full; ++i) to[i] = Number(A.data()[i]);
            return;
        }
        for (int end : {0, 6})
            for (int c = 0; c < 6; ++c)
                for (int r = c; r < 6; ++r) *to++ = Number(A(end + r, end + c));
        for (int c = 0; c < 6; ++c)
            for (int r = 0; r < 6; ++r) *to++ = Number(A(r, 6 + c));
    };
    if (single_precision_) fill(&single_part_[stride_ * std::size_t(element)]);
    else fill(&double_part_[stride_ * std::size_t(element)]);
}

void ElementMatrices::clear(int element) {
    set(element, Mat12::Zero());
    empty_[element] = 1;
    if (has_bridges()) set_bridge(element & ~1, Mat6::Zero());
}

void ElementMatrices::set_bridge(int first, const Mat6& between) {
    const auto fill = [&](auto& bridges) {
        using Number = std::remove_reference_t<decltype(bridges[0])>;
        if (bridges.empty()) bridges.assign(bridge_numbers(), 0);
        for (int i = 0; i < 36; ++i) bridges[std::size_t(first) / 2 * 36 + i] = Number(between.data()[i]);
    };
    single_precision_ ? fill(single_bridge_) : fill(double_bridge_);
}

Mat6 ElementMatrices::whole_bridge(int first) const {
    if (!has_bridges()) return Mat6::Zero();
    const std::size_t at = std::size_t(first) / 2 * 36;
    return single_precision_ ? Mat6(Eigen::Map<const Eigen::Matrix<float, 6, 6>>(&single_bridge_[at]).cast<double>())
                             : Mat6(Eigen::Map<const Mat6>(&double_bridge_[at]));
}

Mat6 ElementMatrices::bridge(int first, int end) const {
    if (!has_bridges()) return Mat6::Zero();
    const Mat6 between = whole_bridge(first);
    const int a = structure_.elements()[first].node[0], b = structure_.elements()[first + 1].node[1];
    return end == 0 ? masked(a, b, between) : masked(b, a, between.transpose());
}

template <class Number>
Mat6 ElementMatrices::own_of(const Number* part, int end) const {
    Mat6 m;
    if (!symmetric_) {
        for (int c = 0; c < 6; ++c)
            for (int r = 0; r < 6; ++r) m(r, c) = part[12 * (6 * end + c) + 6 * end + r];
        return m;
    }
    part += half * end;
    for (int c = 0; c < 6; ++c)
        for (int r = c; r < 6; ++r) m(r, c) = m(c, r) = *part++;
    return m;
}

template <class Number>
Mat6 ElementMatrices::across_of(const Number* part, int end) const {
    if (!symmetric_) {
        Mat6 m;
        for (int c = 0; c < 6; ++c)
            for (int r = 0; r < 6; ++r) m(r, c) = part[12 * (6 * (1 - end) + c) + 6 * end + r];
        return m;
    }
    Mat6 m = Eigen::Map<const Eigen::Matrix<Number, 6, 6>>(part + 2 * half).template cast<double>();
    if (end == 0) return m;
    return m.transpose();
}

void ElementMatrices::set_offset_mass(int node, const Mat6& mass) {
    if (offset_mass_.empty()) offset_mass_.assign(held_.size(), Mat6::Zero());
    offset_mass_[node] = mass;
}

Mat6 ElementMatrices::masked(int a, int b, const Mat6& m) const {
    if (held_[a] == 0 && held_[b] == 0) return m;
    Mat6 out = m;
    for (int c = 0; c < 6; ++c) {
        if (held_[a] >> c & 1) out.row(c).setZero();
        if (held_[b] >> c & 1) out.col(c).setZero();
    }
    return out;
}

Mat6 ElementMatrices::own(int node) const {
    if (is_out(nodes_out_, node)) return Mat6::Identity();
    Mat6 sum = Mat6::Zero();
    for (int e : structure_.elements_at(node)) {
        if (empty(e)) continue;
        const int end = structure_.elements()[e].node[0] == node ? 0 : 1;
        sum += single_precision_ ? own_of(&single_part_[stride_ * std::size_t(e)], end)
                                 : own_of(&double_part_[stride_ * std::size_t(e)], end);
    }
    if (!offset_mass_.empty()) sum += offset_mass_[node];
    for (const Blocks::Node& block : node_blocks_)
        if (block.node == node) sum += block.K;
    sum = masked(node, node, sum);
    for (int c = 0; c < 6; ++c)
        if (held_[node] >> c & 1) sum(c, c) = 1;
    return sum;
}

double ElementMatrices::product(int element, const double* x) const {
    if (empty(element)) return 0;
    const Element& e = structure_.elements()[element];
    const std::size_t at = stride_ * std::size_t(element);
    const auto own = [&](int end) {
        return single_precision_ ? own_of(&single_part_[at], end) : own_of(&double_part_[at], end);
    };
    const Eigen::Map<const Vec6> a(x + 6 * e.node[0]), b(x + 6 * e.node[1]);
    double sum = a.dot(own(0) * a) + b.dot(own(1) * b) + a.dot(across(element, 0) * b) + b.dot(across(element, 1) * a);
    if (has_bridges() && e.partner >= 0) {
        const int first = std::min(element, e.partner);
        const Eigen::Map<const Vec6> outer(x + 6 * structure_.elements()[first].node[0]),
            far(x + 6 * structure_.elements()[first + 1].node[1]);
        sum += outer.dot(bridge(first, 0) * far);
    }
    return sum;
}

double ElementMatrices::product_of_offset_mass(int node, const double* x) const {
    if (offset_mass_.empty()) return 0;
    const Eigen::Map<const Vec6> v(x + 6 * node);
    return v.dot(offset_mass_[node] * v);
}

Mat12 ElementMatrices::whole_part(int element) const {
    const std::size_t at = stride_ * std::size_t(element);
    const auto block = [&](auto of) { return single_precision_ ? of(&single_part_[at]) : of(&double_part_[at]); };
    Mat12 part;
    for (int end : {0, 1}) {
        part.block<6, 6>(6 * end, 6 * end) = block([&](const auto* p) { return own_of(p, end); });
        part.block<6, 6>(6 * end, 6 * (1 - end)) = block([&](const auto* p) { return across_of(p, end); });
    }
    return part;
}

Mat6 ElementMatrices::across(int element, int end) const {
    const Element& e = structure_.elements()[element];
    return masked(e.node[end], e.node[1 - end],
                  single_precision_ ? across_of(&single_part_[stride_ * std::size_t(element)], end)
                                    : across_of(&double_part_[stride_ * std::size_t(element)], end));
}

}  // namespace hinge

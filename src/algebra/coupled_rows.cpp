#include "algebra/coupled_rows.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

namespace hinge {

namespace {

using Entry = std::array<int, 3>;  // row, whether it lies beside the diagonal, column

/// In compressed form.
void compress(std::vector<Entry>& entries, int places, std::vector<int>& begin, std::vector<int>& column) {
    begin.assign(places == 0 ? 0 : places + 1, 0);
    column.clear();
    for (const Entry& e : entries) ++begin[e[0] + 1], column.push_back(e[2]);
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
}

}  // namespace

void CoupledRows::lay_out(int places, const std::vector<Pair>& pairs) {
    pairs_ = pairs;
    std::vector<Entry> entries, light;
    for (const auto& [p, q, is_light] : pairs) {
        entries.insert(entries.end(), {{p, 0, p}, {q, 0, q}});
        auto& beside = is_light ? light : entries;
        beside.insert(beside.end(), {{p, 1, q}, {q, 1, p}});
    }
    for (auto* list : {&entries, &light}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    std::vector<Entry> alone;  // light where no other pair of the same nodes is not
    std::set_difference(light.begin(), light.end(), entries.begin(), entries.end(), std::back_inserter(alone));
    compress(entries, pairs.empty() ? 0 : places, begin_, column_);
    compress(alone, pairs.empty() ? 0 : places, light_begin_, light_column_);
    value_.assign(36 * column_.size() + 2, 0);  // blocks are read two numbers past their end
    light_value_.assign(12 * light_column_.size(), 0);
}

void CoupledRows::add(int row, int column, const Mat6& block) {
    const auto find = [&](const std::vector<int>& begin, const std::vector<int>& list) {
        int k = begin[row];
        while (k < begin[row + 1] && list[k] != column) ++k;
        return k;
    };
    if (const int k = find(begin_, column_); k < begin_[row + 1]) {
        Eigen::Map<Mat6>(&value_[36 * std::size_t(k)]) += block;
        return;
    }
    const int k = find(light_begin_, light_column_);
    Eigen::Map<Eigen::Matrix<double, 4, 3>>(&light_value_[12 * std::size_t(k)]).topRows<3>() +=
        block.topLeftCorner<3, 3>();
}

}  // namespace hinge

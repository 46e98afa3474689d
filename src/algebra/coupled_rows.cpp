#include "algebra/coupled_rows.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace hinge {

void CoupledRows::lay_out(int places, const std::vector<std::pair<int, int>>& pairs) {
    using Entry = std::array<int, 3>;  // row, whether it lies beside the diagonal, column
    std::vector<Entry> entries;
    for (const auto& [p, q] : pairs) entries.insert(entries.end(), {{p, 0, p}, {p, 1, q}, {q, 0, q}, {q, 1, p}});
    std::sort(entries.begin(), entries.end());
    entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
    begin_.assign(pairs.empty() ? 0 : places + 1, 0);
    column_.clear();
    for (const Entry& e : entries) ++begin_[e[0] + 1], column_.push_back(e[2]);
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    value_.assign(36 * column_.size() + 2, 0);  // blocks are read two numbers past their end
}

void CoupledRows::add(int row, int column, const Mat6& block) {
    int k = begin_[row];
    while (column_[k] != column) ++k;
    Eigen::Map<Mat6>(&value_[36 * std::size_t(k)]) += block;
}

}  // namespace hinge

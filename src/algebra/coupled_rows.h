// What couplings add to the rows of a matrix of 6x6 blocks, in compressed form (CSR) and in double precision: a spring
// may be far stiffer than the members beside it.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "algebra/blocks.h"
#include "core/large_pages.h"
#include "core/types.h"

namespace hinge {

class CoupledRows {
public:
    /// Rows and columns are places, `places` of them. Each pair joins two of them; all blocks are zero.
    void lay_out(int places, const std::vector<std::pair<int, int>>& pairs);
    void set_zero() { value_.assign(value_.size(), 0); }
    /// Adds to the block of that row and column, of a pair or of one place.
    void add(int row, int column, const Mat6& block);

    bool has(int row) const { return count(row) > 0; }
    /// The row's own block.
    Eigen::Map<const Mat6> own(int row) const { return Eigen::Map<const Mat6>(&value_[36 * std::size_t(begin_[row])]); }
    /// Whether f is true for one of the places that the row is joined with.
    template <class F>
    bool any_beside(int row, F f) const {
        return has(row) && std::any_of(&column_[begin_[row]] + 1, &column_[begin_[row]] + count(row), f);
    }
    /// Adds the row's product with x, from that entry of it on; 0 is its own block.
    void add_product(blocks::Row& sum, int row, int from, const double* x) const {
        if (begin_.empty()) return;
        for (int k = begin_[row] + from; k < begin_[row + 1]; ++k)
            sum.add(&value_[36 * std::size_t(k)], &x[blocks::stride * column_[k]]);
    }

private:
    int count(int row) const { return begin_.empty() ? 0 : begin_[row + 1] - begin_[row]; }

    std::vector<int> begin_;     ///< of each row: its first entry, which is its own block; empty without pairs
    std::vector<int> column_;    ///< of each entry
    LargeVector<double> value_;  ///< of each entry, 36
};

}  // namespace hinge

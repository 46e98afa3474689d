// What couplings add to the rows of a matrix of 6x6 blocks, in compressed form (CSR) and in double precision: a spring
// may be far stiffer than the members beside it.
#pragma once

#include <algorithm>
#include <vector>

#include "algebra/blocks.h"
#include "core/large_pages.h"
#include "core/types.h"

namespace hinge {

class CoupledRows {
public:
    /// `light`: their translations alone.
    struct Pair {
        int a, b;
        bool light;
        friend bool operator==(const Pair& p, const Pair& q) { return p.a == q.a && p.b == q.b && p.light == q.light; }
    };
    /// Rows and columns are places, `places` of them. Each pair joins two of them; all blocks are zero.
    void lay_out(int places, const std::vector<Pair>& pairs);
    bool is_laid_out_for(const std::vector<Pair>& pairs) const { return pairs == pairs_; }
    void set_zero() { value_.assign(value_.size(), 0), light_value_.assign(light_value_.size(), 0); }
    /// Adds to the block of that row and column, of a pair or of one place.
    void add(int row, int column, const Mat6& block);

    bool has(int row) const { return count(row) > 0; }
    /// The row's own block.
    Eigen::Map<const Mat6> own(int row) const { return Eigen::Map<const Mat6>(&value_[36 * std::size_t(begin_[row])]); }
    /// Whether f is true for one of the places that the row is joined with.
    template <class F>
    bool any_beside(int row, F f) const {
        if (!has(row)) return false;
        const auto any = [&](const std::vector<int>& list, int from, int to) {
            return std::any_of(list.begin() + from, list.begin() + to, f);
        };
        return any(column_, begin_[row] + 1, begin_[row + 1]) ||
               any(light_column_, light_begin_[row], light_begin_[row + 1]);
    }
    /// Adds the row's product with x, from that entry of it on; 0 is its own block.
    void add_product(blocks::Row& sum, int row, int from, const double* x) const {
        if (begin_.empty()) return;
        for (int k = begin_[row] + from; k < begin_[row + 1]; ++k)
            sum.add(&value_[36 * std::size_t(k)], &x[blocks::stride * column_[k]]);
        blocks::Narrow even{}, odd{};
        for (int k = light_begin_[row]; k < light_begin_[row + 1]; ++k) {
            const double *const B = &light_value_[12 * std::size_t(k)], *const of =
                                                                            &x[blocks::stride * light_column_[k]];
            even += blocks::load_narrow(B) * of[0] + blocks::load_narrow(B + 8) * of[2];
            odd += blocks::load_narrow(B + 4) * of[1];
        }
        sum.even += blocks::widened(even + odd);
    }

private:
    int count(int row) const { return begin_.empty() ? 0 : begin_[row + 1] - begin_[row]; }

    std::vector<Pair> pairs_;
    std::vector<int> begin_;     ///< of each row: its first entry, which is its own block; empty without pairs
    std::vector<int> column_;    ///< of each entry
    LargeVector<double> value_;  ///< of each entry, 36
    // likewise, behind those: blocks of translations alone, which are most where panels join nodes
    std::vector<int> light_begin_, light_column_;
    LargeVector<double> light_value_;  ///< of each, three columns of three and a zero
};

}  // namespace hinge

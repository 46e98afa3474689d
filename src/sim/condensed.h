// A system without the nodes that lie between two others: what conjugate gradients work on.
//
// A member's inner nodes hang between two neighbours each. Every other one of them is taken out exactly,
//   S = A_kk - A_km A_mm^-1 A_mk,   x_m = A_mm^-1 (r_m - A_mk x_k),
// which leaves, at two elements a member, the joints alone: a third of the unknowns, less than half of the blocks, and half of
// the iterations (Reid 1972: what is taken out and what is left are the two colours of one chessboard).
#pragma once

#include <vector>

#include "core/types.h"

namespace hinge {

class Condensed {
public:
    /// The pattern of A by block rows: column[row[i]] is i itself, the rest its neighbours in rising order.
    Condensed(const std::vector<int>& row, const std::vector<int>& column);

    /// These nodes stay, whatever else they are: something couples them to others. Nodes whose rows must be renewed for it
    /// are added to `changed`.
    void keep(std::vector<int> nodes, std::vector<int>& changed);
    /// Renews what depends on the rows of these nodes. `value`: blocks of A in the pattern's order, 36 each, by columns.
    /// Returns the nodes whose rows of S changed.
    const std::vector<int>& renew(const std::vector<int>& nodes, const double* value);

    long arrangement() const { return arrangement_; }              ///< another number when other nodes stay
    int size() const { return int(order_.size()); }                ///< nodes that stay
    const std::vector<int>& order() const { return order_; }       ///< which they are
    int place(int node) const { return place_[node]; }             ///< of a node among those that stay, -1: taken out
    Mat6 diagonal(int place) const;

    /// right (six a node, two numbers of room behind it) -> b (eight a node that stays), and what solve_back needs of it.
    void reduce(const double* right, double* b);
    /// y = S x, eight numbers a node; returns x . y.
    double multiply(const double* x, double* y) const;
    /// x (eight a node that stays) -> solution (six a node).
    void solve_back(const double* x, double* solution) const;

private:
    struct Between {                 ///< a node that may be taken out
        int node, count;             ///< of its neighbours, 0 to 2
        int side[2];
        int to[2];                   ///< places in the pattern of (node, side)
        bool kept = false;
        double inverse[38];          ///< A_mm^-1; blocks are read two numbers past their end
        double pull[2][38];          ///< A_mm^-1 A_m,side
    };
    struct Entry { int column, slot; };
    int entry(int node, int column) const;
    void list();
    void renew_between(Between& m, const double* value) const;
    void renew_row(int node, const double* value);

    const std::vector<int>&row_, &column_;
    std::vector<Between> between_;
    std::vector<int> which_;                       ///< of each node: its place in between_, -1
    std::vector<std::vector<Entry>> rows_;         ///< of each node: all columns it may have, itself first
    std::vector<double> value_;                    ///< of every slot, 36
    std::vector<int> order_, place_;
    std::vector<int> begin_, slot_, at_;           ///< upper rows of those that stay: slots, and places of their columns
    std::vector<double> y_;                        ///< A_mm^-1 r_m
    std::vector<int> kept_, renewed_;
    long arrangement_ = 0;
};

}  // namespace hinge

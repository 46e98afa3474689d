#include "algebra/direct_factors.h"

#include <cmath>

namespace hinge {

void DirectFactors::add(int row, int column, const Mat6& block) {
    for (int c = 0; c < 6; ++c)
        for (int r = 0; r < 6; ++r)
            if (const double v = block(r, c); v != 0 && (unsymmetric_ || 6 * row + r >= 6 * column + c))
                entries_.emplace_back(6 * row + r, 6 * column + c, v);
}

bool DirectFactors::factorise(int nodes) {
    Eigen::SparseMatrix<double> A(6 * nodes, 6 * nodes);
    A.setFromTriplets(entries_.begin(), entries_.end());
    entries_ = {};
    diagonal_ = A.diagonal();
    if (unsymmetric_) lu_ = std::make_unique<Eigen::SparseLU<Eigen::SparseMatrix<double>>>(A);
    else ldlt_.compute(A);
    return good();
}

int DirectFactors::loosest_degree_of_freedom(double ratio) const {
    if (ldlt_.info() != Eigen::Success) {
        for (int i = 0; i < diagonal_.size(); ++i)
            if (!(diagonal_[i] > 0)) return i;
    }
    const Eigen::VectorXd pivots = ldlt_.vectorD();
    const Eigen::VectorXd in_order = ldlt_.permutationP() * diagonal_;
    int worst = -1;
    double least = ratio;
    for (int i = 0; i < pivots.size(); ++i)
        if (const double share = std::abs(pivots[i]) / in_order[i]; !(share > least)) least = share, worst = i;
    return worst < 0 ? -1 : ldlt_.permutationPinv().indices()[worst];
}

}  // namespace hinge

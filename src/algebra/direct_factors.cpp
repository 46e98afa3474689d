#include "algebra/direct_factors_eigen.h"

#include <cmath>

#include "core/doing.h"

HINGE_TRIANGLES()

namespace hinge {

DirectFactors::DirectFactors(bool unsymmetric) : unsymmetric_(unsymmetric), factors_(std::make_unique<Factors>()) {}
DirectFactors::~DirectFactors() = default;

bool DirectFactors::good() const {
    return unsymmetric_ ? factors_->lu && factors_->lu->info() == Eigen::Success
                        : factors_->ldlt.info() == Eigen::Success;
}

void DirectFactors::add(int row, int column, const Mat6& block) {
    for (int c = 0; c < 6; ++c)
        for (int r = 0; r < 6; ++r)
            if (const double v = block(r, c); v != 0 && (unsymmetric_ || 6 * row + r >= 6 * column + c))
                factors_->entries.emplace_back(6 * row + r, 6 * column + c, v);
}

/// A pivot on the diagonal, which keeps the pattern, is taken unless another of its column is ten times as large.
constexpr double diagonal_enough = 0.1;

bool DirectFactors::factorise(int nodes) {
    const Doing doing("a factorisation of the stiffness,", 6L * nodes, "unknowns");
    Eigen::SparseMatrix<double> A(6 * nodes, 6 * nodes);
    A.setFromTriplets(factors_->entries.begin(), factors_->entries.end());
    factors_->entries = {};
    factors_->diagonal = A.diagonal();
    if (unsymmetric_) {
        factors_->lu = std::make_unique<Factors::Unsymmetric>();
        factors_->lu->isSymmetric(true);
        factors_->lu->setPivotThreshold(diagonal_enough);
        factors_->lu->compute(A);
    } else {
        factors_->ldlt.compute(A);
    }
    return good();
}

int DirectFactors::loosest_degree_of_freedom(double ratio) const {
    if (factors_->ldlt.info() != Eigen::Success) {
        for (int i = 0; i < factors_->diagonal.size(); ++i)
            if (!(factors_->diagonal[i] > 0)) return i;
    }
    const Eigen::VectorXd pivots = factors_->ldlt.vectorD();
    const Eigen::VectorXd in_order = factors_->ldlt.permutationP() * factors_->diagonal;
    int worst = -1;
    double least = ratio;
    for (int i = 0; i < pivots.size(); ++i)
        if (const double share = std::abs(pivots[i]) / in_order[i]; !(share > least)) least = share, worst = i;
    return worst < 0 ? -1 : factors_->ldlt.permutationPinv().indices()[worst];
}

namespace {

bool is_negative(double pivot, double diagonal) { return pivot < -1e-12 * std::abs(diagonal); }

}  // namespace

int DirectFactors::negative_pivots() const {
    const Eigen::VectorXd pivots = factors_->ldlt.vectorD();
    const Eigen::VectorXd in_order = factors_->ldlt.permutationP() * factors_->diagonal;
    int count = 0;
    for (int i = 0; i < pivots.size(); ++i) count += is_negative(pivots[i], in_order[i]);
    return count;
}

/// L^T y = (0 .. 1 at the pivot .. 0) makes y^T L D L^T y the pivot itself.
Eigen::VectorXd DirectFactors::negative_direction() const {
    const Eigen::VectorXd pivots = factors_->ldlt.vectorD();
    const Eigen::VectorXd in_order = factors_->ldlt.permutationP() * factors_->diagonal;
    int last = int(pivots.size()) - 1;
    while (last >= 0 && !is_negative(pivots[last], in_order[last])) --last;
    if (last < 0) return {};
    const Eigen::SparseMatrix<double>& below =
        factors_->ldlt.matrixL().nestedExpression();  // by columns, without the ones
    Eigen::VectorXd y = Eigen::VectorXd::Zero(pivots.size());
    y[last] = 1;
    for (int column = last - 1; column >= 0; --column) {
        double sum = 0;
        for (Eigen::SparseMatrix<double>::InnerIterator it(below, column); it; ++it) sum += it.value() * y[it.row()];
        y[column] = -sum;
    }
    return factors_->ldlt.permutationPinv() * y;
}

bool DirectFactors::negative_determinant() const { return factors_->lu->signDeterminant() < 0; }

long DirectFactors::size() const {
    if (unsymmetric_) return long(factors_->lu->nnzL()) + long(factors_->lu->nnzU());
    return long(factors_->ldlt.matrixL().nestedExpression().nonZeros()) + long(factors_->diagonal.size());
}

}  // namespace hinge

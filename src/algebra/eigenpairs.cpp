#include "algebra/eigenpairs.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>
#include <Spectra/SymGEigsShiftSolver.h>
#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "core/doing.h"
#include "core/errors.h"

namespace hinge {
namespace {

using Factors = Eigen::SimplicialLDLT<SparseMatrix>;
using Vector = Eigen::VectorXd;

/// x -> M x, for Spectra.
struct MassProduct {
    using Scalar = double;
    const SparseMatrix& M;

    Eigen::Index rows() const { return M.rows(); }
    void perform_op(const double* x, double* y) const {
        Vector::Map(y, rows()) = M.selfadjointView<Eigen::Lower>() * Vector::Map(x, rows());
    }
};

/// x -> (K + a M)^-1 x without its components along the known modes, for Spectra.
struct Inverse {
    using Scalar = double;
    const Factors& factors;
    Eigen::MatrixXd modes, M_modes;  ///< their shapes, of modal mass 1, and M times these

    Eigen::Index rows() const { return factors.rows(); }
    void set_shift(double) {}  // the factors have it
    void perform_op(const double* x, double* y) const {
        if (asked_to_end) throw Interrupted("");
        auto out = Vector::Map(y, rows());
        out = factors.solve(Vector::Map(x, rows()));
        if (modes.cols() > 0) out -= modes * (M_modes.transpose() * out);
    }
};

/// The first `wanted` by rising value.
Eigenpairs sorted(const std::vector<double>& values, const Eigen::MatrixXd& vectors, int wanted, bool with_vectors) {
    std::vector<int> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int i, int j) { return values[i] < values[j]; });
    Eigenpairs found;
    if (with_vectors) found.vectors.resize(vectors.rows(), wanted);
    for (int i = 0; i < wanted; ++i) {
        found.values.push_back(values[order[i]]);
        if (with_vectors) found.vectors.col(i) = vectors.col(order[i]);
    }
    return found;
}

/// Of small matrices: Lanczos' method wants room.
Eigenpairs of_dense(const SparseMatrix& K, const SparseMatrix& M, double a, int wanted, bool with_vectors) {
    const Eigen::MatrixXd shifted = Eigen::MatrixXd(K + a * M).selfadjointView<Eigen::Lower>();
    const Eigen::MatrixXd mass = Eigen::MatrixXd(M).selfadjointView<Eigen::Lower>();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        mass, shifted, with_vectors ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly);
    Eigenpairs found;
    const Eigen::Index size = K.rows();
    if (with_vectors) found.vectors.resize(size, wanted);
    for (int i = 0; i < wanted; ++i) {
        const double inverse = solver.eigenvalues()[size - 1 - i];
        found.values.push_back(1 / inverse - a);
        if (with_vectors) found.vectors.col(i) = solver.eigenvectors().col(size - 1 - i) / std::sqrt(inverse);
    }
    return found;
}

/// A part that no mass and no stiffness holds has a pivot that is rounding.
void must_hold_all(const Factors& factors, const SparseMatrix& matrix) {
    constexpr double rounding = 1e-12;
    const Vector own = matrix.diagonal(), pivots = factors.permutationPinv() * Vector(factors.vectorD());
    if (factors.info() != Eigen::Success || !((pivots.array().abs() > rounding * own.array().abs()).all()))
        throw std::runtime_error(
            "no modes are found: a part without mass can move without resistance; give it a density, or hold it");
}

/// Where M acts on few unknowns: with M = L L^T there, and G = (K + a M)^-1, the vectors z of L^T G L z = z / (v + a)
/// are those of x = (v + a) G L z.
Eigenpairs of_few_masses(const SparseMatrix& K, const SparseMatrix& M, double a, int wanted, bool with_vectors) {
    const Factors factors(K + a * M);
    must_hold_all(factors, K + a * M);
    const Vector own = M.diagonal();
    std::vector<Eigen::Index> heavy;
    for (Eigen::Index i = 0; i < own.size(); ++i)
        if (own[i] > 0) heavy.push_back(i);
    const Eigen::MatrixXd whole = Eigen::MatrixXd(M).selfadjointView<Eigen::Lower>();
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(Eigen::MatrixXd(whole(heavy, heavy)));
    const Eigen::MatrixXd L =
        ldlt.transpositionsP().transpose() *
        Eigen::MatrixXd(Eigen::MatrixXd(ldlt.matrixL()) * ldlt.vectorD().cwiseMax(0.0).cwiseSqrt().asDiagonal());
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(own.size(), L.cols());
    right(heavy, Eigen::all) = L;
    const Eigen::MatrixXd moved = factors.solve(right), inverse = L.transpose() * moved(heavy, Eigen::all);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(inverse);
    const Eigen::Index last = inverse.rows() - 1;
    constexpr double rounding = 1e-14;  // a mass on an arm may have fewer motions than unknowns
    Eigenpairs found;
    if (with_vectors) found.vectors.resize(own.size(), wanted);
    for (Eigen::Index i = 0; i < wanted && i <= last; ++i) {
        const double of_inverse = solver.eigenvalues()[last - i];
        if (!(of_inverse > rounding * solver.eigenvalues()[last])) break;
        found.values.push_back(1 / of_inverse - a);
        if (with_vectors) found.vectors.col(i) = moved * solver.eigenvectors().col(last - i) / of_inverse;
    }
    if (with_vectors) found.vectors.conservativeResize(own.size(), Eigen::Index(found.values.size()));
    return found;
}

}  // namespace

Eigenpairs lowest_eigenpairs(const SparseMatrix& K, const SparseMatrix& M, double a, int wanted, bool with_vectors) {
    const int size = int(K.rows()), heavy = int((M.diagonal().array() > 0).count());
    wanted = std::min(wanted, heavy);
    if (heavy < size && heavy < 4 * wanted + 40) return of_few_masses(K, M, a, wanted, with_vectors);
    if (size < 4 * wanted + 40) return of_dense(K, M, a, wanted, with_vectors);
    const Doing doing("the search for natural frequencies,", size, "unknowns");
    const Factors factors(K + a * M);
    if (heavy < size) must_hold_all(factors, K + a * M);
    Inverse inverse{factors, {}, {}};
    MassProduct mass{M};
    std::vector<double> values;
    Eigen::MatrixXd vectors;
    for (double last = std::numeric_limits<double>::infinity();;) {
        Spectra::SymGEigsShiftSolver<Inverse, MassProduct, Spectra::GEigsMode::ShiftInvert> solver(
            inverse, mass, wanted, std::max(2 * wanted, 20), -a);
        if (heavy < size) {  // a start that M sees
            const Vector start = Vector::LinSpaced(size, 1, 2),
                         seen = factors.solve(M.selfadjointView<Eigen::Lower>() * start);
            solver.init(seen.data());
        } else {
            solver.init();
        }
        if (solver.compute(Spectra::SortRule::LargestMagn) < wanted)
            throw std::runtime_error("the natural frequencies cannot be found: Lanczos' method does not converge");
        const Vector found = solver.eigenvalues();
        values.insert(values.end(), found.begin(), found.end());
        vectors.conservativeResize(size, vectors.cols() + wanted);
        vectors.rightCols(wanted) = solver.eigenvectors();
        std::vector<double> rising = values;
        std::sort(rising.begin(), rising.end());
        // As many negative pivots as there are eigenvalues below the shift (Sylvester): is one of them missing?
        const double shift = (1 - 1e-6) * rising[wanted - 1];
        const Factors shifted(K - shift * M);
        const auto below = std::lower_bound(rising.begin(), rising.end(), shift) - rising.begin();
        if ((shifted.vectorD().array() < 0).count() <= below || found.minCoeff() >= last)
            return sorted(values, vectors, wanted, with_vectors);
        last = rising[wanted - 1];
        inverse.modes = vectors;
        inverse.M_modes = M.selfadjointView<Eigen::Lower>() * inverse.modes;
    }
}

namespace {

void must_be_regular(const Factors& factors) {
    if (factors.info() != Eigen::Success)
        throw std::runtime_error(
            "no modes are found: the stiffness is singular, so that a part of the structure can "
            "move without resistance");
}

}  // namespace

double largest_eigenvalue(const Eigen::MatrixXd& symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric, Eigen::EigenvaluesOnly);
    return solver.eigenvalues().maxCoeff();
}

int negative_pivots(const SparseMatrix& K) {
    const Factors factors(K);
    must_be_regular(factors);
    return int((factors.vectorD().array() < 0).count());
}

Eigen::VectorXd solution(const SparseMatrix& K, const Eigen::VectorXd& right) {
    const Factors factors(K);
    must_be_regular(factors);
    return factors.solve(right);
}

Eigen::MatrixXd vectors_next_to_zero(const SparseMatrix& K, int count) {
    const Factors factors(K);
    must_be_regular(factors);
    Eigen::MatrixXd x(K.rows(), count);
    for (Eigen::Index i = 0; i < x.rows(); ++i)  // no vector of the structure is square to them
        for (int k = 0; k < count; ++k) x(i, k) = std::sin(1.0 + 0.7 * double(i + 1) * (k + 1));
    for (int iteration = 0; iteration < 12; ++iteration) {
        const Eigen::MatrixXd next = factors.solve(x);
        x = Eigen::HouseholderQR<Eigen::MatrixXd>(next).householderQ() * Eigen::MatrixXd::Identity(x.rows(), count);
    }
    return x;
}

}  // namespace hinge

// Unstable modes of a stiffness: the number of its negative eigenvalues, and one eigenvector.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>

#include "algebra/effective_stiffness.h"

namespace hinge {
namespace {

SolverSettings by_factors() {
    SolverSettings settings;
    settings.direct = true;
    return settings;
}

using Solve = std::function<bool(const std::vector<Vec6>& right, std::vector<Vec6>& x)>;

/// Ritz values of A^-1 are those of A where the residual is no larger than this part of them, and real where their
/// imaginary part is: rounding parts a double eigenvalue by the root of its size.
constexpr double converged_to = 1e-8, real_to = 1e-4;

/// Arnoldi's method for the eigenvalues of a matrix A that are next to zero, with A^-1 as `solve` has it. It begins
/// with a block of vectors, so that it finds eigenvalues as often as they are there, up to the size of the block.
/// Rotations are weighed with an element's length. What has converged does not depend on the vectors that it begins
/// with.
class Arnoldi {
public:
    Arnoldi(const std::vector<std::uint8_t>& held, double length, int block, int most)
        : held_(held), length_(length), right_(held.size()), image_(held.size()) {
        const int size = 6 * int(held.size());
        basis_ = Eigen::MatrixXd::Zero(size, most + block);
        projected_ = Eigen::MatrixXd::Zero(most + block, most);
        for (int k = 0; k < block; ++k) {
            Eigen::VectorXd v = Eigen::VectorXd::Zero(size);
            for (int i = 0; i < size; ++i)
                if (!(held[i / 6] >> i % 6 & 1)) v[i] = std::sin(1.0 + (k + 1) * (0.7 * (i / 6) + 0.3) + 1.9 * (i % 6));
            add_orthogonal(v, nullptr);
        }
    }

    /// Until all eigenvalues within `radius` of zero have converged, or there are no more vectors. Returns how many
    /// of those that have converged are real and negative; -1 where a solution fails.
    int real_negative(const Solve& solve, double radius) {
        for (int next = 0; next < int(projected_.cols()) && next < vectors_; ++next) {
            Eigen::VectorXd v = basis_.col(next);
            if (!apply(solve, v)) return -1;
            add_orthogonal(v, &next);
            done_ = next + 1;
            if (done_ % check_every == 0 && has_all_within(radius)) return count_;
        }
        has_all_within(radius);
        return count_;
    }

    /// The one of them that is next to zero, without its sign.
    double nearest() const { return count_ > 0 ? nearest_ : 0; }

    /// Size of the Ritz value next to zero.
    double smallest() const { return smallest_; }

private:
    static constexpr int check_every = 8;

    bool apply(const Solve& solve, Eigen::VectorXd& v) {
        const auto weight = [&](Vec6 x) -> Vec6 { return x.tail<3>() *= length_, x; };
        for (std::size_t i = 0; i < right_.size(); ++i) right_[i] = weight(v.segment<6>(6 * Eigen::Index(i)));
        if (!solve(right_, image_)) return false;
        for (std::size_t i = 0; i < right_.size(); ++i) v.segment<6>(6 * Eigen::Index(i)) = weight(image_[i]);
        return v.allFinite();
    }

    /// Gram and Schmidt, twice against rounding. `column`: of the projected matrix; null: of none. What depends on the
    /// basis adds nothing to it.
    void add_orthogonal(Eigen::VectorXd v, const int* column) {
        const double size = v.norm();
        for (int twice : {0, 1}) {
            (void)twice;
            const Eigen::VectorXd part = basis_.leftCols(vectors_).transpose() * v;
            v -= basis_.leftCols(vectors_) * part;
            if (column) projected_.col(*column).head(vectors_) += part;
        }
        const double left = v.norm();
        if (!(left > 1e-13 * size)) return;
        if (column) projected_(vectors_, *column) = left;
        basis_.col(vectors_++) = v / left;
    }

    /// Counts, from the eigenvalue next to zero outwards.
    bool has_all_within(double radius) {
        const Eigen::EigenSolver<Eigen::MatrixXd> solver(projected_.topLeftCorner(done_, done_));
        count_ = 0;
        if (solver.info() != Eigen::Success) return false;
        const Eigen::MatrixXd rest = projected_.block(done_, 0, vectors_ - done_, done_);
        std::vector<int> order(static_cast<std::size_t>(done_));
        for (int m = 0; m < done_; ++m) order[std::size_t(m)] = m;
        const auto size_of = [&](int m) { return std::abs(solver.eigenvalues()[m]); };
        std::sort(order.begin(), order.end(), [&](int m, int n) { return size_of(m) > size_of(n); });
        smallest_ = 1 / size_of(order.front());
        bool all = true, beyond = vectors_ == done_;
        for (const int m : order) {
            const std::complex<double> inverse = solver.eigenvalues()[m];
            const double residual = (rest * solver.eigenvectors().col(m)).norm();
            const bool converged = residual <= converged_to * std::abs(inverse);
            all = all && converged;
            beyond = beyond || (all && std::abs(inverse) * radius < 1);
            const bool real = std::abs(inverse.imag()) <= real_to * std::abs(inverse.real());
            if (!converged || !real || inverse.real() >= 0) continue;
            if (count_++ == 0) nearest_ = 1 / std::abs(inverse);
        }
        return beyond;
    }

    const std::vector<std::uint8_t>& held_;
    const double length_;
    std::vector<Vec6> right_, image_;
    Eigen::MatrixXd basis_, projected_;
    int vectors_ = 0, done_ = 0, count_ = 0;
    double nearest_ = 0, smallest_ = 0;
};

}  // namespace

int EffectiveStiffness::negative_modes() {
    nearest_negative_ = 0;
    if (!symmetric_factors().good()) return 0;
    const int count = symmetric_factors().negative_pivots();
    if (keeping_ != MatrixStorage::unsymmetric || count == 0) return count;
    const int real = real_negative_modes(count);
    // an odd number of them makes the determinant negative: that is certain
    return factors_.negative_determinant() && real % 2 == 0 ? real + 1 : real;
}

/// Of A that is not symmetric, no more than `most`. Applied moments drive a structure in pairs of complex ones too,
/// which leave it where it is as long as nothing moves. A has no real eigenvalue below those of its symmetric part:
/// that bounds what has to be looked for.
int EffectiveStiffness::real_negative_modes(int most) {
    const int nodes = int(structure_.position().size()), free = structure_.free_dofs();
    double length = 0;
    for (const Element& e : structure_.elements()) length += e.length / double(structure_.elements().size());
    Vec6 weight;
    weight << Vec3::Ones(), Vec3::Constant(length * length);
    double stiffest = 0;
    for (int i = 0; i < nodes; ++i) stiffest = std::max(stiffest, matrices_.own(i).diagonal().head<3>().maxCoeff());
    double bound = 1e-13 * stiffest;
    for (;; bound *= 4) {
        DirectFactors symmetric(false);
        if (factorise_shifted(symmetric, true, bound * weight) && symmetric.negative_pivots() == 0) break;
        if (!(bound < stiffest)) break;
    }
    constexpr int least_vectors = 60, vectors_of_each = 12;
    const int block = std::min(most + 2, free),
              vectors = std::min(std::max(least_vectors, vectors_of_each * block), free);
    Arnoldi arnoldi(matrices_.held(), length, block, vectors);
    const auto solve = [&](const std::vector<Vec6>& right, std::vector<Vec6>& x) {
        return solve_by(factors_, right, x);
    };
    const int found = arnoldi.real_negative(solve, bound);
    nearest_negative_ = arnoldi.nearest();
    return found < 0 ? most : std::min(found, most);
}

double EffectiveStiffness::smallest_eigenvalue() {
    const int free = structure_.free_dofs();
    if (free == 0) return 0;
    double length = 0;
    for (const Element& e : structure_.elements()) length += e.length / double(structure_.elements().size());
    Arnoldi arnoldi(matrices_.held(), length, std::min(2, free), std::min(16, free));
    const auto solve = [&](const std::vector<Vec6>& right, std::vector<Vec6>& x) {
        return solve_by(factors_, right, x);
    };
    return arnoldi.real_negative(solve, 1e300) < 0 ? 0 : arnoldi.smallest();
}

/// Inverse iteration, for as long as what comes out is still driven on.
std::vector<Vec6> EffectiveStiffness::negative_mode() {
    std::vector<Vec6> mode(structure_.position().size(), Vec6::Zero());
    if (!symmetric_factors().good()) return mode;
    const Eigen::VectorXd direction = symmetric_factors().negative_direction();
    if (direction.size() == 0 || !direction.allFinite()) return mode;
    for (std::size_t i = 0; i < mode.size(); ++i) mode[i] = direction.segment<6>(6 * i);
    const auto scale = [](std::vector<Vec6>& v) {
        double most = 0;
        for (const Vec6& x : v) most = std::max(most, x.cwiseAbs().maxCoeff());
        if (most > 0)
            for (Vec6& x : v) x /= most;
    };
    scale(mode);
    std::vector<Vec6> next(mode.size(), Vec6::Zero());
    for (int iteration = 0; iteration < 8; ++iteration) {
        if (!solve(mode, next, by_factors()).converged) break;
        double work = 0;  // next^T A next
        for (std::size_t i = 0; i < mode.size(); ++i) work += next[i].dot(mode[i]);
        if (!(work < 0)) break;
        scale(next);
        mode.swap(next);
    }
    return mode;
}

}  // namespace hinge

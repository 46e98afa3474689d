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

/// Subspace iteration with (A + shift W)^-1 W, which `solve` has the inverse of: the `size` eigenvalues of A next to
/// -shift. W weighs rotations with the square of an element's length.
class SubspaceIteration {
public:
    SubspaceIteration(const std::vector<std::uint8_t>& held, const Vec6& weight, int size)
        : weight_(weight), basis_(size, std::vector<Vec6>(held.size())), image_(basis_), right_(held.size()) {
        for (int k = 0; k < size; ++k)
            for (int i = 0; i < int(held.size()); ++i)
                for (int c = 0; c < 6; ++c)
                    basis_[k][i][c] = held[i] >> c & 1 ? 0 : std::sin(1.0 + (k + 1) * (0.7 * i + 0.3) + 1.9 * c);
    }

    /// Iterates, and finds the eigenvalues in the subspace. False where one of the solutions fails.
    bool run(const Solve& solve) {
        for (int iteration = 0; iteration < 40; ++iteration) {
            if (iteration > 0) basis_.swap(image_);
            if (!orthonormalise() || !apply(solve)) return false;
        }
        Eigen::MatrixXd inverse(basis_.size(), basis_.size());
        for (std::size_t j = 0; j < basis_.size(); ++j)
            for (std::size_t k = 0; k < basis_.size(); ++k) inverse(j, k) = product(basis_[j], image_[k]);
        if (!inverse.allFinite()) return false;
        solver_.compute(inverse);
        return solver_.info() == Eigen::Success;
    }

    /// How many of the eigenvalues are real and negative. Without a shift an eigenvalue counts where its vector is one,
    /// to a hundredth: what is not yet separated from others may have either sign.
    int real_negative(double shift) const {
        int count = 0;
        for (int m = 0; m < int(basis_.size()); ++m) {
            const std::complex<double> stiffness = 1.0 / solver_.eigenvalues()[m] - shift;
            const bool real = std::abs(stiffness.imag()) <= 1e-3 * std::abs(stiffness.real());
            count += stiffness.real() < 0 && real && (shift > 0 || is_vector(m));
        }
        return count;
    }

private:
    double product(const std::vector<Vec6>& a, const std::vector<Vec6>& b) const {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(weight_.cwiseProduct(b[i]));
        return sum;
    }

    /// Gram and Schmidt, twice against rounding. False where a vector depends on those before it.
    bool orthonormalise() {
        for (std::size_t k = 0; k < basis_.size(); ++k) {
            for (std::size_t j = 0; j < 2 * k; ++j) {
                const std::vector<Vec6>& other = basis_[j % k];
                const double part = product(other, basis_[k]);
                for (std::size_t i = 0; i < other.size(); ++i) basis_[k][i] -= part * other[i];
            }
            const double norm = std::sqrt(product(basis_[k], basis_[k]));
            if (!(norm > 0)) return false;
            for (Vec6& v : basis_[k]) v /= norm;
        }
        return true;
    }

    bool apply(const Solve& solve) {
        for (std::size_t k = 0; k < basis_.size(); ++k) {
            for (std::size_t i = 0; i < right_.size(); ++i) right_[i] = weight_.cwiseProduct(basis_[k][i]);
            if (!solve(right_, image_[k])) return false;
        }
        return true;
    }

    /// Whether the vector of the real eigenvalue m is an eigenvector of the whole matrix, to a hundredth.
    bool is_vector(int m) const {
        double off = 0, size_of = 0;
        for (std::size_t i = 0; i < right_.size(); ++i) {
            Vec6 wanted = Vec6::Zero(), found = Vec6::Zero();
            for (std::size_t k = 0; k < basis_.size(); ++k) {
                const double part = solver_.eigenvectors()(k, m).real();
                wanted += solver_.eigenvalues()[m].real() * part * basis_[k][i], found += part * image_[k][i];
            }
            off += (found - wanted).cwiseAbs2().dot(weight_), size_of += wanted.cwiseAbs2().dot(weight_);
        }
        return off <= 1e-4 * size_of;
    }

    Vec6 weight_;
    std::vector<std::vector<Vec6>> basis_, image_;
    std::vector<Vec6> right_;
    Eigen::EigenSolver<Eigen::MatrixXd> solver_;
};

/// Of the `size` eigenvalues of A next to -shift: how many are real and negative, -1 where that is not known.
int real_negative_next_to(const Solve& solve, const std::vector<std::uint8_t>& held, const Vec6& weight, int size,
                          double shift) {
    SubspaceIteration iteration(held, weight, size);
    return iteration.run(solve) ? iteration.real_negative(shift) : -1;
}

}  // namespace

int EffectiveStiffness::negative_modes() {
    if (!symmetric_factors().good()) return 0;
    const int count = symmetric_factors().negative_pivots();
    if (keeping_ != MatrixStorage::unsymmetric || count == 0) return count;
    const int real = real_negative_modes(count);
    // an odd number of them makes the determinant negative: that is certain
    return factors_.negative_determinant() && real % 2 == 0 ? real + 1 : real;
}

/// Of A that is not symmetric, no more than `most`. Applied moments drive a structure in pairs of complex ones too,
/// which leave it where it is as long as nothing moves. A has no real eigenvalue below those of its symmetric part, so
/// that with a shift beyond these the lowest are found. Where moments make the symmetric part very negative, that shift
/// is far from the real ones, and those next to zero are looked for as well.
int EffectiveStiffness::real_negative_modes(int most) {
    const int nodes = int(structure_.position().size()), size = std::min(most + 4, structure_.free_dofs());
    double length = 0;
    for (const Element& e : structure_.elements()) length += e.length / double(structure_.elements().size());
    Vec6 weight;
    weight << Vec3::Ones(), Vec3::Constant(length * length);
    double stiffest = 0;
    for (int i = 0; i < nodes; ++i) stiffest = std::max(stiffest, matrices_.own(i).diagonal().head<3>().maxCoeff());
    // no larger than it must be: beside stiff parts, a large shift leaves the eigenvalues of slender ones too close
    double shift = 1e-13 * stiffest;
    for (;; shift *= 4) {
        DirectFactors symmetric(false);
        if (factorise_shifted(symmetric, true, shift * weight) && symmetric.negative_pivots() == 0) break;
        if (!(shift < stiffest)) return most;
    }
    DirectFactors shifted(true);
    if (!factorise_shifted(shifted, false, 2 * shift * weight)) return most;
    const auto found_by = [&](DirectFactors& factors, double distance) {
        const Solve solve = [&](const std::vector<Vec6>& right, std::vector<Vec6>& x) {
            return solve_by(factors, right, x);
        };
        return real_negative_next_to(solve, matrices_.held(), weight, size, distance);
    };
    const int lowest = found_by(shifted, 2 * shift);
    if (lowest < 0 || lowest >= most) return most;
    return std::min(std::max(lowest, found_by(factors_, 0)), most);
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

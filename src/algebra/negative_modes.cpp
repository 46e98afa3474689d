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

/// By subspace iteration with (A + shift W)^-1 W, which `solve` has the inverse of: how many of the `size` eigenvalues
/// of A next to -shift are real and negative, -1 where that is not known. W weighs rotations with the square of an
/// element's length. Without a shift an eigenvalue counts where its vector is one, to a hundredth: what is not yet
/// separated from others may have either sign.
int real_negative_next_to(const Solve& solve, const std::vector<std::uint8_t>& held, const Vec6& weight, int size,
                          double shift) {
    const int nodes = int(held.size());
    const auto product = [&](const std::vector<Vec6>& a, const std::vector<Vec6>& b) {
        double sum = 0;
        for (int i = 0; i < nodes; ++i) sum += a[i].dot(weight.cwiseProduct(b[i]));
        return sum;
    };
    std::vector<std::vector<Vec6>> basis(size, std::vector<Vec6>(nodes)), image = basis;
    for (int k = 0; k < size; ++k)
        for (int i = 0; i < nodes; ++i)
            for (int c = 0; c < 6; ++c)
                basis[k][i][c] = held[i] >> c & 1 ? 0 : std::sin(1.0 + (k + 1) * (0.7 * i + 0.3) + 1.9 * c);
    Eigen::MatrixXd inverse(size, size);
    std::vector<Vec6> right(nodes);
    for (int iteration = 0; iteration < 40; ++iteration) {
        if (iteration > 0) basis.swap(image);
        for (int k = 0; k < size; ++k) {  // orthonormal, twice against rounding
            for (int j = 0; j < 2 * k; ++j) {
                const std::vector<Vec6>& other = basis[j % k];
                const double part = product(other, basis[k]);
                for (int i = 0; i < nodes; ++i) basis[k][i] -= part * other[i];
            }
            const double norm = std::sqrt(product(basis[k], basis[k]));
            if (!(norm > 0)) return -1;
            for (Vec6& v : basis[k]) v /= norm;
        }
        for (int k = 0; k < size; ++k) {
            for (int i = 0; i < nodes; ++i) right[i] = weight.cwiseProduct(basis[k][i]);
            if (!solve(right, image[k])) return -1;
        }
        for (int j = 0; j < size; ++j)
            for (int k = 0; k < size; ++k) inverse(j, k) = product(basis[j], image[k]);
    }
    if (!inverse.allFinite()) return -1;
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(inverse);
    const auto is_vector = [&](int m) {
        double off = 0, size_of = 0;
        for (int i = 0; i < nodes; ++i) {
            Vec6 wanted = Vec6::Zero(), found = Vec6::Zero();
            for (int k = 0; k < size; ++k) {
                const double part = solver.eigenvectors()(k, m).real();
                wanted += solver.eigenvalues()[m].real() * part * basis[k][i], found += part * image[k][i];
            }
            off += (found - wanted).cwiseAbs2().dot(weight), size_of += wanted.cwiseAbs2().dot(weight);
        }
        return off <= 1e-4 * size_of;
    };
    int count = 0;
    for (int m = 0; m < size; ++m) {
        const std::complex<double> stiffness = 1.0 / solver.eigenvalues()[m] - shift;
        const bool real = std::abs(stiffness.imag()) <= 1e-3 * std::abs(stiffness.real());
        count += stiffness.real() < 0 && real && (shift > 0 || is_vector(m));
    }
    return count;
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

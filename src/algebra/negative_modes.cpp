// Ways of moving that a stiffness drives on: its negative eigenvalues, how many and one of them.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "algebra/effective_stiffness.h"

namespace hinge {
namespace {

SolverSettings by_factors() {
    SolverSettings settings;
    settings.direct = true;
    return settings;
}

}  // namespace

int EffectiveStiffness::negative_modes() {
    if (!symmetric_factors().good()) return 0;
    const int count = symmetric_factors().negative_pivots();
    if (keeping_ != Keeping::unsymmetric || count == 0) return count;
    const int real = real_negative_modes(count);
    // an odd number of them makes the determinant negative: that is certain
    return factors_.negative_determinant() && real % 2 == 0 ? real + 1 : real;
}

/// Of A that is not symmetric, no more than `most`. Applied moments drive a structure in pairs of complex ones too,
/// which leave it where it is as long as nothing moves. Subspace iteration with (A + shift W)^-1 W, where the shift
/// lies below all eigenvalues, finds the lowest; W weighs rotations with the square of an element's length.
int EffectiveStiffness::real_negative_modes(int most) {
    const int nodes = int(structure_.position().size()), size = std::min(most + 4, structure_.free_dofs());
    const std::vector<std::uint8_t>& held = matrices_.held();
    double length = 0;
    for (const Element& e : structure_.elements()) length += e.length / double(structure_.elements().size());
    Vec6 weight;
    weight << Vec3::Ones(), Vec3::Constant(length * length);
    const auto product = [&](const std::vector<Vec6>& a, const std::vector<Vec6>& b) {
        double sum = 0;
        for (int i = 0; i < nodes; ++i) sum += a[i].dot(weight.cwiseProduct(b[i]));
        return sum;
    };
    double stiffest = 0;
    for (int i = 0; i < nodes; ++i) stiffest = std::max(stiffest, matrices_.own(i).diagonal().head<3>().maxCoeff());
    double shift = 1e-9 * stiffest;
    for (;; shift *= 4) {  // A has no real eigenvalue below those of its symmetric part
        DirectFactors shifted(false);
        if (factorise_shifted(shifted, true, shift * weight) && shifted.negative_pivots() == 0) break;
        if (!(shift < stiffest)) return most;
    }
    DirectFactors factors(true);
    if (!factorise_shifted(factors, false, 2 * shift * weight)) return most;
    std::vector<std::vector<Vec6>> basis(size, std::vector<Vec6>(nodes)), image = basis;
    for (int k = 0; k < size; ++k)
        for (int i = 0; i < nodes; ++i)
            for (int c = 0; c < 6; ++c)
                basis[k][i][c] = held[i] >> c & 1 ? 0 : std::sin(1.0 + (k + 1) * (0.7 * i + 0.3) + 1.9 * c);
    Eigen::MatrixXd inverse(size, size);
    std::vector<Vec6> right(nodes);
    for (int iteration = 0; iteration < 40; ++iteration) {
        for (int k = 0; k < size; ++k) {  // orthonormal, twice against rounding
            for (int j = 0; j < 2 * k; ++j) {
                const std::vector<Vec6>& other = basis[j % k];
                const double part = product(other, basis[k]);
                for (int i = 0; i < nodes; ++i) basis[k][i] -= part * other[i];
            }
            const double norm = std::sqrt(product(basis[k], basis[k]));
            if (!(norm > 0)) return most;
            for (Vec6& v : basis[k]) v /= norm;
        }
        for (int k = 0; k < size; ++k) {
            for (int i = 0; i < nodes; ++i) right[i] = weight.cwiseProduct(basis[k][i]);
            if (!solve_by(factors, right, image[k])) return most;
        }
        for (int j = 0; j < size; ++j)
            for (int k = 0; k < size; ++k) inverse(j, k) = product(basis[j], image[k]);
        basis.swap(image);
    }
    if (!inverse.allFinite()) return most;
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(inverse, false);
    int count = 0;
    for (const std::complex<double>& value : solver.eigenvalues()) {
        const std::complex<double> stiffness = 1.0 / value - 2 * shift;
        count += stiffness.real() < 0 && std::abs(stiffness.imag()) <= 1e-3 * std::abs(stiffness.real());
    }
    return std::min(count, most);
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

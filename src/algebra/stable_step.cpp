#include "algebra/stable_step.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "beam/mass.h"

namespace hinge {
namespace {

/// The largest eigenvalue of M^-1 K of one element, 1/s^2, M lumped: that of m^-1/2 K m^-1/2.
double highest(const Element& e) {
    const auto T = beam::linear_deformation(e.length);
    Mat12 K = T.transpose() * e.stiffness.matrix() * T;
    const Vec12 root =
        beam::lumped_inertia(e.rigidity, e.length).matrix(Mat3::Identity()).diagonal().cwiseSqrt().cwiseInverse();
    K = root.asDiagonal() * K * root.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<Mat12>(K, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace

StableStep stable_step(const Structure& structure, std::span<const ElementDamping> damping) {
    StableStep least{std::numeric_limits<double>::infinity(), -1};
    std::map<std::tuple<const Section*, const Material*, double>, double> known;  // most elements are like another
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        const MemberData& member = structure.model().members()[e.member];
        const auto [at, fresh] =
            known.try_emplace({member.section.get(), member.material.get(), std::round(1e9 * e.length)}, 0);
        if (fresh) at->second = highest(e);
        const ElementDamping d = damping.empty() ? ElementDamping{} : damping[i];
        const double c = d.of_mass + d.of_stiffness * at->second, dt = 2 / (c + std::sqrt(c * c + at->second));
        if (dt < least.dt) least = {dt, int(i)};
    }
    return least;
}

}  // namespace hinge

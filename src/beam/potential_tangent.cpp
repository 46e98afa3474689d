// The consistent tangent of elements and pairs whose sections follow a PotentialLaw.
#include <Eigen/Cholesky>
#include <algorithm>

#include "beam/potential_parts.h"

namespace hinge::beam {
namespace {

constexpr double least_pivot_growth = 1e-13;  ///< of a pivot: N may flow at either end
constexpr double at_the_start = 1e-9;         ///< lambda over that of the flow found: a flow that begins (flowing_on)
constexpr double stiff = 1e6;  ///< over the elastic stiffness: the second derivatives of D where flow begins

}  // namespace

/// The second derivatives of the work at the flow of a section, an end without its e. False: it does not flow.
bool PotentialLaw::curvature_of(const ElementFlow& flow, int section, const End& end, Mat4& out) const {
    if (!(flow.lambda[section] > 0)) return false;
    const Vec4 e = normalised_flow(flow, section);
    Work w = work_at(e);
    const double largest = w.curvature.cwiseAbs().maxCoeff();
    if (flow.lambda[section] < at_the_start * 0.5 * w.initial && largest > 0)
        w.curvature *= std::max(1.0, stiff * end.k.maxCoeff() / largest);
    const Vec4 surface = w.q;
    const double slope = end.turned.slope * factor_at(end.history, w.initial / material_.zone.energy, end.dt).value;
    harden(end, e, w);
    out = w.curvature;
    if (follows_rotation_) out += slope * surface * surface.transpose();
    return true;
}

namespace {

/// K - K B^T (B K B^T + D'')^-1 B K: the tangent where the n sections of B flow. Where N may flow at either of two
/// ends, the matrix in the middle is singular, and what is left of it is damped.
template <int n, int size>
Eigen::Matrix<double, size, size> reduced(const Eigen::Matrix<double, size, size>& K,
                                          const Eigen::Matrix<double, 16, size>& rows, const Mat4 (&bend)[4]) {
    constexpr int height = 4 * n;
    const Eigen::Matrix<double, height, size> BK = rows.template topRows<height>() * K;
    Eigen::Matrix<double, height, height> H = BK * rows.template topRows<height>().transpose();
    for (int i = 0; i < n; ++i) H.template block<4, 4>(4 * i, 4 * i) += bend[i];
    for (int i = 0; i < height; ++i) {
        if (H(i, i) == 0) H(i, i) = 1;  // of infinite strength
        else H(i, i) *= 1 + least_pivot_growth;
    }
    return K - BK.transpose() * H.ldlt().solve(BK);
}

template <int size>
Eigen::Matrix<double, size, size> reduced(int n, const Eigen::Matrix<double, size, size>& K,
                                          const Eigen::Matrix<double, 16, size>& rows, const Mat4 (&bend)[4]) {
    switch (n) {
        case 0: return K;
        case 1: return reduced<1>(K, rows, bend);
        case 2: return reduced<2>(K, rows, bend);
        case 3: return reduced<3>(K, rows, bend);
        default: return reduced<4>(K, rows, bend);
    }
}

}  // namespace

Mat6 PotentialLaw::tangent(const ElementFlow& flow, const Stiffness& k, const double* sections, int n,
                           const SectionConditions& at) const {
    const Mat6 K = k.matrix();
    Eigen::Matrix<double, 16, 6> B;
    Mat4 bend[4];
    int count = 0;
    for (int i = 0; i < n; ++i) {
        End end(sections[i], per_strength_, k);
        end.set_history(at, i, *this, so_far(flow, i));
        if (!curvature_of(flow, i, end, bend[count])) continue;
        B.middleRows<4>(4 * count++) = end.rows();
    }
    return reduced<6>(count, K, B, bend);
}

Mat12 PotentialLaw::pair_tangent(const Mat12& elastic, const ElementFlow* const (&flow)[2],
                                 const SectionConditions* at) const {
    Eigen::Matrix<double, 16, 12> B;
    Mat4 bend[4];
    int count = 0;
    for (int i : {0, 1})
        for (int s = 0; flow[i] && s < 2; ++s) {
            End end(s == 0 ? -1 : 1, per_strength_, {});
            const SectionRows own = end.rows();
            const Mat6 K = elastic.block<6, 6>(6 * i, 6 * i);
            end.k = (own * K * own.transpose()).diagonal();
            end.set_history(at[i], s, *this, so_far(*flow[i], s));
            if (!curvature_of(*flow[i], s, end, bend[count])) continue;
            B.middleRows<4>(4 * count).setZero();
            B.block<4, 6>(4 * count++, 6 * i) = own;
        }
    return reduced<12>(count, elastic, B, bend);
}

}  // namespace hinge::beam

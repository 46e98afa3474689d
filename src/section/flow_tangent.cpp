// The consistent tangent of elements and pairs whose sections are a FlowProblem.
#include <algorithm>

#include "section/flow_end.h"
#include "section/flow_return.h"

namespace hinge::beam {
namespace {

constexpr double least_pivot_growth = 1e-13;  ///< of a pivot: N may flow at either end
constexpr double at_the_start = 1e-9;         ///< lambda over that of the flow found: a flow that begins (flowing_on)
constexpr double stiff = 1e6;  ///< over the elastic stiffness: the second derivatives of D where flow begins

/// The second derivatives of the work at the flow of a section, an end without its e. False: it does not flow.
bool curvature_of(const FlowProblem& problem, const ElementFlow& flow, int section, const FlowingEnd& end, Mat4& out) {
    if (!(flow.lambda[section] > 0)) return false;
    const Vec4 e = problem.normalised(flow.section[section]);
    WorkOfFlow w = problem.work_at(e, end.own);
    const double largest = w.curvature.cwiseAbs().maxCoeff();
    if (flow.lambda[section] < at_the_start * 0.5 * w.initial && largest > 0)
        w.curvature *= std::max(1.0, stiff * end.k.maxCoeff() / largest);
    const Vec4 surface = w.q;
    const double slope =
        end.turned.slope * problem.factor_at(end.history, w.initial / problem.material.zone.energy, end.moment).value;
    harden(problem, end, e, w);
    out = w.curvature;
    if (problem.follows_rotation) out += slope * surface * surface.transpose();
    return true;
}

/// K - K B^T (B K B^T + D'')^-1 B K: the tangent where sections flow, with four rows of B and a block of D'' for each.
/// Row after row is eliminated, that of the largest pivot first. Where N may flow at either of two ends, the matrix in
/// the middle is singular, and what is left of it is damped.
template <int size, int sections>
void reduce(Eigen::Matrix<double, size, size>& K, const Eigen::Matrix<double, 16, size>& B, const Mat4 (&bend)[4]) {
    constexpr int height = 4 * sections;
    double BK[height][size], H[height][height];
    for (int i = 0; i < height; ++i) {
        for (int j = 0; j < size; ++j) BK[i][j] = 0;
        for (int m = 0; m < size; ++m)
            for (int j = 0; j < size; ++j) BK[i][j] += B(i, m) * K(j, m);
        for (int k = 0; k <= i; ++k) {
            double sum = i / 4 == k / 4 ? bend[i / 4](i % 4, k % 4) : 0;
            for (int j = 0; j < size; ++j) sum += BK[i][j] * B(k, j);
            H[i][k] = H[k][i] = sum;
        }
        if (H[i][i] == 0) H[i][i] = 1;  // of infinite strength
        else H[i][i] *= 1 + least_pivot_growth;
    }
    bool left[height];
    std::fill_n(left, height, true);
    for (int step = 0; step < height; ++step) {
        int p = -1;
        for (int i = 0; i < height; ++i)
            if (left[i] && (p < 0 || H[i][i] > H[p][p])) p = i;
        left[p] = false;
        if (!(H[p][p] > 0)) continue;
        for (int i = 0; i < size; ++i) {
            const double part = BK[p][i] / H[p][p];
            for (int j = 0; j < size; ++j) K(j, i) -= part * BK[p][j];
        }
        for (int i = 0; i < height; ++i) {
            if (!left[i]) continue;
            const double part = H[i][p] / H[p][p];
            for (int k = 0; k < height; ++k) H[i][k] -= part * H[p][k];
            for (int j = 0; j < size; ++j) BK[i][j] -= part * BK[p][j];
        }
    }
}

template <int size>
Eigen::Matrix<double, size, size> reduced(Eigen::Matrix<double, size, size> K, const Eigen::Matrix<double, 16, size>& B,
                                          const Mat4 (&bend)[4], int sections) {
    if (sections == 1) reduce<size, 1>(K, B, bend);
    if (sections == 2) reduce<size, 2>(K, B, bend);
    if (sections == 3) reduce<size, 3>(K, B, bend);
    if (sections == 4) reduce<size, 4>(K, B, bend);
    return K;
}

/// The same of an element of which one section flows: half of its entries are 0, and D'' + `end.k`, the matrix in the
/// middle, needs no choice of pivots where no strength falls.
Mat6 one_reduced(const Stiffness& k, const FlowingEnd& end, const Mat4& bend) {
    double rows[4][6] = {{}, {}, {}, {}};  // B K
    rows[0][0] = end.per[0] * (end.n1 * k.x11 + end.n2 * k.x12),
    rows[0][1] = end.per[0] * (end.n1 * k.x12 + end.n2 * k.x22);
    rows[1][2] = end.per[1] * (end.n1 * k.y11 + end.n2 * k.y12),
    rows[1][3] = end.per[1] * (end.n1 * k.y12 + end.n2 * k.y22);
    rows[2][4] = end.per[2] * k.axial, rows[3][5] = end.per[3] * k.twist;
    double H[4][4];
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j <= i; ++j) H[i][j] = bend(i, j) + (i == j ? end.k[i] : 0);
    Mat6 K = k.matrix();
    for (int p = 0; p < 4; ++p) {
        const double inverse = 1 / H[p][p];
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j) K(j, i) -= inverse * rows[p][i] * rows[p][j];
        for (int i = p + 1; i < 4; ++i) {
            const double part = inverse * H[i][p];
            for (int j = p + 1; j <= i; ++j) H[i][j] -= part * H[j][p];
            for (int j = 0; j < 6; ++j) rows[i][j] -= part * rows[p][j];
        }
    }
    return K;
}

}  // namespace

Mat6 tangent_of_element(const FlowProblem& problem, const ElementFlow& flow, const Stiffness& k, const double* sections,
                        int n, const SectionConditions& at) {
    FlowingEnd ends[2];
    Mat4 bend[4];
    int count = 0;
    for (int i = 0; i < n; ++i) {
        if (!(flow.lambda[i] > 0)) continue;
        FlowingEnd& end = ends[count] = FlowingEnd(sections[i], problem.per_strength, k);
        end.set_history(at, i, problem, flow_so_far(problem, flow, i, at.history_of(i, problem.history_size)));
        count += curvature_of(problem, flow, i, end, bend[count]);
    }
    if (count == 1 && !problem.follows_rotation) return one_reduced(k, ends[0], bend[0]);
    Eigen::Matrix<double, 16, 6> B;
    for (int i = 0; i < count; ++i) B.middleRows<4>(4 * i) = ends[i].rows();
    return reduced<6>(k.matrix(), B, bend, count);
}

Mat12 tangent_of_pair(const FlowProblem& problem, const Mat12& elastic, const ElementFlow* const (&flow)[2],
                      const SectionConditions* at) {
    Eigen::Matrix<double, 16, 12> B;
    Mat4 bend[4];
    int count = 0;
    for (int i : {0, 1})
        for (int s = 0; flow[i] && s < 2; ++s) {
            FlowingEnd end(s == 0 ? -1 : 1, problem.per_strength, {});
            const SectionRows own = end.rows();
            const Mat6 K = elastic.block<6, 6>(6 * i, 6 * i);
            end.k = (own * K * own.transpose()).diagonal();
            end.set_history(at[i], s, problem,
                            flow_so_far(problem, *flow[i], s, at[i].history_of(s, problem.history_size)));
            if (!curvature_of(problem, *flow[i], s, end, bend[count])) continue;
            B.middleRows<4>(4 * count).setZero();
            B.block<4, 6>(4 * count++, 6 * i) = own;
        }
    return reduced<12>(elastic, B, bend, count);
}

}  // namespace hinge::beam

#include "contact/tie.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace hinge::contact {

namespace {

Mat3 symmetric(const Vec3& u, const Vec3& v) {
    Mat3 m = 0.5 * (u * v.transpose());
    m += m.transpose().eval();
    return m;
}

/// A tie as it stands now.
struct Pose {
    Vec3 arm[4];   ///< R arm, m
    Vec3 r[4];     ///< of each gap, m
    Vec3 s[4];     ///< Q r0
    Quat q;        ///< Q
    Mat3 inverse;  ///< S^-1, 1/(N m)
};

// Newton's step with every curvature taken as positive, at most half a radian long: leaves saddles, never climbs.
Vec3 downhill(const Mat3& grip, const Vec3& c, double size) {
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.computeDirect(grip);
    Vec3 step = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = solver.eigenvectors().col(i);
        step += axis * (axis.dot(c) / std::max(std::abs(solver.eigenvalues()[i]), 1e-6 * size));
    }
    const double angle = step.norm();
    return angle > 0.5 ? Vec3(0.5 / angle * step) : step;
}

// Q by Newton's method on the rotation: sum k s x r = 0, with S as the derivative. It starts from the last Q, so that
// it follows one valley of U as the points move, however the nodes spin; two or three rounds reach rounding. Where all
// gaps lie on one line S has no grip about that line, nor does Q matter there: a trace of stiffness keeps it
// invertible. Far from the least U (gaps stretched by their own length) S may point uphill: then downhill() steps.
Pose pose(const Tie& tie, const std::vector<Vec3>& position, const std::vector<Quat>& rotation) {
    Pose out;
    Vec3 point[4];
    for (int i = 0; i < 4; ++i) {
        const End& end = tie.end[i];
        out.arm[i] = rotation[end.node] * end.arm;
        point[i] = position[end.node] + out.arm[i];
    }
    out.q = tie.rotation;
    Vec3 kr[4];
    double size = 0;
    for (int g = 0; g < 4; ++g) {
        out.r[g] = point[gap_b(g)] - point[gap_a(g)];
        kr[g] = tie.gap[g].stiffness * out.r[g];
        size += std::sqrt(kr[g].squaredNorm() * tie.gap[g].rest.squaredNorm());
    }
    const auto turn_rest = [&] {
        const Mat3 Q = out.q.toRotationMatrix();
        for (int g = 0; g < 4; ++g) out.s[g] = Q * tie.gap[g].rest;
    };
    turn_rest();

    for (int round = 0; round < 20; ++round) {
        Vec3 c = Vec3::Zero();
        Mat3 grip = Mat3::Zero();
        for (int g = 0; g < 4; ++g) {
            c += out.s[g].cross(kr[g]);
            grip.noalias() -= kr[g] * out.s[g].transpose();
        }
        const double trace = -grip.trace();
        grip = (0.5 * (grip + grip.transpose())).eval();
        grip.diagonal().array() += trace + 1e-10 * size;
        out.inverse = size > 0 ? Mat3(grip.inverse()) : Mat3(Mat3::Zero());
        Vec3 step = out.inverse * c;
        double angle = step.norm();
        if (!(step.dot(c) >= 0 && angle < 1)) {
            step = downhill(grip, c, size);
            angle = step.norm();
        }
        if (!(angle > 1e-15)) break;
        const double sine = angle < 1e-4 ? 0.5 - angle * angle / 48 : std::sin(0.5 * angle) / angle;
        const Quat by(std::cos(0.5 * angle), sine * step.x(), sine * step.y(), sine * step.z());
        out.q = (by * out.q).normalized();
        turn_rest();
        if (angle < 1e-12) break;
    }
    return out;
}

}  // namespace

double gap_stiffness(double ea_a, double ea_b, double length, double shortest) {
    return 2 * ea_a * ea_b / (ea_a + ea_b) / std::max(length, shortest);
}

void add_tie_forces(Tie& tie, const std::vector<Vec3>& position, const std::vector<Quat>& rotation,
                    std::vector<Vec6>& force) {
    const Pose now = pose(tie, position, rotation);
    Vec3 at_end[4];
    for (Vec3& f : at_end) f.setZero();
    tie.energy = tie.opening = 0;
    tie.rotation = now.q;
    tie.normal_now = now.q * tie.normal;
    for (int g = 0; g < 4; ++g) {
        const int a = gap_a(g), b = gap_b(g);
        const Vec3 strain = now.r[g] - now.s[g], f = tie.gap[g].stiffness * strain;
        at_end[a] -= f;
        at_end[b] += f;
        tie.energy += 0.5 * f.dot(strain);
        const double share = (a == 0 ? 1 - tie.at[0] : tie.at[0]) * (b == 2 ? 1 - tie.at[1] : tie.at[1]);
        tie.opening += share * strain.dot(tie.normal_now);
    }
    for (int i = 0; i < 4; ++i) {
        tie.force[i] = at_end[i];
        Vec6& out = force[tie.end[i].node];
        out.head<3>() += at_end[i];
        out.tail<3>() += now.arm[i].cross(at_end[i]);
    }
}

namespace {

/// The parts of which the stiffness of a tie is made (add_tie_stiffness).
struct TieParts {
    Vec3 at_end[4];    ///< force at each end, N
    Mat3 g[4], sg[4];  ///< G of each end, S^-1 G
};

TieParts parts_of(const Tie& tie, const Pose& now) {
    TieParts parts;
    Vec3 lever[4];  // G is [lever]
    for (int i = 0; i < 4; ++i) parts.at_end[i] = lever[i] = Vec3::Zero();
    for (int g = 0; g < 4; ++g) {
        const Vec3 ks = tie.gap[g].stiffness * now.s[g], f = tie.gap[g].stiffness * now.r[g] - ks;
        parts.at_end[gap_a(g)] -= f;
        parts.at_end[gap_b(g)] += f;
        lever[gap_a(g)] -= ks;
        lever[gap_b(g)] += ks;
    }
    for (int i = 0; i < 4; ++i) {
        parts.g[i] = skew(lever[i]);
        parts.sg[i] = now.inverse * parts.g[i];
    }
    return parts;
}

/// Stiffness between the points of two ends.
struct PointStiffness {
    Mat3 block[2][2];
};

/// Of ends i and j; gap: the number of the gap element that joins them, -1 for the two ends of one bar.
PointStiffness between_points(const Tie& tie, const TieParts& of, int i, int j, int gap) {
    const bool same_bar = gap < 0;
    PointStiffness K;
    auto& block = K.block;
    block[0][1] = of.g[i] * of.sg[j];  // -G_i^T S^-1 G_j, as G^T = -G
    block[1][0] = block[0][1].transpose();
    block[0][0] = same_bar ? Mat3(of.g[i] * of.sg[i]) : Mat3(Mat3::Zero());
    block[1][1] = same_bar ? Mat3(of.g[j] * of.sg[j]) : Mat3(Mat3::Zero());
    if (!same_bar) {
        const double k = tie.gap[gap].stiffness;
        for (int d = 0; d < 3; ++d) {
            block[0][0](d, d) += k;
            block[1][1](d, d) += k;
            block[0][1](d, d) -= k;
            block[1][0](d, d) -= k;
        }
    }
    return K;
}

/// Carries the stiffness between the points of two ends to their nodes: dp = dx - [arm] dtheta.
Mat12 at_nodes(const Tie& tie, const Pose& now, const PointStiffness& K, const int end[2]) {
    Mat12 m = Mat12::Zero();
    const bool armed[2] = {!tie.end[end[0]].arm.isZero(0), !tie.end[end[1]].arm.isZero(0)};
    for (int p = 0; p < 2; ++p)
        for (int q = 0; q < 2; ++q) {
            const Mat3& block = K.block[p][q];
            m.block<3, 3>(6 * p, 6 * q) = block;
            if (!armed[p] && !armed[q]) continue;
            const Mat3 arm_p = skew(now.arm[end[p]]), arm_q = skew(now.arm[end[q]]);
            m.block<3, 3>(6 * p, 6 * q + 3) = -block * arm_q;
            m.block<3, 3>(6 * p + 3, 6 * q) = arm_p * block;
            m.block<3, 3>(6 * p + 3, 6 * q + 3) = -arm_p * block * arm_q;
        }
    return m;
}

/// Adds the symmetric part of [F][R a] at both ends of a bar.
void add_moments_of_arms(Mat12& m, const Pose& now, const TieParts& of, const int end[2]) {
    for (int p = 0; p < 2; ++p) {
        const Vec3 &arm = now.arm[end[p]], &f = of.at_end[end[p]];
        m.block<3, 3>(6 * p + 3, 6 * p + 3) += symmetric(f, arm) - f.dot(arm) * Mat3::Identity();
    }
}

}  // namespace

void add_tie_stiffness(const Tie& tie, const std::vector<Vec3>& position, const std::vector<Quat>& rotation,
                       const AddStiffness& add) {
    const Pose now = pose(tie, position, rotation);
    const TieParts parts = parts_of(tie, now);
    // Six pairs; what belongs to one node alone goes with A1A2 and B1B2.
    constexpr int pairs[6][2] = {{0, 1}, {2, 3}, {0, 2}, {0, 3}, {1, 2}, {1, 3}};
    Mat12 lone = Mat12::Zero();  // both ends on one node (a broken element): kept for that node's next pair
    bool has_lone[2] = {false, false};
    for (int n = 0; n < 6; ++n) {
        const int end[2] = {pairs[n][0], pairs[n][1]};
        const bool same_bar = n < 2;
        Mat12 m = at_nodes(tie, now, between_points(tie, parts, end[0], end[1], same_bar ? -1 : n - 2), end);
        if (same_bar) add_moments_of_arms(m, now, parts, end);
        m = (0.5 * (m + m.transpose())).eval();

        const int node_i = tie.end[end[0]].node, node_j = tie.end[end[1]].node;
        if (same_bar && node_i == node_j) {
            const Mat6 both = m.block<6, 6>(0, 6) + m.block<6, 6>(6, 0);
            lone.block<6, 6>(6 * n, 6 * n) = m.block<6, 6>(0, 0) + m.block<6, 6>(6, 6) + both;
            has_lone[n] = true;
            continue;
        }
        if (n == 2 && (has_lone[0] || has_lone[1])) m += lone;
        add(node_i, node_j, m);
    }
}

}  // namespace hinge::contact

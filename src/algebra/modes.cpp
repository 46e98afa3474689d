#include "algebra/modes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

#include "algebra/eigenpairs.h"
#include "beam/tangent.h"
#include "core/text.h"

namespace hinge {
namespace {

using Sparse = SparseMatrix;

/// K and M of the elements at these nodes, their lower halves, on the degrees of freedom that no support holds.
struct Matrices {
    int size = 0;
    bool adds_stiffness = false;  ///< effects do
    Sparse K, M;

    Matrices(const Structure& structure, const std::vector<int>& nodes, const AddedToModes& added) {
        std::vector<int> place(6 * structure.position().size(), -1);
        for (int n : nodes)
            for (int c = 0; c < 6; ++c)
                if (!(structure.fixed()[n] >> c & 1)) place[6 * n + c] = size++;
        std::vector<Eigen::Triplet<double>> stiffness, mass;
        for (int n : nodes)
            for (int index : structure.elements_at(n)) {
                const Element& e = structure.elements()[index];
                if (e.node[0] != n) continue;
                const Mat3 axes = e.axes.toRotationMatrix();
                const Mat12 k = beam::linear_tangent(axes.transpose(), e.length, e.stiffness.matrix());
                const Mat12 m = structure.inertia(index).matrix(axes);
                for (int i = 0; i < 12; ++i)
                    for (int j = 0; j < 12; ++j) {
                        const int row = place[6 * e.node[i / 6] + i % 6], column = place[6 * e.node[j / 6] + j % 6];
                        if (row < 0 || column < 0 || row < column) continue;
                        stiffness.emplace_back(row, column, k(i, j));
                        if (m(i, j) != 0) mass.emplace_back(row, column, m(i, j));
                    }
            }
        const auto add = [&](auto& to, int a, int b, const auto& block) {
            for (int i = 0; i < block.rows(); ++i)
                for (int j = 0; j < block.cols(); ++j) {
                    const int row = place[6 * (i < 6 ? a : b) + i % 6], column = place[6 * (j < 6 ? a : b) + j % 6];
                    if (row < 0 || column < 0 || row < column || block(i, j) == 0) continue;
                    to.emplace_back(row, column, block(i, j));
                    adds_stiffness = adds_stiffness || &to == &stiffness;
                }
        };
        for (const Coupling& c : added.stiffness.pairs) add(stiffness, c.a, c.b, c.K);
        for (const Blocks::Node& n : added.stiffness.nodes) add(stiffness, n.node, n.node, n.K);
        for (const Blocks::Node& n : added.mass) add(mass, n.node, n.node, n.K);
        K.resize(size, size), M.resize(size, size);
        K.setFromTriplets(stiffness.begin(), stiffness.end());
        M.setFromTriplets(mass.begin(), mass.end());
        if (!added.constraints.empty()) reduce(place, added.constraints);
    }

private:
    /// T^T K T and T^T M T, with T of the constraints whose degrees of freedom are all here.
    void reduce(const std::vector<int>& place, const std::vector<LinearConstraint>& constraints) {
        const auto place_of = [&](const DegreeOfFreedom& of) { return place[6 * of.node + of.component]; };
        std::vector<char> depends(size, 0);
        for (const LinearConstraint& c : constraints)
            if (const int row = place_of(c.dependent); row >= 0) depends[row] = 1;
        std::vector<int> column(size, -1);
        int left = 0;
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < size; ++i)
            if (!depends[i]) column[i] = left++, entries.emplace_back(i, column[i], 1.0);
        for (const LinearConstraint& c : constraints)
            for (const LinearConstraint::Term& term : c.terms)
                if (const int row = place_of(c.dependent), of = place_of(term.of); row >= 0 && of >= 0)
                    entries.emplace_back(row, column[of], term.factor);
        Sparse T(size, left);
        T.setFromTriplets(entries.begin(), entries.end());
        const auto reduced = [&](const Sparse& lower) -> Sparse {
            const Sparse whole = lower.selfadjointView<Eigen::Lower>();
            const Sparse product = T.transpose() * whole * T;
            return product.triangularView<Eigen::Lower>();
        };
        K = reduced(K), M = reduced(M);
        size = left;
        adds_stiffness = true;  // bodies may be joined that are not rigid together
    }
};

}  // namespace

std::vector<RigidMotion> free_motions(const Structure& structure, const std::vector<int>& nodes) {
    Vec3 centre = Vec3::Zero();
    for (int n : nodes) centre += structure.position()[n] / double(nodes.size());
    double reach = 0;
    for (int n : nodes) reach = std::max(reach, (structure.position()[n] - centre).norm());
    // what the supports see of a shift and of a rotation that moves the farthest node by one
    Mat6 seen = Mat6::Zero();
    for (int n : nodes) {
        Mat6 motion = Mat6::Identity();
        motion.topRightCorner<3, 3>() = -skew(structure.position()[n] - centre) / reach;
        for (int c = 0; c < 6; ++c)
            if (structure.fixed()[n] >> c & 1) seen += motion.row(c).transpose() * motion.row(c);
    }
    const Eigen::SelfAdjointEigenSolver<Mat6> solver(seen);
    std::vector<RigidMotion> motions;
    for (int i = 0; i < 6; ++i)
        if (solver.eigenvalues()[i] < 1e-12 * std::max(1.0, solver.eigenvalues()[5]))
            motions.push_back(
                {centre, solver.eigenvectors().col(i).head<3>(), solver.eigenvectors().col(i).tail<3>() / reach});
    return motions;
}

namespace {

bool moves_a_support(const Structure& structure, const std::vector<int>& supports, const RigidMotion& m) {
    for (int n : supports) {
        Vec6 motion;
        motion << m.v + m.w.cross(structure.position()[n] - m.centre), m.w;
        for (int c = 0; c < 6; ++c)
            if (structure.fixed()[n] >> c & 1 && std::abs(motion[c]) > 1e-9) return true;
    }
    return false;
}

std::string triple(const Vec3& v) {
    return vector_text(v.unaryExpr([](double x) { return std::abs(x) < 1e-9 ? 0 : x; }), 4);
}

}  // namespace

std::string ways_to_move(const Structure& structure, const std::vector<int>& supports,
                         const std::vector<RigidMotion>& motions) {
    std::string text;
    for (int c = 0; c < 6; ++c) {
        RigidMotion m{structure.position()[supports[0]], Vec3::Zero(), Vec3::Zero()};
        (c < 3 ? m.v : m.w)[c % 3] = 1;
        if (!moves_a_support(structure, supports, m))
            text += (text.empty() ? "" : ", ") + std::string(c < 3 ? "move along " : "rotate about ") + "xyz"[c % 3];
    }
    if (!text.empty()) return text + (text.find("rotate") == std::string::npos ? "" : " through that node");
    const RigidMotion& m = motions[0];
    if (m.w.norm() < 1e-9 * m.v.norm()) return "move along " + triple(m.v.normalized());
    return "rotate about the line through " + triple(m.centre + m.w.cross(m.v) / m.w.squaredNorm()) + " m along " +
           triple(m.w.normalized());
}

std::vector<double> natural_frequencies(const Structure& structure, const std::vector<int>& nodes, int rigid, int count,
                                        const AddedToModes& added) {
    const Matrices of(structure, nodes, added);
    const int wanted = std::min(rigid + count, of.size);
    if (wanted <= rigid && !of.adds_stiffness) return {};
    const double k = of.K.diagonal().sum(), m = of.M.diagonal().sum();
    const auto values = lowest_eigenpairs(of.K / k, of.M / m, rigid > 0 ? 1e-9 : 0, wanted, false).values;
    int first = rigid;
    if (of.adds_stiffness)
        for (first = 0; first < wanted && values[first] < 1e-11; ++first) {}
    std::vector<double> frequencies;
    for (int i = first; i < wanted && i < first + count; ++i)
        frequencies.push_back(std::sqrt(std::max(0.0, values[i] * k / m)));
    return frequencies;
}

}  // namespace hinge

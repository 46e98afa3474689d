#include "algebra/modes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <random>

#include "beam/tangent.h"

namespace hinge {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// K and M of the elements at these nodes, their lower halves, on the freedoms that no support holds.
struct Matrices {
    int size = 0;
    Sparse K, M;

    Matrices(const Structure& structure, const std::vector<int>& nodes) {
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
        K.resize(size, size), M.resize(size, size);
        K.setFromTriplets(stiffness.begin(), stiffness.end());
        M.setFromTriplets(mass.begin(), mass.end());
    }
};

}  // namespace

std::vector<RigidMotion> free_motions(const Structure& structure, const std::vector<int>& nodes) {
    Vec3 centre = Vec3::Zero();
    for (int n : nodes) centre += structure.position()[n] / double(nodes.size());
    double reach = 0;
    for (int n : nodes) reach = std::max(reach, (structure.position()[n] - centre).norm());
    // what the supports see of a shift and of a turn that moves the farthest node by one
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

std::vector<double> natural_frequencies(const Structure& structure, const std::vector<int>& nodes, int rigid,
                                        int count) {
    const Matrices of(structure, nodes);
    const int wanted = std::min(rigid + count, of.size), width = std::min(of.size, std::max(2 * wanted, wanted + 8));
    if (wanted <= rigid) return {};
    const auto M = of.M.selfadjointView<Eigen::Lower>();
    const double a = rigid > 0 ? 1e-9 * of.K.diagonal().sum() / of.M.diagonal().sum() : 0;
    const Eigen::SimplicialLDLT<Sparse> factors(Sparse(of.K + a * of.M));
    std::mt19937 dice(1);
    Eigen::MatrixXd X = Eigen::MatrixXd::NullaryExpr(of.size, width, [&] { return double(dice()) / dice.max() - 0.5; });
    Eigen::VectorXd values = Eigen::VectorXd::Zero(width);
    for (int iteration = 0; iteration < 100; ++iteration) {
        const Eigen::MatrixXd inverted = factors.solve(M * X);
        const Eigen::MatrixXd Q =
            Eigen::HouseholderQR<Eigen::MatrixXd>(inverted).householderQ() * Eigen::MatrixXd::Identity(of.size, width);
        const Eigen::MatrixXd MQ = M * Q, KQ = of.K.selfadjointView<Eigen::Lower>() * Q;
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> small(Q.transpose() * KQ, Q.transpose() * MQ);
        const Eigen::VectorXd change = small.eigenvalues() - values;
        values = small.eigenvalues();
        X = Q * small.eigenvectors();
        const auto elastic = Eigen::seqN(rigid, wanted - rigid);
        if ((change(elastic).array().abs() <= 2e-10 * values(elastic).array()).all()) break;
    }
    std::vector<double> frequencies;
    for (int i = rigid; i < wanted; ++i) frequencies.push_back(std::sqrt(std::max(0.0, values[i])));
    return frequencies;
}

}  // namespace hinge

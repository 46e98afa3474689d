#include "algebra/modes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

#include "algebra/eigenpairs.h"
#include "algebra/free_unknowns.h"
#include "algebra/rigid_modes.h"
#include "beam/tangent.h"
#include "core/text.h"

namespace hinge {
namespace {

/// K, M and C of the elements at these nodes and of what effects add, on the degrees of freedom that no support holds.
struct Matrices {
    const Structure& structure;
    FreeUnknowns unknowns;
    bool adds_stiffness;  ///< effects do
    SparseMatrix K, M, C;
    int size() const { return int(K.rows()); }

    Matrices(const Structure& s, const std::vector<int>& nodes, const AddedToModes& added)
        : structure(s), unknowns(free_at(s, nodes), added.constraints) {
        FreeUnknowns::Triplets stiffness, mass, damping;
        for (int n : nodes)
            for (int index : structure.elements_at(n)) {
                const Element& e = structure.elements()[index];
                if (e.node[0] != n) continue;
                const Mat3 axes = e.axes.toRotationMatrix();
                const Mat12 k = beam::linear_tangent(axes.transpose(), e.length, e.stiffness.matrix()),
                            m = structure.inertia(index).matrix(axes);
                unknowns.add(stiffness, n, e.node[1], k);
                unknowns.add(mass, n, e.node[1], m);
                if (added.damping.empty()) continue;
                const ElementDamping& c = added.damping[std::size_t(index)];
                unknowns.add(damping, n, e.node[1], Mat12(c.of_mass * m + c.of_stiffness * k));
            }
        const std::size_t of_elements = stiffness.size();
        for (const Coupling& c : added.stiffness.pairs) unknowns.add(stiffness, c.a, c.b, c.K);
        for (const Blocks::Node& n : added.stiffness.nodes) unknowns.add(stiffness, n.node, n.node, n.K);
        // constraints may join bodies that are not rigid together
        adds_stiffness = stiffness.size() > of_elements || !added.constraints.empty();
        for (const Blocks::Node& n : added.mass) unknowns.add(mass, n.node, n.node, n.K);
        for (const Coupling& c : added.more_damping.pairs) unknowns.add(damping, c.a, c.b, c.K);
        for (const Blocks::Node& n : added.more_damping.nodes) unknowns.add(damping, n.node, n.node, n.K);
        K = unknowns.reduced(stiffness), M = unknowns.reduced(mass), C = unknowns.reduced(damping);
    }

private:
    static std::vector<std::uint8_t> free_at(const Structure& s, const std::vector<int>& nodes) {
        std::vector<std::uint8_t> free(s.position().size());
        for (int n : nodes) free[n] = ~s.held()[n] & 63;
        return free;
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
    bool rotates = false;
    for (int c = 0; c < 6; ++c) {
        RigidMotion m{structure.position()[supports[0]], Vec3::Zero(), Vec3::Zero()};
        (c < 3 ? m.v : m.w)[c % 3] = 1;
        if (moves_a_support(structure, supports, m)) continue;
        text += (text.empty() ? "" : ", ") + std::string(c < 3 ? "move along " : "rotate about ") + "xyz"[c % 3];
        rotates = rotates || c >= 3;
    }
    if (!text.empty()) return text + (rotates ? " through that node" : "");
    const RigidMotion& m = motions[0];
    if (m.w.norm() < 1e-9 * m.v.norm()) return "move along " + triple(m.v.normalized());
    return "rotate about the line through " + triple(m.centre + m.w.cross(m.v) / m.w.squaredNorm()) + " m along " +
           triple(m.w.normalized());
}

namespace {

std::vector<DampedMode> modes(const Matrices& of, int rigid, int count, bool with_damping) {
    if (of.size() == 0) return {};  // supports hold all of it
    int wanted = std::min(rigid + count, of.size());
    if (wanted <= rigid && !of.adds_stiffness) return {};
    const double k = of.K.diagonal().sum(), m = of.M.diagonal().sum();
    Eigenpairs found =
        lowest_eigenpairs(of.K / k, of.M / m, rigid > 0 ? 1e-9 : 0, wanted, with_damping || of.adds_stiffness);
    const std::vector<double>& values = found.values;
    wanted = std::min(wanted, int(values.size()));  // fewer where few unknowns have mass
    int first = rigid;
    if (of.adds_stiffness) {
        tell_rigid_modes(of.K / k, of.M / m, 1e-9, found, [&](const Eigen::VectorXd& x) {
            return strained_member(of.structure, initial_state(of.structure), of.unknowns.at_nodes(x));
        });
        for (first = 0; first < wanted && values[first] <= 0; ++first) {}
    }
    std::vector<DampedMode> list;
    for (int i = first; i < wanted && i < first + count; ++i) {
        DampedMode mode{std::sqrt(std::max(0.0, values[i] * k / m)), 0};
        if (with_damping) {
            const Eigen::VectorXd x = found.vectors.col(i) / std::sqrt(m);  // x . M x = 1
            mode.ratio = x.dot(of.C.selfadjointView<Eigen::Lower>() * x) / (2 * mode.frequency);
        }
        list.push_back(mode);
    }
    return list;
}

}  // namespace

std::vector<double> natural_frequencies(const Structure& structure, const std::vector<int>& nodes, int rigid, int count,
                                        const AddedToModes& added) {
    std::vector<double> frequencies;
    for (const DampedMode& m : modes(Matrices(structure, nodes, added), rigid, count, false))
        frequencies.push_back(m.frequency);
    return frequencies;
}

std::vector<DampedMode> damped_modes(const Structure& structure, const std::vector<int>& nodes, int rigid, int count,
                                     const AddedToModes& added) {
    return modes(Matrices(structure, nodes, added), rigid, count, true);
}

}  // namespace hinge

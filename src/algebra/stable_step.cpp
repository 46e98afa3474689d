#include "algebra/stable_step.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "algebra/eigenpairs.h"
#include "beam/element_mass.h"
#include "state/lone_elements.h"

namespace hinge {
namespace {

/// The largest eigenvalue of M^-1 K of one element, 1/s^2, M lumped: that of m^-1/2 K m^-1/2.
double highest(const Element& e, const beam::Inertia& lumped) {
    const auto T = beam::linear_deformation(e.length);
    Mat12 K = T.transpose() * e.stiffness.matrix() * T;
    const Vec12 root = lumped.matrix(Mat3::Identity()).diagonal().cwiseSqrt().cwiseInverse();
    K = root.asDiagonal() * K * root.asDiagonal();
    return largest_eigenvalue(K);
}

/// And of a lone one (state/lone_elements.h), that of L^-1 K L^-T with M = L L^T.
double highest_of_lone(int index, const Element& e) {
    const auto T = beam::linear_deformation(e.length);
    Mat12 K = T.transpose() * e.stiffness.matrix() * T;
    Mat12 M = e.lone.matrix(Mat3::Identity());
    const int inner = inner_end(index, e);
    M.block<6, 6>(6 * inner, 6 * inner) += lone_mass(e, (inner == 0 ? 1 : -1) * e.length / 3 * Vec3::UnitZ());
    const Mat12 inverse = M.llt().matrixL().solve(Mat12::Identity());
    return largest_eigenvalue(Mat12(inverse * K * inverse.transpose()));
}

/// Calls f(element, omega^2, c) for each.
template <class F>
void for_each_element(const Structure& structure, std::span<const ElementDamping> damping, bool breaks, F f) {
    std::map<std::tuple<const Section*, const Material*, double, double>, double> known;  // most are like another
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        const ElementDamping d = damping.empty() ? ElementDamping{} : damping[i];
        if (!(e.mass() > 0)) {  // no step is short enough
            constexpr double infinite = std::numeric_limits<double>::infinity();
            f(int(i), infinite, d.of_stiffness > 0 ? infinite : d.of_mass);
            continue;
        }
        const MemberData& member = structure.model().members()[e.member];
        const beam::Inertia lumped =
            structure.lumped() ? e.inertia : beam::lumped_inertia(e.rigidity, e.length, 0.5);  // the scale of others
        const double heavy = std::round(1e6 * std::max(lumped.own[0], lumped.own[1]) / e.mass());
        const auto [at, fresh] =
            known.try_emplace({member.section.get(), member.material.get(), std::round(1e9 * e.length), heavy}, 0);
        if (fresh) {
            at->second = highest(e, lumped);
            if (breaks && e.partner >= 0) at->second = std::max(at->second, highest_of_lone(int(i), e));
        }
        f(int(i), at->second, d.of_mass + d.of_stiffness * at->second);
    }
}

/// Blocks of effects against the masses of the nodes, M^-1/2 K M^-1/2 in blocks of 6 x 6, by their norms.
class Joined {
public:
    /// `held`: degrees of freedom that do not move, beside those that the state holds.
    Joined(const Structure& structure, const State& state, const Blocks& blocks, std::uint8_t held) {
        const auto root = [&](int node) -> Mat6 {
            Mat6 M = Mat6::Zero();
            const LumpedMass lumped = lumped_mass_at(structure, state, node);
            M.diagonal() << Vec3::Constant(lumped.mass), Vec3::Constant(lumped.rotary);
            if (!state.offset_mass.empty() && state.offset_mass[node].mass > 0)
                M += offset_mass_in_space(state.offset_mass[node], state.rotation[node]);
            std::uint8_t still = state.held[node] | held;
            for (int c = 0; c < 6; ++c)
                if (M(c, c) == 0) still |= 1 << c;
            for (int c = 0; c < 6; ++c)
                if (still >> c & 1) M.row(c).setZero(), M.col(c).setZero(), M(c, c) = 1;
            Mat6 inverse = M.llt().matrixL().solve(Mat6::Identity());
            for (int c = 0; c < 6; ++c)
                if (still >> c & 1) inverse(c, c) = 0;
            return inverse;
        };
        std::map<int, Mat6> roots;
        const auto root_of = [&](int node) -> const Mat6& {
            const auto [at, fresh] = roots.try_emplace(node);
            if (fresh) at->second = root(node), group_[node] = node;
            return at->second;
        };
        std::map<std::pair<int, int>, Mat6> sum;
        const auto add = [&](int a, int b, const Mat6& K) {
            const Mat6 part = root_of(a) * K * root_of(b).transpose();
            const auto [at, fresh] = sum.try_emplace({a, b}, part);
            if (!fresh) at->second += part;
        };
        for (const Blocks::Node& n : blocks.nodes) add(n.node, n.node, n.K);
        for (const Coupling& p : blocks.pairs) {
            const int node[2] = {p.a, p.b};
            for (int i : {0, 1})
                for (int j : {0, 1}) add(node[i], node[j], p.K.block<6, 6>(6 * i, 6 * j));
            group_[find(p.a)] = find(p.b);
        }
        for (const auto& [at, part] : sum) {
            const double square = largest_eigenvalue(part.transpose() * part);
            norms_.push_back({at.first, at.second, std::sqrt(std::max(0.0, square))});
        }
    }

    /// Of each node that is joined to another, or to the ground: the bound of all that are connected.
    std::map<int, double> bounds() {
        std::map<int, double> x, bound, least;
        for (const auto& [node, unused] : group_) x[node] = 1;
        for (int i = 0; i < rounds; ++i) {
            std::map<int, double> y;
            for (const Norm& n : norms_) y[n.a] += n.size * x[n.b];
            bound.clear();
            for (const auto& [node, now] : y) {
                double& most = bound[find(node)];
                most = std::max(most, now / x[node]);
            }
            for (const auto& [group, most] : bound) {
                const auto [at, fresh] = least.try_emplace(group, most);
                if (!fresh) at->second = std::min(at->second, most);
            }
            // half of the old one keeps it above zero, and from swinging
            bool changes = false;
            for (auto& [node, value] : x)
                if (const double most = bound[find(node)]; most > 0) {
                    const double next = 0.5 * (value + y[node] / most);
                    changes = changes || next != value;
                    value = next;
                }
            if (!changes) break;  // as where no node is joined to another: ground, dashpots on supports
        }
        std::map<int, double> of_nodes;
        for (const auto& [node, unused] : group_) of_nodes[node] = least[find(node)];
        return of_nodes;
    }
    /// One of the nodes that are connected with this one; -1 where nothing is joined to it.
    int group(int node) { return group_.count(node) ? find(node) : -1; }

private:
    static constexpr int rounds = 60;
    struct Norm {
        int a, b;
        double size;
    };
    int find(int node) {
        while (group_[node] != node) node = group_[node] = group_[group_[node]];
        return node;
    }
    std::map<int, int> group_;  ///< of each node another one that it is connected with; itself for the first of them
    std::vector<Norm> norms_;
};

}  // namespace

StableStep stable_step(const Structure& structure, std::span<const ElementDamping> damping, bool breaks) {
    StableStep least{std::numeric_limits<double>::infinity(), -1};
    for_each_element(structure, damping, breaks, [&](int element, double square, double c) {
        const double dt = 2 / (c + std::sqrt(c * c + square));
        if (dt < least.dt) least = {dt, element};
    });
    return least;
}

/// The mass of a node is shared out between its elements and what effects add, as their squares of the frequency are:
/// each part alone then has the sum of both (Irons 1970).
JoinedStep stable_step_of_joined(const Structure& structure, const State& state,
                                 std::span<const ElementDamping> damping, const Blocks& stiffness,
                                 const Blocks& of_damping) {
    Blocks both = stiffness;  // connected by either
    for (Coupling p : of_damping.pairs) p.K.setZero(), both.pairs.push_back(p);
    for (Blocks::Node n : of_damping.nodes) n.K.setZero(), both.nodes.push_back(n);
    Joined joined(structure, state, both, 0);
    struct Most {
        double square = 0, c = 0, of_elements = 0, c_of_elements = 0;
    };
    std::map<int, Most> groups;
    for (const auto& [node, bound] : joined.bounds()) groups[joined.group(node)].square = bound;
    for (const auto& [node, bound] : Joined(structure, state, of_damping, 0).bounds()) {
        double& c = groups[joined.group(node)].c;
        c = std::max(c, bound);
    }
    for_each_element(structure, damping, false, [&](int element, double square, double c) {
        if (state.broken[element]) return;
        for (const int node : structure.elements()[element].node) {
            const auto at = groups.find(joined.group(node));
            if (at == groups.end()) continue;
            at->second.of_elements = std::max(at->second.of_elements, square);
            at->second.c_of_elements = std::max(at->second.c_of_elements, c);
        }
    });
    JoinedStep least{std::numeric_limits<double>::infinity(), -1};
    for (const auto& [node, m] : groups) {
        const double c = m.c + m.c_of_elements, dt = 2 / (c + std::sqrt(c * c + m.square + m.of_elements));
        if (dt < least.dt) least = {dt, node};
    }
    return least;
}

double fastest_of_joined(const Structure& structure, const State& state, const Blocks& stiffness) {
    double most = 0;
    for (const auto& [node, bound] : Joined(structure, state, stiffness, 0b111000).bounds())
        most = std::max(most, bound);
    return most;
}

}  // namespace hinge

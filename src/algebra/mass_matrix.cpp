#include "algebra/mass_matrix.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "algebra/blocks.h"
#include "algebra/effective_stiffness.h"
#include "algebra/massless.h"
#include "algebra/unfused.h"
#include "beam/element_mass.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

constexpr int most_iterations = 500;  ///< of conjugate gradients on M, which takes some 20 to 1e-13

void hold(std::vector<Vec6>& v, const State& state) {
    for (std::size_t i = 0; i < v.size(); ++i)
        if (const int held = state.held[i])
            for (int c = 0; c < 6; ++c)
                if (held >> c & 1) v[i][c] = 0;
}

bool has_offset_mass(const State& state, int node) {
    return !state.offset_mass.empty() && state.offset_mass[node].mass > 0;
}

Mat6 inverse_of_free(Mat6 m, int held) {  // held components take no part: a mass on a pinned node rotates about the pin
    for (int c = 0; c < 6; ++c)
        if (held >> c & 1) m.row(c).setZero(), m.col(c).setZero(), m(c, c) = 1;
    return inverse_by_halves(m);
}

/// Of one element with the linear mass, in space: rho A L/6 (kg) and rho I L/6 (kg m^2); zero when it is broken.
struct Part {
    double mass = 0;
    Mat3 rotary = Mat3::Zero();
};

Part part_of(const Structure& structure, int index, const State& state, const Configuration& pose) {
    Part part;
    if (state.broken[index]) return part;
    const Element& e = structure.elements()[index];
    const Mat3 axes = axes_of(element_frame(structure, index, pose));
    part.mass = e.mass() / 6;
    part.rotary = e.length / 6 * (axes * beam::rotary_inertia(e.rigidity).asDiagonal() * axes.transpose());
    return part;
}

/// Linear mass M as products element by element, and the inverse of each node's own block.
class ElementMass {
public:
    ElementMass(const Structure& structure, const State& state);
    /// y = M x without what is held.
    void multiply(const std::vector<Vec6>& x, std::vector<Vec6>& y) const;
    /// z = r by the inverse of each node's own block: the preconditioner.
    void divide_by_own(const std::vector<Vec6>& r, std::vector<Vec6>& z) const;

private:
    struct RigidOffset {
        int node;
        Mat6 mass, inverse;
    };
    void invert_own(const Configuration& pose);

    const Structure& structure_;
    const State& state_;
    std::vector<Part> part_;                ///< of each element
    std::vector<double> own_inverse_;       ///< of each node, 1/kg
    std::vector<Mat3> own_rotary_inverse_;  ///< of each node, 1/(kg m^2)
    std::vector<RigidOffset> offset_;       ///< masses beside their node
};

ElementMass::ElementMass(const Structure& structure, const State& state)
    : structure_(structure),
      state_(state),
      part_(structure.elements().size()),
      own_inverse_(structure.position().size(), 0),
      own_rotary_inverse_(structure.position().size(), Mat3::Zero()) {
    const Configuration& pose = state;
    for (std::size_t i = 0; i < part_.size(); ++i) {
        part_[i] = part_of(structure, int(i), state, pose);
        for (int node : structure.elements()[i].node)
            own_inverse_[node] += 2 * part_[i].mass, own_rotary_inverse_[node] += 2 * part_[i].rotary;
    }
    invert_own(pose);
}

/// In place: until now the sums are those of the elements.
void ElementMass::invert_own(const Configuration& pose) {
    for (std::size_t i = 0; i < own_inverse_.size(); ++i) {
        double& mass = own_inverse_[i];
        Mat3& rotary = own_rotary_inverse_[i];
        if (has_offset_mass(state_, int(i))) {
            Mat6 own = offset_mass_in_space(state_.offset_mass[i], pose.rotation[i]);
            offset_.push_back({int(i), own, {}});
            own.topLeftCorner<3, 3>().diagonal().array() += mass;
            own.bottomRightCorner<3, 3>() += rotary;
            offset_.back().inverse = inverse_of_free(own, state_.held[i]);
        }
        if (mass > 0) mass = 1 / mass, rotary = rotary.inverse().eval();
    }
}

void ElementMass::multiply(const std::vector<Vec6>& x, std::vector<Vec6>& y) const {
    for (Vec6& v : y) v.setZero();
    for (std::size_t i = 0; i < part_.size(); ++i) {
        if (part_[i].mass == 0) continue;
        const auto& [a, b] = structure_.elements()[i].node;
        const Vec6 sum = x[a] + x[b];
        for (int node : {a, b}) {
            const Vec6 to = sum + x[node];
            y[node].head<3>() += part_[i].mass * to.head<3>();
            y[node].tail<3>() += part_[i].rotary * to.tail<3>();
        }
    }
    for (const RigidOffset& s : offset_) y[s.node] += s.mass * x[s.node];
    hold(y, state_);
}

void ElementMass::divide_by_own(const std::vector<Vec6>& r, std::vector<Vec6>& z) const {
    for (std::size_t i = 0; i < r.size(); ++i)
        z[i] << own_inverse_[i] * r[i].head<3>(), own_rotary_inverse_[i] * r[i].tail<3>();
    for (const RigidOffset& s : offset_) z[s.node] = s.inverse * r[s.node];
    hold(z, state_);
}

double dot(const std::vector<Vec6>& a, const std::vector<Vec6>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
    return sum;
}

/// Linear mass: change = M^-1 r by conjugate gradients on products element by element, each node's own block as
/// preconditioner.
SolveReport solve_over_elements(const Structure& structure, std::vector<Vec6> r, std::vector<Vec6>& change,
                                const State& state, double tolerance) {
    const std::size_t n = r.size();
    const ElementMass mass(structure, state);
    std::vector<Vec6> d(n), q(n);
    for (Vec6& v : change) v.setZero();
    mass.divide_by_own(r, d);
    double rho = dot(r, d);
    const double goal = rho * tolerance * tolerance;
    SolveReport report;
    for (; rho > goal && rho > 1e-280; ++report.iterations) {
        if (report.iterations == most_iterations) return report.converged = false, report;
        mass.multiply(d, q);
        const double dq = dot(d, q);
        if (!(dq > 0)) return {report.iterations, false, dq <= 0};
        const double alpha = rho / dq;
        for (std::size_t i = 0; i < n; ++i) change[i] += alpha * d[i], r[i] -= alpha * q[i];
        mass.divide_by_own(r, q);
        const double next = dot(r, q), beta = next / rho;
        rho = next;
        for (std::size_t i = 0; i < n; ++i) d[i] = q[i] + beta * d[i];
    }
    report.converged = std::isfinite(rho);
    return report;
}

}  // namespace

Mass::Mass(const Structure& structure, const State& state) : structure_(structure) {
    if (!structure.lumped()) return;
    std::vector<int> all(structure.elements().size());
    std::iota(all.begin(), all.end(), 0);
    renew(all, state, state);
}

void Mass::set_reduction(const Reduction* reduction) {
    reduction_ = reduction;
    leave_out_joined();
}

void Mass::leave_out_joined() {
    if (!reduction_ || !structure_.lumped()) return;
    for (const std::vector<int>& group : reduction_->groups())
        for (const int n : group) lumped_inverse_[n].setZero();
}

void Mass::renew(const std::vector<int>& elements, const State& state, const Configuration& pose) {
    if (structure_.lumped()) return renew_lumped(elements, state, pose);
    if (reduction_) {
        pose_ = std::make_unique<Configuration>(pose);
        return;
    }
    const bool first = !blocks_;
    if (first) keep_blocks(state);
    const auto update_block = [&](int index) {
        const Mat3 axes = axes_of(element_frame(structure_, index, pose));
        blocks_->parts.set(index, state.broken[index] ? Mat12::Zero() : structure_.inertia(index).matrix(axes));
        for (int node : structure_.elements()[index].node) mark(node);
    };
    if (first)
        for (int e = 0; e < int(structure_.elements().size()); ++e) update_block(e);
    else
        for (int e : elements) update_block(e);
    for (std::size_t i = 0; i < state.offset_mass.size(); ++i)
        if (has_offset_mass(state, int(i)))
            blocks_->parts.set_offset_mass(int(i), offset_mass_in_space(state.offset_mass[i], pose.rotation[i])),
                mark(int(i));
}

void Mass::renew_lumped(const std::vector<int>& elements, const State& state, const Configuration& pose) {
    lumped_inverse_.resize(structure_.position().size(), Vec6::Zero());
    std::vector<char> stale(lumped_inverse_.size(), 0);
    for (int index : elements)
        for (int node : structure_.elements()[index].node) stale[node] = 1;
    heavy_.clear();
    for (std::size_t i = 0; i < stale.size(); ++i) {
        if (!stale[i] && !has_offset_mass(state, int(i))) continue;
        LumpedMass lumped = lumped_mass_at(structure_, state, int(i));
        if (has_offset_mass(state, int(i)) && state.offset_mass[i].is_point()) lumped.mass += state.offset_mass[i].mass;
        lumped_inverse_[i] = lumped.inverse(state.held[i]);
        if (!has_offset_mass(state, int(i)) || state.offset_mass[i].is_point()) continue;
        Heavy h{int(i), Mat6::Zero(), {}, {}};
        h.elements.diagonal() << Vec3::Constant(lumped.mass), Vec3::Constant(lumped.rotary);
        heavy_.push_back(h);
    }
    rotate_offset_masses(state, pose);
    leave_out_joined();
}

void Mass::rotate_offset_masses(const State& state, const Configuration& pose) {
    for (Heavy& h : heavy_) {
        h.offsets = offset_mass_in_space(state.offset_mass[h.node], pose.rotation[h.node]);
        h.inverse = inverse_of_free(h.elements + h.offsets, state.held[h.node]);
    }
}

void Mass::mark(int node) {
    if (!blocks_->is_dirty[node]) blocks_->is_dirty[node] = 1, blocks_->dirty.push_back(node);
}

void Mass::keep_blocks(const State& state) {
    make_blocks();
    blocks_->parts.set_held(state.held);
}

void Mass::make_blocks() {
    const int nodes = int(structure_.position().size());
    blocks_.reset(new Blocks{ElementMatrices(structure_, false, true),
                             Condensed<double>(structure_, alone_),
                             {},
                             std::vector<char>(nodes, 0)});
    for (int node = 0; node < nodes; ++node) mark(node);
}

/// Degrees of freedom that are held since the last solution: of nodes that nothing is left of.
void Mass::update_supports(const State& state) {
    const std::vector<std::uint8_t>& before = blocks_->parts.held();
    if (before == state.held) return;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] == state.held[i]) continue;
        mark(int(i));
        for (int e : structure_.elements_at(int(i)))
            for (int node : structure_.elements()[e].node) mark(node);
    }
    blocks_->parts.set_held(state.held);
}

SolveReport Mass::solve(const std::vector<Vec6>& impulse, std::vector<Vec6>& change, const State& state,
                        double tolerance) {
    change.resize(impulse.size());
    std::vector<Vec6> right = impulse;
    hold(right, state);
    if (structure_.lumped()) {
        for (std::size_t i = 0; i < right.size(); ++i) change[i] = lumped_inverse_[i].cwiseProduct(right[i]);
        for (const Heavy& h : heavy_) change[h.node] = h.inverse * right[h.node];
        if (reduction_) solve_joined(right, change, state);
        hold(change, state);
        return {};
    }
    if (const std::vector<MasslessNode> massless = massless_nodes(structure_, state, reduction_); !massless.empty()) {
        const State still = with_massless_held(state, massless);
        hold(right, still);
        const SolveReport report = solve_reduced(right, change, still);
        if (report.converged) take_out_massless(massless, change);
        return report;
    }
    if (reduction_) return solve_reduced(right, change, state);
    if (!blocks_ && structure_.cubic()) renew({}, state, state);
    if (!blocks_) return solve_over_elements(structure_, std::move(right), change, state, tolerance);
    update_supports(state);
    std::sort(blocks_->dirty.begin(), blocks_->dirty.end());
    blocks_->condensed.renew(blocks_->dirty, blocks_->parts);
    for (int node : blocks_->dirty) blocks_->is_dirty[node] = 0;
    blocks_->dirty.clear();
    SolverSettings sharp;
    sharp.tolerance = tolerance;
    return blocks_->condensed.solve(right[0].data(), change[0].data(), sharp);
}

Mat6 Mass::lumped_at(int node, const State& state) const {
    const LumpedMass own = lumped_mass_at(structure_, state, node);
    Mat6 M = Mat6::Zero();
    M.diagonal() << Vec3::Constant(own.mass), Vec3::Constant(own.rotary);
    if (has_offset_mass(state, node) && state.offset_mass[node].is_point())
        M.diagonal().head<3>().array() += state.offset_mass[node].mass;
    for (const Heavy& h : heavy_)
        if (h.node == node) M += h.offsets;
    return M;
}

/// Each group by itself: T^T M T of the nodes on which others depend. The free components of a dependent node are on
/// their own, unless an offset mass couples them to the others, or other nodes depend on them: a node of a diaphragm
/// whose members end in joints.
void Mass::solve_joined(const std::vector<Vec6>& impulse, std::vector<Vec6>& change, const State& state) const {
    std::vector<char> carries(structure_.position().size(), 0);  // whether others depend on the node
    for (const Reduction::Dependent& d : reduction_->dependents())
        for (const Reduction::Part& p : d.parts) carries[p.node] = 1;
    for (const std::vector<int>& group : reduction_->groups()) {
        std::vector<Mat6> M;
        std::vector<int> place;  // of each node of the group in the matrix, -1
        int unknowns = 0;
        for (const int n : group) {
            M.push_back(lumped_at(n, state));
            const bool alone = reduction_->depends(n) && !carries[n] && M.back().isDiagonal(0);
            place.push_back(alone ? -1 : std::exchange(unknowns, unknowns + 6));
        }
        const auto place_of = [&](int node) {
            return place[std::lower_bound(group.begin(), group.end(), node) - group.begin()];
        };
        Eigen::MatrixXd A = Eigen::MatrixXd::Zero(unknowns, unknowns);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
        const auto out = [&](int n) { return reduction_->tied(n) | state.held[n]; };
        for (std::size_t i = 0; i < group.size(); ++i) {
            const int n = group[i];
            if (place[i] >= 0) A.block<6, 6>(place[i], place[i]) += M[i], right.segment<6>(place[i]) += impulse[n];
            reduction_->spread(n, n, M[i], [&](int p, int q, const Mat6& block) {
                if (place_of(p) >= 0 && place_of(q) >= 0) A.block<6, 6>(place_of(p), place_of(q)) += block;
            });
        }
        for (const Reduction::Dependent& d : reduction_->dependents())
            if (std::binary_search(group.begin(), group.end(), d.node))
                for (const Reduction::Part& p : d.parts)
                    right.segment<6>(place_of(p.node)) += p.factors.transpose() * impulse[d.node];
        for (std::size_t i = 0; i < group.size(); ++i)
            for (int c = 0; place[i] >= 0 && c < 6; ++c)
                if (const int k = place[i] + c; (out(group[i]) >> c & 1) || !(A(k, k) > 0))
                    A.row(k).setZero(), A.col(k).setZero(), A(k, k) = 1, right[k] = 0;
        const Eigen::VectorXd x = A.ldlt().solve(right);
        for (std::size_t i = 0; i < group.size(); ++i) {
            Vec6& of = change[group[i]];
            if (place[i] >= 0) of = x.segment<6>(place[i]);
            else
                for (int c = 0; c < 6; ++c)
                    of[c] = (out(group[i]) >> c & 1) || !(M[i](c, c) > 0) ? 0 : impulse[group[i]][c] / M[i](c, c);
        }
    }
    reduction_->expand(change);
}

/// Consistent mass: by the factors of T^T M T, or of M, computed here.
SolveReport Mass::solve_reduced(const std::vector<Vec6>& right, std::vector<Vec6>& change, const State& state) {
    EffectiveStiffness reduced(structure_, alone_, 1, 0, false, MatrixStorage::direct);
    reduced.set_reduction(reduction_);
    reduced.set_held(state.held);
    std::vector<int> elements;
    for (int e = 0; e < int(state.broken.size()); ++e)
        if (!state.broken[e]) elements.push_back(e);
    const Configuration& at = pose_ ? *pose_ : static_cast<const Configuration&>(state);
    reduced.build(elements, state, at, {});
    for (int n = 0; n < int(state.offset_mass.size()); ++n)
        if (has_offset_mass(state, n))
            reduced.set_offset_mass(n, offset_mass_in_space(state.offset_mass[n], at.rotation[n]));
    reduced.assemble();
    SolverSettings direct;
    direct.direct = true;
    return reduced.solve(right, change, direct);
}

double pass_on(State& state, Mass& mass, std::vector<Vec6>& impulse) {
    for (std::size_t i = 0; i < impulse.size(); ++i)
        for (int c = 0; c < 6; ++c)
            if (state.held[i] >> c & 1) {  // the support takes it, and one that moves does work on it
                state.accumulated["work"] -= impulse[i][c] * state.velocity[i][c];
                state.accumulated["fracture_kinetic"] -= impulse[i][c] * state.velocity[i][c];
                impulse[i][c] = 0;
            }
    std::vector<Vec6> change;
    if (!mass.solve(impulse, change, state, 1e-13).converged) return std::numeric_limits<double>::quiet_NaN();
    double cost = 0;
    for (std::size_t i = 0; i < impulse.size(); ++i) {
        cost -= impulse[i].dot(state.velocity[i] + 0.5 * change[i]);
        state.velocity[i] += change[i];
    }
    state.accumulated["fracture_kinetic"] += cost;
    return cost;
}

}  // namespace hinge

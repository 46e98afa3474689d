#include "sim/mass.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "beam/mass.h"
#include "sim/blocks.h"
#include "sim/breaking.h"

namespace hinge {
namespace {

void hold(std::vector<Vec6>& v, const State& state) {
    for (std::size_t i = 0; i < v.size(); ++i)
        if (const int held = state.held[i])
            for (int c = 0; c < 6; ++c)
                if (held >> c & 1) v[i][c] = 0;
}

Mat3 whole(const double* m) {
    Mat3 J;
    J << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
    return J;
}

}  // namespace

Mass::Mass(const Structure& structure, const State& state) : structure_(structure) {
    if (!structure.lumped()) part_.resize(structure.elements().size());
    inverse_.resize(structure.position().size());
    std::vector<int> all(structure.elements().size());
    std::iota(all.begin(), all.end(), 0);
    renew(all, state, pose_of(state));
}

void Mass::renew(const std::vector<int>& elements, const State& state, const Pose& pose) {
    std::vector<char> stale(inverse_.size(), 0);
    for (int index : elements) {
        const Element& e = structure_.elements()[index];
        for (int node : e.node) stale[node] = 1;
        if (structure_.lumped()) continue;
        part_[index] = {};
        if (state.broken[index]) continue;
        const auto f = place_element(structure_, index, pose).frame;
        const Vec3 J = beam::rotary_inertia(e.rigidity) * (e.length / 6);
        const double x[3] = {f.x.x, f.x.y, f.x.z}, y[3] = {f.y.x, f.y.y, f.y.z}, z[3] = {f.z.x, f.z.y, f.z.z};
        part_[index].mass = e.rigidity.rhoA * e.length / 6;
        for (int i = 0, k = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j) part_[index].rotary[k++] = J[0] * x[i] * x[j] + J[1] * y[i] * y[j] + J[2] * z[i] * z[j];
    }
    heavy_.clear();
    for (std::size_t i = 0; i < stale.size(); ++i) {
        const bool hung = !state.hung.empty() && state.hung[i].mass > 0;
        if (!stale[i] && !hung) continue;
        double mass = 0;
        Mat3 rotary = Mat3::Zero();
        for (int index : structure_.elements_at(int(i))) {
            if (state.broken[index]) continue;
            const Element& e = structure_.elements()[index];
            if (structure_.lumped()) {
                mass += beam::lumped_mass(e.rigidity, e.length);
                rotary.diagonal().array() += beam::lumped_rotary(e.rigidity, e.length);
            } else {
                mass += 2 * part_[index].mass;
                rotary += 2 * whole(part_[index].rotary);
            }
        }
        inverse_[i] = {};
        if (mass > 0) inverse_[i] = {1 / mass, rotary.inverse()};
        if (structure_.lumped()) {
            lumped_inverse_.resize(inverse_.size());
            lumped_inverse_[i] << Vec3::Constant(inverse_[i].mass), inverse_[i].rotary.diagonal();
            for (int c = 0; c < 6; ++c)
                if (state.held[i] >> c & 1) lumped_inverse_[i][c] = 0;
        }
        if (!hung) continue;
        Heavy h{int(i), Mat6::Zero(), {}, {}};
        h.elements.topLeftCorner<3, 3>().diagonal().array() += mass;
        h.elements.bottomRightCorner<3, 3>() = rotary;
        heavy_.push_back(h);
    }
    turn_stubs(state, pose);
    if (!blocks_) return;
    for (int index : elements) {
        blocks_->parts.set(index, matrix(index));
        for (int node : structure_.elements()[index].node) mark(node);
    }
    for (const Heavy& h : heavy_) blocks_->parts.set_hung(h.node, h.stubs), mark(h.node);
}

void Mass::turn_stubs(const State& state, const Pose& pose) {
    for (Heavy& h : heavy_) {
        h.stubs = hung_in_space(state.hung[h.node], pose.rotation[h.node]);
        Mat6 free = h.elements + h.stubs;  // what is held takes no part: a stub on a pinned node turns about the pin
        for (int c = 0; c < 6; ++c)
            if (state.held[h.node] >> c & 1) free.row(c).setZero(), free.col(c).setZero(), free(c, c) = 1;
        h.inverse = blocks::inverse_by_halves(free);
    }
}

/// z: node by node what r does to it alone, nothing where a freedom is held.
void Mass::by_node(const std::vector<Vec6>& r, std::vector<Vec6>& z, const State& state) const {
    for (std::size_t i = 0; i < r.size(); ++i) {
        const Vec3 turn = r[i].tail<3>();
        z[i].head<3>() = inverse_[i].mass * r[i].head<3>();
        z[i].tail<3>().noalias() = inverse_[i].rotary.lazyProduct(turn);
    }
    for (const Heavy& h : heavy_) z[h.node].noalias() = h.inverse.lazyProduct(r[h.node]);
    hold(z, state);
}

void Mass::multiply(const std::vector<Vec6>& x, std::vector<Vec6>& y) const {
    for (Vec6& v : y) v.setZero();
    for (std::size_t i = 0; i < part_.size(); ++i) {
        const Part& p = part_[i];
        if (p.mass == 0) continue;
        const int a = structure_.elements()[i].node[0], b = structure_.elements()[i].node[1];
        const Mat3 J = whole(p.rotary);
        const Vec6 sum = x[a] + x[b], to_a = sum + x[a], to_b = sum + x[b];
        const Vec3 turn_a = to_a.tail<3>(), turn_b = to_b.tail<3>();
        y[a].head<3>() += p.mass * to_a.head<3>();
        y[b].head<3>() += p.mass * to_b.head<3>();
        y[a].tail<3>() += J.lazyProduct(turn_a);
        y[b].tail<3>() += J.lazyProduct(turn_b);
    }
    for (const Heavy& h : heavy_) y[h.node].noalias() += h.stubs.lazyProduct(x[h.node]);
}

/// The element's part of M, 12 x 12 in space.
Mat12 Mass::matrix(int element) const {
    const Part& p = part_[element];
    const Mat3 J = whole(p.rotary);
    Mat12 M = Mat12::Zero();
    for (int i : {0, 1})
        for (int j : {0, 1}) {
            const double share = i == j ? 2 : 1;
            M.block<3, 3>(6 * i, 6 * j).diagonal().setConstant(share * p.mass);
            M.block<3, 3>(6 * i + 3, 6 * j + 3) = share * J;
        }
    return M;
}

void Mass::mark(int node) {
    if (!blocks_->is_dirty[node]) blocks_->is_dirty[node] = 1, blocks_->dirty.push_back(node);
}

void Mass::keep_blocks(const State& state) {
    const int nodes = int(inverse_.size());
    blocks_.reset(new Blocks{Parts(structure_, false, true), Condensed<double>(structure_, alone_), {}, std::vector<char>(nodes, 0)});
    for (std::size_t e = 0; e < part_.size(); ++e) blocks_->parts.set(int(e), matrix(int(e)));
    for (const Heavy& h : heavy_) blocks_->parts.set_hung(h.node, h.stubs);
    blocks_->parts.set_held(state.held);
    for (int node = 0; node < nodes; ++node) mark(node);
}

/// Freedoms that are held since the last solution: of nodes that nothing is left of.
void Mass::take_up_held(const State& state) {
    const std::vector<std::uint8_t>& before = blocks_->parts.held();
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] == state.held[i]) continue;
        mark(int(i));
        for (int e : structure_.elements_at(int(i)))
            for (int node : structure_.elements()[e].node) mark(node);
    }
    blocks_->parts.set_held(state.held);
}

void Mass::solve(const std::vector<Vec6>& impulse, std::vector<Vec6>& change, const State& state, double tolerance) {
    change.resize(impulse.size());
    std::vector<Vec6> right = impulse;
    hold(right, state);
    if (structure_.lumped()) return by_node(right, change, state);
    if (!solved_) {
        solved_ = true;
        return solve_over_elements(std::move(right), change, state, tolerance);
    }
    if (!blocks_) keep_blocks(state);
    take_up_held(state);
    std::sort(blocks_->dirty.begin(), blocks_->dirty.end());
    blocks_->condensed.renew(blocks_->dirty, blocks_->parts);
    for (int node : blocks_->dirty) blocks_->is_dirty[node] = 0;
    blocks_->dirty.clear();
    SolverSettings sharp;
    sharp.tolerance = tolerance;
    blocks_->condensed.solve(right[0].data(), change[0].data(), sharp);
}

/// Conjugate gradients on products element by element, each node's own block as preconditioner.
void Mass::solve_over_elements(std::vector<Vec6> r, std::vector<Vec6>& change, const State& state, double tolerance) const {
    const std::size_t n = r.size();
    std::vector<Vec6> d(n), q(n);
    by_node(r, d, state);
    double rho = 0;
    for (std::size_t i = 0; i < n; ++i) rho += r[i].dot(d[i]), change[i].setZero();
    const double goal = rho * tolerance * tolerance;
    for (int iteration = 0; rho > goal && rho > 1e-280 && iteration < 500; ++iteration) {
        multiply(d, q);
        hold(q, state);
        double dq = 0;
        for (std::size_t i = 0; i < n; ++i) dq += d[i].dot(q[i]);
        if (!(dq > 0)) return;
        const double alpha = rho / dq;
        for (std::size_t i = 0; i < n; ++i) {
            change[i] += alpha * d[i];
            r[i] -= alpha * q[i];
        }
        by_node(r, q, state);
        double next = 0;
        for (std::size_t i = 0; i < n; ++i) next += r[i].dot(q[i]);
        const double beta = next / rho;
        rho = next;
        for (std::size_t i = 0; i < n; ++i) d[i] = q[i] + beta * d[i];
    }
}

}  // namespace hinge

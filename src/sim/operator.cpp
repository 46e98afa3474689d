#include "sim/operator.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "beam/mass.h"
#include "sim/blocks.h"
#include "sim/hinges.h"
#include "beam/tangent.h"

namespace hinge {

using namespace blocks;

Operator::Operator(const Structure& structure, double mass_factor, double stiffness_factor, bool geometric)
    : structure_(structure), mass_factor_(mass_factor), stiffness_factor_(stiffness_factor), geometric_(geometric) {
    const int n = int(structure.position().size());
    std::vector<std::vector<int>> neighbours(n);
    for (const Element& e : structure.elements()) {
        neighbours[e.node[0]].push_back(e.node[1]);
        neighbours[e.node[1]].push_back(e.node[0]);
    }
    row_.push_back(0);
    for (int i = 0; i < n; ++i) {
        auto& near = neighbours[i];
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
        column_.push_back(i);
        column_.insert(column_.end(), near.begin(), near.end());
        row_.push_back(int(column_.size()));
    }
    value_.assign(column_.size() * 36 + 8, 0);
    const auto find = [&](int i, int j) { return int(std::lower_bound(column_.begin() + row_[i] + 1, column_.begin() + row_[i + 1], j) - column_.begin()); };
    for (const Element& e : structure.elements()) slot_.push_back({find(e.node[0], e.node[1]), find(e.node[1], e.node[0])});
    part_.assign(structure.elements().size(), Mat12::Zero());
    condensed_ = std::make_unique<Condensed>(row_, column_);
    is_dirty_.assign(n, 0);
    held_ = structure.fixed();
    for (auto* v : {&x_, &r_, &z_, &d_, &q_}) v->assign(stride * std::size_t(n), 0);
    for (int i = 0; i < n; ++i) mark(i);
}

void Operator::mark(int node) {
    if (!is_dirty_[node]) is_dirty_[node] = 1, dirty_.push_back(node);
}

void Operator::build(const std::vector<int>& elements, const State& state, const Pose& pose, const std::vector<const Mat6*>& tangents) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const int index = elements[i];
        const Element& e = structure_.elements()[index];
        const beam::Placement<double> place = place_element(structure_, index, pose);
        Mat3 axes;
        const auto& f = place.frame;
        axes << f.x.x, f.y.x, f.z.x, f.x.y, f.y.y, f.z.y, f.x.z, f.y.z, f.z.z;
        Mat6 k;
        if (!tangents.empty() && tangents[i]) k = *tangents[i];
        else k = stiffness_now(structure_, state, index).matrix();
        const auto stiffness = [&](bool geometric) {
            return structure_.large() ? beam::tangent(place, state.force[index], k, geometric) : beam::linear_tangent(axes.transpose(), e.length, k);
        };
        const Mat12 K = stiffness(geometric_);
        Mat12& A = part_[index];
        if (unsymmetric_) A = stiffness_factor_ * K;
        else A = (0.5 * stiffness_factor_) * (K + K.transpose());
        if (mass_factor_ != 0) {
            const Mat12 M = mass_factor_ * beam::consistent_mass(e.rigidity, e.length, axes);
            A += M;
            // conjugate gradients need every part positive: initial stress stays out of one that it would turn over
            if (geometric_ && keep_positive_ && A.llt().info() != Eigen::Success) A = stiffness_factor_ * stiffness(false) + M;
        }
        mark(e.node[0]);
        mark(e.node[1]);
        ++counts_.built;
    }
}

void Operator::remove(int element) {
    part_[element].setZero();
    for (int node : structure_.elements()[element].node) mark(node);
}

void Operator::set_couplings(std::vector<Coupling> couplings) {
    for (const auto* list : {&couplings_, &couplings})
        for (const Coupling& c : *list) mark(c.a), mark(c.b);
    couplings_ = std::move(couplings);
    std::vector<int> coupled;
    for (const Coupling& c : couplings_) coupled.push_back(c.a), coupled.push_back(c.b);
    std::vector<int> changed;
    condensed_->keep(std::move(coupled), changed);
    for (int node : changed) {
        mark(node);
        for (int k = row_[node] + 1; k < row_[node + 1]; ++k) mark(column_[k]);
    }
    for (Coupling& c : couplings_) {
        c.K *= stiffness_factor_;
        for (int i = 0; i < 12; ++i)
            if (held_[i < 6 ? c.a : c.b] >> (i % 6) & 1) c.K.row(i).setZero(), c.K.col(i).setZero();
    }
}

void Operator::set_hung(int node, const Mat6& mass) {
    if (hung_.empty()) hung_.assign(held_.size(), Mat6::Zero());
    hung_[node] = mass_factor_ * mass;
    mark(node);
}

void Operator::set_held(const std::vector<std::uint8_t>& held) {
    for (std::size_t i = 0; i < held.size(); ++i)
        if (held[i] != held_[i]) {
            mark(int(i));
            for (int k = row_[i] + 1; k < row_[i + 1]; ++k) mark(column_[k]);
        }
    held_ = held;
}

Mat6 Operator::masked(int a, int b, const Mat6& block) const {
    if (held_[a] == 0 && held_[b] == 0) return block;
    Mat6 m = block;
    for (int c = 0; c < 6; ++c) {
        if (held_[a] >> c & 1) m.row(c).setZero();
        if (held_[b] >> c & 1) m.col(c).setZero();
    }
    return m;
}

void Operator::assemble() {
    if (dirty_.empty()) return;
    factor_valid_ = false;
    std::sort(dirty_.begin(), dirty_.end());
    const auto store = [&](int slot, const Mat6& m) { std::memcpy(&value_[36 * slot], m.data(), 36 * sizeof(double)); };
    for (int i : dirty_) {
        Mat6 diagonal = Mat6::Zero();
        for (int k = row_[i] + 1; k < row_[i + 1]; ++k) store(k, Mat6::Zero());
        for (int index : structure_.elements_at()[i]) {
            const Element& e = structure_.elements()[index];
            const int a = e.node[0] == i ? 0 : 1, other = e.node[1 - a];
            diagonal += part_[index].block<6, 6>(6 * a, 6 * a);
            const Mat6 block = masked(i, other, part_[index].block<6, 6>(6 * a, 6 * (1 - a)));
            double* at = &value_[36 * slot_[index][a]];
            for (int c = 0; c < 36; ++c) at[c] += block.data()[c];
        }
        if (!hung_.empty()) diagonal += hung_[i];
        diagonal = masked(i, i, diagonal);
        for (int c = 0; c < 6; ++c)
            if (held_[i] >> c & 1) diagonal(c, c) = 1;
        store(row_[i], diagonal);
    }
    for (int i : dirty_) is_dirty_[i] = 0;
    stale_.insert(stale_.end(), dirty_.begin(), dirty_.end());
    dirty_.clear();
}

/// What conjugate gradients work on, brought up to date; a direct solver needs none of it.
void Operator::condense() {
    if (stale_.empty()) return;
    std::sort(stale_.begin(), stale_.end());
    stale_.erase(std::unique(stale_.begin(), stale_.end()), stale_.end());
    const std::vector<int>& renewed = condensed_->renew(stale_, value_.data());
    const bool all = condensed_->size() + 1 != int(inverse_.size()) || arrangement_ != condensed_->arrangement();
    arrangement_ = condensed_->arrangement();
    const std::vector<int>& nodes = all ? condensed_->order() : renewed;
    inverse_.resize(condensed_->size() + 1, Mat6::Identity());  // one more: a block is read two numbers past its end
    for (int i : nodes) inverse_[condensed_->place(i)] = condensed_->diagonal(condensed_->place(i)), is_dirty_[i] = 1;
    for (const Coupling& c : couplings_) {
        if (is_dirty_[c.a]) inverse_[condensed_->place(c.a)] += c.K.block<6, 6>(0, 0);
        if (is_dirty_[c.b]) inverse_[condensed_->place(c.b)] += c.K.block<6, 6>(6, 6);
    }
    for (int i : nodes) inverse_[condensed_->place(i)] = inverse_by_halves(inverse_[condensed_->place(i)]), is_dirty_[i] = 0;
    stale_.clear();
}

double Operator::multiply(const double* x, double* y) const {
    const int n = int(held_.size());
    Wide product{};
    for (int i = 0; i < n; ++i) {
        Wide row{};
        for (int k = row_[i]; k < row_[i + 1]; ++k) row += times(&value_[36 * std::size_t(k)], x + 6 * column_[k]);
        store_six(y + 6 * i, row);
        product += six * row * load(x + 6 * i);
    }
    double dot = sum(product);
    for (const Coupling& c : couplings_) {
        Vec12 v;
        v << Eigen::Map<const Vec6>(x + 6 * c.a), Eigen::Map<const Vec6>(x + 6 * c.b);
        const Vec12 w = c.K.lazyProduct(v);  // Eigen's product of this size goes through a loop for any size
        Eigen::Map<Vec6>(y + 6 * c.a) += w.head<6>();
        Eigen::Map<Vec6>(y + 6 * c.b) += w.tail<6>();
        dot += v.dot(w);
    }
    return dot;
}

bool Operator::factorise() {
    if (factor_valid_) return (unsymmetric_ ? lu_->info() : factor_.info()) == Eigen::Success;
    std::vector<Eigen::Triplet<double>> entries;
    const int n = int(held_.size());
    for (int i = 0; i < n; ++i)
        for (int k = row_[i]; k < row_[i + 1]; ++k)
            for (int c = 0; c < 6; ++c)
                for (int r = 0; r < 6; ++r)
                    if (const double v = value_[36 * k + 6 * c + r]; v != 0 && (unsymmetric_ || 6 * i + r >= 6 * column_[k] + c)) entries.emplace_back(6 * i + r, 6 * column_[k] + c, v);
    for (const Coupling& p : couplings_)
        for (int c = 0; c < 12; ++c)
            for (int r = 0; r < 12; ++r) {
                const int at_r = 6 * (r < 6 ? p.a : p.b) + r % 6, at_c = 6 * (c < 6 ? p.a : p.b) + c % 6;
                if (p.K(r, c) != 0 && (unsymmetric_ || at_r >= at_c)) entries.emplace_back(at_r, at_c, p.K(r, c));
            }
    Eigen::SparseMatrix<double> A(6 * n, 6 * n);
    A.setFromTriplets(entries.begin(), entries.end());
    diagonal_ = A.diagonal();
    factor_valid_ = true;
    ++counts_.factorisations;
    if (unsymmetric_) {
        lu_ = std::make_unique<Eigen::SparseLU<Eigen::SparseMatrix<double>>>(A);
        return lu_->info() == Eigen::Success;
    }
    factor_.compute(A);
    return factor_.info() == Eigen::Success;
}

int Operator::loosest_freedom(double ratio) const {
    if (factor_.info() != Eigen::Success) {
        for (int i = 0; i < diagonal_.size(); ++i)
            if (!(diagonal_[i] > 0)) return i;
    }
    const Eigen::VectorXd pivots = factor_.vectorD();
    const Eigen::VectorXd in_order = factor_.permutationP() * diagonal_;
    int worst = -1;
    double least = ratio;
    for (int i = 0; i < pivots.size(); ++i)
        if (const double share = std::abs(pivots[i]) / in_order[i]; !(share > least)) least = share, worst = i;
    return worst < 0 ? -1 : factor_.permutationPinv().indices()[worst];
}

SolveReport Operator::solve(const std::vector<Vec6>& right, std::vector<Vec6>& x, const SolverSettings& settings) {
    ++counts_.solves;
    const int n = int(right.size());
    if (settings.direct) {
        if (!factorise()) return {0, false};
        Eigen::Map<const Eigen::VectorXd> b(right[0].data(), 6 * n);
        Eigen::Map<Eigen::VectorXd> out(x[0].data(), 6 * n);
        if (unsymmetric_) out = lu_->solve(b);
        else out = factor_.solve(b);
        return {0, out.allFinite()};
    }
    return solve_iteratively(right[0].data(), x[0].data(), settings);
}

/// Conjugate gradients from x = 0 on the condensed system, preconditioned by each node's own block.
SolveReport Operator::solve_iteratively(const double* right, double* solution, const SolverSettings& settings) {
    condense();
    const int n = condensed_->size();
    double *x = x_.data(), *r = r_.data(), *z = z_.data(), *d = d_.data(), *q = q_.data();
    std::memcpy(q, right, 6 * sizeof(double) * held_.size());  // with room behind it
    condensed_->reduce(q, r);
    Wide product{};
    for (int i = 0; i < n; ++i) {
        const Wide zi = times(inverse_[i].data(), r + stride * i);
        store(d + stride * i, zi);
        product += six * zi * load(r + stride * i);
    }
    std::memset(x, 0, stride * sizeof(double) * std::size_t(n));
    double rho = sum(product);
    const double goal = std::max(rho * settings.tolerance * settings.tolerance, settings.floor);
    SolveReport report;
    while (rho > goal && rho > 1e-280) {
        if (report.iterations == settings.max_iterations) return report.converged = false, report;
        const double dq = condensed_->multiply(d, q) + add_couplings(d, q);
        if (!(dq > 0)) return report.converged = false, report;
        const double alpha = rho / dq;
        product = Wide{};
        for (int i = 0; i < n; ++i) {
            const Wide ri = load(r + stride * i) - alpha * load(q + stride * i);
            store(x + stride * i, load(x + stride * i) + alpha * load(d + stride * i));
            store(r + stride * i, ri);
            const Wide zi = times(inverse_[i].data(), r + stride * i);
            store(z + stride * i, zi);
            product += six * zi * ri;
        }
        const double next = sum(product), beta = next / rho;
        rho = next;
        for (int k = 0; k < stride * n; k += stride) store(d + k, load(z + k) + beta * load(d + k));
        ++report.iterations;
    }
    condensed_->solve_back(x, solution);
    counts_.iterations += report.iterations;
    report.converged = std::isfinite(rho);
    return report;
}

/// y += K x of what couples nodes beside the elements, which all stay in the condensed system. Returns x . K x.
double Operator::add_couplings(const double* x, double* y) const {
    double dot = 0;
    for (const Coupling& c : couplings_) {
        const int a = condensed_->place(c.a), b = condensed_->place(c.b);
        Vec12 v;
        v << Eigen::Map<const Vec6>(x + stride * a), Eigen::Map<const Vec6>(x + stride * b);
        const Vec12 w = c.K.lazyProduct(v);  // Eigen's product of this size goes through a loop for any size
        Eigen::Map<Vec6>(y + stride * a) += w.head<6>();
        Eigen::Map<Vec6>(y + stride * b) += w.tail<6>();
        dot += v.dot(w);
    }
    return dot;
}

}  // namespace hinge

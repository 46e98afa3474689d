#include "algebra/effective_stiffness.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "beam/tangent.h"
#include "algebra/blocks.h"
#include "algebra/unfused.h"
#include "state/hinges.h"
#include "state/node_mass.h"

namespace hinge {

EffectiveStiffness::EffectiveStiffness(const Structure& structure, ThreadPool& pool, double mass_factor,
                                       double stiffness_factor, bool geometric, MatrixStorage keeping)
    : structure_(structure),
      pool_(pool),
      mass_factor_(mass_factor),
      stiffness_factor_(stiffness_factor),
      geometric_(geometric),
      keeping_(keeping),
      matrices_(structure, keeping == MatrixStorage::single_precision, keeping != MatrixStorage::unsymmetric),
      factors_(keeping == MatrixStorage::unsymmetric) {
    const int n = int(structure.position().size());
    if (keeping == MatrixStorage::single_precision) single_ = std::make_unique<Condensed<float>>(structure, pool);
    if (keeping == MatrixStorage::iterative) condensed_ = std::make_unique<Condensed<double>>(structure, pool);
    is_dirty_.assign(n, 0);
    for (int i = 0; i < n; ++i) mark(i);
}

void EffectiveStiffness::mark(int node) {
    if (!is_dirty_[node]) is_dirty_[node] = 1, dirty_.push_back(node);
}

namespace {

const ElementTangent* find(const std::vector<ElementTangent>& given, int element) {
    if (given.empty()) return nullptr;
    const auto at = std::lower_bound(given.begin(), given.end(), element,
                                     [](const ElementTangent& g, int e) { return g.element < e; });
    return at != given.end() && at->element == element ? &*at : nullptr;
}

}  // namespace

/// m M + gamma dt C; without what `given` has of C.
Mat12 EffectiveStiffness::inertia_part(int index, const State& state, const ElementFrame& place,
                                       const ElementTangent* given) const {
    const ElementDamping c = damping_.empty() ? ElementDamping{} : damping_[index];
    const double of_M = mass_factor_ + by_damping_ * c.of_mass;
    const Mat3 axes = axes_of(place);
    Mat12 M = of_M * inertia_matrix(inertia_now(structure_, state, index), axes);
    if (c.of_stiffness != 0 && !(given && given->with_damping)) {
        const Mat6 k = stiffness_now(structure_, state, index).matrix();
        M += (by_damping_ * c.of_stiffness) *
             (structure_.large() ? element_tangent(place, state.force[index], k, false)
                                 : beam::linear_tangent(axes.transpose(), structure_.elements()[index].length, k));
    }
    return M;
}

Mat12 EffectiveStiffness::single_part(int index, const State& state, const Configuration& pose,
                                      const ElementTangent* given) const {
    const Element& e = structure_.elements()[index];
    const Mat6 k = given ? given->own : stiffness_now(structure_, state, index, heat_of(pose.heat, index)).matrix();
    const ElementFrame place = element_frame(structure_, index, pose);
    const auto stiffness = [&](bool geometric) {
        return structure_.large() ? element_tangent(place, state.force[index], k, geometric)
                                  : beam::linear_tangent(axes_of(place).transpose(), e.length, k);
    };
    const Mat12 K = stiffness(geometric_);
    Mat12 A;
    if (keeping_ == MatrixStorage::unsymmetric) A = stiffness_factor_ * K;
    else A = (0.5 * stiffness_factor_) * (K + K.transpose());
    const ElementDamping c = damping_.empty() ? ElementDamping{} : damping_[index];
    if (mass_factor_ + by_damping_ * c.of_mass == 0) return A;
    const Mat12 M = inertia_part(index, state, place, given);
    A += M;
    if (geometric_ && (keeping_ == MatrixStorage::iterative || keeping_ == MatrixStorage::single_precision) &&
        A.llt().info() != Eigen::Success)
        A = stiffness_factor_ * stiffness(false) + M;
    return A;
}

EffectiveStiffness::PairPart EffectiveStiffness::pair_part(int first, const State& state, const Configuration& pose,
                                                           const std::vector<ElementTangent>& given) const {
    const ElementFrame place[2] = {element_frame(structure_, first, pose), element_frame(structure_, first + 1, pose)};
    beam::PairMatrix k;
    const ElementTangent* const g[2] = {find(given, first), find(given, first + 1)};
    if (g[0]) k << g[0]->own, g[0]->partner, g[0]->partner.transpose(), g[1]->own;
    else k = elastic_pair_tangent(structure_, state, pose, first, place);
    Mat12 M[2] = {Mat12::Zero(), Mat12::Zero()};
    bool heavy = false;
    for (int i : {0, 1}) {
        const ElementDamping c = damping_.empty() ? ElementDamping{} : damping_[first + i];
        if (mass_factor_ + by_damping_ * c.of_mass == 0) continue;
        M[i] = inertia_part(first + i, state, place[i], g[i]), heavy = true;
    }
    // rows of the first element's nodes, columns of the second one's
    const Mat6 coupled = stiffness_factor_ * k.topRightCorner<6, 6>();
    const Eigen::Matrix<double, 12, 6> by_second = forces_at_nodes(place[0]).lazyProduct(coupled);
    const Mat12 between = by_second.lazyProduct(forces_at_nodes(place[1]).transpose());
    const auto put_together = [&](bool geometric) {
        PairPart part;
        for (int i : {0, 1}) {
            const Mat12 K = element_tangent(place[i], state.force[first + i], k.block<6, 6>(6 * i, 6 * i), geometric);
            if (keeping_ == MatrixStorage::unsymmetric || !geometric) part.A[i] = stiffness_factor_ * K + M[i];
            else part.A[i] = (0.5 * stiffness_factor_) * (K + K.transpose()) + M[i];
        }
        const auto outer = between.topLeftCorner<6, 6>(), at_middle = between.bottomLeftCorner<6, 6>(),
                   far = between.bottomRightCorner<6, 6>();
        part.A[0].topRightCorner<6, 6>() += outer;
        part.A[0].bottomLeftCorner<6, 6>() += outer.transpose();
        part.A[0].bottomRightCorner<6, 6>() += at_middle + at_middle.transpose();
        part.A[1].topRightCorner<6, 6>() += far;
        part.A[1].bottomLeftCorner<6, 6>() += far.transpose();
        part.bridge = between.topRightCorner<6, 6>();
        return part;
    };
    PairPart part = put_together(geometric_);
    if (geometric_ && heavy && (keeping_ == MatrixStorage::iterative || keeping_ == MatrixStorage::single_precision)) {
        Eigen::Matrix<double, 18, 18> whole = Eigen::Matrix<double, 18, 18>::Zero();
        whole.topLeftCorner<12, 12>() = part.A[0];
        whole.bottomRightCorner<12, 12>() += part.A[1];
        whole.bottomLeftCorner<6, 6>() = part.bridge.transpose();  // the factors read the lower half
        if (whole.llt().info() != Eigen::Success) part = put_together(false);
    }
    return part;
}

ElementPart EffectiveStiffness::part(int index, const State& state, const Configuration& pose,
                                     const std::vector<ElementTangent>& given) const {
    if (in_pair(structure_, state, index)) {
        const PairPart both = pair_part(index & ~1, state, pose, given);
        return {both.A[index & 1], index & 1 ? Mat6(both.bridge.transpose()) : both.bridge};
    }
    return {single_part(index, state, pose, find(given, index)), Mat6::Zero()};
}

void EffectiveStiffness::build(const std::vector<int>& elements, const State& state, const Configuration& pose,
                               const std::vector<ElementTangent>& given) {
    if (structure_.p_delta() && !matrices_.has_bridges() && !elements.empty()) matrices_.set_bridge(0, Mat6::Zero());
    pool_.share(int(elements.size()), 64, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            const int e = elements[i];
            if (!in_pair(structure_, state, e)) {
                matrices_.set(e, part(e, state, pose, given).A);
            } else if (e % 2 == 0) {  // both of the pair
                const PairPart both = pair_part(e, state, pose, given);
                matrices_.set(e, both.A[0]), matrices_.set(e + 1, both.A[1]);
                matrices_.set_bridge(e, both.bridge);
            }
        }
    });
    for (int index : elements)
        for (int node : structure_.elements()[index].node) mark(node);
    counts_.built += long(elements.size());
}

void EffectiveStiffness::remove(int element) {
    matrices_.clear(element);
    for (int node : structure_.elements()[element].node) mark(node);
}

void EffectiveStiffness::exchange_blocks(Blocks& blocks) {
    exchange_couplings(blocks.pairs);
    for (Blocks::Node& n : blocks.nodes) n.K *= stiffness_factor_;
    if (reduction_) given_.nodes.swap(blocks.nodes), given_changed_ = true;
    else take_node_blocks(blocks.nodes);
}

void EffectiveStiffness::exchange_couplings(std::vector<Coupling>& couplings) {
    for (Coupling& c : couplings) c.K *= stiffness_factor_;
    if (reduction_) given_.pairs.swap(couplings), given_changed_ = true;
    else take_couplings(couplings);
}

/// As exchange_blocks: the list is left with what was there before.
void EffectiveStiffness::take_node_blocks(std::vector<Blocks::Node>& blocks) {
    for (const Blocks::Node& n : matrices_.node_blocks()) mark(n.node);
    for (const Blocks::Node& n : blocks) mark(n.node);
    matrices_.exchange_node_blocks(blocks);
}

/// The same.
void EffectiveStiffness::take_couplings(std::vector<Coupling>& couplings) {
    const std::vector<std::uint8_t>& held = matrices_.held();
    for (Coupling& c : couplings)
        for (int i = 0; i < 12; ++i)
            if (held[i < 6 ? c.a : c.b] >> (i % 6) & 1) c.K.row(i).setZero(), c.K.col(i).setZero();
    const bool same_nodes = std::equal(couplings.begin(), couplings.end(), couplings_.begin(), couplings_.end(),
                                       [](const Coupling& c, const Coupling& d) { return c.a == d.a && c.b == d.b; });
    for (std::size_t i = 0; same_nodes && i < couplings.size(); ++i)
        if (couplings[i].K != couplings_[i].K) mark(couplings[i].a), mark(couplings[i].b);
    for (const auto* list : {&couplings_, &couplings})
        for (std::size_t i = 0; !same_nodes && i < list->size(); ++i) mark((*list)[i].a), mark((*list)[i].b);
    couplings_.swap(couplings);
    std::vector<int> changed;
    if (single_) single_->couple(couplings_, changed);
    if (condensed_) condensed_->couple(couplings_, changed);
    for (int node : changed) mark(node);
}

void EffectiveStiffness::set_offset_mass(int node, const Mat6& mass) {
    matrices_.set_offset_mass(node, mass_factor_ * mass);
    mark(node);
}

void EffectiveStiffness::set_held(const std::vector<std::uint8_t>& by_supports) {
    std::vector<std::uint8_t> held = by_supports;
    if (reduction_)
        for (const Reduction::Dependent& d : reduction_->dependents()) held[d.node] |= d.tied;
    for (std::size_t i = 0; i < held.size(); ++i) {
        if (held[i] == matrices_.held()[i]) continue;
        mark(int(i));
        for (int e : structure_.elements_at(int(i)))
            for (int node : structure_.elements()[e].node) mark(node);
    }
    matrices_.set_held(held);
}

void EffectiveStiffness::set_reduction(const Reduction* reduction) {
    reduction_ = reduction;
    if (single_ || condensed_) tied_members_ = std::make_unique<TiedMembers>(structure_, pool_);
}

void EffectiveStiffness::leave_out(const std::vector<int>& resting) {
    resting_ = resting;
    leave_out();
}

/// Bodies at rest, and what is condensed within members.
void EffectiveStiffness::leave_out() {
    std::vector<int> list = resting_;
    if (tied_members_ && !tied_members_->none()) {
        list.resize(is_dirty_.size(), -1);
        for (std::size_t n = 0; n < list.size(); ++n)
            if (tied_members_->takes_out_node(int(n))) list[n] = 0;
    }
    if (single_) single_->leave_out(list);
    if (condensed_) condensed_->leave_out(list);
}

/// Condenses the members whose ends follow other nodes, as far as something has changed.
void EffectiveStiffness::condense_tied() {
    if (tied_members_->find(*reduction_, given_.pairs, matrices_)) {
        matrices_.take_out(tied_members_->nodes_out(), tied_members_->elements_out());
        leave_out();
        for (int node = 0; node < int(is_dirty_.size()); ++node) mark(node);
    }
    if (!tied_members_->none())
        tied_members_->renew(reduced_by_, given_, matrices_, is_dirty_, [this](int node) { mark(node); });
}

/// After its fields were read. False where a coupling joins what is not there.
bool EffectiveStiffness::finish_restore() {
    const int nodes = int(is_dirty_.size());
    for (const Coupling& c : couplings_)
        if (c.a < 0 || c.a >= nodes || c.b < 0 || c.b >= nodes || c.a == c.b) return false;
    std::vector<int> changed;
    if (single_) single_->couple(couplings_, changed);
    if (condensed_) condensed_->couple(couplings_, changed);
    for (int node = 0; node < nodes; ++node) mark(node);
    return true;
}

void EffectiveStiffness::assemble() {
    if (reduction_) reduce();
    if (dirty_.empty()) return;
    factor_valid_ = false;
    if (tied_members_)
        std::erase_if(dirty_,
                      [this](int node) { return tied_members_->takes_out_node(node) && !(is_dirty_[node] = 0); });
    std::sort(dirty_.begin(), dirty_.end());
    if (single_) single_->renew(dirty_, matrices_);
    if (condensed_) condensed_->renew(dirty_, matrices_);
    for (int i : dirty_) is_dirty_[i] = 0;
    dirty_.clear();
}

SolveReport EffectiveStiffness::solve(const std::vector<Vec6>& right, std::vector<Vec6>& x,
                                      const SolverSettings& settings) {
    if (!reduction_) return solve_reduced(right, x, settings);
    std::vector<Vec6> reduced = right;
    const bool tied = tied_members_ && !tied_members_->none();
    if (tied) tied_members_->reduce(reduced);
    reduction_->reduce(reduced);
    take_out_held(reduced);
    const SolveReport report = solve_reduced(reduced, x, settings);
    reduction_->expand(x);
    if (tied) tied_members_->solve_back(x);
    return report;
}

SolveReport EffectiveStiffness::solve_reduced(const std::vector<Vec6>& right, std::vector<Vec6>& x,
                                              const SolverSettings& settings) {
    ++counts_.solves;
    if (settings.direct) {
        if (!factorise()) return {0, false};
        return {0, factors_.solve(right[0].data(), x[0].data(), int(right.size()))};
    }
    const SolveReport report = single_ ? single_->solve(right[0].data(), x[0].data(), settings)
                                       : condensed_->solve(right[0].data(), x[0].data(), settings);
    for (std::size_t n = 0; n < resting_.size(); ++n)
        if (resting_[n] >= 0) x[n].setZero();  // it has what was there before
    counts_.iterations += report.iterations;
    return report;
}

EffectiveStiffness::Weakest EffectiveStiffness::weakest_part() const {
    const int nodes = int(structure_.position().size());
    std::vector<double> d(6 * std::size_t(nodes));
    if (single_) single_->direction(d.data());
    else if (condensed_) condensed_->direction(d.data());
    const auto at = [&](int node) { return Eigen::Map<const Vec6>(&d[6 * std::size_t(node)]); };
    Weakest found;
    double least = 0;
    const auto compare = [&](double product, int a, int b, int element) {
        if (!(product < least)) return;
        least = product;
        const bool first = b < 0 || at(a).squaredNorm() >= at(b).squaredNorm();
        found = {first ? a : b, element, element >= 0 ? -1 : first ? b : a};
    };
    for (int e = 0; e < int(structure_.elements().size()); ++e) {
        const auto& node = structure_.elements()[e].node;
        compare(matrices_.product(e, d.data()), node[0], node[1], e);
    }
    for (const Blocks::Node& n : matrices_.node_blocks()) compare(at(n.node).dot(n.K * at(n.node)), n.node, -1, -1);
    for (int n = 0; n < nodes; ++n) compare(matrices_.product_of_offset_mass(n, d.data()), n, -1, -1);
    for (const Coupling& c : couplings_) {
        Vec12 x;
        x << at(c.a), at(c.b);
        compare(x.dot(c.K * x), c.a, c.b, tied_members_ ? tied_members_->element_between(c.a, c.b) : -1);
    }
    for (int n = 0; n < nodes && found.node < 0; ++n)  // rounding alone
        if (at(n).squaredNorm() > least) least = at(n).squaredNorm(), found.node = n;
    return found;
}

bool EffectiveStiffness::factorise() {
    if (factor_valid_) return factors_.good();
    const int n = int(structure_.position().size());
    for (int i = 0; i < n; ++i) factors_.add(i, i, matrices_.own(i));
    for (std::size_t e = 0; e < structure_.elements().size(); ++e)
        for (int end : {0, 1})
            factors_.add(structure_.elements()[e].node[end], structure_.elements()[e].node[1 - end],
                         matrices_.across(int(e), end));
    for (std::size_t e = 0; matrices_.has_bridges() && e + 1 < structure_.elements().size(); e += 2)
        for (int end : {0, 1})
            factors_.add(structure_.elements()[e + end].node[end], structure_.elements()[e + 1 - end].node[1 - end],
                         matrices_.bridge(int(e), end));
    for (const Coupling& p : couplings_)
        for (int a : {0, 1})
            for (int b : {0, 1}) factors_.add(a == 0 ? p.a : p.b, b == 0 ? p.a : p.b, p.K.block<6, 6>(6 * a, 6 * b));
    factor_valid_ = true;
    symmetric_.reset();
    ++counts_.factorisations;
    return factors_.factorise(n);
}

/// Adds A, or its symmetric part, and `on_diagonal` at each node.
void EffectiveStiffness::add_to(DirectFactors& factors, bool symmetric_part, const Vec6& on_diagonal) const {
    const auto add = [&](int a, int b, const Mat6& of_ab, const Mat6& of_ba) {
        factors.add(a, b, symmetric_part ? 0.5 * (of_ab + of_ba.transpose()) : of_ab);
    };
    for (int i = 0; i < int(structure_.position().size()); ++i) {
        Mat6 own = matrices_.own(i);
        own.diagonal() += on_diagonal;
        add(i, i, own, own);
    }
    for (std::size_t e = 0; e < structure_.elements().size(); ++e) {
        const Mat6 across[2] = {matrices_.across(int(e), 0), matrices_.across(int(e), 1)};
        for (int end : {0, 1})
            add(structure_.elements()[e].node[end], structure_.elements()[e].node[1 - end], across[end],
                across[1 - end]);
    }
    for (std::size_t e = 0; matrices_.has_bridges() && e + 1 < structure_.elements().size(); e += 2)
        for (int end : {0, 1})
            add(structure_.elements()[e + end].node[end], structure_.elements()[e + 1 - end].node[1 - end],
                matrices_.bridge(int(e), end), matrices_.bridge(int(e), 1 - end));
    for (const Coupling& p : couplings_)
        for (int a : {0, 1})
            for (int b : {0, 1})
                add(a == 0 ? p.a : p.b, b == 0 ? p.a : p.b, p.K.block<6, 6>(6 * a, 6 * b),
                    p.K.block<6, 6>(6 * b, 6 * a));
}

const DirectFactors& EffectiveStiffness::symmetric_factors() {
    if (keeping_ != MatrixStorage::unsymmetric) return factors_;
    if (symmetric_) return *symmetric_;
    symmetric_ = std::make_unique<DirectFactors>(false);
    add_to(*symmetric_, true, Vec6::Zero());
    ++counts_.factorisations;
    symmetric_->factorise(int(structure_.position().size()));
    return *symmetric_;
}

bool EffectiveStiffness::factorise_shifted(DirectFactors& factors, bool symmetric_part, const Vec6& on_diagonal) {
    add_to(factors, symmetric_part, on_diagonal);
    ++counts_.factorisations;
    return factors.factorise(int(structure_.position().size()));
}

bool EffectiveStiffness::solve_by(const DirectFactors& factors, const std::vector<Vec6>& right, std::vector<Vec6>& x) {
    ++counts_.solves;
    return factors.solve(right[0].data(), x[0].data(), int(right.size()));
}

bool EffectiveStiffness::more_negative_modes(int known) const {
    if (keeping_ == MatrixStorage::unsymmetric) return factors_.negative_determinant() != (known % 2 == 1);
    return factors_.negative_pivots() > known;
}

double EffectiveStiffness::time_product(int repeats) const {
    using namespace blocks;
    const int n = int(structure_.position().size());
    std::vector<int> first(1, 0), column;
    std::vector<double> value;
    value.reserve(36 * (std::size_t(n) + 2 * structure_.elements().size()) + 8);
    const auto add = [&](int j, const Mat6& m) {
        column.push_back(j), value.insert(value.end(), m.data(), m.data() + 36);
    };
    for (int i = 0; i < n; ++i) {
        add(i, matrices_.own(i));
        for (int e : structure_.elements_at(int(i))) {
            const int end = structure_.elements()[e].node[0] == i ? 0 : 1;
            add(structure_.elements()[e].node[1 - end], matrices_.across(e, end));
        }
        first.push_back(int(column.size()));
    }
    value.resize(value.size() + 8);
    std::vector<double> x(6 * std::size_t(n) + 8, 1.0), y(x.size());
    double best = std::numeric_limits<double>::infinity();
    for (int repeat = 0; repeat < repeats; ++repeat) {
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < n; ++i) {
            Wide row{};
            for (int k = first[i]; k < first[i + 1]; ++k) row += times(&value[36 * std::size_t(k)], &x[6 * column[k]]);
            store_six(&y[6 * i], row);
        }
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

}  // namespace hinge

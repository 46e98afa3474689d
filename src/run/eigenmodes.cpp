#include "run/eigenmodes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/effective_stiffness.h"
#include "algebra/eigenpairs.h"
#include "core/errors.h"
#include "run/constraints.h"
#include "run/pressed_pairs.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Degrees of freedom that can move, and matrices of them: lower halves, with constraints eliminated.
class Unknowns {
public:
    /// `supports`: with what supports hold.
    Unknowns(const Run& run, const State& state, bool supports = false) : run_(run), place_(6 * state.held.size(), -1) {
        for (std::size_t n = 0; n < state.held.size(); ++n)
            for (int c = 0; c < 6; ++c)
                if (!state.gone[n] && (supports || !(state.held[n] >> c & 1))) place_[6 * n + std::size_t(c)] = size_++;
        make_reduction();
    }
    int size() const { return int(T_.cols()); }

    template <class Block>
    void add(Triplets& to, int a, int b, const Block& block) const {
        for (int i = 0; i < block.rows(); ++i)
            for (int j = 0; j < block.cols(); ++j) {
                const int row = place_[std::size_t(6 * (i < 6 ? a : b) + i % 6)],
                          column = place_[std::size_t(6 * (j < 6 ? a : b) + j % 6)];
                if (row >= column && column >= 0 && block(i, j) != 0)
                    to.emplace_back(row, column, 0.5 * (block(i, j) + block(j, i)));
            }
    }
    /// A block between two nodes, and its transposed.
    void add_between(Triplets& to, int a, int b, const Mat6& block) const {
        Mat12 both = Mat12::Zero();
        both.topRightCorner<6, 6>() = block;
        both.bottomLeftCorner<6, 6>() = block.transpose();
        add(to, a, b, both);
    }
    SparseMatrix reduced(const Triplets& of) const {
        SparseMatrix lower(size_, size_);
        lower.setFromTriplets(of.begin(), of.end());
        const SparseMatrix whole = lower.selfadjointView<Eigen::Lower>();
        const SparseMatrix product = T_.transpose() * whole * T_;
        return product.triangularView<Eigen::Lower>();
    }
    std::vector<Vec6> at_nodes(const Eigen::VectorXd& x) const {
        const Eigen::VectorXd all = T_ * x;
        std::vector<Vec6> nodes(place_.size() / 6, Vec6::Zero());
        for (std::size_t i = 0; i < place_.size(); ++i)
            if (place_[i] >= 0) nodes[i / 6][Eigen::Index(i % 6)] = all[place_[i]];
        return nodes;
    }
    /// Of all degrees of freedom, constraints apart: a motion of the nodes, and a unit displacement along an axis.
    Eigen::VectorXd of_nodes(const std::vector<Vec6>& motion) const {
        Eigen::VectorXd all = Eigen::VectorXd::Zero(size_);
        for (std::size_t i = 0; i < place_.size(); ++i)
            if (place_[i] >= 0) all[place_[i]] = motion[i / 6][Eigen::Index(i % 6)];
        return all;
    }
    Eigen::VectorXd along(int axis) const { return of_nodes(std::vector<Vec6>(place_.size() / 6, Vec6::Unit(axis))); }
    SparseMatrix whole(const Triplets& of) const {
        SparseMatrix lower(size_, size_);
        lower.setFromTriplets(of.begin(), of.end());
        return lower.selfadjointView<Eigen::Lower>();
    }

private:
    void make_reduction() {
        std::vector<LinearConstraint> constraints;
        if (run_.constraints()) constraints = run_.constraints()->list_at(run_.state());
        const auto at = [&](const DegreeOfFreedom& of) { return place_[std::size_t(6 * of.node + of.component)]; };
        std::vector<char> depends(std::size_t(size_), 0);
        for (const LinearConstraint& c : constraints)
            if (at(c.dependent) >= 0) depends[std::size_t(at(c.dependent))] = 1;
        std::vector<int> column(std::size_t(size_), -1);
        int left = 0;
        Triplets entries;
        for (int i = 0; i < size_; ++i)
            if (!depends[std::size_t(i)]) column[std::size_t(i)] = left++, entries.emplace_back(i, left - 1, 1.0);
        for (const LinearConstraint& c : constraints)
            for (const LinearConstraint::Term& term : c.terms)
                if (at(c.dependent) >= 0 && at(term.of) >= 0 && column[std::size_t(at(term.of))] >= 0)
                    entries.emplace_back(at(c.dependent), column[std::size_t(at(term.of))], term.factor);
        T_.resize(size_, left);
        T_.setFromTriplets(entries.begin(), entries.end());
    }

    const Run& run_;
    int size_ = 0;
    std::vector<int> place_;
    SparseMatrix T_;
};

/// m M + k K of the elements, in a state.
Triplets of_elements(const Run& run, const State& state, const Unknowns& unknowns, double m, double k) {
    ThreadPool alone(1);
    const Structure& s = run.structure();
    const EffectiveStiffness matrix(s, alone, m, k, true, MatrixStorage::direct);
    const Configuration pose = configuration_of(state);
    Triplets entries;
    for (std::size_t i = 0; i < s.elements().size(); ++i) {
        if (state.broken[i]) continue;
        const Element& e = s.elements()[i];
        const ElementPart part = matrix.part(int(i), state, pose, {});
        unknowns.add(entries, e.node[0], e.node[1], part.A);
        if (i % 2 == 0 && !part.bridge.isZero(0))
            unknowns.add_between(entries, e.node[0], s.elements()[std::size_t(e.partner)].node[1], part.bridge);
    }
    return entries;
}

void add_effects(const Run& run, const Unknowns& unknowns, Triplets& to) {
    const Blocks blocks = run.added_stiffness();
    for (const Coupling& c : blocks.pairs) unknowns.add(to, c.a, c.b, c.K);
    for (const Blocks::Node& n : blocks.nodes) unknowns.add(to, n.node, n.node, n.K);
}

void add_offset_masses(const State& state, const Unknowns& unknowns, Triplets& to) {
    for (std::size_t n = 0; n < state.offset_mass.size(); ++n)
        if (state.offset_mass[n].mass > 0)
            unknowns.add(to, int(n), int(n), offset_mass_in_space(state.offset_mass[n], state.rotation[n]));
}

}  // namespace

NaturalModes natural_modes(const Run& run, int count) {
    const State& state = run.state();
    const Unknowns unknowns(run, state);
    Triplets stiffness = of_elements(run, state, unknowns, 0, 1), mass = of_elements(run, state, unknowns, 1, 0);
    add_effects(run, unknowns, stiffness);
    add_offset_masses(state, unknowns, mass);
    const SparseMatrix K = unknowns.reduced(stiffness), M = unknowns.reduced(mass);
    const Eigen::VectorXd own = M.diagonal();
    if (own.size() == 0) return {{}, Vec3::Zero()};
    if (!(own.minCoeff() > 0))
        throw InputError(
            "a node that can move has no mass, so that there are no natural modes; give all materials a "
            "density");
    const double k = K.diagonal().cwiseAbs().sum(), m = own.sum();
    // a small shift: bodies that nothing holds have modes of frequency 0
    double shift = 1e-9;
    while (negative_pivots(K / k + shift * M / m) > 0) shift *= 4;  // an unstable state has negative values, too
    const int wanted = std::min(count, int(own.size()));
    const Eigenpairs found = lowest_eigenpairs(K / k, M / m, shift, wanted, true);
    const Unknowns all(run, state, true);
    Triplets mass_of_all = of_elements(run, state, all, 1, 0);
    add_offset_masses(state, all, mass_of_all);
    const SparseMatrix whole = all.whole(mass_of_all);
    NaturalModes modes;
    for (int axis : {0, 1, 2}) modes.mass[axis] = all.along(axis).dot(whole * all.along(axis));
    for (int i = 0; i < wanted; ++i) {
        const Eigen::VectorXd x = found.vectors.col(i) / std::sqrt(m);
        NaturalMode mode{found.values[std::size_t(i)] * k / m, unknowns.at_nodes(x), Vec3::Zero()};
        const Eigen::VectorXd momentum = whole * all.of_nodes(mode.shape);
        for (int axis : {0, 1, 2}) mode.participation[axis] = all.along(axis).dot(momentum);
        // rounding: what is below a millionth of a millionth of the stiffness is a rigid motion
        if (std::abs(found.values[std::size_t(i)]) < 1e-11) mode.omega_squared = 0;
        modes.list.push_back(std::move(mode));
    }
    return modes;
}

namespace {

/// The structure in its declared place, with the internal forces of a run times a factor.
class Loaded {
public:
    explicit Loaded(const Run& run)
        : run_(run), state_(initial_state(run.structure())), unknowns_(run, state_), forces_(run.state().force) {
        add_effects(run, unknowns_, effects_);
    }
    SparseMatrix at(double factor) {
        scale(factor);
        Triplets entries = of_elements(run_, state_, unknowns_, 0, 1);
        entries.insert(entries.end(), effects_.begin(), effects_.end());
        return unknowns_.reduced(entries);
    }
    int unstable(double factor) { return negative_pivots(at(factor)); }
    /// The factor at which the first pair of elements buckles between its ends.
    double hidden() const {
        double most = 0;
        for (std::size_t i = 0; i + 1 < run_.structure().elements().size(); i += 2)
            most = std::max(most, pressed(run_.structure(), state_, forces_, int(i)).most());
        return most > 0 ? 1 / most : std::numeric_limits<double>::infinity();
    }
    std::vector<Vec6> shape(const Eigen::VectorXd& x) const {
        std::vector<Vec6> nodes = unknowns_.at_nodes(x);
        double largest = 0;
        for (const Vec6& v : nodes) largest = std::max(largest, v.head<3>().norm());
        for (Vec6& v : nodes) v /= largest > 0 ? largest : 1;
        return nodes;
    }

private:
    /// The bending of pairs follows their stretch: they have that of their axial forces in the declared place.
    void scale(double factor) {
        const std::vector<Element>& elements = run_.structure().elements();
        for (std::size_t i = 0; i < forces_.size(); ++i) {
            state_.force[i] = factor * forces_[i];
            state_.plastic[i][axial] = -state_.force[i][axial] * elements[i].length / elements[i].rigidity.EA;
        }
    }
    static constexpr int axial = 4;  ///< place of the axial force and of the stretch in p and d
    const Run& run_;
    State state_;
    Unknowns unknowns_;
    std::vector<Vec6> forces_;
    Triplets effects_;
};

}  // namespace

BucklingModes buckling_modes(const Run& run, int count, double most) {
    constexpr double accuracy = 1e-7, together = 1e-6;  // of a factor; of those that are one multiple factor
    Loaded loaded(run);
    BucklingModes modes{{}, loaded.hidden()};
    const double end = std::min(most, modes.hidden * (1 - accuracy));
    double below = 0;
    const int at_start = loaded.unstable(0);
    double first = std::min(1e-3 * end, 1.0);  // less than the first factor
    while (first > 1e-12 * end && loaded.unstable(first) > at_start) first *= 0.1;
    for (int known = at_start; known < at_start + count;) {
        double above = std::max(below, first) * 2;  // a factor beyond the next one
        while (above < end && loaded.unstable(above) <= known) below = above, above *= 2;
        above = std::min(above, end);
        if (loaded.unstable(above) <= known) break;
        while (above - below > accuracy * above) {
            const double middle = below > 0 ? std::sqrt(below * above) : 0.5 * (below + above);
            (loaded.unstable(middle) > known ? above : below) = middle;
        }
        const int multiple = std::max(1, loaded.unstable(above * (1 + together)) - known);
        const Eigen::MatrixXd x = vectors_next_to_zero(loaded.at(below), multiple);
        for (int i = 0; i < multiple && int(modes.list.size()) < count; ++i)
            modes.list.push_back({0.5 * (below + above), loaded.shape(x.col(i))});
        known += multiple;
        below = above * (1 + together);
    }
    return modes;
}

}  // namespace hinge

#include "run/eigenmodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "algebra/effective_stiffness.h"
#include "algebra/eigenpairs.h"
#include "algebra/free_unknowns.h"
#include "algebra/rigid_modes.h"
#include "algebra/unsymmetric_pairs.h"
#include "beam/beam_column.h"
#include "core/errors.h"
#include "core/text.h"
#include "run/constraints.h"
#include "run/pair_compression.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

using Triplets = FreeUnknowns::Triplets;

/// What can move in a state; `supports`: with what supports hold.
FreeUnknowns unknowns_of(const Run& run, const State& state, bool supports = false) {
    std::vector<std::uint8_t> free(state.held.size());
    for (std::size_t n = 0; n < free.size(); ++n)
        if (!state.gone[n]) free[n] = supports ? 63 : std::uint8_t(~state.held[n] & 63);
    return {free, run.constraints() ? run.constraints()->list_at(run.state()) : std::vector<LinearConstraint>()};
}

/// Adds m M + k K of the elements, in a state: add(a, b, block) with 12 x 12 of both nodes, add_between(a, b, block)
/// with 6 x 6 that joins the outer ends of a pair.
template <class Add, class AddBetween>
void for_each_part(const Run& run, const State& state, double m, double k, MatrixStorage storage, Add add,
                   AddBetween add_between) {
    ThreadPool alone(1);
    const Structure& s = run.structure();
    const EffectiveStiffness matrix(s, alone, m, k, true, storage);
    const Configuration& pose = state;
    for (std::size_t i = 0; i < s.elements().size(); ++i) {
        if (state.broken[i]) continue;
        const Element& e = s.elements()[i];
        const ElementPart part = matrix.part(int(i), state, pose, {});
        add(e.node[0], e.node[1], part.A);
        if (i % 2 == 0 && !part.bridge.isZero(0))
            add_between(e.node[0], s.elements()[std::size_t(e.partner)].node[1], part.bridge);
    }
}

/// m M + k K of the elements, in a state.
Triplets of_elements(const Run& run, const State& state, const FreeUnknowns& unknowns, double m, double k) {
    Triplets entries;
    for_each_part(
        run, state, m, k, MatrixStorage::direct, [&](int a, int b, const Mat12& A) { unknowns.add(entries, a, b, A); },
        [&](int a, int b, const Mat6& bridge) { unknowns.add_between(entries, a, b, bridge); });
    return entries;
}

/// What effects and constraints add to the stiffness at a pose, with `factor` times the forces and loads of the state.
Blocks added_at(const Run& run, Yielded yielded, const State& pose, double factor) {
    Blocks blocks = run.added_stiffness(yielded, factor);
    if (!run.constraints()) return blocks;
    const bool known = run.constraints()->add_curvature_of_state(pose, factor, blocks);
    const auto carries = [](const Vec6& p) { return !p.isZero(0); };
    if (!known && std::any_of(run.state().force.begin(), run.state().force.end(), carries))
        throw InputError(
            "the run has done no step since it was made or read, so that the forces of its rigid links and diaphragms "
            "are not known; take a step, or ask the run before");
    return blocks;
}

void add_effects(const Blocks& blocks, const FreeUnknowns& unknowns, Triplets& to) {
    for (const Coupling& c : blocks.pairs) unknowns.add(to, c.a, c.b, c.K);
    for (const Blocks::Node& n : blocks.nodes) unknowns.add(to, n.node, n.node, n.K);
}

/// K with what loads make of it that is not symmetric: a moment whose axis stays does other work about the axes of
/// space in another order of rotations.
SparseMatrix unsymmetric_stiffness(const Run& run, const State& state, const FreeUnknowns& unknowns,
                                   const Blocks& blocks) {
    Triplets entries;
    const auto add = [&](int a, int b, const auto& K) { unknowns.add_unsymmetric(entries, a, b, K); };
    for_each_part(run, state, 0, 1, MatrixStorage::unsymmetric, add, [&](int a, int b, const Mat6& bridge) {
        Mat12 both = Mat12::Zero();
        both.topRightCorner<6, 6>() = bridge;
        both.bottomLeftCorner<6, 6>() = bridge.transpose();
        add(a, b, both);
    });
    for (const Coupling& c : blocks.pairs) add(c.a, c.b, c.K);
    for (const Blocks::Node& n : blocks.nodes) add(n.node, n.node, n.K);
    return unknowns.reduced_unsymmetric(entries);
}

void add_offset_masses(const State& state, const FreeUnknowns& unknowns, Triplets& to) {
    for (std::size_t n = 0; n < state.offset_mass.size(); ++n)
        if (state.offset_mass[n].mass > 0)
            unknowns.add(to, int(n), int(n), offset_mass_in_space(state.offset_mass[n], state.rotation[n]));
}

/// K and M of a state on its unknowns, each over its trace.
struct Vibration {
    FreeUnknowns unknowns;
    Blocks blocks;
    SparseMatrix K, M;
    double k = 0, m = 0;  ///< the traces
    double shift = 1e-9;  ///< small: bodies that nothing holds have modes of frequency 0

    /// `positive`: find a shift with which K + shift M is positive definite.
    Vibration(const Run& run, Yielded yielded, bool positive = true)
        : unknowns(unknowns_of(run, run.state())), blocks(added_at(run, yielded, run.state(), 1)) {
        const State& state = run.state();
        Triplets stiffness = of_elements(run, state, unknowns, 0, 1), mass = of_elements(run, state, unknowns, 1, 0);
        add_effects(blocks, unknowns, stiffness);
        add_offset_masses(state, unknowns, mass);
        K = unknowns.reduced(stiffness), M = unknowns.reduced(mass);
        const Eigen::VectorXd own = M.diagonal();
        if (own.size() == 0) return;
        if (!(own.maxCoeff() > 0))
            throw InputError(
                "nothing that can move has mass, so that there are no natural modes; give materials a density, or "
                "nodes a mass (model:mass)");
        k = K.diagonal().cwiseAbs().sum(), m = own.sum();
        K = K / k, M = M / m;
        while (positive && negative_pivots(K + shift * M) > 0)
            if ((shift *= 4) > 1e12)  // an unstable state has negative values, too
                throw std::runtime_error(
                    "no modes are found: a part without mass is unstable under the forces of the run; give it a "
                    "density");
    }
    int size() const { return int(M.rows()); }
};

/// The modes of the unsymmetric stiffness in the place of those of its symmetric part, where they differ.
void count_unsymmetric(const Run& run, const Vibration& v, Eigenpairs& found) {
    constexpr double counts = 1e-3;  // of the square of a frequency: 0.05 % of the frequency
    const int wanted = int(found.values.size());
    const SparseMatrix K = unsymmetric_stiffness(run, run.state(), v.unknowns, v.blocks) / v.k;
    if (change_by_unsymmetric(K, v.K, v.M, v.shift, found) < counts) return;
    const std::string why = "moments or loads that turn with their member make the stiffness unsymmetric";
    if (!(v.M.diagonal().minCoeff() > 0))
        throw InputError(why +
                         ", which is not done yet where nodes that can move have no mass; give all materials a "
                         "density");
    if (v.size() > most_unsymmetric)
        throw InputError(why + ", and with " + std::to_string(v.size()) +
                         " degrees of freedom that takes too long (most: " + std::to_string(most_unsymmetric) +
                         "); give the members fewer elements, or see in dynamics what a small push does");
    const UnsymmetricPairs pairs = lowest_of_unsymmetric(K, v.M, v.shift, wanted);
    for (std::size_t i = 0; i < pairs.values.size(); ++i) {
        const std::complex<double> square = pairs.values[i] * v.k / v.m;
        if (std::abs(square.imag()) > 1e-6 * std::abs(square)) {
            const std::complex<double> omega = std::sqrt(square);
            throw InputError(why + ", and mode " + std::to_string(i + 1) + " flutters: vibrations of " +
                             number_text(std::abs(omega.real()) / 6.283185307179586) + " Hz grow by exp(" +
                             number_text(std::abs(omega.imag())) +
                             " t), t in s, without damping; ask for fewer modes, or see in dynamics how far they go");
        }
        found.values[i] = pairs.values[i].real();
    }
    found.values.resize(pairs.values.size());
    found.vectors = pairs.vectors;
}

}  // namespace

NaturalModes natural_modes(const Run& run, int count, Yielded yielded) {
    const State& state = run.state();
    const Vibration v(run, yielded);
    if (v.size() == 0) return {{}, Vec3::Zero()};
    Eigenpairs found = lowest_eigenpairs(v.K, v.M, v.shift, std::min(count, v.size()), true);
    tell_rigid_modes(v.K, v.M, v.shift, found, [&](const Eigen::VectorXd& x) {
        return strained_member(run.structure(), state, v.unknowns.at_nodes(x));
    });
    if (run.has_unsymmetric_loads()) count_unsymmetric(run, v, found);
    const FreeUnknowns all = unknowns_of(run, state, true);
    Triplets mass_of_all = of_elements(run, state, all, 1, 0);
    add_offset_masses(state, all, mass_of_all);
    const SparseMatrix whole = all.whole(mass_of_all);
    NaturalModes modes;
    for (int axis : {0, 1, 2}) modes.mass[axis] = all.along(axis).dot(whole * all.along(axis));
    for (std::size_t i = 0; i < found.values.size(); ++i) {
        const Eigen::VectorXd x = found.vectors.col(Eigen::Index(i)) / std::sqrt(v.m);
        NaturalMode mode{found.values[i] * v.k / v.m, v.unknowns.at_nodes(x), Vec3::Zero()};
        const Eigen::VectorXd momentum = whole * all.of_nodes(mode.shape);
        for (int axis : {0, 1, 2}) mode.participation[axis] = all.along(axis).dot(momentum);
        modes.list.push_back(std::move(mode));
    }
    return modes;
}

int unstable_modes(const Run& run) {
    const Vibration v(run, Yielded::unloads, false);
    return v.size() == 0 ? 0 : negative_pivots(v.K + v.shift * v.M);
}

namespace {

/// The structure in its declared place, with the internal forces of a run times a factor.
class LoadedStructure {
public:
    LoadedStructure(const Run& run, Yielded yielded)
        : run_(run),
          state_(initial_state(run.structure())),
          unknowns_(unknowns_of(run, state_)),
          forces_(run.state().force),
          yielded_(yielded) {
        state_.heat.resize(run.state().heat.size());  // its deformations are in the forces
        for (std::size_t i = 0; i < state_.heat.size(); ++i) state_.heat[i].stiffness = run.state().heat[i].stiffness;
    }
    SparseMatrix at(double factor) {
        scale(factor);
        Triplets entries = of_elements(run_, state_, unknowns_, 0, 1);
        add_effects(added_at(run_, yielded_, state_, factor), unknowns_, entries);
        add_strongly_pressed(entries);
        return unknowns_.reduced(entries);
    }
    int unstable(double factor) { return negative_pivots(at(factor)); }
    /// How much what moments make of the stiffness that is not symmetric changes a factor of the symmetric one, x its
    /// mode, as a part of it: A x . K0^-1 A x over x . K0 x, by second-order perturbation.
    double change_by_unsymmetric(double factor, const Eigen::VectorXd& x) {
        const SparseMatrix unloaded = at(0);
        scale(factor);
        const SparseMatrix K = unsymmetric_stiffness(run_, state_, unknowns_, added_at(run_, yielded_, state_, factor));
        const Eigen::VectorXd moved = 0.5 * (K * x - SparseMatrix(K.transpose()) * x);
        return moved.dot(solution(unloaded, moved)) / x.dot(unloaded.selfadjointView<Eigen::Lower>() * x);
    }
    /// The factor at which the first pair of elements buckles between its ends.
    double hidden() const {
        double most = 0;
        for (std::size_t i = 0; i + 1 < run_.structure().elements().size(); i += 2)
            most = std::max(most, pair_compression(run_.structure(), state_, forces_, int(i)).most());
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
            state_.plastic[i][axial] =
                -state_.force[i][axial] * elements[i].length / elements[i].rigidity.EA / softened(i);
        }
    }
    /// S and A of a pair are straight lines beyond p = 6, which its return to the yield surface asks for
    /// (beam/beam_column.h). Here they are exact up to where it buckles between clamped ends: the rest, of rotations
    /// about the pair's axes at its ends and in its middle, t2 - t0 and 2 t1 - t0 - t2.
    void add_strongly_pressed(Triplets& to) const {
        const std::vector<Element>& elements = run_.structure().elements();
        if (!run_.structure().p_delta()) return;
        for (std::size_t i = 0; i + 1 < elements.size(); i += 2) {
            const PairCompression by = pair_compression(run_.structure(), state_, state_.force, int(i));
            for (const int plane : {0, 1}) {
                constexpr double clamped = std::numbers::pi * std::numbers::pi;
                const Element& e = elements[i];
                const beam::PairKind<double> kind = pair_kind_of(e, heat_of(state_.heat, int(i)));
                const double shear = kind.shear[plane].flexible,
                             straight = clamped / (1 + clamped * shear) * std::min(by.part[plane], 1 - 1e-9),
                             p = straight / (1 - shear * straight);
                if (!(p > beam::pair_most)) continue;
                const double b = 0.5 * softened(i) * (plane == 0 ? e.rigidity.EIx : e.rigidity.EIy) / e.length;
                const Vec3 axis = e.axes.toRotationMatrix().col(plane);
                const auto has = beam::stability_functions(straight, kind.shear[plane]);
                const double cot = std::sqrt(p) / std::tan(std::sqrt(p)), S = cot + beam::pair_sag * p,
                             A = p / (3 * (1 - cot));
                const Mat3 turn = axis * axis.transpose(), by_S = b * (S - has.S) * turn, by_A = b * (A - has.A) * turn;
                const int at[] = {e.node[0], e.node[1], elements[i + 1].node[1]};
                add_rotations(to, at[0], at[0], by_S + by_A), add_rotations(to, at[2], at[2], by_S + by_A);
                add_rotations(to, at[1], at[1], 4 * by_A);
                add_rotations(to, at[0], at[2], by_A - by_S);
                add_rotations(to, at[0], at[1], -2 * by_A), add_rotations(to, at[1], at[2], -2 * by_A);
            }
        }
    }
    double softened(std::size_t element) const { return heat_of(state_.heat, int(element)).stiffness; }
    void add_rotations(Triplets& to, int a, int b, const Mat3& K) const {
        Mat6 block = Mat6::Zero();
        block.bottomRightCorner<3, 3>() = K;
        if (a == b) unknowns_.add(to, a, a, block);
        else unknowns_.add_between(to, a, b, block);
    }
    static constexpr int axial = 4;  ///< place of the axial force and of the stretch in p and d
    const Run& run_;
    State state_;
    FreeUnknowns unknowns_;
    std::vector<Vec6> forces_;
    Yielded yielded_;
};

/// Throws where moments change the factor by more than a thousandth: the symmetric part of the stiffness then has a
/// factor that the structure does not have.
void must_be_symmetric(LoadedStructure& loaded, double factor, const Eigen::VectorXd& x) {
    if (!(loaded.change_by_unsymmetric(factor, x) > 1e-3)) return;
    throw InputError(
        "moments whose axes stay as they are, or loads that turn with their member, make the stiffness unsymmetric, so "
        "that the structure may flutter and need not buckle; see how far statics goes (to_limit = true), and what a "
        "small push does in dynamics. Give a moment that another part would pass on as a pair of forces");
}

}  // namespace

BucklingModes buckling_modes(const Run& run, int count, double most, Yielded yielded) {
    constexpr double accuracy = 1e-7, together = 1e-6;  // of a factor; of those that are one multiple factor
    LoadedStructure loaded(run, yielded);
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
        if (run.has_unsymmetric_loads()) must_be_symmetric(loaded, below, x.col(0));
        for (int i = 0; i < multiple && int(modes.list.size()) < count; ++i)
            modes.list.push_back({0.5 * (below + above), loaded.shape(x.col(i))});
        known += multiple;
        below = above * (1 + together);
    }
    return modes;
}

}  // namespace hinge

#include "algebra/massless.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "algebra/effective_stiffness.h"
#include "state/node_mass.h"

namespace hinge {

bool may_be_massless(const Structure& structure) {
    for (const Element& e : structure.elements())
        if (!(e.rigidity.rhoA > 0)) return true;
    for (std::size_t n = 0; n < structure.model().nodes().size(); ++n)
        if (structure.hangs_on_joints(int(n))) return true;
    return false;
}

namespace {

/// Diagonal of what acts on a node itself, of elements alone: kg, kg m^2.
Vec6 of_elements(const Structure& structure, const State& state, int node) {
    Vec6 own = Vec6::Zero();
    for (const int index : structure.elements_at(node)) {
        if (state.broken[index]) continue;
        const beam::Inertia& m = inertia_now(structure, state, index);
        const int end = structure.elements()[index].node[0] == node ? 0 : 1;
        own.head<3>().array() += m.own[end];
        own.tail<3>().array() += m.rotary[end].sum();
    }
    return own;
}

bool has_offset(const State& state, int node) { return !state.offset_mass.empty() && state.offset_mass[node].mass > 0; }

/// The part of a rotation about which an offset mass has no inertia.
Mat3 without_inertia(const State& state, int node) {
    if (!has_offset(state, node)) return Mat3::Identity();
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(state.offset_mass[node].inertia);
    const double least = 1e-12 * axes.eigenvalues()[2];
    Mat3 none = Mat3::Zero();
    for (int i = 0; i < 3; ++i)
        if (!(axes.eigenvalues()[i] > least))
            none += axes.eigenvectors().col(i) * axes.eigenvectors().col(i).transpose();
    const Mat3 R = state.rotation[node].toRotationMatrix();
    return R * none * R.transpose();
}

}  // namespace

std::vector<MasslessNode> massless_nodes(const Structure& structure, const State& state, const Reduction* reduction) {
    std::vector<MasslessNode> list;
    if (!may_be_massless(structure)) return list;
    std::vector<Vec6> passed_on(reduction ? state.held.size() : 0, Vec6::Zero());
    if (reduction)
        for (const Reduction::Dependent& d : reduction->dependents()) {
            Mat6 M = of_elements(structure, state, d.node).asDiagonal();
            if (has_offset(state, d.node)) M += offset_mass_in_space(state.offset_mass[d.node], state.rotation[d.node]);
            for (const Reduction::Part& p : d.parts)
                passed_on[p.node] += (p.factors.transpose() * M * p.factors).diagonal();
        }
    for (int n = 0; n < int(state.held.size()); ++n) {
        if (state.gone[n]) continue;
        const bool joined = reduction && reduction->joins(n);
        const int still = state.held[n] | (reduction ? reduction->tied(n) : 0);
        Vec6 own = of_elements(structure, state, n);
        if (joined) own += passed_on[n];
        MasslessNode at{n, 0, Mat3::Zero()};
        for (int c = 0; c < 3; ++c)
            if (own[c] == 0 && !has_offset(state, n) && !(still >> c & 1)) at.translations |= std::uint8_t(1 << c);
        if (own.tail<3>().isZero(0)) at.rotations = without_inertia(state, n);
        else if (joined)
            for (int c = 0; c < 3; ++c)
                at.rotations(c, c) = own[3 + c] == 0 && without_inertia(state, n)(c, c) > 0.5 ? 1 : 0;
        for (int c = 0; c < 3; ++c)
            if (still >> (3 + c) & 1) at.rotations.row(c).setZero(), at.rotations.col(c).setZero();
        if (at.translations || at.has_rotations()) list.push_back(at);
    }
    return list;
}

State with_massless_held(const State& state, const std::vector<MasslessNode>& list) {
    State still = state;
    for (const MasslessNode& at : list) {
        still.held[at.node] |= at.translations;
        bool tilted = false;
        for (int c = 0; c < 3; ++c) {
            const double part = at.rotations(c, c);
            if (part > 1 - 1e-12) still.held[at.node] |= std::uint8_t(8 << c);
            else tilted = tilted || part > 0;
        }
        if (!tilted || !has_offset(state, at.node)) continue;
        Mat3& inertia = still.offset_mass[at.node].inertia;
        inertia += 1e-9 * inertia.trace() * Mat3::Identity();
    }
    return still;
}

void keep_massless(const std::vector<MasslessNode>& list, std::vector<Vec6>& of) {
    std::vector<Vec6> kept(of.size(), Vec6::Zero());
    for (const MasslessNode& at : list) {
        for (int c = 0; c < 3; ++c)
            if (at.translations >> c & 1) kept[at.node][c] = of[at.node][c];
        kept[at.node].tail<3>() = at.rotations * Vec3(of[at.node].tail<3>());
    }
    of = std::move(kept);
}

void take_out_massless(const std::vector<MasslessNode>& list, std::vector<Vec6>& of) {
    for (const MasslessNode& at : list) {
        for (int c = 0; c < 3; ++c)
            if (at.translations >> c & 1) of[at.node][c] = 0;
        of[at.node].tail<3>() -= at.rotations * Vec3(of[at.node].tail<3>());
    }
}

void settle_massless(const std::vector<MasslessNode>& list, const State& state, double dt,
                     const std::vector<Vec3>& rotation_step, Configuration& trial) {
    for (const MasslessNode& at : list) {
        const int n = at.node;
        Vec6 mean;
        mean << trial.displacement[n] - state.displacement[n], rotation_step[n];
        mean /= dt;
        const Vec6 rise = mean - (state.velocity[n] - 0.5 * dt * state.acceleration[n]), v = mean + 0.5 * rise,
                   a = rise / dt;
        for (int c = 0; c < 3; ++c)
            if (at.translations >> c & 1) trial.velocity[n][c] = v[c], trial.acceleration[n][c] = a[c];
        const auto put = [&](const Vec6& from, Vec6& to) {
            to.tail<3>() += at.rotations * Vec3(from.tail<3>() - to.tail<3>());
        };
        put(v, trial.velocity[n]);
        put(a, trial.acceleration[n]);
    }
}

void condense_velocities(const std::vector<MasslessNode>& list, const Structure& structure, const Reduction* reduction,
                         Blocks blocks, ThreadPool& pool, State& state) {
    const auto rests = [](const Vec6& v) { return v.isZero(0); };
    if (list.empty() || std::all_of(state.velocity.begin(), state.velocity.end(), rests)) return;
    EffectiveStiffness K(structure, pool, 0, 1, structure.large(), MatrixStorage::direct);
    K.set_reduction(reduction);
    std::vector<std::uint8_t> held(state.held.size(), 63);
    for (const MasslessNode& at : list) {
        held[at.node] &= std::uint8_t(~at.translations);
        for (int c = 0; c < 3; ++c)
            if (at.rotations(c, c) > 1 - 1e-12) held[at.node] &= std::uint8_t(~(8 << c));
    }
    K.set_held(held);
    std::vector<int> whole;
    for (int e = 0; e < int(state.broken.size()); ++e)
        if (!state.broken[e]) whole.push_back(e);
    const Configuration& pose = state;
    K.build(whole, state, pose, {});
    K.set_blocks(blocks);
    K.assemble();
    std::vector<Vec6> right(state.velocity.size(), Vec6::Zero()), change;
    K.subtract_stiffness(state.velocity, blocks, state, pose, right);
    for (std::size_t n = 0; n < right.size(); ++n)
        for (int c = 0; c < 6; ++c)
            if (held[n] >> c & 1) right[n][c] = 0;
    change.resize(right.size());
    SolverSettings direct;
    direct.direct = true;
    if (!K.solve(right, change, direct).converged) return;
    keep_massless(list, change);
    for (std::size_t n = 0; n < change.size(); ++n)
        if (change[n].allFinite()) state.velocity[n] += change[n];
}

}  // namespace hinge

#include "state/lone_elements.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace hinge {
namespace {

constexpr double inner_part = 0.75, inner_place = 1 / 3.0;  // Radau's point beside the pair's middle

/// Of a point mass at r from the node.
Mat6 point_mass(double mass, const Vec3& r) {
    return beam::offset_mass_matrix(mass, mass * r, mass * (r.squaredNorm() * Mat3::Identity() - r * r.transpose()));
}
Mat6 on_diagonal(double mass, double rotary) {
    Mat6 M = Mat6::Zero();
    M.diagonal() << Vec3::Constant(mass), Vec3::Constant(rotary);
    return M;
}
/// Rows: velocities of a point at r from the one whose velocity it is given.
Mat6 moved_by(const Vec3& r) {
    Mat6 T = Mat6::Identity();
    T.topRightCorner<3, 3>() = -skew(r);
    return T;
}
double energy(const Mat6& M, const Vec6& v) { return 0.5 * v.dot(M * v); }

Vec3 place_of(const Structure& structure, const State& state, int node) {
    return structure.position()[node] + state.displacement[node];
}

/// The offset mass of a lone element on its inner node, in that node's frame.
OffsetMass on_inner_node(const Element& e, const Vec3& arm) {
    const double mass = inner_part * e.mass();
    return {mass, mass * arm, mass * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose())};
}
void add_lone(State& state, const Element& e, int index, const Vec3& arm) {
    const OffsetMass more = on_inner_node(e, arm);
    OffsetMass& h = state.offset_mass[e.node[inner_end(index, e)]];
    h.mass += more.mass, h.moment += more.moment, h.inertia += more.inertia;
    state.offset_arm[index] = arm;
}
void remove_lone(State& state, const Element& e, int index) {
    const OffsetMass less = on_inner_node(e, state.offset_arm[index]);
    OffsetMass& h = state.offset_mass[e.node[inner_end(index, e)]];
    h.mass -= less.mass, h.moment -= less.moment, h.inertia -= less.inertia;
    if (!(h.mass > 1e-9 * less.mass)) h = {};  // rounding
    state.offset_arm[index].setZero();
}
void have_arrays(const Structure& structure, State& state) {
    if (state.offset_mass.empty()) state.offset_mass.assign(structure.position().size(), {});
    if (state.offset_arm.empty()) state.offset_arm.assign(structure.elements().size(), Vec3::Zero());
}

/// A pair whose nodes are outer, middle, outer: masses of its elements before and after they got new ones.
struct Pair {
    int element[2], node[3];
    Mat6 before[3], after[2][2];  ///< after: of each element at its outer and at its inner node
    Vec3 from_middle[3];
    Vec3 arm[2];
};

/// The arms keep the pair's centre also where it is bent, and `more` keeps its moment of inertia from becoming less.
Pair pair_of(const Structure& structure, const State& state, int broken) {
    const std::vector<Element>& elements = structure.elements();
    Pair p;
    p.element[0] = broken, p.element[1] = elements[broken].partner;
    double mass[2], rotary[2][2];
    Vec3 sum = Vec3::Zero();
    for (int i : {0, 1}) {
        const Element& e = elements[p.element[i]];
        const int inner = inner_end(p.element[i], e);
        p.node[2 * i] = e.node[1 - inner], p.node[1] = e.node[inner];
        mass[i] = e.mass();
        for (int end : {0, 1}) rotary[i][end] = e.inertia.rotary[end == 0 ? 1 - inner : inner].x();
    }
    for (int i : {0, 1, 2})
        p.from_middle[i] = place_of(structure, state, p.node[i]) - place_of(structure, state, p.node[1]);
    for (int i : {0, 1}) sum += mass[i] * p.from_middle[2 * i];
    Mat3 less = Mat3::Zero();  // of the moment of inertia about the middle
    p.before[1].setZero();
    for (int i : {0, 1}) {
        const Element& e = elements[p.element[i]];
        const int inner = inner_end(p.element[i], e);
        const Vec3& d = p.from_middle[2 * i];
        p.arm[i] = inner_place * d - 2.0 / 9 * sum / (mass[0] + mass[1]);
        p.before[2 * i] = on_diagonal(e.inertia.own[1 - inner], rotary[i][0]);
        p.before[1] += on_diagonal(e.inertia.own[inner], rotary[i][1]);
        p.after[i][0] = on_diagonal((1 - inner_part) * mass[i], rotary[i][0]);
        p.after[i][1] = point_mass(inner_part * mass[i], p.arm[i]) + on_diagonal(0, rotary[i][1]);
        less += point_mass(e.inertia.own[1 - inner] - (1 - inner_part) * mass[i], d).bottomRightCorner<3, 3>() -
                point_mass(inner_part * mass[i], p.arm[i]).bottomRightCorner<3, 3>();
    }
    const double most = Eigen::SelfAdjointEigenSolver<Mat3>(less, Eigen::EigenvaluesOnly).eigenvalues()[2];
    if (most > 0) p.after[0][1].bottomRightCorner<3, 3>() += most * Mat3::Identity();
    return p;
}

/// The velocities w that the new masses have.
std::array<Vec6, 3> velocities_of(const Pair& p, const std::array<Vec6, 3>& v) {
    const Mat6 after[3] = {p.after[0][0], p.after[0][1] + p.after[1][1], p.after[1][0]};
    Mat6 whole_before = Mat6::Zero(), whole_after = whole_before;
    Vec6 momentum = Vec6::Zero();
    Mat6 T[3];
    for (int i : {0, 1, 2}) {
        T[i] = moved_by(p.from_middle[i]);
        whole_before += T[i].transpose() * p.before[i] * T[i];
        whole_after += T[i].transpose() * after[i] * T[i];
        momentum += T[i].transpose() * (p.before[i] * v[i]);
    }
    const Vec6 rigid_before = whole_before.ldlt().solve(momentum), rigid_after = whole_after.ldlt().solve(momentum);
    std::array<Vec6, 3> w;
    double had = 0, has = 0;
    for (int i : {0, 1, 2}) {
        const Vec6 beside = v[i] - T[i] * rigid_before;
        const Vec6 passed = p.before[i] * beside;
        w[i] = after[i].ldlt().solve(passed);
        had += 0.5 * beside.dot(passed), has += 0.5 * w[i].dot(passed);
    }
    const double s = has > had ? std::sqrt(std::max(0.0, had) / has) : 1;
    for (int i : {0, 1, 2}) w[i] = T[i] * rigid_after + s * w[i];
    return w;
}

LooseElement loosen_pair(const Structure& structure, State& state, int index, std::vector<Vec6>& impulse) {
    const Pair p = pair_of(structure, state, index);
    std::array<Vec6, 3> v;
    for (int i : {0, 1, 2}) v[i] = state.velocity[p.node[i]];
    const std::array<Vec6, 3> w = velocities_of(p, v);
    LooseElement of;
    of.kinetic = of.left_kinetic = 0;
    for (int i : {0, 1, 2}) of.kinetic += energy(p.before[i], v[i]);
    for (int i : {0, 1}) {  // the partner, at its outer and its inner node
        const int at = 2 - i;
        of.left_kinetic += energy(p.after[1][i], v[at]);
        impulse[p.node[at]] += p.after[1][i] * (w[at] - v[at]);
    }
    const std::vector<Element>& elements = structure.elements();
    const int inner = inner_end(index, elements[index]), partner = p.element[1];
    for (int i : {0, 1}) {
        const int end = i == 0 ? 1 - inner : inner;
        of.mass[end] = p.after[0][i], of.velocity[end] = w[i];
    }
    add_lone(state, elements[partner], partner, state.rotation[p.node[1]].conjugate() * p.arm[1]);
    return of;
}

}  // namespace

Mat6 lone_mass(const Element& e, const Vec3& arm) { return point_mass(inner_part * e.mass(), arm); }

LooseElement loosen(const Structure& structure, State& state, int index, std::vector<Vec6>& impulse) {
    have_arrays(structure, state);
    const Element& e = structure.elements()[index];
    if (e.partner >= 0 && !state.broken[e.partner]) return loosen_pair(structure, state, index, impulse);
    LooseElement of;
    const bool lone = is_lone(structure, state, index);
    const beam::Inertia& m = inertia_now(structure, state, index);
    of.kinetic = of.left_kinetic = 0;
    for (int end : {0, 1}) {
        of.mass[end] = on_diagonal(m.own[end], m.rotary[end].x());
        of.velocity[end] = state.velocity[e.node[end]];
    }
    if (lone) {
        const int inner = inner_end(index, e);
        of.mass[inner] += lone_mass(e, state.rotation[e.node[inner]] * state.offset_arm[index]);
        remove_lone(state, e, index);
    }
    for (int end : {0, 1}) of.kinetic += energy(of.mass[end], of.velocity[end]);
    return of;
}

State with_lone_elements(const Structure& structure, State state) {
    if (state.offset_arm.empty()) return state;
    for (int i = 0; i < int(structure.elements().size()); ++i) {
        const Element& e = structure.elements()[i];
        if (e.partner < 0 || state.broken[i] || !state.broken[e.partner]) continue;
        const bool has = !state.offset_arm[i].isZero(0);
        if (has == structure.lumped()) continue;
        if (has) {
            remove_lone(state, e, i);
            continue;
        }
        const int inner = inner_end(i, e);
        const Vec3 span = place_of(structure, state, e.node[1 - inner]) - place_of(structure, state, e.node[inner]);
        add_lone(state, e, i, state.rotation[e.node[inner]].conjugate() * (inner_place * span));
    }
    return state;
}

}  // namespace hinge

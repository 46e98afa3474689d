#include "effects/member_weights.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "beam/pair_bow.h"
#include "effects/joined_bodies.h"
#include "state/hinges.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

/// In the order in which Eigen adds up.
[[gnu::always_inline]] inline Lanes dot(const Lanes (&a)[3], const Lanes (&b)[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
[[gnu::always_inline]] inline Lanes dot(const Lanes (&a)[3], const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Adds y, rotated by these nodes' quaternions.
void add_rotated(const std::vector<Quat>& rotation, const int* node, const Lanes* y, Lanes (&to)[3]) {
    Lanes q[lane_count];  // x y z w
    pick_rows<4>(rotation.data()->coeffs().data(), node, 4, q);
    Lanes across[3];
    for (int i : {0, 1, 2}) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        across[i] = q[j] * y[k] - q[k] * y[j];
        across[i] += across[i];
    }
    for (int i : {0, 1, 2}) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        to[i] += y[i] + q[3] * across[i] + (q[j] * across[k] - q[k] * across[j]);
    }
}

/// Carried elements with lumped mass have half of their weight on each node (EvenWeights).
double weight_of(const Structure& s, int element, int end) {
    return s.lumped() ? 0.5 * s.elements()[element].mass() : s.inertia(element).weight(end);
}

}  // namespace

MemberWeights::MemberWeights(const Structure& s) {
    std::map<std::tuple<const void*, double, int>, int> known;  // members that are alike
    for (const auto& [first, end] : elements_of_members(s)) {
        const Element& e = s.elements()[first];
        ends_.push_back({first, end - first});
        const auto [at, is_new] = known.try_emplace({&e.rigidity, e.length, end - first}, int(kinds_.size()));
        if (is_new) kinds_.push_back(kind_of(s, ends_.back()));
        kind_.push_back(at->second);
    }
}

MemberWeights::Kind MemberWeights::kind_of(const Structure& s, const MemberEnds& ends) {
    const int n = ends.count;
    const Element& e = s.elements()[ends.first];
    const double length = n * e.length, per_length = e.rigidity.rhoA;
    const ClampedMember clamped(s, ends.first, ends.first + n);
    std::vector<double> at_node(n + 1, 0.0);
    for (int i = 0; i < n; ++i)
        for (int end : {0, 1}) at_node[i + end] += weight_of(s, ends.first + i, end);
    Kind kind;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k)
            kind.c += gauss_weight[k] * e.length * per_length * clamped.of_force(0, 0, (i + gauss_point[k]) / n);
    for (int k = 0; k <= n; ++k) kind.c -= at_node[k] * clamped.arrives(k, 1, 3);
    kind.bow.assign(n + 1, 0.0);
    for (int k = 1; k < n; ++k) {
        const double z = k * e.length;
        kind.bow[k] = 0.5 * per_length * z * (length - z);
        for (int j = 1; j < n; ++j) kind.bow[k] -= at_node[j] * std::min(j, k) * (n - std::max(j, k)) * e.length / n;
    }
    for (int i = 0; i < n; ++i) {
        const double weights[2] = {weight_of(s, ends.first + i, 0), weight_of(s, ends.first + i, 1)};
        const double first = kind.c + kind.bow[i], second = kind.c + kind.bow[i + 1];
        kind.by_gravity.push_back({{-first, second, first, -second}, {weights[0], -weights[1]}, {0, 0}});
    }
    return kind;
}

bool MemberWeights::carries_itself(const Structure& s, const Vec3& g, int member) const {
    const MemberEnds& ends = ends_[member];
    const Element& e = s.elements()[ends.first];
    const double length = ends.count * e.length;
    const Vec3 m = e.rigidity.rhoA * length * length / 16 * (e.axes.conjugate() * g);
    return e.yield.x * m.y() * m.y() + e.yield.y * m.x() * m.x() <= 1;
}

void MemberWeights::choose(const Structure& s, const std::vector<int>& members) {
    chosen_.assign(ends_.size(), 0);
    blocks_.clear();
    joints_.clear();
    others_.clear();
    std::vector<int> place(s.position().size(), -1);
    const int rows = (int(members.size()) + lane_count - 1) / lane_count * lane_count;
    for (int row = 0; row < rows; ++row) {
        const int m = members[std::min(row, int(members.size()) - 1)], i = row % lane_count;
        if (i == 0) blocks_.emplace_back();
        Block& block = blocks_.back();
        if (row < int(members.size())) block.count = i + 1;
        chosen_[m] = 1;
        const MemberEnds& ends = ends_[m];
        const Element &a = s.elements()[ends.first], &b = s.elements()[ends.first + ends.count - 1];
        block.member[i] = m;
        block.node[0][i] = a.node[0], block.node[1][i] = b.node[1];
        for (int end : {0, 1}) {
            const int node = block.node[end][i];
            int& at = place[node];
            if (at < 0) at = int(joints_.size()), joints_.push_back(node);
            block.joint[end][i] = at;
        }
        const Vec3 span = double(ends.count) * a.chord;
        const Vec3 y = a.axes * Vec3::UnitY();
        for (int c : {0, 1, 2}) block.span[c][i] = span[c], block.y[c][i] = y[c];
        block.c[i] = kinds_[kind_[m]].c;
        block.first[i] = ends.first;
        block.pairs[i] = s.p_delta() && a.partner == ends.first + 1 && a.forms_pairs ? ends.count / 2 : 0;
        block.most_pairs = std::max(i == 0 ? 0 : block.most_pairs, block.pairs[i]);
        const beam::PairKind<double> kind = beam::pair_kind(a.rigidity, a.length);
        for (int plane : {0, 1}) {
            block.flexible[plane][i] = kind.c[plane];
            beam::put(block.shear[plane], i, kind.shear[plane]);
        }
        block.of_pair[i] = a.rigidity.rhoA * a.length * a.length;
        block.a_pair[i] = block.of_pair[i] / 3 / std::max(1, block.pairs[i]);
    }
    axes_.assign(s.p_delta() ? blocks_.size() : 0, {});
    for (int i = 0; i < int(s.elements().size()); ++i)
        if (!chosen_[s.elements()[i].member]) others_.push_back(i);
}

/// And its length.
Lanes MemberWeights::find_span(const Block& b, bool large, const Pose& at, Lanes (&span)[3]) const {
    for (int c : {0, 1, 2}) span[c] = b.span[c];
    if (large) {
        Lanes u[2][lane_count];
        for (int end : {0, 1}) pick_rows<3>(at.displacement.data()->data(), b.node[end], 3, u[end]);
        for (int c : {0, 1, 2}) span[c] += u[1][c] - u[0][c];
    }
    return square_root(dot(span, span));
}

Vec3 MemberWeights::moment_by_N(const Structure& s, const Vec3& local, const std::vector<Vec6>& force,
                                const ElementHeats& heat, int member) const {
    Vec3 sum = Vec3::Zero();
    const MemberEnds& ends = ends_[member];
    if (!s.p_delta()) return sum;
    const double mass = s.elements()[ends.first].rigidity.rhoA;
    for (int i = 0; i < ends.count; i += 2) {
        const PressedPair pair(s, ends.first + i, force, heat);
        for (int plane : {0, 1}) sum[plane] += pair.of_even(plane, mass * local[1 - plane]);
    }
    return 2.0 / ends.count * sum;
}

Vec3 MemberWeights::middle_by_N(const Structure& s, const Vec3& local, const std::vector<Vec6>& force,
                                const ElementHeats& heat, int element) const {
    Vec3 m = Vec3::Zero();
    const Element& e = s.elements()[element];
    if (!s.p_delta() || e.partner < 0) return m;
    const PressedPair pair(s, std::min(element, e.partner), force, heat);
    for (int plane : {0, 1}) m[plane] = pair.middle_of_spread(plane, e.rigidity.rhoA * local[1 - plane]);
    return m;
}

Lanes MemberWeights::force_of_pairs(const Block& b, int k, const std::vector<Vec6>& force, const ElementHeats& heat) {
    Lanes N = {};
    for (int i = 0; i < lane_count; ++i) {
        if (k >= b.pairs[i]) continue;
        const Vec6* p = &force[b.first[i] + 2 * k];
        N[i] = 0.5 * (p[0][4] + p[1][4]) / heat_of(heat, b.first[i] + 2 * k).stiffness;
    }
    return N - N == 0 ? N : Lanes{};  // a step that has failed
}

/// Calls visit(k, plane, p) for the k-th pairs of its members where any is pressed or drawn enough to count.
template <class Visit>
bool MemberWeights::visit_pressed(const Block& b, const std::vector<Vec6>& force, const ElementHeats& heat,
                                  Visit visit) const {
    bool any = false;
    for (int k = 0; k < b.most_pairs && !force.empty(); ++k) {
        const Lanes N = force_of_pairs(b, k, force, heat);
        for (int plane : {0, 1}) {
            const Lanes p = beam::softened_by_shear<Lanes>(-b.flexible[plane] * N, b.shear[plane]);
            if (!any_above(p < 0 ? -p : p, counts_from)) continue;
            any = true;
            visit(k, plane, counted(p));
        }
    }
    return any;
}

Lanes MemberWeights::end_by_N(const Block& b, int plane, const Lanes& p) {
    const Lanes whole = 1 / beam::stability_functions(p).A,
                m = b.a_pair * (whole - 1 + b.shear[plane].flexible * p * (whole - 3 * beam::arm_of_pair));
    return plane == 0 ? -m : m;
}

void MemberWeights::add_middle(const Block& b, int k, int plane, const Lanes& p, const Lanes& across,
                               std::vector<beam::FixedEnd>& all) {
    const Lanes m = b.of_pair * (1 + b.shear[plane].flexible * p) * (beam::bow_functions(p).share - 0.5) * across;
    for (int i = 0; i < b.count; ++i) {
        if (k >= b.pairs[i]) continue;
        beam::FixedEnd* pair = &all[b.first[i] + 2 * k];
        pair[0].moment[2 * plane + 1] += m[i];
        pair[1].moment[2 * plane] -= m[i];
    }
}

bool MemberWeights::find_by_N(const Block& b, const std::vector<Vec6>& force, const ElementHeats& heat,
                              Lanes (&of)[2]) const {
    of[0] = of[1] = Lanes{};
    return visit_pressed(b, force, heat, [&](int, int plane, const Lanes& p) { of[plane] += end_by_N(b, plane, p); });
}

void MemberWeights::find_moments(const Structure& s, const Vec3& g, const Pose& at, const std::vector<Vec6>& force,
                                 bool placed, std::vector<Vec3>& out) const {
    out.assign(joints_.size(), Vec3::Zero());
    const auto put = [&](const Block& b, const Lanes(&m)[3]) {
        for (int i = 0; i < b.count; ++i) {
            const Vec3 of(m[0][i], m[1][i], m[2][i]);
            out[b.joint[0][i]] += of;
            out[b.joint[1][i]] -= of;
        }
    };
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const Block& b = blocks_[i];
        if (b.most_pairs == 0) {
            Lanes span[3];
            const Lanes k = b.c / find_span(b, s.large(), at, span);
            put(b, {k * (g.y() * span[2] - g.z() * span[1]), k * (g.z() * span[0] - g.x() * span[2]),
                    k * (g.x() * span[1] - g.y() * span[0])});
            continue;
        }
        if (!placed) find_axes(s, b, at, axes_[i]);
        const auto& [x, y, z] = axes_[i].axis;
        Lanes local[3], by_N[2];
        axes_[i].to_members(g, local);
        find_by_N(b, force, at.heat, by_N);
        const Lanes mx = (b.c + by_N[0]) * local[1], my = (by_N[1] - b.c) * local[0];
        put(b, {mx * x[0] + my * y[0], mx * x[1] + my * y[1], mx * x[2] + my * y[2]});
    }
}

void MemberWeights::Axes::to_members(const Vec3& v, Lanes (&components)[3]) const {
    for (int c : {0, 1, 2}) components[c] = dot(axis[c], v);
}

void MemberWeights::find_axes(const Structure& s, const Block& b, const Pose& at, Axes& axes) const {
    const auto one_by_one = [&](const Lanes& size) {
        for (int i = 0; i < lane_count; ++i) {
            if (size[i] > 0.1) continue;
            const Mat3 of = ends_[b.member[i]].axes(s, at);
            for (int axis : {0, 1, 2})
                for (int c : {0, 1, 2}) axes.axis[axis][c][i] = of(c, axis);
        }
    };
    if (!s.large()) return one_by_one(Lanes{});
    auto& [x, y, z] = axes.axis;
    const Lanes length = find_span(b, true, at, z);
    for (int c : {0, 1, 2}) z[c] /= length, y[c] = Lanes{};
    for (int end : {0, 1}) add_rotated(at.rotation, b.node[end], b.y, y);
    const Lanes along = dot(z, y);
    for (int c : {0, 1, 2}) y[c] -= along * z[c];
    const Lanes size = square_root(dot(y, y));
    for (Lanes& c : y) c /= size;
    for (int c : {0, 1, 2}) x[c] = y[(c + 1) % 3] * z[(c + 2) % 3] - y[(c + 2) % 3] * z[(c + 1) % 3];
    if (any_not_below(-size, -0.1)) one_by_one(size);  // ends that point apart
}

beam::FixedEnd MemberWeights::fixed_end(const Structure& s, const Vec3& g, const Pose& at,
                                        const std::vector<Vec6>& force, int element) const {
    const int member = s.elements()[element].member;
    const MemberEnds& ends = ends_[member];
    const Vec3 local = ends.axes(s, at).transpose() * g;
    beam::FixedEnd part = kinds_[kind_[member]].by_gravity[element - ends.first];
    for (int i : {0, 1}) part.moment[i] *= local.y(), part.moment[2 + i] *= local.x(), part.N[i] *= local.z();
    const Vec3 more = moment_by_N(s, local, force, at.heat, member);
    for (int end : {0, 1}) part.add(end, more.x(), more.y(), 0, 0);
    const Vec3 middle = middle_by_N(s, local, force, at.heat, element);
    part.add((element - ends.first) % 2 == 0 ? 1 : 0, middle.x(), middle.y(), 0, 0);
    return part;
}

void MemberWeights::add_fixed_ends(const Structure& s, ThreadPool& pool, const Vec3& g, const Pose& at,
                                   const std::vector<Vec6>& force, bool anew, std::vector<beam::FixedEnd>& all) const {
    static_assert(sizeof(beam::FixedEnd) == sizeof(Lanes));
    if (anew)
        for (const int i : others_) all[i] = {};
    pool.share(int(blocks_.size()), 16, [&](int first, int end, int) {
        for (int block = first; block < end; ++block) {
            const Block& b = blocks_[block];
            Axes here;
            Axes& axes = axes_.empty() ? here : axes_[block];
            find_axes(s, b, at, axes);
            Lanes local[3], by_N[2];
            axes.to_members(g, local);
            const Lanes components[lane_count] = {local[1], local[1], local[0], local[0], local[2], local[2], {}, {}};
            Lanes of[lane_count], more[lane_count];  // each member's own, in the places of FixedEnd
            transpose(components, of);
            for (int i = 0; i < b.count; ++i) {
                const Kind& kind = kinds_[kind_[b.member[i]]];
                const LanesAnywhere* by_gravity = reinterpret_cast<const LanesAnywhere*>(kind.by_gravity.data());
                LanesAnywhere* to = reinterpret_cast<LanesAnywhere*>(&all[b.first[i]]);
                for (std::size_t k = 0; k < kind.by_gravity.size(); ++k) {
                    const Lanes part = by_gravity[k] * of[i];
                    to[k] = anew ? part : to[k] + part;
                }
            }
            by_N[0] = by_N[1] = Lanes{};
            const bool pressed = visit_pressed(b, force, at.heat, [&](int k, int plane, const Lanes& p) {
                by_N[plane] += end_by_N(b, plane, p);
                add_middle(b, k, plane, p, plane == 0 ? local[1] : -local[0], all);
            });
            if (!pressed) continue;
            const Lanes mx = by_N[0] * local[1], my = by_N[1] * local[0];
            const Lanes parts[lane_count] = {-mx, mx, -my, my};
            transpose(parts, more);
            for (int i = 0; i < b.count; ++i) {
                LanesAnywhere* to = reinterpret_cast<LanesAnywhere*>(&all[b.first[i]]);
                for (int k = 0; k < ends_[b.member[i]].count; ++k) to[k] += more[i];
            }
        }
    });
}

void MemberWeights::add_section_forces(const Structure& s, const State& state, const Vec3& g, int element, double side,
                                       SectionForces& forces) const {
    const int member = s.elements()[element].member, end = side < 0 ? 0 : 1;
    const MemberEnds& ends = ends_[member];
    const Mat3 to_local = axes_of(element_frame(s, element, state)).transpose();
    add_share(side, weight_of(s, element, end) * (to_local * g), Vec3::Zero(), forces);
    const MemberEnds::Chord chord = ends.chord(s, state);
    const Kind& kind = kinds_[kind_[member]];
    const double bow = kind.bow[element - ends.first + end], gx = chord.axes.col(0).dot(g),
                 gy = chord.axes.col(1).dot(g);
    forces.Mx += bow * gy, forces.My -= bow * gx;
    const Vec3 first(kind.c * gy, -kind.c * gx, 0), m[2] = {first, -first};
    ends.add_section_forces(element, end, chord.span.norm(), m, forces);
    const Vec3 local = ends.axes(s, state).transpose() * g,
               more = moment_by_N(s, local, state.force, state.heat, member);
    forces.Mx += more.x(), forces.My += more.y();
    if (((element - ends.first) % 2 == 0) != (end == 1)) return;
    const Vec3 middle = middle_by_N(s, local, state.force, state.heat, element);
    forces.Mx += middle.x(), forces.My += middle.y();
}

void EvenWeights::find(const Structure& s, const State& state, const Vec3& g) {
    if (!s.lumped()) return;
    more_.assign(s.position().size(), 0);
    const Bodies bodies = find_bodies(s, state);
    const std::vector<char> carried = carried_bodies(s, state, bodies, g);
    for (int i = 0; i < int(s.elements().size()); ++i) {
        const Element& e = s.elements()[i];
        const int body = bodies.of_node[e.node[0]];
        if (body < 0 || !carried[body] || state.broken[i] || is_lone(s, state, i)) continue;
        for (int end : {0, 1}) more_[e.node[end]] += weight_of(s, i, end) - e.inertia.own[end];
    }
}

std::vector<char> carried_members(const Structure& s, const State& state, const MemberWeights& weights, const Vec3& g) {
    const Bodies bodies = find_bodies(s, state);
    const std::vector<char> carried = carried_bodies(s, state, bodies, g);
    std::vector<char> of(weights.count(), 0);
    for (int m = 0; m < weights.count(); ++m) {
        const MemberEnds& ends = weights.ends(m);
        const int body = bodies.of_node[s.elements()[ends.first].node[0]];
        of[m] = body >= 0 && carried[body] && ends.whole(state);
    }
    return of;
}

}  // namespace hinge

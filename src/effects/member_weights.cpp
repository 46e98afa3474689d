#include "effects/member_weights.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "effects/connectors.h"

namespace hinge {

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
        for (int end : {0, 1}) at_node[i + end] += s.inertia(ends.first + i).weight(end);
    Kind kind;
    for (int i = 0; i < n; ++i)
        for (int end : {0, 1}) kind.share.push_back(s.inertia(ends.first + i).weight(end));
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
    list_.clear();
    joints_.clear();
    std::vector<int> place(s.position().size(), -1);
    for (const int m : members) {
        chosen_[m] = 1;
        const MemberEnds& ends = ends_[m];
        const Element &a = s.elements()[ends.first], &b = s.elements()[ends.first + ends.count - 1];
        Chosen c{m, {a.node[0], b.node[1]}, {}, double(ends.count) * a.chord, kinds_[kind_[m]].c};
        for (int end : {0, 1}) {
            int& at = place[c.node[end]];
            if (at < 0) at = int(joints_.size()), joints_.push_back(c.node[end]);
            c.joint[end] = at;
        }
        list_.push_back(c);
    }
}

void MemberWeights::find_moments(const Structure& s, const Vec3& g, const Places& at, std::vector<Vec3>& out) const {
    out.assign(joints_.size(), Vec3::Zero());
    const bool large = s.large();
    for (const Chosen& c : list_) {
        Vec3 span = c.span;
        if (large) span += at.displacement[c.node[1]] - at.displacement[c.node[0]];
        const Vec3 m = (c.c / span.norm()) * g.cross(span);
        out[c.joint[0]] += m;
        out[c.joint[1]] -= m;
    }
}

/// `g`: in the member's axes.
void MemberWeights::add_fixed_end(const Kind& kind, int place, const Vec3& g, beam::FixedEnd& to) {
    for (int end : {0, 1}) {
        const double moment = kind.c + kind.bow[place + end], share = kind.share[2 * place + end];
        to.add(end, moment * g.y(), -moment * g.x(), end == 0 ? share * g.z() : -share * g.z(), 0);
    }
}

beam::FixedEnd MemberWeights::fixed_end(const Structure& s, const Vec3& g, const Places& at, int element) const {
    const int member = s.elements()[element].member;
    const MemberEnds& ends = ends_[member];
    beam::FixedEnd part;
    add_fixed_end(kinds_[kind_[member]], element - ends.first, ends.axes(s, at).transpose() * g, part);
    return part;
}

void MemberWeights::add_fixed_ends(const Structure& s, ThreadPool& pool, const Vec3& g, const Places& at,
                                   std::vector<beam::FixedEnd>& all) const {
    pool.share(int(list_.size()), 64, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            const MemberEnds& ends = ends_[list_[i].member];
            const Vec3 local = ends.axes(s, at).transpose() * g;
            const Kind& kind = kinds_[kind_[list_[i].member]];
            for (int k = 0; k < ends.count; ++k) add_fixed_end(kind, k, local, all[ends.first + k]);
        }
    });
}

void MemberWeights::add_section_forces(const Structure& s, const State& state, const Vec3& g, int element, double side,
                                       SectionForces& forces) const {
    const int member = s.elements()[element].member, end = side < 0 ? 0 : 1;
    const MemberEnds& ends = ends_[member];
    const Mat3 to_local = axes_of(place_element(s, element, state)).transpose();
    add_share(side, s.inertia(element).weight(end) * (to_local * g), Vec3::Zero(), forces);
    const MemberEnds::Chord chord = ends.chord(s, state);
    const Kind& kind = kinds_[kind_[member]];
    const double bow = kind.bow[element - ends.first + end], gx = chord.axes.col(0).dot(g),
                 gy = chord.axes.col(1).dot(g);
    forces.Mx += bow * gy, forces.My -= bow * gx;
    const Vec3 first(kind.c * gy, -kind.c * gx, 0), m[2] = {first, -first};
    ends.add_section_forces(element, end, chord.span.norm(), m, forces);
}

std::vector<char> carried_members(const Structure& s, const State& state, const MemberWeights& weights, const Vec3& g) {
    const Bodies bodies = find_bodies(s, state);
    std::vector<char> carried(bodies.count, 0);
    for (std::size_t n = 0; n < bodies.of_node.size(); ++n)
        for (int c : {0, 1, 2})
            if (bodies.of_node[n] >= 0 && g[c] != 0 && state.held[n] >> c & 1) carried[bodies.of_node[n]] = 1;
    const auto& connectors = s.model().declared<Connector>(connectors_effect);
    for (bool more = true; more;) {
        more = false;
        for (const Connector& joint : connectors) {
            // a node without elements carries where it is held
            const auto carries = [&](int node) {
                return node < 0 ||
                       (bodies.of_node[node] >= 0 ? carried[bodies.of_node[node]] != 0 : state.held[node] != 0);
            };
            for (const auto& [by, what] : {std::pair{joint.a, joint.b}, std::pair{joint.b, joint.a}}) {
                if (what < 0 || bodies.of_node[what] < 0 || carried[bodies.of_node[what]] || !carries(by)) continue;
                carried[bodies.of_node[what]] = 1;
                more = true;
            }
        }
    }
    std::vector<char> of(weights.count(), 0);
    for (int m = 0; m < weights.count(); ++m) {
        const MemberEnds& ends = weights.ends(m);
        const int body = bodies.of_node[s.elements()[ends.first].node[0]];
        of[m] = body >= 0 && carried[body] && ends.whole(state);
    }
    return of;
}

}  // namespace hinge

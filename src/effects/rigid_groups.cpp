#include "effects/rigid_groups.h"

#include <algorithm>

#include "core/errors.h"
#include "core/rotation.h"
#include "effects/all_effects.h"
#include "effects/declared.h"
#include "effects/settlement.h"
#include "model/member_ends.h"
#include "state/node_mass.h"

namespace hinge {

RigidGroups::RigidGroups(const char* name, const char* call, std::vector<RigidGroup> groups, Workspace& w, Host& host)
    : Effect(name, w, host), call_(call), declared_(std::move(groups)) {
    for (const RigidGroup& group : declared_) refuse(group);
    find_bodies();
}

/// Nodes that nothing moves, those that a support moves along a path, and ball joints on an arm that may lose its node.
void RigidGroups::refuse(const RigidGroup& group) const {
    std::vector<int> nodes{group.first};
    for (const RigidGroup::Follower& f : group.followers) nodes.push_back(f.node);
    for (const int n : nodes) {
        if (w_.structure.is_alone(n) && !has_member_at(w_.structure.model(), n))
            throw InputError(call_ + (": " + w_.structure.node_name(n)) +
                             " has no member, so that it has neither stiffness nor mass; join nodes of members");
        if (w_.structure.has_panels_alone(n))
            throw InputError(call_ + (": panels alone join " + w_.structure.node_name(n)) +
                             ", so that it has no rotation of its own; join nodes of members");
        for (const DeclaredLoad& load : declared_loads(w_.structure.model()))
            if (load.motion && load.node == n && w_.kind.dynamic)
                throw InputError(call_ + (": " + w_.structure.node_name(n)) +
                                 " is moved by model:move; that does not go together yet: move a node that is not "
                                 "joined");
    }
    const auto balls =
        std::count_if(group.followers.begin(), group.followers.end(), [](const auto& f) { return f.tied == 7; });
    if (!w_.kind.dynamic || balls == 0 || nodes.size() == 2) return;
    for (const int e : w_.structure.elements_at(group.first))
        if (may_break(w_.structure.model(), w_.kind, w_.structure.elements()[e].member))
            throw InputError(call_ + (": " + w_.structure.element_name(e)) + " can break at " +
                             w_.structure.node_name(group.first) +
                             ", from which links with dofs = 'xyz' and others begin; that does not go together yet: "
                             "give the member a group without fracture");
}

/// Of the nodes that have members left. The first one is followed by the others, or by what follows it in full.
RigidGroup RigidGroups::without_gone(RigidGroup group) const {
    const auto gone = [&](int node) { return w_.state.gone[node] && !w_.structure.is_alone(node); };  // no support
    const auto is_gone = [&](const RigidGroup::Follower& f) { return gone(f.node); };
    group.followers.erase(std::remove_if(group.followers.begin(), group.followers.end(), is_gone),
                          group.followers.end());
    if (!gone(group.first)) return with_held(std::move(group));
    const auto next = std::find_if(group.followers.begin(), group.followers.end(),
                                   [&](const RigidGroup::Follower& f) { return group.normal >= 0 || f.tied == 63; });
    if (next == group.followers.end()) return group.followers.clear(), group;
    group.first = next->node;
    group.followers.erase(next);
    return with_held(std::move(group));
}

RigidGroup RigidGroups::with_held(RigidGroup group) const {
    for (RigidGroup::Follower& f : group.followers) f.held = held_at_both(group, f);
    return group;
}

/// A component that a support holds at a node agrees with the constraint if supports hold all on which it depends at
/// the first node, and do not settle.
std::uint8_t RigidGroups::held_at_both(const RigidGroup& group, const RigidGroup::Follower& f) const {
    const std::vector<std::uint8_t>& fixed = w_.structure.fixed();
    std::uint8_t still = fixed[group.first], both = 0;
    for (const Settlement& s : w_.structure.model().declared<Settlement>(settlement_effect))
        if (s.node == group.first && s.by != 0) still &= std::uint8_t(~(1 << s.component));
    const Vec3 arm = w_.structure.position()[f.node] - w_.structure.position()[group.first];
    for (int c = 0; c < 6; ++c) {
        bool agrees = (f.tied & fixed[f.node] & still) >> c & 1;
        for (int k = 0; c < 3 && k < 3; ++k) {  // an arm that rotates has other levers later
            const bool turns = group.normal < 0 || k == group.normal,
                       moves = w_.structure.large() ? k != c && !arm.isZero(0) : Vec3::Unit(k).cross(arm)[c] != 0;
            if (turns && moves && !(still >> (3 + k) & 1)) agrees = false;
        }
        if (agrees) both |= std::uint8_t(1 << c);
    }
    return both;
}

void RigidGroups::find_bodies() {
    std::vector<double> mass(w_.state.displacement.size(), 0);
    for_each_weight(w_.structure, w_.state, [&](int node, double kg) { mass[node] += kg; });
    for (std::size_t n = 0; n < w_.state.offset_mass.size(); ++n) mass[n] += w_.state.offset_mass[n].mass;
    bodies_.clear();
    for (const RigidGroup& group : declared_)
        if (RigidGroup left = without_gone(group); !left.followers.empty())
            bodies_.push_back(weigh(std::move(left), mass));
}

RigidGroups::Body RigidGroups::weigh(RigidGroup group, const std::vector<double>& mass) const {
    Body body{std::move(group), {}, false};
    body.nodes.push_back({body.group.first, 0, 0, 0});
    for (const RigidGroup::Follower& f : body.group.followers) body.nodes.push_back({f.node, 0, f.tied, f.held});
    double sum = 0;
    for (const Weighed& n : body.nodes) sum += mass[n.node];
    std::uint8_t in_plane = 7;
    if (body.group.normal >= 0) in_plane &= std::uint8_t(~(1 << body.group.normal));
    body.about_first = !w_.kind.dynamic || !(sum > 0) || (w_.state.held[body.group.first] & in_plane);
    if (body.about_first) body.nodes[0].part = 1;
    else
        for (Weighed& n : body.nodes) n.part = mass[n.node] / sum;
    return body;
}

/// Masses at nodes have changed, and a node may be gone.
void RigidGroups::broke(const Break&) { find_bodies(); }

bool RigidGroups::restored(std::span<const State* const>) { return find_bodies(), true; }

/// Small displacement: as declared.
Vec3 RigidGroups::place_of(int node, const Pose& at) const {
    return w_.structure.large() ? Vec3(w_.structure.position()[node] + at.displacement[node])
                                : w_.structure.position()[node];
}

template <class Of>
Vec3 RigidGroups::mean(const Body& body, Of of) const {
    if (body.about_first) return body.in_plane(of(body.nodes[0].node));
    Vec3 sum = Vec3::Zero();
    for (const Weighed& n : body.nodes) sum += n.part * of(n.node);
    return body.in_plane(sum);
}

/// set(node, r) for each node that is placed by the reference point.
template <class Set>
void RigidGroups::for_arms(const Body& body, const Pose& at, Set set) const {
    const Vec3 centre = mean(body, [&](int n) { return place_of(n, at); });
    for (const Weighed& n : body.nodes)
        if (n.tied || !body.about_first) set(n, Vec3(body.in_plane(place_of(n.node, at)) - centre));
}

/// u' = u + w x arm, w' = w.
void RigidGroups::add_constraints(const Pose& at, std::vector<LinearConstraint>& list) const {
    for (const Body& body : bodies_) {
        const int first = body.group.first;
        for (const RigidGroup::Follower& f : body.group.followers) {
            const Vec3 arm = body.in_plane(place_of(f.node, at) - place_of(first, at));
            for (int c = 0; c < 6; ++c) {
                if (!((f.tied & ~f.held) >> c & 1)) continue;
                LinearConstraint tie{call_, {f.node, c}, {{{first, c}, 1}}};
                for (int k = 0; c < 3 && k < 3; ++k)
                    if (const double lever = body.turning(Vec3::Unit(k)).cross(arm)[c]; lever != 0)
                        tie.terms.push_back({{first, 3 + k}, lever});
                list.push_back(std::move(tie));
            }
        }
    }
}

void RigidGroups::place(const Pose& from, const std::vector<Vec3>& rotation_step, Configuration& to) const {
    for (const Body& body : bodies_) {
        const Vec3 by = body.turning(rotation_step[body.group.first]);
        const Quat turn = rotated(by, Quat::Identity());
        const Vec3 moved = mean(body, [&](int n) -> Vec3 { return to.displacement[n] - from.displacement[n]; });
        for_arms(body, from, [&](const Weighed& n, const Vec3& r) {
            const Vec3 turned = w_.structure.large() ? Vec3(turn * r - r) : by.cross(r);
            for (int c = 0; c < 3; ++c)
                if (body.places(n, c)) to.displacement[n.node][c] = from.displacement[n.node][c] + moved[c] + turned[c];
        });
    }
}

void RigidGroups::set_velocities(Configuration& of) const {
    for (const Body& body : bodies_) {
        const Vec3 w = body.turning(of.velocity[body.group.first].tail<3>());
        const Vec3 v = mean(body, [&](int n) -> Vec3 { return of.velocity[n].head<3>(); });
        for_arms(body, of, [&](const Weighed& n, const Vec3& r) {
            const Vec3 there = v + w.cross(r);
            for (int c = 0; c < 3; ++c)
                if (body.places(n, c)) of.velocity[n.node][c] = there[c];
            for (int c = 3; c < 6; ++c)
                if ((n.tied & ~n.held) >> c & 1) of.velocity[n.node][c] = of.velocity[body.group.first][c];
        });
    }
}

void RigidGroups::set_accelerations(Configuration& of) const {
    for (const Body& body : bodies_) {
        const Vec6& first = of.acceleration[body.group.first];
        const Vec3 dw = body.turning(first.tail<3>()), w = body.turning(of.velocity[body.group.first].tail<3>());
        const bool large = w_.structure.large();
        const Vec3 a = mean(body, [&](int n) -> Vec3 { return of.acceleration[n].head<3>(); });
        for_arms(body, of, [&](const Weighed& n, const Vec3& r) {
            const Vec3 there = large ? Vec3(a + dw.cross(r) + w.cross(w.cross(r))) : Vec3(a + dw.cross(r));
            for (int c = 0; c < 3; ++c)
                if (body.places(n, c)) of.acceleration[n.node][c] = there[c];
            for (int c = 3; c < 6; ++c)
                if ((n.tied & ~n.held) >> c & 1) of.acceleration[n.node][c] = first[c];
        });
    }
}

/// The moment arm x f of a dependent node on the first one changes as the arm rotates: d(arm) = dw x arm.
void RigidGroups::add_curvature(const Pose& at, const std::vector<Vec6>& unbalanced, Blocks& blocks) const {
    if (!w_.structure.large()) return;
    for (const Body& body : bodies_) {
        Mat3 sum = Mat3::Zero();
        for (const RigidGroup::Follower& f : body.group.followers) {
            const Vec3 arm = body.in_plane(place_of(f.node, at) - place_of(body.group.first, at));
            sum += skew(body.in_plane(unbalanced[f.node].head<3>())) * skew(arm);
        }
        Mat6 K = Mat6::Zero();
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if (body.group.normal < 0 || (i == body.group.normal && j == i)) K(3 + i, 3 + j) = sum(i, j);
        blocks.stiffness(body.group.first, K);
    }
}

void RigidGroups::keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const {
    for (const Body& body : bodies_)
        for (const Weighed& n : body.nodes)
            if (const int b = bodies.of_node[n.node]; b >= 0) rests[b] = 0;
}

}  // namespace hinge

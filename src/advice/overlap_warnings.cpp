// Bars of different bodies that overlap at the start of a run: contact ignores them until they have separated.
#include <algorithm>

#include "contact/broad_phase.h"
#include "contact/segments.h"
#include "core/text.h"
#include "effects/contact.h"
#include "effects/joined_bodies.h"
#include "model/member_text.h"
#include "advice/load_warnings.h"

namespace hinge {
namespace {

constexpr double rests =
    1e-6;  ///< of the sum of the half depths: bars that rest on each other (contact/member_contacts.cpp)

}  // namespace

std::vector<Warning> overlapping_bars(const Structure& s, const State& start) {
    const Model& model = s.model();
    const std::vector<ContactRule>& rules = contact_rules(model);
    if (rules.empty() || contact_of(start)) return {};
    std::vector<int> bars;
    std::vector<contact::Box> boxes;
    const auto at = [&](int node) { return Vec3(s.position()[node] + start.displacement[node]); };
    for (std::size_t i = 0; i < s.elements().size(); ++i) {
        const Element& e = s.elements()[i];
        if (start.broken[i] || !can_collide(rules, model.members()[e.member])) continue;
        const Vec3 p = at(e.node[0]), q = at(e.node[1]);
        bars.push_back(int(i));
        boxes.push_back({p.cwiseMin(q).array() - e.radius, p.cwiseMax(q).array() + e.radius});
    }
    const Bodies bodies = joined_bodies(s, start);
    const auto element = [&](int bar) -> const Element& { return s.elements()[bars[bar]]; };
    const auto apart = [&](int a, int b) {
        return bodies.of_node[element(a).node[0]] != bodies.of_node[element(b).node[0]];
    };
    std::vector<std::pair<int, int>> members;  // that overlap
    int worst[2] = {-1, -1};
    double depth = 0;
    Vec3 place = Vec3::Zero();
    for (const contact::IndexPair& pair : contact::overlapping(boxes, apart)) {
        const Element &a = element(pair.a), &b = element(pair.b);
        const contact::Closest closest =
            contact::closest_points(at(a.node[0]), at(a.node[1]), at(b.node[0]), at(b.node[1]));
        const double reach = a.radius + b.radius;
        if (!(closest.distance < (1 - rests) * reach)) continue;
        if (contact_rule(rules, model.members()[a.member], model.members()[b.member]) < 0) continue;
        members.push_back(std::minmax(a.member, b.member));
        if (reach - closest.distance <= depth) continue;
        depth = reach - closest.distance;
        worst[0] = a.member, worst[1] = b.member;
        place = at(a.node[0]) + closest.s * (at(a.node[1]) - at(a.node[0])) + 0.5 * closest.between;
    }
    if (members.empty()) return {};
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    const auto nodes_of = [&](int member) {
        const auto& node = model.members()[member].node;
        return " between nodes " + std::to_string(node[0] + 1) + " and " + std::to_string(node[1] + 1);
    };
    return {{Warning::Kind::contact,
             member_text(model, worst[0]) + nodes_of(worst[0]) + " and " + member_text(model, worst[1]) +
                 nodes_of(worst[1]) + " overlap by " + number_text(depth, 3) + " m where this run begins, at " +
                 vector_text(place, 4) +
                 " m: contact leaves such a pair alone until it has parted, so one may pass through the other",
             "move them apart by so much; in contact a member is a round bar, its radius half the smaller side of its "
             "section",
             model.asked_at("member " + std::to_string(worst[1] + 1)), int(members.size()) - 1, int(members.size())}};
}

}  // namespace hinge

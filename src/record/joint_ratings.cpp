#include "record/joint_ratings.h"

#include <cmath>

#include "effects/connectors.h"
#include "run/run.h"

namespace hinge {
namespace {

/// At the first element of a node.
JointPlace place_at(const Structure& s, int node) {
    const int element = s.elements_at(node)[0];
    return {element, s.elements()[std::size_t(element)].node[0] == node ? 1 : 2, node};
}
void set_place(const JointPlace& place, JointRating& r) {
    r.element = place.element, r.end = place.end, r.node = place.node;
}

/// About an axis that is a spring.
void set_axis(const JointAxis& axis, const JointRecord& record, int k, JointRating& r) {
    const JointState& now = *r.now;
    r.which = JointRating::Which(k);
    r.record = &record.axis[k];
    r.force = now.broken ? 0 : now.moment[k], r.largest_force = r.record->moment;
    r.strength = axis.strength(), r.capacity = axis.capacity;
    const double left = k < 2 ? now.left : 1;
    r.utilisation = r.force == 0 || std::isinf(r.strength) ? 0 : std::abs(r.force) / (left * r.strength);
    r.largest = r.record->largest;
    r.demand = k < 2 ? record.bent : r.largest;
}

void set_force(double limit, double largest, double now, JointRating::Which which, JointRating& r) {
    r.which = which, r.record = nullptr;
    r.force = r.now->broken ? 0 : now, r.largest_force = largest;
    r.strength = limit, r.capacity = JointAxis::infinite;
    r.utilisation = r.force <= 0 ? 0 : r.force / limit;
    r.largest = r.demand = 0;
}

void add_connectors(const Run& run, std::vector<JointRating>& list) {
    const Structure& s = run.structure();
    const auto& declared = s.model().declared<Connector>(connectors_effect);
    const auto* now = run.state().data.find<ConnectorsNow>(connectors_effect);
    for (std::size_t i = 0; now && i < declared.size() && i < now->list.size(); ++i) {
        const ConnectorNow& c = now->list[i];
        for (int k = 0; k < 6; ++k) {
            if (!std::isfinite(declared[i].capacity[k])) continue;
            JointRating r;
            r.joint = int(i), r.connector = true, r.which = JointRating::Which(JointRating::force_x + k);
            const auto place = connector_place(s, int(i));
            if (!place) continue;
            set_place(*place, r);
            r.force = c.broken ? 0 : std::abs(c.force[k]), r.largest_force = c.largest[k];
            r.strength = declared[i].capacity[k];
            r.utilisation = r.force / r.strength;
            r.broken = c.broken;
            r.failed = c.broken && (c.force.array().abs() >= declared[i].capacity.array()).any();
            list.push_back(r);
        }
    }
}

}  // namespace

std::string joint_name(const Structure& structure, int joint) {
    const Joint& j = structure.model().declared<Joint>(joints_effect)[std::size_t(joint)];
    if (j.is_between_nodes())
        return "joint between nodes " + std::to_string(j.from + 1) + " and " + std::to_string(j.to + 1);
    return "joint at end " + std::string(j.end == 0 ? "a" : "b") + " of member " + std::to_string(j.member + 1);
}

std::string connector_name(const Structure& structure, int connector) {
    const Connector& c = structure.model().declared<Connector>(connectors_effect)[std::size_t(connector)];
    const std::string to = std::to_string(c.b + 1), name = "connector " + std::to_string(connector + 1) + " between ";
    return name + (c.a < 0 ? "the ground and node " + to : "nodes " + std::to_string(c.a + 1) + " and " + to);
}

JointPlace joint_place(const Structure& s, int joint) {
    const Joint& j = s.model().declared<Joint>(joints_effect)[std::size_t(joint)];
    if (j.is_between_nodes()) return place_at(s, j.to);
    const auto [first, past] = elements_of(s, j.member);
    return {j.end == 0 ? first : past - 1, j.end + 1, s.model().members()[std::size_t(j.member)].node[j.end]};
}

std::optional<JointPlace> connector_place(const Structure& s, int connector) {
    const Connector& c = s.model().declared<Connector>(connectors_effect)[std::size_t(connector)];
    for (const int node : {c.b, c.a})
        if (node >= 0 && !s.elements_at(node).empty()) return place_at(s, node);
    return std::nullopt;
}

std::vector<JointRating> joint_ratings(const Run& run) {
    std::vector<JointRating> list;
    const Structure& s = run.structure();
    const auto& declared = s.model().declared<Joint>(joints_effect);
    const auto* now = run.state().data.find<JointStates>(joints_effect);
    const auto* records = run.state().data.find<JointRecords>(joint_records);
    for (std::size_t i = 0; now && records && i < declared.size() && i < now->list.size() && i < records->list.size();
         ++i) {
        const JointProperties& is = declared[i].is;
        JointRating r;
        r.joint = int(i), r.now = &now->list[i];
        r.broken = r.now->broken, r.failed = r.now->over >= 0;
        set_place(joint_place(s, int(i)), r);
        for (int k = 0; k < 3; ++k)
            if (is.axis[k].is_spring()) set_axis(is.axis[k], records->list[i], k, r), list.push_back(r);
        if (std::isfinite(is.tension))
            set_force(is.tension, records->list[i].tension, r.now->tension, JointRating::tension, r), list.push_back(r);
        if (std::isfinite(is.shear))
            set_force(is.shear, records->list[i].shear, r.now->shear, JointRating::shear, r), list.push_back(r);
    }
    add_connectors(run, list);
    return list;
}

}  // namespace hinge

#include "script/record/joint_ratings.h"

#include <cmath>

#include "run/run.h"
#include "script/lua/objects.h"

namespace hinge::script {
namespace {

/// Sets element, end and node. A joint between nodes stands at the first element of its second node.
void set_place(const Structure& s, const Joint& j, JointRating& r) {
    if (j.is_between_nodes()) {
        r.element = s.elements_at(j.to)[0], r.node = j.to;
        r.end = s.elements()[std::size_t(r.element)].node[0] == j.to ? 1 : 2;
        return;
    }
    const auto [first, past] = elements_of(s, j.member);
    r.element = j.end == 0 ? first : past - 1, r.end = j.end + 1;
    r.node = s.model().members()[std::size_t(j.member)].node[j.end];
}

/// About an axis that is a spring.
void set_axis(const JointAxis& axis, const JointRecord& record, int k, JointRating& r) {
    const JointNow& now = *r.now;
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

}  // namespace

std::string joint_name(const Structure& structure, int joint) {
    const Joint& j = structure.model().declared<Joint>(joints_effect)[std::size_t(joint)];
    if (j.is_between_nodes())
        return "joint between nodes " + std::to_string(j.from + 1) + " and " + std::to_string(j.to + 1);
    return "joint at end " + std::string(j.end == 0 ? "a" : "b") + " of member " + std::to_string(j.member + 1);
}

std::vector<JointRating> joint_ratings(const Run& run) {
    std::vector<JointRating> list;
    const Structure& s = run.structure();
    const auto& declared = s.model().declared<Joint>(joints_effect);
    const auto* now = run.state().data.find<JointsNow>(joints_effect);
    const auto* records = run.state().data.find<JointRecords>(joint_records);
    if (!now || !records) return list;
    for (std::size_t i = 0; i < declared.size() && i < now->list.size() && i < records->list.size(); ++i) {
        const JointProperties& is = declared[i].is;
        JointRating r;
        r.joint = int(i), r.now = &now->list[i];
        r.broken = r.now->broken, r.failed = r.now->over >= 0;
        set_place(s, declared[i], r);
        for (int k = 0; k < 3; ++k)
            if (is.axis[k].is_spring()) set_axis(is.axis[k], records->list[i], k, r), list.push_back(r);
        if (std::isfinite(is.tension))
            set_force(is.tension, records->list[i].tension, r.now->tension, JointRating::tension, r), list.push_back(r);
        if (std::isfinite(is.shear))
            set_force(is.shear, records->list[i].shear, r.now->shear, JointRating::shear, r), list.push_back(r);
    }
    return list;
}

}  // namespace hinge::script

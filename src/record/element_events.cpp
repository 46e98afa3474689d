#include "record/element_events.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "core/files.h"
#include "effects/connectors.h"
#include "effects/fracture.h"
#include "effects/removal.h"
#include "record/joint_ratings.h"
#include "record/recording.h"
#include "core/quoting.h"

namespace hinge {
namespace {

constexpr std::size_t most_happenings = 200'000;

/// Elements of which a byte has become other than it was seen last: calls tell(element, before, now).
template <class Tell>
void each_change(std::vector<std::uint8_t>& seen, const std::vector<std::uint8_t>& now, Tell tell) {
    if (seen == now) return;
    seen.resize(now.size());
    for (std::size_t e = 0; e < now.size(); ++e)
        if (seen[e] != now[e]) tell(int(e), seen[e], now[e]);
    seen = now;
}

int end_of(std::uint8_t bits) { return bits == hinge_at_1 ? 1 : bits == hinge_at_2 ? 2 : 0; }

const char* name(ElementEvent::What what) {
    constexpr const char* names[] = {"contact",     "yield",       "fracture",       "joint_yield",
                                     "joint_limit", "joint_break", "connector_break"};
    return names[int(what)];
}
bool is_of_joint(const ElementEvent& h) { return h.what >= ElementEvent::What::joint_yield; }

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

// Bits of RunRecord::joints_seen. The first three: it has yielded about x, y, z.
constexpr std::uint8_t seen_beyond = 8, seen_broken = 16;

/// What has happened to the joints, then to the connectors of a run so far. Those whose node has lost its last member
/// have not broken by themselves.
std::vector<std::uint8_t> joints_now(const Run& run) {
    const State& state = run.state();
    const auto* now = state.data.find<JointStates>(joints_effect);
    const auto* records = state.data.find<JointRecords>(joint_records);
    const auto* connectors = state.data.find<ConnectorsNow>(connectors_effect);
    std::vector<std::uint8_t> bits;
    for (std::size_t i = 0; now && records && i < now->list.size() && i < records->list.size(); ++i) {
        const JointState& j = now->list[i];
        std::uint8_t b = j.over < 0 ? 0 : j.broken ? seen_broken : seen_beyond;
        for (int k = 0; k < 3; ++k)
            if (records->list[i].axis[k].yielded) b |= std::uint8_t(1 << k);
        bits.push_back(b);
    }
    for (std::size_t i = 0; connectors && i < connectors->list.size(); ++i)
        bits.push_back(connectors->list[i].broken ? seen_broken : 0);
    return bits;
}

/// A joint that has yielded about axis k: its moment there now, over that at which its elastic part ends.
ElementEvent yield_of(const Run& run, int joint, int k) {
    const JointState& j = run.state().data.find<JointStates>(joints_effect)->list[std::size_t(joint)];
    const auto& curve = run.structure().model().declared<Joint>(joints_effect)[std::size_t(joint)].is.axis[k].curve;
    const JointPlace at = joint_place(run.structure(), joint);
    return {ElementEvent::What::joint_yield,
            0,
            at.element,
            at.end,
            k,
            j.moment[k],
            (k < 2 ? j.left : 1) * curve.front().second,
            joint};
}

/// A joint that has reached its `over`: a rotation or a force.
ElementEvent limit_of(const Run& run, int joint, ElementEvent::What what) {
    const JointState& j = run.state().data.find<JointStates>(joints_effect)->list[std::size_t(joint)];
    const JointProperties& is = run.structure().model().declared<Joint>(joints_effect)[std::size_t(joint)].is;
    const JointPlace at = joint_place(run.structure(), joint);
    const double value = j.over < 3 ? j.rotation[j.over] : j.over == 3 ? j.tension : j.shear;
    const double limit = j.over < 3 ? is.axis[j.over].capacity : j.over == 3 ? is.tension : is.shear;
    return {what, 0, at.element, at.end, j.over, value, limit, joint};
}

/// A connector that has broken by a force or by its plastic deformation; nothing where its node has lost its last
/// member, or where panels alone join both of its nodes.
std::optional<ElementEvent> break_of(const Run& run, int connector) {
    const ConnectorNow& c = run.state().data.find<ConnectorsNow>(connectors_effect)->list[std::size_t(connector)];
    const Connector& is = run.structure().model().declared<Connector>(connectors_effect)[std::size_t(connector)];
    const std::optional<JointPlace> at = connector_place(run.structure(), connector);
    if (!at) return std::nullopt;
    for (int k = 0; k < 6; ++k)
        if (std::abs(c.force[k]) >= is.capacity[k])
            return ElementEvent{ElementEvent::What::connector_break,
                                0,
                                at->element,
                                at->end,
                                JointRating::force_x + k,
                                c.force[k],
                                is.capacity[k],
                                connector};
    if (const int k = is.ultimate.reached(c.plastic); k >= 0) {  // by its plastic deformation, at the force of yielding
        const bool both = k == 6;
        return ElementEvent{ElementEvent::What::connector_break,
                            0,
                            at->element,
                            at->end,
                            JointRating::force_x + (both ? 0 : k),
                            both ? std::hypot(c.force[0], c.force[1]) : c.force[k],
                            both ? is.yield.xy : is.yield.each[k],
                            connector};
    }
    return std::nullopt;
}

/// What has happened first to joints and connectors since they were seen last: yield and limits, or breaks.
template <class Add>
void each_of_joints(const RunRecord& r, const std::vector<std::uint8_t>& now, bool breaks, Add add) {
    const auto* there = r.run->state().data.find<JointStates>(joints_effect);
    const std::size_t joints = there ? there->list.size() : 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const int fresh = now[i] & ~(i < r.joints_seen.size() ? r.joints_seen[i] : 0);
        for (int k = 0; k < 3 && !breaks; ++k)
            if (fresh & 1 << k) add(yield_of(*r.run, int(i), k));
        if (!breaks && fresh & seen_beyond) add(limit_of(*r.run, int(i), ElementEvent::What::joint_limit));
        if (!breaks || !(fresh & seen_broken)) continue;
        if (i < joints) add(limit_of(*r.run, int(i), ElementEvent::What::joint_break));
        else if (const auto broke = break_of(*r.run, int(i - joints))) add(*broke);
    }
}

/// What has been seen stays: a joint in statics may come back below its limit.
void see_joints(RunRecord& r, const std::vector<std::uint8_t>& now) {
    r.joints_seen.resize(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) r.joints_seen[i] |= now[i];
}

}  // namespace

void note_happenings(RunRecord& r) {
    const State& s = r.run->state();
    const std::vector<std::uint8_t> joints = joints_now(*r.run);
    if (!r.started) {
        r.yielded_seen = s.yielded, r.touched_seen = s.touched, r.joints_seen = joints;
        return;
    }
    const double at = abscissa(*r.run);
    const auto keep = [&](ElementEvent h) {
        h.at = at;
        if (r.happenings.size() < most_happenings) r.happenings.push_back(h);
    };
    const auto add = [&](ElementEvent::What what, int element, int end, const beam::LimitReached& cause = {}) {
        keep({what, at, element, end, int(cause.which), cause.strain, cause.limit});
    };
    each_change(r.touched_seen, s.touched, [&](int e, int, int) { add(ElementEvent::What::contact, e, 0); });
    each_change(r.yielded_seen, s.yielded, [&](int e, std::uint8_t before, std::uint8_t now) {
        if (before == 0) add(ElementEvent::What::yield, e, end_of(now));
    });
    each_of_joints(r, joints, false, keep);
    if (r.run->breaks() != r.breaks_noted)
        for (const Break& b : r.run->broken_last()) add(ElementEvent::What::fracture, b.element, b.end, b.cause);
    each_of_joints(r, joints, true, keep);
    see_joints(r, joints);
}

namespace {

/// What took the element out of the structure; null where a rule of the script broke it. Whatever of a member is whole
/// when its removal is due breaks by that.
const Removal* removed_by(const Structure& s, const ElementEvent& h) {
    for (const Removal& r : s.model().declared<Removal>(removal_effect)) {
        const bool is_of =
            r.group >= 0 ? s.in_group(h.element, r.group) : s.elements()[std::size_t(h.element)].member == r.member;
        if (is_of && h.at >= r.at - 1e-7) return &r;
    }
    return nullptr;
}

}  // namespace

std::vector<std::string> event_columns(const Run& run) {
    return {run.is_static() ? "factor" : "time",
            "event",
            "element",
            "member",
            "end",
            "group",
            "limit",
            "strain",
            "of",
            "rule",
            "joint"};
}

namespace {

/// Fills limit, strain, of and joint of an event of a joint or a connector.
void add_joint_fields(const Structure& s, const ElementEvent& h, std::vector<std::string>& fields) {
    constexpr const char* about[] = {"x", "y", "z"};
    const bool rotation = h.limit < 3 && h.what != ElementEvent::What::joint_yield;
    fields[6] =
        h.limit < 3 ? std::string(rotation ? "rotation_" : "moment_") + about[h.limit] : joint_rating_names[h.limit];
    fields[7] = number(h.strain), fields[8] = number(h.of);
    fields[10] = h.what == ElementEvent::What::connector_break ? connector_name(s, h.joint) : joint_name(s, h.joint);
}

}  // namespace

std::vector<std::string> event_fields(const Run& run, const ElementEvent& h) {
    const Structure& s = run.structure();
    const Element& e = s.elements()[h.element];
    const auto& groups = s.model().members()[e.member].groups;
    std::vector<std::string> fields = {number(h.at),
                                       name(h.what),
                                       std::to_string(h.element + 1),
                                       std::to_string(e.member + 1),
                                       h.end > 0 ? std::to_string(h.end) : "",
                                       groups.empty() ? "" : s.model().groups()[groups[0]]};
    fields.resize(11);
    if (is_of_joint(h)) add_joint_fields(s, h, fields);
    if (h.what != ElementEvent::What::fracture) return fields;
    const bool limit = h.limit != int(beam::Limit::rule);
    const Removal* removal = limit ? nullptr : removed_by(s, h);
    fields[6] = removal ? "removed" : beam::limit_names[h.limit];
    if (limit) fields[7] = number(h.strain), fields[8] = number(h.of);
    const auto& rules = fracture_rules(s.model());
    if (removal) fields[9] = removal->asked_at;
    else if (const int rule = fracture_rule_of(rules, s.model().members()[e.member]); rule >= 0)
        fields[9] = rules[rule].asked_at;
    return fields;
}

namespace {

/// A line of events.csv. Names stand in quotes: the group's, and the rule's place.
std::string line_of(const std::vector<std::string>& fields) {
    std::string line;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const bool is_name = (i == 5 || i >= 9) && !fields[i].empty();
        line += (i > 0 ? "," : "") + (is_name ? csv_text(fields[i], CsvQuotes::always) : fields[i]);
    }
    return line + "\n";
}

/// The lines from the happening of that number on; with the heading where it is the first.
std::string lines_from(const RunRecord& r, std::size_t first) {
    std::string text;
    if (first == 0)
        for (const std::string& column : event_columns(*r.run)) text += (text.empty() ? "" : ",") + column;
    if (first == 0) text += "\n";
    for (std::size_t i = first; i < r.happenings.size(); ++i) text += line_of(event_fields(*r.run, r.happenings[i]));
    return text;
}

}  // namespace

void begin_happenings(RunRecord& r, const std::string& path) {
    r.files.events_path = path;
    r.files.events_written = r.happenings.size();
    if (r.happenings.empty()) std::remove(path.c_str());
    else write_whole(path, lines_from(r, 0));
}

void write_happenings(RunRecord& r) {
    if (r.files.events_path.empty() || r.files.events_written == r.happenings.size()) return;
    const std::string lines = lines_from(r, r.files.events_written);
    if (r.files.events_written == 0) write_whole(r.files.events_path, lines);
    else append_to(r.files.events_path, lines);
    r.files.events_written = r.happenings.size();
}

void leave_happenings(const Context& c, RunRecord& r) {
    if (!r.files.events_path.empty()) return write_happenings(r);
    if (r.begun || !c.runs.writer) begin_happenings(r, c.output.folder + "/events.csv");
}

Json damage_by_group(const Run& run) {
    Json list = Json::array();
    const auto& groups = run.structure().model().groups();
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const Run::Counts n = run.count_members(int(g));
        list.push_back({{"group", groups[g]},
                        {"members", n.elastic + n.yielded + n.broken},
                        {"elastic", n.elastic},
                        {"yielded", n.yielded},
                        {"broken", n.broken},
                        {"touched", n.touched}});
    }
    return list;
}

}  // namespace hinge

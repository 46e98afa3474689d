#include "script/record/element_events.h"

#include <algorithm>
#include <cstdio>

#include "core/files.h"
#include "effects/fracture.h"
#include "effects/removal.h"
#include "script/record/recording.h"
#include "script/files/quoting.h"

namespace hinge::script {
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
    return what == ElementEvent::What::contact ? "contact" : what == ElementEvent::What::yield ? "yield" : "fracture";
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

}  // namespace

void note_happenings(RunRecord& r) {
    const State& s = r.run->state();
    if (!r.started) {
        r.yielded_seen = s.yielded, r.touched_seen = s.touched;
        return;
    }
    const double at = abscissa(*r.run);
    const auto add = [&](ElementEvent::What what, int element, int end, const beam::LimitReached& cause = {}) {
        if (r.happenings.size() < most_happenings)
            r.happenings.push_back({what, at, element, end, int(cause.which), cause.strain, cause.limit});
    };
    each_change(r.touched_seen, s.touched, [&](int e, int, int) { add(ElementEvent::What::contact, e, 0); });
    each_change(r.yielded_seen, s.yielded, [&](int e, std::uint8_t before, std::uint8_t now) {
        if (before == 0) add(ElementEvent::What::yield, e, end_of(now));
    });
    if (r.run->breaks() != r.breaks_noted)
        for (const Break& b : r.run->broken_last()) add(ElementEvent::What::fracture, b.element, b.end, b.cause);
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
    return {std::string(run.kind()) == "static" ? "factor" : "time",
            "event",
            "element",
            "member",
            "end",
            "group",
            "limit",
            "strain",
            "of",
            "rule"};
}

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
    fields.resize(10);
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
        const bool is_name = (i == 5 || i == 9) && !fields[i].empty();
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

}  // namespace hinge::script

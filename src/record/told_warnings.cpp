#include "record/told_warnings.h"

#include <algorithm>
#include <cstdio>

#include "advice/adviser.h"
#include "advice/check.h"
#include "advice/size_notice.h"
#include "effects/declared.h"
#include "record/events.h"

namespace hinge {
namespace {

constexpr int most_lines = 10;               ///< of all the script's runs
constexpr std::size_t most_kept = 100;       ///< in summary.json
constexpr int most_models = 50;              ///< that are looked at: a loop's further ones are like the first
constexpr std::size_t most_members = 20000;  ///< of one: half a second
constexpr int most_solved = 2000;            ///< nodes, where a linear solution is asked for: a tenth of a second

}  // namespace

void tell(Context& c, const Warning& w) {
    const std::string text = warning_text(w);
    if (c.messages.warned.size() >= most_kept ||
        std::find(c.messages.warned.begin(), c.messages.warned.end(), text) != c.messages.warned.end())
        return;
    c.messages.warned.push_back(text);
    write_event(c, "warning", {{"text", w.what}, {"advice", w.advice}, {"line", w.asked_at}, {"more", w.more}});
    if (!c.messages.warns || c.messages.warnings_told >= most_lines) return;
    if (++c.messages.warnings_told < most_lines) std::fprintf(stderr, "warning: %s\n", text.c_str());
    else std::fprintf(stderr, "warning: and more than these %d; hinge check tells all\n", most_lines - 1);
}

void tell_findings(Context& c, const RunRecord& r) {
    if (!r.run || r.run->steps_done() == 0) return;
    for (const Warning& w : findings_of(*r.run)) tell(c, w);
}

void look_over(Context& c, const Model& model) {
    c.messages.of_units.reset();
    if (!c.mode.looks_over || c.messages.looked_over >= most_models || model.members().size() > most_members) return;
    ++c.messages.looked_over;
    const std::vector<Warning> list = warnings(model, linked_nodes(model), declared_gravity(model));
    c.messages.of_units = of_units(list);
    for (const Warning& w : list) tell(c, w);
}

void look_over(Context& c, RunRecord& record) {
    record.of_units = c.messages.of_units;
    if (!c.mode.looks_over || c.messages.looked_over >= most_models ||
        record.run->structure().model().members().size() > most_members)
        return;
    std::vector<Warning> list = warnings_of_run(record, c.messages.of_units ? 0 : most_solved, false, true);
    const auto buckles = [](const Warning& w) { return w.kind == Warning::Kind::buckling; };
    const long columns = std::count_if(list.begin(), list.end(), buckles);
    const auto first = std::find_if(list.begin(), list.end(), buckles);
    if (columns > 1) {  // the worst is told, the others are counted
        for (auto w = first + 1; w != list.end(); ++w) first->more += w->more + w->tells_of;
        list.erase(first + 1, list.end());
    }
    for (const Warning& w : list) tell(c, w);
    if (!record.of_units) record.of_units = of_units(list);
}

namespace {

bool tells_size(const Context& c) { return c.messages.progress || c.messages.warns; }

}  // namespace

void tell_members(const Context& c, std::size_t members) {
    const std::string text = members_notice(members);
    if (!text.empty() && tells_size(c)) std::fprintf(stderr, "%s\n", text.c_str());
}

void tell_size(Context& c, const Model& model) {
    static std::size_t told = 0;  // a loop's models of one size are told of once
    const std::size_t members = model.members().size();
    if (members == told) return;
    const std::string text = size_notice(model);
    if (!text.empty()) told = members;
    tell_notice(c, text);
}

void tell_notice(Context& c, const std::string& text) {
    if (text.empty()) return;
    if (tells_size(c)) std::fprintf(stderr, "%s\n", text.c_str());
    write_event(c, "size", {{"text", text}});
}

}  // namespace hinge

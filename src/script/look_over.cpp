// Likely mistakes that hinge run tells of, before the mechanism or the failure that they may end in.
#include <algorithm>

#include "script/check.h"
#include "script/events.h"

namespace hinge::script {
namespace {

constexpr int most_lines = 10;               ///< of all the script's runs
constexpr std::size_t most_kept = 100;       ///< in summary.json
constexpr int most_models = 50;              ///< that are looked at: a loop's further ones are like the first
constexpr std::size_t most_members = 20000;  ///< of one: half a second
constexpr int most_solved = 2000;            ///< nodes, where a linear solution is asked for: a tenth of a second

}  // namespace

void tell(Context& c, const Warning& w) {
    const std::string text = warning_text(w);
    if (c.warned.size() >= most_kept || std::find(c.warned.begin(), c.warned.end(), text) != c.warned.end()) return;
    c.warned.push_back(text);
    write_event(c, "warning", {{"text", w.what}, {"advice", w.advice}, {"line", w.asked_at}, {"more", w.more}});
    if (!c.progress || c.warnings_told >= most_lines) return;
    if (++c.warnings_told < most_lines) std::fprintf(stderr, "warning: %s\n", text.c_str());
    else std::fprintf(stderr, "warning: and more than these %d; hinge check tells all\n", most_lines - 1);
}

void look_over(Context& c, const Model& model) {
    if (!c.looks_over || c.looked_over >= most_models || model.members().size() > most_members) return;
    ++c.looked_over;
    const std::vector<Warning> list = warnings(model);
    c.doubts_units = doubts_units(list);
    for (const Warning& w : list) tell(c, w);
}

void look_over(Context& c, const RunRecord& record) {
    if (!c.looks_over || c.looked_over >= most_models ||
        record.run->structure().model().members().size() > most_members)
        return;
    std::vector<Warning> list = warnings_of_run(record, c.doubts_units ? 0 : most_solved, false, true);
    const auto buckles = [](const Warning& w) { return w.what.find("Euler's load") != std::string::npos; };
    const long columns = std::count_if(list.begin(), list.end(), buckles);
    const auto first = std::find_if(list.begin(), list.end(), buckles);
    if (columns > 1) {  // the worst is told, the others are counted
        for (auto w = first + 1; w != list.end(); ++w) first->more += w->more + 1;
        list.erase(first + 1, list.end());
    }
    for (const Warning& w : list) tell(c, w);
}

}  // namespace hinge::script

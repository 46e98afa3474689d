#include "advice/idle_effects.h"

#include <algorithm>
#include <vector>

#include "core/text.h"
#include "effects/contact.h"
#include "effects/damping.h"
#include "effects/effect_list.h"
#include "effects/fracture.h"
#include "effects/ground.h"
#include "run/dynamics.h"

namespace hinge {
namespace {

constexpr double least_part = 0.02, least_seconds = 1;

struct Idle {
    std::string name;
    double seconds;
};

bool did_nothing(const Run& run, const std::string& effect) {
    if (effect == contact_effect) {
        const auto& touched = run.state().touched;
        return std::none_of(touched.begin(), touched.end(), [](auto t) { return t != 0; });
    }
    if (effect == fracture_effect) return run.breaks() == 0;
    if (effect == damping_effect) return run.state().accumulated["damping"] == 0;
    if (effect != ground_effect) return false;
    const auto& changes = run.activations();
    return std::none_of(changes.begin(), changes.end(), [&](const auto& a) { return a.effect == effect; });
}

/// A damping that no member has is no effect of the run, and takes none of its time.
bool damps_no_member(const Run& run) {
    const auto lines = run.effects();
    return !run.structure().model().declared<Damping>(damping_effect).empty() &&
           std::none_of(lines.begin(), lines.end(),
                        [](const PlanLine& l) { return l.name == damping_effect && l.active; });
}

std::string percent_text(double part) { return number_text(100 * part, 2) + " %"; }

}  // namespace

std::string idle_effects(const Run& run, double seconds) {
    if (!run.dynamics() || seconds < least_seconds) return "";
    std::vector<Idle> idle;
    for (const PlanLine& line : run.effects())
        if (line.active && did_nothing(run, line.name)) idle.push_back({line.name, line.seconds});
    std::string names, parts;
    double sum = 0;
    for (std::size_t i = 0; i < idle.size(); ++i) {
        names += (i == 0 ? "" : i + 1 == idle.size() ? " and " : ", ") + idle[i].name;
        parts += (i == 0 ? "" : ", ") + idle[i].name + " " + percent_text(idle[i].seconds / seconds);
        sum += idle[i].seconds;
    }
    const std::string none = damps_no_member(run) ? "damping did nothing in this run: it damps no member" : "";
    if (!(sum > least_part * seconds)) return none;
    return (none.empty() ? "" : none + "; ") + names + " did nothing in this run and took " +
           percent_text(sum / seconds) + " of its time" + (parts.find(',') == std::string::npos ? "" : ": " + parts);
}

}  // namespace hinge

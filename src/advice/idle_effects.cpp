#include "advice/idle_effects.h"

#include <algorithm>
#include <string_view>
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

/// Step control that is there for forces that may vanish, and for nothing that did something (calls_for_control in
/// run/step_length.cpp).
bool controlled_for_these(const Run& run, const std::vector<Idle>& idle) {
    const DynamicSettings& settings = run.dynamics()->settings();
    if (!settings.controlled_by_default || settings.automatic || run.structure().can_yield()) return false;
    const auto& all = run.effect_list().all;
    return run.effect_list().any(&EffectTraits::forces_vanish) &&
           std::all_of(all.begin(), all.end(), [&](const auto& e) {
               return !e->traits().forces_vanish ||
                      std::any_of(idle.begin(), idle.end(), [&](const Idle& i) { return i.name == e->name(); });
           });
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
    if (!idle.empty() && controlled_for_these(run, idle))
        for (const StageTime& stage : run.stage_times())
            if (std::string_view(stage.name) == "step control")
                parts += ", step control for them " + percent_text(stage.seconds / seconds), sum += stage.seconds;
    const std::string none = damps_no_member(run) ? "damping did nothing in this run: it damps no member" : "";
    if (!(sum > least_part * seconds)) return none;
    return (none.empty() ? "" : none + "; ") + names + " did nothing in this run and took " +
           percent_text(sum / seconds) + " of its time" + (parts.find(',') == std::string::npos ? "" : ": " + parts);
}

}  // namespace hinge

#include "record/progress.h"

#include <algorithm>
#include <cmath>
#include <unistd.h>

#include "core/text.h"
#include "record/chain.h"
#include "advice/adviser.h"
#include "advice/idle_effects.h"
#include "record/events.h"
#include "record/recording.h"
#include "record/told_warnings.h"
#include "record/summary.h"

namespace hinge {

namespace {

/// Whether messages go to a terminal; asked once, for it costs a call of the system.
bool on_screen() {
    static const bool screen = isatty(2);
    return screen;
}

/// Clears the progress line before another is written.
const char* line_start() { return on_screen() ? "\r\033[K" : ""; }

/// 1234, 12, 1.2, 0.12
std::string rate_text(double v) { return v >= 9.5 ? number_text(std::round(v)) : number_text(v, 2); }

/// How far a run is; `trying`: a static run is within a step that is halved, and has found no equilibrium there yet.
void show_progress(const Context& c, RunRecord& r, bool last, bool trying = false) {
    if (!c.messages.progress && !c.messages.events) return;
    const double wall = seconds_of(Clock::now() - r.progress.start);
    if (last && wall < 2 && !c.messages.events) return;
    const long done = r.run->steps_done(), all = r.run->planned_steps(), now = done - r.resumed_at;
    const double share = std::clamp(r.run->part_done(), 0.0, 1.0);
    if (!trying && r.every == 0) weigh_error(r, r.run->energy());  // no row has done it
    if (c.messages.events) {
        Json j = {{"run", r.number}, {"kind", r.run->kind()},       {"step", done},
                  {"steps", all},    {"time", r.run->state().time}, {"factor", r.run->state().factor},
                  {"part", share},   {"wall_seconds", wall},        {"energy_error", r.last_energy_share},
                  {"halved", trying}};
        if (last) j["verdict"] = name(verdict_of(r)), j["reason"] = reason_of(r);
        if (last && verdict_of(r) == Verdict::failed) j["cause"] = cause_of(r);
        write_event(c, last ? "run_ended" : "progress", std::move(j));
        return;
    }
    std::string bar(24, '-');
    for (int i = 0; i < int(24 * share); ++i) bar[i] = '#';
    std::string text = std::string(line_start()) + r.run->kind() + " [" + bar + "]";
    char part[80];
    std::snprintf(part, sizeof part, " %3.0f %%  step %ld of %ld", 100 * share, done, all);
    text += part;
    if (trying) {
        std::snprintf(part, sizeof part,
                      "; the next one is halved, %ld times so far: no equilibrium yet beyond factor ",
                      r.run->rejected());
        text += part + number_text(r.run->state().factor);
    } else if (last) {
        text += "  took " + duration_text(wall);
    } else if (now > 0) {
        text += "  " + rate_text(double(now) / std::max(wall, 1e-9)) + " steps/s  left " +
                duration_text(wall * double(std::max(0L, all - done)) / double(now));
    }
    if (!trying && r.last_energy_error != 0) {
        std::snprintf(part, sizeof part, "  energy error %+.2g %% of the largest energy", 100 * r.last_energy_share);
        text += part;
    }
    std::fprintf(stderr, "%s%s", text.c_str(), on_screen() && !last ? "" : "\n");
    std::fflush(stderr);
}

void show_if_due(const Context& c, RunRecord& r, bool trying) {
    const auto now = Clock::now();
    const double pause = c.messages.events ? 1
                         : on_screen()     ? 0.2
                                           : 10,
                 first = c.messages.events ? 1
                         : on_screen()     ? 2
                                           : 5;
    if (seconds_of(now - r.progress.start) <= first || seconds_of(now - r.progress.last_shown) <= pause) return;
    show_progress(c, r, false, trying);
    r.progress.last_shown = now;
}

}  // namespace

void tell_of_beginning(const std::shared_ptr<Context>& c, RunRecord& r) {
    if (c->messages.events) {
        const Structure& s = r.run->structure();
        write_event(*c, "run_begun",
                    {{"run", r.number},
                     {"kind", r.run->kind()},
                     {"line", r.asked_at},
                     {"members", s.model().members().size()},
                     {"elements", s.elements().size()},
                     {"nodes", s.position().size()},
                     {"free_dofs", s.free_dofs()},
                     {"steps", r.run->planned_steps()}});
    }
    if (c->messages.progress || c->messages.events)
        r.run->on_each_try([c = std::weak_ptr(c), &r, seen = 0L]() mutable {
            const auto context = c.lock();
            if (context && r.run->rejected() > seen) seen = r.run->rejected(), show_if_due(*context, r, true);
        });
}

namespace {

/// Effects that woke or fell asleep: the first of each kind is told, the others are counted.
void tell_changes(const Context& c, RunRecord& r, bool over) {
    for (const auto& list = r.run->activations(); r.progress.activations_seen < list.size();
         ++r.progress.activations_seen) {
        const Run::Activation& w = list[r.progress.activations_seen];
        RunRecord::Changes& so_far = r.progress.changes[w.effect];
        so_far.last = w.time;
        if ((w.awake ? so_far.awake : so_far.asleep)++ > 0) continue;
        if (c.messages.events)
            write_event(
                c, "state",
                {{"run", r.number}, {"time", w.time}, {"effect", w.effect}, {"awake", w.awake}, {"why", w.why}});
        else if (c.messages.progress)
            std::fprintf(stderr, "%st = %s s: %s %s, %s\n", line_start(), number_text(w.time, 4).c_str(),
                         w.effect.c_str(), w.awake ? "awake" : "asleep", w.why.c_str());
    }
    if (!over) return;
    for (const auto& [effect, n] : r.progress.changes) {
        if (n.awake + n.asleep < 3 && n.awake < 2 && n.asleep < 2) continue;
        const auto times = [](int count) {
            return count == 1 ? std::string("once") : std::to_string(count) + " times";
        };
        if (c.messages.events)
            write_event(
                c, "changes",
                {{"run", r.number}, {"effect", effect}, {"awake", n.awake}, {"asleep", n.asleep}, {"last", n.last}});
        else if (c.messages.progress)
            std::fprintf(stderr, "%s%s: awake %s, asleep %s in all, the last at t = %s s (run.state_changes)\n",
                         line_start(), effect.c_str(), times(n.awake).c_str(),
                         n.asleep == 0 ? "never" : times(n.asleep).c_str(), number_text(n.last, 4).c_str());
    }
    r.progress.changes.clear();
}

/// The first instability of a static run.
void tell_instability(const Context& c, RunRecord& r) {
    if (!r.run->instability() || r.progress.instability_shown || r.run->verdict() == Verdict::failed) return;
    r.progress.instability_shown = true;
    if (c.messages.events) write_event(c, "instability", {{"run", r.number}, {"text", r.run->instability_text()}});
    else if (c.messages.progress)
        std::fprintf(stderr, "%sstatic: %s\n", line_start(), r.run->instability_text().c_str());
}

void tell_idle_effects(const Context& c, const RunRecord& r) {
    if (!c.messages.progress && !c.messages.events) return;
    const std::string text = idle_effects(*r.run, r.wall);
    if (text.empty()) return;
    if (c.messages.events) write_event(c, "idle", {{"run", r.number}, {"text", text}});
    else std::fprintf(stderr, "%s%s\n", line_start(), text.c_str());
}

}  // namespace

void tell_step(Context& c, RunRecord& r, bool over) {
    tell_changes(c, r, over);
    for (const auto& list = warnings_of(*r.run); r.progress.warnings_seen < list.size(); ++r.progress.warnings_seen)
        tell(c, list[r.progress.warnings_seen]);
    if (over) tell_findings(c, r);
    tell_instability(c, r);
    if (over) tell_idle_effects(c, r), show_progress(c, r, true);
    else show_if_due(c, r, false);
}

}  // namespace hinge

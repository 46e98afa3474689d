// Recording during a run: probes, rows of history.csv, and progress messages.
#include "script/record/recording.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unistd.h>

#include "core/doing.h"
#include "core/files.h"
#include "core/rotation.h"
#include "core/text.h"
#include "script/checks/chain.h"
#include "script/checks/check.h"
#include "script/files/run_checkpoint.h"
#include "script/record/events.h"
#include "script/files/folders.h"
#include "script/record/element_events.h"
#include "script/lua/interrupts.h"
#include "script/lua/run_observer.h"
#include "script/record/summary.h"
#include "run/dynamics.h"
#include "run/statics.h"

namespace hinge::script {

namespace {

/// How a node has rotated against another, as a rotation vector in space.
double relative_rotation(const Run& run, const Probe& p) {
    const State& state = run.state();
    if (!run.structure().large())
        return (state.small_rotation[p.node] - state.small_rotation[p.relative_to])[p.component - 3];
    return rotation_vector(state.rotation[p.node] * state.rotation[p.relative_to].conjugate())[p.component - 3];
}

}  // namespace

double value_of(const Run& run, const Probe& p) {
    if (p.relative_to >= 0) {
        if (p.quantity == Probe::Quantity::displacement && p.component >= 3) return relative_rotation(run, p);
        const auto of = [&](int node) { return value_of(run, Probe{node, p.quantity, p.component, {}, {}, {}}); };
        const double difference = of(p.node) - of(p.relative_to);
        return p.height > 0 ? difference / p.height : difference;
    }
    switch (p.quantity) {
        case Probe::Quantity::velocity: return run.state().velocity[p.node][p.component];
        case Probe::Quantity::acceleration: return run.state().acceleration[p.node][p.component];
        case Probe::Quantity::reaction: return run.reaction(p.node)[p.component];
        default:
            return p.component < 3 ? run.state().displacement[p.node][p.component]
                                   : run.displacement(p.node)[p.component];
    }
}

double abscissa(const Run& run) {
    return std::strcmp(run.kind(), "static") == 0 ? run.state().factor : run.state().time;
}

std::string history_row(const RunRecord& r, const Energy& e, const LostBalance* lost) {
    char text[64];
    std::snprintf(text, sizeof text, "%.9g,%.9g", lost ? lost->time : r.run->state().time,
                  lost ? lost->factor : r.run->state().factor);
    std::string row = text;
    const auto add = [&](double value) {
        std::snprintf(text, sizeof text, ",%.9g", value);
        row += text;
    };
    for (const AccountInfo& account : r.run->accounts())
        if (account.part_of.empty()) add(e[account.name]);
    add(e.error);
    for (const auto& p : r.probes) add(lost ? std::nan("") : value_of(*r.run, *p));
    return row + '\n';
}

std::string duration_text(double s) {
    const long whole = std::lround(s);
    const auto two = [](long a, const char* large, long b, const char* small) {
        return std::to_string(a) + large + (b > 0 ? " " + std::to_string(b) + small : "");
    };
    if (whole < 120) return std::to_string(whole) + " s";
    return whole < 7200 ? two(whole / 60, " min", whole % 60, " s")
                        : two(whole / 3600, " h", whole % 3600 / 60, " min");
}

namespace {

using Clock = std::chrono::steady_clock;
double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

void sample(RunRecord& r) {
    for (auto& p : r.probes) {
        p->time.push_back(abscissa(*r.run));
        p->value.push_back(value_of(*r.run, *p));
    }
}

/// The units of the columns of history.csv that are probes.
void write_probes(const Context& c, const RunRecord& r) {
    const std::string path = c.output.folder + "/probes.json";
    if (r.probes.empty()) std::remove(path.c_str());
    else write_whole(path, probes_json(r).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

/// Its history is history.csv from now on; those of the runs before it are kept by number.
void take_files(const std::shared_ptr<Context>& c, const std::shared_ptr<RunRecord>& record) {
    take_folder(*c);
    record->history_path = c->output.folder + "/history.csv";
    if (c->runs.writer) {
        write_rows(*c->runs.writer);
        const std::string number = "-" + std::to_string(++c->runs.histories) + ".csv";
        c->runs.writer->history_path = c->output.folder + "/history" + number;
        c->runs.writer->events_path = c->output.folder + "/events" + number;
        std::rename(record->history_path.c_str(), c->runs.writer->history_path.c_str());
        // What stands there of an earlier program: nothing has happened in this one, and there was no probe.
        const auto keep = [&](const std::string& file, const std::string& as) {
            if (std::rename((c->output.folder + file).c_str(), as.c_str()) != 0) std::remove(as.c_str());
        };
        keep("/events.csv", c->runs.writer->events_path);
        keep("/hinges.csv", c->output.folder + "/hinges" + number);
        keep("/probes.json", c->output.folder + "/probes-" + std::to_string(c->runs.histories) + ".json");
    } else {  // of an earlier run: not about this one
        for (const char* file : {"/summary.json", "/hinges.csv"}) std::remove((c->output.folder + file).c_str());
    }
    c->runs.writer = record;
    write_probes(*c, *record);
    begin_happenings(*record, c->output.folder + "/events.csv");
}

void begin_history(const std::shared_ptr<Context>& c, const std::shared_ptr<RunRecord>& record) {
    RunRecord& r = *record;
    r.begun = true;
    r.number = ++c->runs.begun;
    r.start = r.last_progress = r.last_write = Clock::now();
    const bool keeps = !c->output.folder.empty() && r.every > 0;
    if (!keeps && !c->messages.observer) return;
    if (keeps) take_files(c, record);
    std::string header = "time,factor";
    for (const AccountInfo& account : r.run->accounts())
        if (account.part_of.empty()) header += "," + std::string(account.name);
    header += ",energy_error";
    for (const auto& p : r.probes) header += "," + p->name;
    const std::string text = r.past.empty() ? header + "\n" : r.past;
    if (c->messages.observer) c->messages.observer->begun(r, text);
    if (!keeps) return;
    write_whole(r.history_path, text);
    r.past.clear();
}

/// What a run lost whose energy balance no longer closed, else null.
const LostBalance* lost_by(const RunRecord& r) {
    const auto* d = dynamic_cast<const Dynamics*>(r.run.get());
    return d && d->lost() ? &*d->lost() : nullptr;
}

/// The energy error as a part of the largest energy: of the state, and of the run, which for a run whose balance no
/// longer closed is that of the moment at which this was seen, not that of the state to which it went back.
void weigh_error(RunRecord& r, const Energy& e) {
    if (!r.largest_energy) r.largest_energy.emplace(r.run->structure());
    if (const auto* d = dynamic_cast<const Dynamics*>(r.run.get()))  // it looks between the rows too
        r.largest_energy->set_most(std::max(r.largest_energy->most(), d->largest_energy()));
    r.last_energy_share = r.state_energy_share = r.largest_energy->share(e, r.run->accounts());
    if (const LostBalance* lost = lost_by(r)) r.last_energy_share = lost->share;
}

void add_row(const Context& c, RunRecord& r) {
    const Energy e = r.run->energy();
    const LostBalance* lost = lost_by(r);
    r.initial = e.initial;
    r.last_energy_error = lost ? lost->energy.error : e.error;
    weigh_error(r, e);
    if (!std::isnan(r.worst_energy_error) && !(std::abs(r.last_energy_error) <= r.worst_energy_error))
        r.worst_energy_error = std::abs(r.last_energy_error);  // an error that is not a number stays
    const long step = lost ? lost->step : r.run->state().step;
    if (step < r.row_of) return;  // a run that failed may have gone back to its last good step
    r.row_of = step;
    keep_row(r, lost ? lost->energy : e, lost);
    if (r.history_path.empty() && (!c.messages.observer || r.every == 0)) return;
    const std::string row = history_row(r, lost ? lost->energy : e, lost);
    if (!r.history_path.empty()) r.rows += row;
    if (c.messages.observer) c.messages.observer->row(r, row);
}

/// When elements broke and nodes lost their last one. What a run starts with broken, broke before it.
void note_what_went(RunRecord& r) {
    const State& s = r.run->state();
    if (s.offset_arm.empty() || (r.started && r.run->breaks() == r.breaks_noted)) return;
    r.breaks_noted = r.run->breaks();
    const double now = r.started ? s.time : -std::numeric_limits<double>::infinity();
    r.broken_at.resize(s.broken.size(), std::nan(""));
    r.left_at.resize(s.gone.size(), std::nan(""));
    for (std::size_t e = 0; e < s.broken.size(); ++e)
        if (s.broken[e] && std::isnan(r.broken_at[e])) r.broken_at[e] = now;
    for (std::size_t n = 0; n < s.gone.size(); ++n)
        if (s.gone[n] && std::isnan(r.left_at[n]) && !r.run->structure().elements_at(int(n)).empty())
            r.left_at[n] = now;
}

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
    const double wall = seconds(Clock::now() - r.start);
    if (last && wall < 2 && !c.messages.events) return;
    const long done = r.run->steps_done(), all = r.run->planned_steps(), now = done - r.resumed_at;
    const auto* statics = dynamic_cast<const Statics*>(r.run.get());
    const double share =
        std::clamp(statics ? statics->part_done() : double(done) / double(std::max(1L, all)), 0.0, 1.0);
    if (!trying && r.every == 0) weigh_error(r, r.run->energy());  // no row has done it
    if (c.messages.events) {
        Json j = {{"run", r.number}, {"kind", r.run->kind()},       {"step", done},
                  {"steps", all},    {"time", r.run->state().time}, {"factor", r.run->state().factor},
                  {"part", share},   {"wall_seconds", wall},        {"energy_error", r.last_energy_share},
                  {"halved", trying}};
        if (last) j["verdict"] = name(verdict_of(r)), j["reason"] = reason_of(r);
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
                      statics->rejected());
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
    if (seconds(now - r.start) <= first || seconds(now - r.last_progress) <= pause) return;
    show_progress(c, r, false, trying);
    r.last_progress = now;
}

/// A run takes its first step: from now on it is told how it goes.
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
    if (auto* statics = dynamic_cast<Statics*>(r.run.get()); statics && (c->messages.progress || c->messages.events))
        statics->on_try = [c = std::weak_ptr(c), &r, seen = 0L, statics]() mutable {
            const auto context = c.lock();
            if (context && statics->rejected() > seen) seen = statics->rejected(), show_if_due(*context, r, true);
        };
}

/// Effects that woke or fell asleep: the first of each kind is told, the others are counted.
void tell_changes(const Context& c, RunRecord& r, bool over) {
    for (const auto& list = r.run->activations(); r.wakings_seen < list.size(); ++r.wakings_seen) {
        const Run::Activation& w = list[r.wakings_seen];
        RunRecord::Changes& so_far = r.changes[w.effect];
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
    for (const auto& [effect, n] : r.changes) {
        if (n.awake + n.asleep < 3 && n.awake < 2 && n.asleep < 2) continue;
        const auto times = [](int n) { return n == 1 ? std::string("once") : std::to_string(n) + " times"; };
        if (c.messages.events)
            write_event(
                c, "changes",
                {{"run", r.number}, {"effect", effect}, {"awake", n.awake}, {"asleep", n.asleep}, {"last", n.last}});
        else if (c.messages.progress)
            std::fprintf(stderr, "%s%s: awake %s, asleep %s in all, the last at t = %s s (run.state_changes)\n",
                         line_start(), effect.c_str(), times(n.awake).c_str(),
                         n.asleep == 0 ? "never" : times(n.asleep).c_str(), number_text(n.last, 4).c_str());
    }
    r.changes.clear();
}

}  // namespace

namespace {

/// While it lasts the run's own functions may neither step it nor change its model.
class InsideStep {
public:
    InsideStep(RunRecord& r, bool mid_step) : r_(r) { set(true), r_.mid_step = mid_step; }
    ~InsideStep() { set(false), r_.mid_step = false; }

private:
    void set(bool inside) { r_.stepping = inside, r_.model->lock(inside); }
    RunRecord& r_;
};

void call_on_step(lua_State* L, const std::shared_ptr<RunRecord>& record) {
    const InsideStep inside(*record, false);
    for (const LuaFunction& f : std::vector<LuaFunction>(record->on_step)) {  // one may add another
        f.push(L);
        push<RunBox>(L, record);
        hold_registry(L, *record->model);
        call_hook(L, f, 1, 0,
                  "run:on_step after step " + std::to_string(record->run->steps_done()) + ", which is done");
    }
}

}  // namespace

void write_rows(RunRecord& r) {
    write_happenings(r);  // first: a kill in between loses none that happened before the last row
    if (r.rows.empty() || r.history_path.empty()) return;
    append(r.history_path, r.rows);
    r.rows.clear();
}

bool advance(lua_State* L, const std::shared_ptr<RunRecord>& record) {
    RunRecord& r = *record;
    const auto c = context(L);
    c->running = L;
    if (r.stepping)
        throw InputError(
            "run:step: called from a function of this very run, in the middle of a step; it steps on when that is "
            "done");
    if (c->mode.planning) return false;
    if (!r.changed.empty() && !r.closed && r.run->verdict() == Verdict::running)
        throw InputError("run:step: " + r.changed + " came after this run was made at " + r.asked_at +
                         ", which does not know of it; declare it before, or make another run that goes on from this "
                         "one (from = run)");
    if (!r.begun) {
        begin_checkpoints(L, *c, r);
        note_happenings(r);
        note_what_went(r);
        begin_history(c, record);
        if (!r.started) add_row(*c, r);
        r.started = true;
        tell_of_beginning(c, r);
    }
    run_is_under_way(true);
    mind_interrupts(L, *c, r);
    keep_if_due(L, *c, r);
    if (r.closed) return false;
    const auto before = Clock::now();
    bool more;
    try {
        const InsideStep inside(r, true);
        const Doing doing(r.run->kind()[0] == 's' ? "a step of the static run" : "a step of the dynamic run");
        more = r.run->advance();
    } catch (const HookError&) {
        write_rows(r);
        if (asked_to_end) throw Interrupted("");  // so did the function of the script
        throw;
    } catch (...) {
        write_rows(r);
        throw;
    }
    const auto now = Clock::now();
    r.wall += seconds(now - before);
    note_happenings(r);
    note_what_went(r);
    if (more) {
        sample(r);
        if (r.every > 0 && r.run->steps_done() % r.every == 0) add_row(*c, r);
    }
    if (more && !r.on_step.empty()) call_on_step(L, record);
    const bool over = !more || r.run->verdict() != Verdict::running;
    r.closed = over;
    if (over) run_is_under_way(false);
    if (over && verdict_of(r) == Verdict::failed)
        c->runs.failed.emplace_back(r.number, std::string(r.run->kind()) + " run " + std::to_string(r.number) +
                                                  (r.asked_at.empty() ? "" : ", made at " + r.asked_at) +
                                                  ", failed: " + reason_of(r));
    if (over && (r.every == 0 || r.run->steps_done() % r.every != 0 || lost_by(r))) add_row(*c, r);
    if (over || seconds(now - r.last_write) > 0.5) {
        write_rows(r);
        r.last_write = now;
    }
    tell_changes(*c, r, over);
    for (const auto& list = r.run->warnings(); r.warnings_seen < list.size(); ++r.warnings_seen)
        tell(*c, warning_of(*r.run, list[r.warnings_seen]));
    if (over) tell_findings(*c, r);
    const auto* statics = dynamic_cast<const Statics*>(r.run.get());
    if (statics && statics->instability() && !r.instability_shown && r.run->verdict() != Verdict::failed) {
        r.instability_shown = true;
        if (c->messages.events)
            write_event(*c, "instability", {{"run", r.number}, {"text", statics->instability_text()}});
        else if (c->messages.progress)
            std::fprintf(stderr, "%sstatic: %s\n", line_start(), statics->instability_text().c_str());
    }
    if (over) show_progress(*c, r, true);
    else show_if_due(*c, r, false);
    if (c->messages.observer) c->messages.observer->stepped(*c, r, over, now);
    return more;
}

}  // namespace hinge::script

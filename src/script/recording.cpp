// What a run keeps as it goes: probes, rows of history.csv, and what a user sees meanwhile.
#include "script/recording.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unistd.h>

#include "core/files.h"
#include "script/checkpoint.h"

namespace hinge::script {

double value_of(const Run& run, const Probe& p) {
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

namespace {

using Clock = std::chrono::steady_clock;
double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

void sample(RunRecord& r) {
    for (auto& p : r.probes) {
        p->time.push_back(abscissa(*r.run));
        p->value.push_back(value_of(*r.run, *p));
    }
}

void begin_history(const std::shared_ptr<Context>& c, const std::shared_ptr<RunRecord>& record) {
    RunRecord& r = *record;
    r.begun = true;
    r.start = r.last_progress = r.last_write = Clock::now();
    if (!c->out_dir.empty() && r.every > 0) {
        make_folder(c->out_dir);
        // the last run's history is history.csv; those before it keep theirs by number
        r.history_path = c->out_dir + "/history.csv";
        if (c->writer) {
            write_rows(*c->writer);
            c->writer->history_path = c->out_dir + "/history-" + std::to_string(++c->histories) + ".csv";
            std::rename(r.history_path.c_str(), c->writer->history_path.c_str());
        } else
            std::remove((c->out_dir + "/summary.json").c_str());  // what an earlier run left does not speak of this one
        c->writer = record;
        std::string header = "time,factor";
        for (const AccountInfo& account : r.run->accounts())
            if (account.part_of.empty()) header += "," + std::string(account.name);
        header += ",remainder";
        for (const auto& p : r.probes) header += "," + p->name;
        write_whole(r.history_path, r.past.empty() ? header + "\n" : r.past);
        r.past.clear();
    }
}

void add_row(RunRecord& r) {
    const Energy e = r.run->energy();
    r.initial = e.initial;
    r.last_energy_error = e.error;
    if (!r.largest_energy) r.largest_energy.emplace(r.run->structure());
    r.last_energy_share = r.largest_energy->share(e, r.run->accounts());
    if (!std::isnan(r.worst_energy_error) && !(std::abs(e.error) <= r.worst_energy_error))
        r.worst_energy_error = std::abs(e.error);  // an error that is not a number stays
    const long step = r.run->state().step;
    if (r.history_path.empty() || step < r.row_of)
        return;  // a run that failed may have gone back to its last good step
    r.row_of = step;
    char text[64];
    std::snprintf(text, sizeof text, "%.9g,%.9g", r.run->state().time, r.run->state().factor);
    r.rows += text;
    const auto add = [&](double value) {
        std::snprintf(text, sizeof text, ",%.9g", value);
        r.rows += text;
    };
    for (const AccountInfo& account : r.run->accounts())
        if (account.part_of.empty()) add(e[account.name]);
    add(e.error);
    for (const auto& p : r.probes) {
        std::snprintf(text, sizeof text, ",%.9g", value_of(*r.run, *p));
        r.rows += text;
    }
    r.rows += '\n';
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

void show_progress(const Context& c, RunRecord& r, bool last) {
    if (!c.progress) return;
    const double wall = seconds(Clock::now() - r.start);
    if (last && wall < 2) return;
    const bool screen = on_screen();
    const long done = r.run->steps_done(), all = r.run->planned_steps(), now = done - r.resumed_at;
    const double share = std::min(1.0, double(done) / double(std::max(1L, all)));
    const double left = now > 0 ? wall * double(std::max(0L, all - done)) / double(now) : 0;
    std::string bar(24, '-');
    for (int i = 0; i < int(24 * share); ++i) bar[i] = '#';
    char energy_error[48] = "";
    if (r.last_energy_error != 0)
        std::snprintf(energy_error, sizeof energy_error, "  energy error %+.2g %%", 100 * r.last_energy_share);
    std::fprintf(stderr, "%s%s [%s] %3.0f %%  step %ld of %ld  %.0f steps/s  %s%.0f s%s%s", screen ? "\r\033[K" : "",
                 r.run->kind(), bar.c_str(), 100 * share, done, all, double(now) / std::max(wall, 1e-9),
                 last ? "took " : "left ", last ? wall : left, energy_error, screen && !last ? "" : "\n");
    std::fflush(stderr);
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
    if (c->planning) return false;
    if (!r.begun) {
        begin_checkpoints(L, *c, r);
        note_what_went(r);
        begin_history(c, record);
        if (!r.started) add_row(r);
        r.started = true;
    }
    mind_interrupts(L, *c, r);
    keep_if_due(L, *c, r);
    if (r.closed) return false;
    const auto before = Clock::now();
    bool more;
    try {
        const InsideStep inside(r, true);
        more = r.run->advance();
    } catch (...) {
        write_rows(r);
        throw;
    }
    const auto now = Clock::now();
    r.wall += seconds(now - before);
    note_what_went(r);
    if (more) {
        sample(r);
        if (r.every > 0 && r.run->steps_done() % r.every == 0) add_row(r);
    }
    if (more && !r.on_step.empty()) call_on_step(L, record);
    const bool over = !more || r.run->verdict() != Verdict::running;
    r.closed = over;
    if (over && (r.every == 0 || r.run->steps_done() % r.every != 0)) add_row(r);
    if (over || seconds(now - r.last_write) > 0.5) {
        write_rows(r);
        r.last_write = now;
    }
    for (const auto& list = r.run->wakings(); r.wakings_shown < list.size(); ++r.wakings_shown)
        if (c->progress) {
            const Run::Waking& w = list[r.wakings_shown];
            std::fprintf(stderr, "%st = %.4g s: %s %s, %s\n", on_screen() ? "\r\033[K" : "", w.time, w.effect.c_str(),
                         w.awake ? "awake" : "asleep", w.why.c_str());
        }
    const auto* statics = dynamic_cast<const Statics*>(r.run.get());
    if (statics && statics->instability() && !r.instability_shown && r.run->verdict() != Verdict::failed) {
        r.instability_shown = true;
        if (c->progress)
            std::fprintf(stderr, "%sstatic: %s\n", on_screen() ? "\r\033[K" : "", statics->instability_text().c_str());
    }
    const double pause = on_screen() ? 0.2 : 10;
    if (seconds(now - r.start) > (on_screen() ? 2.0 : 5.0) && seconds(now - r.last_progress) > pause) {
        show_progress(*c, r, false);
        r.last_progress = now;
    }
    if (over) show_progress(*c, r, true);
    return more;
}

}  // namespace hinge::script

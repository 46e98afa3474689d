// Recording during a run: probes, rows of history.csv, and progress messages.

#include "record/recording.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/doing.h"
#include "core/files.h"
#include "core/quoting.h"
#include "record/chain.h"
#include "record/element_events.h"
#include "record/folder_lock.h"
#include "record/folders.h"
#include "record/progress.h"
#include "record/run_checkpoint.h"
#include "record/run_observer.h"
#include "record/summary.h"
#include "record/told_warnings.h"
#include "run/energy_monitor.h"
namespace hinge {

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

void weigh_error(RunRecord& r, const Energy& e) {
    LargestEnergy largest(r.run->structure());
    largest.set_most(r.largest_energy);
    largest.set_most(std::max(largest.most(), r.run->largest_energy()));  // it looks between the rows too
    r.last_energy_share = r.state_energy_share = largest.share(e, r.run->accounts());
    r.largest_energy = largest.most();
    if (const LostBalance* lost = r.run->lost()) r.last_energy_share = lost->share;
}

namespace {

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
    else write_whole(path, whole_text(probes_json(r)));
}

/// Its history is history.csv from now on; those of the runs before it are kept by number.
void take_files(const std::shared_ptr<Context>& c, const std::shared_ptr<RunRecord>& record) {
    take_folder(*c);
    record->files.history_path = c->output.folder + "/history.csv";
    if (c->runs.writer) {
        write_rows(*c->runs.writer);
        const std::string number = "-" + std::to_string(++c->runs.histories) + ".csv";
        c->runs.writer->files.history_path = c->output.folder + "/history" + number;
        c->runs.writer->files.events_path = c->output.folder + "/events" + number;
        std::rename(record->files.history_path.c_str(), c->runs.writer->files.history_path.c_str());
        // What stands there of an earlier program: nothing has happened in this one, and there was no probe.
        const auto keep = [&](const std::string& file, const std::string& as) {
            if (std::rename((c->output.folder + file).c_str(), as.c_str()) != 0) std::remove(as.c_str());
        };
        keep("/events.csv", c->runs.writer->files.events_path);
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
    r.progress.start = r.progress.last_shown = r.progress.last_write = Clock::now();
    const bool keeps = !c->output.folder.empty() && r.every > 0;
    if (!keeps && !c->messages.observer) return;
    if (keeps) take_files(c, record);
    std::string header = "time,factor";
    for (const AccountInfo& account : r.run->accounts())
        if (account.part_of.empty()) header += "," + std::string(account.name);
    header += ",energy_error";
    for (const auto& p : r.probes) header += "," + csv_text(p->name);
    const std::string text = r.files.past.empty() ? header + "\n" : r.files.past;
    if (c->messages.observer) c->messages.observer->begun(r, text);
    if (!keeps) return;
    write_whole(r.files.history_path, text);
    r.files.past.clear();
}

void add_row(const Context& c, RunRecord& r) {
    const Energy e = r.run->energy();
    const LostBalance* lost = r.run->lost();
    r.initial = e.initial;
    r.last_energy_error = lost ? lost->energy.error : e.error;
    weigh_error(r, e);
    if (!std::isnan(r.worst_energy_error) && !(std::abs(r.last_energy_error) <= r.worst_energy_error))
        r.worst_energy_error = std::abs(r.last_energy_error);  // an error that is not a number stays
    const long step = lost ? lost->step : r.run->state().step;
    if (step < r.row_of) return;  // a run that failed may have gone back to its last good step
    r.row_of = step;
    keep_row(r, lost ? lost->energy : e, lost);
    if (r.files.history_path.empty() && (!c.messages.observer || r.every == 0)) return;
    const std::string row = history_row(r, lost ? lost->energy : e, lost);
    if (!r.files.history_path.empty()) r.files.rows += row;
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
        if (s.gone[n] && std::isnan(r.left_at[n]) && !r.run->structure().is_alone(int(n))) r.left_at[n] = now;
}

/// While it lasts the run's own functions may not step it.
class InsideStep {
public:
    InsideStep(RunRecord& r, bool mid_step) : r_(r) { r_.stepping = true, r_.mid_step = mid_step; }
    ~InsideStep() { r_.stepping = r_.mid_step = false; }

private:
    RunRecord& r_;
};

}  // namespace

void write_rows(RunRecord& r) {
    if (!r.files.history_path.empty()) refuse_removed(r.files.history_path);
    write_happenings(r);  // first: a kill in between loses none that happened before the last row
    if (r.files.rows.empty() || r.files.history_path.empty()) return;
    append_to(r.files.history_path, r.files.rows);
    r.files.rows.clear();
}

namespace {

/// Refuses a step that the script may not ask for now.
void refuse_step(const RunRecord& r) {
    if (r.stepping)
        throw InputError(
            "run:step: called from a function of this very run, in the middle of a step; it steps on when that is "
            "done");
}

/// Refuses to step a run that does not know of all that was declared since it was made.
void refuse_outdated(const RunRecord& r) {
    if (!r.changed.empty() && !r.closed && r.run->verdict() == Verdict::running)
        throw InputError("run:step: " + r.changed + " came after this run was made at " + r.asked_at +
                         ", which does not know of it; declare it before, or make another run that goes on from this "
                         "one (from = run)");
}

/// Says how a run ended, and keeps its failure for the summary.
void tell_end(Context& c, RunRecord& r) {
    if (verdict_of(r) == Verdict::failed)
        c.runs.failed.push_back({r.number,
                                 std::string(r.run->kind()) + " run " + std::to_string(r.number) +
                                     (r.asked_at.empty() ? "" : ", made at " + r.asked_at) +
                                     ", failed: " + reason_of(r),
                                 cause_of(r)});
    tell_step(c, r, true);
}

/// Before the first step: opens the files and records the start.
void begin(const std::shared_ptr<Context>& c, const std::shared_ptr<RunRecord>& record) {
    RunRecord& r = *record;
    begin_checkpoints(*c, r);
    note_happenings(r);
    note_what_went(r);
    begin_history(c, record);
    if (!r.started) add_row(*c, r);
    r.started = true;
    tell_of_beginning(c, r);
    if (r.closed) tell_end(*c, r);  // it went on from the checkpoint of a run that had ended
}

/// A step of the engine; an error leaves the rows so far in the file. Returns whether there was one to take.
bool step_once(RunRecord& r) {
    try {
        const InsideStep inside(r, true);
        const Doing doing(r.run->is_static() ? "a step of the static run" : "a step of the dynamic run");
        return r.run->advance();
    } catch (const HookError&) {
        write_rows(r);
        if (asked_to_end) throw Interrupted("");  // so did the function of the script
        throw;
    } catch (...) {
        write_rows(r);
        throw;
    }
}

/// Records the step: breaks, probes and a row; then the program's own functions.
void keep_results(const Context& c, RunRecord& r, bool more, StepHooks& hooks) {
    note_happenings(r);
    note_what_went(r);
    if (!more) return;
    sample(r);
    if (r.every > 0 && r.run->steps_done() % r.every == 0) add_row(c, r);
    const InsideStep inside(r, false);
    hooks.after_step(r);
}

/// Closes a run that is over: its last row.
void close_run(const Context& c, RunRecord& r) {
    if (r.every == 0 || r.run->steps_done() % r.every != 0 || r.run->lost()) add_row(c, r);
}

}  // namespace

void record_run(Context& c, const std::shared_ptr<RunRecord>& record) {
    if (c.runs.last) tell_findings(c, *c.runs.last);
    c.runs.last = record;
    ++c.runs.made;
}

bool record_step(const std::shared_ptr<Context>& c, const std::shared_ptr<RunRecord>& record, StepHooks& hooks) {
    RunRecord& r = *record;
    refuse_step(r);
    if (c->mode.planning) return false;
    refuse_outdated(r);
    if (!r.begun) begin(c, record);
    hooks.before_step(r);
    keep_if_due(*c, r);
    if (r.closed) return false;
    const auto before = Clock::now();
    const bool more = step_once(r);
    const auto now = Clock::now();
    r.wall += seconds_of(now - before);
    keep_results(*c, r, more, hooks);
    const bool over = !more || r.run->verdict() != Verdict::running;
    r.closed = over;
    if (over) close_run(*c, r);
    if (over || seconds_of(now - r.progress.last_write) > 0.5) {
        write_rows(r);
        r.progress.last_write = now;
    }
    if (over) tell_end(*c, r);
    else tell_step(*c, r, false);
    if (c->messages.observer) c->messages.observer->stepped(*c, r, over, now);
    if (!more) keep_if_due(*c, r);  // it has failed, and nobody need ask for another step
    return more;
}

bool record_step(const std::shared_ptr<Context>& c, const std::shared_ptr<RunRecord>& record) {
    StepHooks none;
    return record_step(c, record, none);
}

std::optional<std::pair<int, double>> break_of(const RunRecord& r, int member) {
    if (!r.run || member >= int(r.run->structure().model().members().size())) return {};
    const auto [first, end] = elements_of(r.run->structure(), member);
    std::optional<std::pair<int, double>> earliest;
    for (int e = first; e < end; ++e) {
        if (!r.run->state().broken[e]) continue;
        const double time = r.broken_at.empty() ? -std::numeric_limits<double>::infinity() : r.broken_at[e];
        if (!earliest || time < earliest->second) earliest = {e - first + 1, time};
    }
    return earliest;
}

}  // namespace hinge

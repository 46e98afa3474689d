// Recording of a run's steps: its probes, history.csv, events.csv, checkpoints and messages.
//
// A program makes a Context, gives it each run that it makes (record_run), and takes the steps with record_step:
//
//     auto context = std::make_shared<hinge::Context>();
//     context->output.folder = "out";
//     auto record = std::make_shared<hinge::RunRecord>();
//     record->run = std::make_shared<hinge::Dynamics>(structure, hinge::initial_state(*structure), settings);
//     hinge::record_run(*context, record);
//     while (hinge::record_step(context, record)) {}
//     hinge::write_summary(*context);
#pragma once

#include "record/context.h"
#include "record/run_record.h"

namespace hinge {

/// What a program does between the steps of a run. By default nothing.
struct StepHooks {
    virtual ~StepHooks() = default;
    /// Before each step; may throw, such as Interrupted, to end the run there.
    virtual void before_step(RunRecord&) {}
    /// After a step that is recorded; may stop the run, or throw.
    virtual void after_step(RunRecord&) {}
};

/// Makes it the context's last run, of which summary.json speaks, and prints what the one before found as a whole.
void record_run(Context& c, const std::shared_ptr<RunRecord>& record);

/// One step, recorded. False at the end. Throws InputError for a run that is inside a step or outdated, and what the
/// engine, the hooks and the writing of files throw.
bool record_step(const std::shared_ptr<Context>& c, const std::shared_ptr<RunRecord>& record, StepHooks& hooks);
bool record_step(const std::shared_ptr<Context>& c, const std::shared_ptr<RunRecord>& record);  ///< without hooks

/// summary.json of the last run in the output folder.
void write_summary(Context& c);

/// Rows of history.csv and events.csv that are not yet in the files.
void write_rows(RunRecord& r);

/// A row of history.csv with these energies, and its line's end. `lost`: the balance that no longer closed, with probes
/// that are not numbers; null: that of the state.
std::string history_row(const RunRecord& record, const Energy& energy, const LostBalance* lost = nullptr);

/// The energy error as a part of the largest energy: of the state, and of the run, which for a run whose balance no
/// longer closed is that of the moment at which this was seen, not that of the state to which it went back.
void weigh_error(RunRecord& record, const Energy& energy);

void keep_row(RunRecord& r, const Energy& energy, const LostBalance* lost = nullptr);  ///< for plots; see KeptRows

/// The rows kept for plots, and the present state last.
struct RunHistory {
    std::vector<std::string> columns;  ///< time, factor, the accounts with their parts, energy_error
    std::vector<std::string> parts;    ///< those columns that are parts of another account
    std::vector<double> values;        ///< row by row
};

/// In the middle of a step the last row is of the state before it; of a run whose energy balance no longer closed it is
/// of the moment at which this was seen.
RunHistory history_of(const RunRecord& record);

/// Number of the member's element that broke first and the time (s) of it, -inf where that was before this run.
std::optional<std::pair<int, double>> break_of(const RunRecord& r, int member);

}  // namespace hinge

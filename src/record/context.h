// What the runs of one program share: its output folder, its messages, and which runs there are.
#pragma once

#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "advice/warning.h"

namespace hinge {

struct RunObserver;
struct RunRecord;

/// A run that has failed: its number, a text with the reason, and the cause (cause_of).
struct FailedRun {
    int number;
    std::string text, cause;
};

/// Data shared by the runs of a program: the output folder, messages, and the run of the summary. By default it writes
/// and prints nothing.
struct Context {
    /// The program's output: its folder, and files that could not be written.
    struct Output {
        std::string folder;                                  ///< empty: nothing is written unless a path is given
        std::string owner;                                   ///< run.json of that folder; "": none is written
        bool owner_written = false;                          ///< run.json is there
        std::vector<std::pair<double, std::string>> frames;  ///< written so far: time, file
        std::set<std::string> checkpoints;                   ///< files that runs have named
        std::vector<std::string> lost;  ///< pictures, frames and checkpoints that could not be written, and why
    };
    /// Messages on stderr: settings, and those already printed.
    struct Messages {
        bool progress = false;                   ///< progress of runs, and their changes of state
        bool warns = false;                      ///< likely mistakes
        bool tells_failures = false;             ///< failures that the script did not check
        std::FILE* events = nullptr;             ///< the same as JSON, an object a line; null: nowhere
        RunObserver* observer = nullptr;         ///< watches the steps of runs (hinge run --live); null: none
        std::vector<std::string> warned;         ///< warnings with their advice: each is printed once
        std::optional<Warning> of_units;         ///< the first such warning of the model checked last
        int warnings_told = 0, looked_over = 0;  ///< lines printed; models checked
        std::set<std::string> described;         ///< the plans printed so far: a loop's runs are described once
        std::map<std::string, std::string> described_at;  ///< line of the run, by the text printed of its model
    };
    /// How the program was asked to make its runs.
    struct Mode {
        bool looks_over = false;  ///< check the models of runs for likely mistakes
        bool resume = false;      ///< runs go on from their checkpoints
        bool sandbox = false;     ///< the script is not trusted: nothing is written outside the output folder
        bool planning = false;    ///< runs are described, not stepped; nothing is written
        bool checking = false;    ///< while planning: models are checked, and no effects are listed
        std::string left_out;     ///< the effect that runs do without, whatever their models declare; "" for none
    };
    /// The runs that have been made.
    struct Runs {
        std::shared_ptr<RunRecord> last;
        std::shared_ptr<RunRecord> writer;  ///< the run that writes history.csv; earlier ones have numbered files
        int made = 0;
        int begun = 0;      ///< runs that have taken a step
        int histories = 0;  ///< numbered history files so far
        std::vector<FailedRun> failed;
        std::set<int> asked;  ///< runs whose verdict the script has read
    };
    Output output;
    Messages messages;
    Mode mode;
    Runs runs;
};

}  // namespace hinge

// C++ objects in the userdata of a script, and the script's context.
#pragma once

#include <chrono>
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/warnings.h"
#include "script/lua/model_registry.h"
#include "run/energy_monitor.h"
#include "run/run.h"

namespace hinge::script {

/// A run that has failed: its number, a text with the reason, and the cause (cause_of).
struct FailedRun {
    int number;
    std::string text, cause;
};

/// Data shared by a Lua state that runs a script: the output folder, messages, and the run of the summary.
struct Context {
    /// The script's output: its folder, and files that could not be written.
    struct Output {
        std::string folder;                                  ///< empty: nothing is written unless a path is given
        std::string owner;                                   ///< run.json of that folder; "": none is written
        bool owner_written = false;                          ///< run.json is there
        std::vector<std::pair<double, std::string>> frames;  ///< written so far: time, file
        std::set<std::string> checkpoints;                   ///< files that runs have named
        std::vector<std::string> lost;  ///< pictures, frames and checkpoints that could not be written, and why
    };
    /// Messages of the program on stderr: settings, and those already printed.
    struct Messages {
        bool progress = false;                   ///< progress of runs, and their changes of state
        bool warns = false;                      ///< likely mistakes
        bool tells_failures = false;             ///< failures that the script did not check
        std::FILE* events = nullptr;             ///< the same as JSON, an object a line; null: nowhere
        struct RunObserver* observer = nullptr;  ///< watches the steps of runs (hinge run --live); null: none
        std::vector<std::string> warned;         ///< warnings with their advice: each is printed once
        std::optional<Warning> of_units;         ///< the first such warning of the model checked last
        int warnings_told = 0, looked_over = 0;  ///< lines printed; models checked
        std::set<std::string> described;         ///< the plans printed so far: a loop's runs are described once
        std::map<std::string, std::string> described_at;  ///< line of the run, by the text printed of its model
    };
    /// How the program was asked to execute the script.
    struct Mode {
        bool looks_over = false;  ///< check the models of runs for likely mistakes
        bool resume = false;      ///< runs go on from their checkpoints
        bool sandbox = false;     ///< the script is not trusted: nothing is written outside the output folder
        bool planning = false;    ///< runs are described, not stepped; nothing is written
        bool checking = false;    ///< while planning: models are checked, and no effects are listed
        std::string left_out;     ///< the effect that runs do without, whatever their models declare; "" for none
    };
    /// Ctrl-C and SIGTERM.
    struct Signals {
        volatile std::sig_atomic_t interrupted = 0;  ///< the signal that came: the run under way ends with an error
        bool ends_on_signals = false;                ///< the program ends as well; false: the prompt goes on
        int exit_status = 3;  ///< after such an end: 3 with a checkpoint written, else 128 and the signal
    };
    /// The runs that the script has made.
    struct Runs {
        std::shared_ptr<struct RunRecord> last;
        std::shared_ptr<struct RunRecord>
            writer;  ///< the run that writes history.csv; earlier ones have numbered files
        int made = 0;
        int begun = 0;      ///< runs that have taken a step
        int histories = 0;  ///< numbered history files so far
        std::vector<FailedRun> failed;
        std::set<int> asked;  ///< runs whose verdict the script has read
    };
    /// The error that the engine raised last, to tell its kind from its text.
    struct Errors {
        std::string last;
        const char* kind = "";   ///< "input", "outside", "interrupted", "hook"
        std::string about, why;  ///< the file that could not be written, or the field of wrong input; why; else ""
    };
    lua_State* running = nullptr;  ///< the thread that entered the engine last; hooks are called on it
    std::string library;           ///< folder of the Lua library
    std::string picture_module;    ///< path of the output module
    Output output;
    Messages messages;
    Mode mode;
    Signals signals;
    Runs runs;
    Errors errors;
    std::size_t unseen = 0;  ///< bytes that objects took outside Lua since the last full collection
};
std::shared_ptr<Context> context(lua_State* L);  ///< throws InputError while Lua is being closed
bool has_context(lua_State* L);
void set_context(lua_State* L, std::shared_ptr<Context> c);

/// Lua's collector sees a handle, not the megabytes behind it: each 16 MB that new objects took outside Lua make it
/// collect all.
void tell_collector(lua_State* L, std::size_t bytes);

struct MaterialBox {
    static constexpr const char* lua_name = "hinge.material";
    std::shared_ptr<const Material> value;
};
struct SectionBox {
    static constexpr const char* lua_name = "hinge.section";
    std::shared_ptr<const Section> value;
};

struct BackboneBox {
    static constexpr const char* lua_name = "hinge.backbone";
    std::shared_ptr<const beam::MaterialLaw> value;
};

/// A model that a script has made.
struct ScriptModel : Model {
    using Model::Model;
    std::string closed_at;  ///< the script's line that closed it, "" while it is open
    std::vector<std::weak_ptr<struct RunRecord>> runs;
    std::optional<int> gravity_case;               ///< that gravity belongs to, -1 for none
    std::vector<Vec3> crooked;                     ///< by what imperfections have moved the first nodes, m
    std::vector<std::pair<int, int>> group_loads;  ///< of model:load { group = }: the group, the first load's number
};
struct ModelBox {
    static constexpr const char* lua_name = "hinge.model";
    std::shared_ptr<ScriptModel> value;
};
struct NodeBox {
    static constexpr const char* lua_name = "hinge.node";
    std::shared_ptr<ScriptModel> model;
    int index;
};
struct MemberBox {
    static constexpr const char* lua_name = "hinge.member";
    std::shared_ptr<ScriptModel> model;
    int index;
};
struct GroupBox {
    static constexpr const char* lua_name = "hinge.group";
    std::shared_ptr<ScriptModel> model;
    int index;
    std::string name;
};
struct LoadBox {
    static constexpr const char* lua_name = "hinge.load";
    std::shared_ptr<ScriptModel> model;
    int index;  ///< its number
    int node;
    std::string removed_at = {};  ///< the script's line that removed it, "" while it is there
};

struct CaseBox {
    static constexpr const char* lua_name = "hinge.case";
    std::shared_ptr<ScriptModel> model;
    int index;
};

/// A quantity of a node, or its difference between two nodes, recorded at every step.
struct Probe {
    int node;
    enum class Quantity { displacement, velocity, acceleration, reaction } quantity;
    int component;
    std::string name;
    std::vector<double> time, value;
    int relative_to = -1;  ///< the node whose value is subtracted, -1: none
    double height = 0;     ///< m, divisor of the difference for a drift; 0: none
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.node, s.quantity, s.component, s.name, s.time, s.value, s.relative_to, s.height);
    }
};
struct ProbeBox {
    static constexpr const char* lua_name = "hinge.probe";
    std::shared_ptr<Probe> value;
};

/// First contact, yield or fracture of an element; first yield of a joint about an axis, a limit of its own that it has
/// reached in statics, its break, and the break of a connector.
struct ElementEvent {
    enum class What : int { contact, yield, fracture, joint_yield, joint_limit, joint_break, connector_break } what;
    double at;         ///< s; in statics the load factor
    int element, end;  ///< end 1 or 2; 0: no end, or both
    int limit;         ///< beam::Limit reached at a break; of joints and connectors JointRating::Which
    double strain,
        of;          ///< the strain that reached it, and its limit; of joints and connectors moment, rotation or force
    int joint = -1;  ///< joint or connector, in the order of declaration
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.what, s.at, s.element, s.end, s.limit, s.strain, s.of, s.joint);
    }
};

/// Rows of the energy balance for plots, with or without a history.csv: time, load factor, all accounts, energy error.
/// If they are many, every second one is removed, and so on.
struct KeptRows {
    static constexpr long most = 8192;
    long stride = 1, seen = 0;
    std::vector<double> values;  ///< row by row
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.stride, s.seen, s.values);
    }
};

/// Recorded results of a run's steps that a checkpoint contains.
struct Recorded {
    bool started = false, closed = false;
    long breaks_noted = 0;
    std::vector<double> broken_at,
        left_at;  ///< s, when an element broke, when a node lost its last; -inf: before this run; empty until one does
    double wall = 0;  ///< s in steps
    double worst_energy_error = 0, last_energy_error = 0, initial = 0;
    long row_of = -1;                                      ///< the step of the last row
    std::vector<ElementEvent> happenings;                  ///< in order
    std::vector<std::uint8_t> yielded_seen, touched_seen;  ///< of each element, as in the state
    std::vector<std::uint8_t> joints_seen;                 ///< of each joint, then of each connector: what has happened
    KeptRows kept_rows;
    long resumed_at = 0;            ///< steps, when it last went on from a checkpoint
    double largest_energy = 0;      ///< J, of the rows so far (LargestEnergy::most)
    double last_energy_share = 0;   ///< the energy error as a part of it, also of a balance that no longer closed
    double state_energy_share = 0;  ///< likewise of the last state, to which such a run went back
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.started, s.closed, s.breaks_noted, s.broken_at, s.left_at, s.wall, s.worst_energy_error,
          s.last_energy_error, s.initial, s.row_of, s.happenings, s.yielded_seen, s.touched_seen, s.joints_seen,
          s.kept_rows, s.resumed_at, s.largest_energy, s.last_energy_share, s.state_energy_share);
    }
};

/// Checkpoint file of a run, and the interval between writes.
struct CheckpointPlan {
    std::string file;
    double every = 60;             ///< s
    std::optional<LuaValue> keep;  ///< the script's table that is saved with it
    std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
    bool ended = false;  ///< it holds the end of the run
};

/// A run with its recorded results.
struct RunRecord : Recorded {
    std::shared_ptr<Run> run;
    std::shared_ptr<ScriptModel> model;  ///< the script's own, to know its nodes and groups again
    std::vector<std::shared_ptr<Probe>> probes;
    long every = 1;  ///< steps between rows of history.csv; 0: none is kept
    /// The files that grow as the run goes.
    struct Files {
        std::string history_path, events_path;  ///< history.csv and events.csv; "": the run has none
        std::string rows;                       ///< of history.csv, not yet written
        std::string past;                       ///< of history.csv, from a checkpoint
        std::size_t events_written = 0;         ///< of the happenings
    } files;
    std::string asked_at;                  ///< the script's line that made the run
    std::vector<Warning> likely_mistakes;  ///< likely mistakes found when it was made
    std::optional<Warning> of_units;       ///< of its model: a value that looks as if in another unit
    std::string weak;                      ///< the run before that did not reach its end (weak_link); "" for none
    bool weak_allowed = false;             ///< allow_failed = true
    std::string changed;                   ///< the first declaration since, and its line; "" for none
    bool begun = false;                    ///< its files are open
    bool stepping = false;                 ///< inside a step: the script's functions may not start another
    bool mid_step = false;                 ///< inside a step that was not completed
    std::optional<CheckpointPlan> checkpoint;
    std::vector<LuaFunction> on_step;  ///< called after each step
    int number = 0;                    ///< of the program's runs that have begun, from 1
    /// Changes of state of an effect.
    struct Changes {
        int awake = 0, asleep = 0;
        double last = 0;  ///< s
    };
    /// What has been printed and written of it so far.
    struct Progress {
        std::chrono::steady_clock::time_point start, last_shown, last_write;
        std::size_t activations_seen = 0, warnings_seen = 0;
        std::map<std::string, Changes> changes;  ///< by effect: the first of each kind is printed, the others counted
        bool instability_shown = false;
    } progress;
};
struct RunBox {
    static constexpr const char* lua_name = "hinge.run";
    std::shared_ptr<RunRecord> value;
};

std::string name_of(const NodeBox& n);
std::string name_of(const MemberBox& m);
std::string name_of(const GroupBox& g);
std::string name_of(const LoadBox& l);
std::string name_of(const CaseBox& c);
std::string name_of(const ModelBox& m);
std::string name_of(const RunBox& r);

/// "" for an object that exists, else the reason, as " of a model that was closed at script.lua:12".
std::string gone(const ScriptModel& model);
template <class T>
std::string gone(const T& handle) {
    return gone(*handle.model);
}
std::string gone(const LoadBox& l);
std::string gone(const ModelBox& m);
std::string gone(const RunBox& r);

template <class T>
requires requires(const T& handle) { name_of(handle); }
void refuse_gone(const T& handle, const std::string& function) {
    if (const std::string since = gone(handle); !since.empty())
        throw InputError(function + ": this is " + name_of(handle) + since);
}

/// The loads of the groups that a member has joined act on it too.
void join_loads(ScriptModel& model, int member);

/// Pushes the handle to the model's node, member, group or load of that number; while one is in use it is always the
/// same one.
template <class T, class... More>
void push_handle(lua_State* L, const std::shared_ptr<ScriptModel>& model, int number, More&&... more) {
    push_handles(L, *model, T::lua_name);
    if (lua_rawgeti(L, -1, number + 1) == LUA_TNIL) {
        lua_pop(L, 1);
        push<T>(L, model, number, std::forward<More>(more)...);
        lua_pushvalue(L, -3);
        lua_setiuservalue(L, -2, 1);  // as hold_registry does
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, number + 1);
    }
    lua_replace(L, -3);  // the registry
    lua_pop(L, 1);
}
void push_group(lua_State* L, const std::shared_ptr<ScriptModel>& model, int index);
void push_load(lua_State* L, const std::shared_ptr<ScriptModel>& model, int number);

/// Rows of history.csv and events.csv that are not yet in the files.
void write_rows(RunRecord& r);

/// One step, recorded. False at the end.
bool advance(lua_State* L, const std::shared_ptr<RunRecord>& record);

void open_values(lua_State* L, int module);    ///< hinge.material, hinge.section
void open_backbone(lua_State* L, int module);  ///< hinge.backbone
void open_joints(lua_State* L, int module);    ///< hinge.joint
void open_model(lua_State* L, int module);     ///< hinge.model
void open_objects(lua_State* L);               ///< nodes, members, groups, loads
void open_run(lua_State* L);
void open_modes(lua_State* L);               ///< run:modes, run:buckling
void open_reading(lua_State* L);             ///< results of runs, nodes and members
void open_output(lua_State* L, int module);  ///< summary and other files
void open_pictures(lua_State* L, int module);
void open_plots(lua_State* L, int module);
void open_frames(lua_State* L, int module);   ///< frames for a page
void open_measure(lua_State* L, int module);  ///< clock, memory, callback of every run

#define HINGE_MODEL_METHOD(name, function) int function(lua_State* L);
#define HINGE_MODEL_RUN(name, function) int function(lua_State* L);
#include "script/bind/model_methods.inc"
#undef HINGE_MODEL_METHOD
#undef HINGE_MODEL_RUN
int set_gravity(lua_State* L);
#define HINGE_LOAD_ON(target, function, ...) int function(lua_State* L);
#include "script/bind/load_targets.inc"
#undef HINGE_LOAD_ON

/// Reads a quantity over time from a field of the options: a function, or points with linear interpolation. `each`: the
/// value of a point beside its time. Empty if the field is absent. `jumps`: two points may have the same time.
History read_history(Options& o, const char* field, const std::string& each, const Model& model, bool jumps);

/// Calls body, which changes its model: runs made before are then refused (advance).
int declaring(lua_State* L, const char* name, Body body);
void note_change(lua_State* L, ScriptModel& model, const char* name);
template <Name name, int most, Body body>
int declares(lua_State* L) {
    return taking(L, name.text, most, [](lua_State* inner) { return declaring(inner, name.text, body); });
}

/// The case in field 'case' of a load, by name or handle; -1 where there is none.
int case_of(Options& o, const Model& model);
int case_argument(lua_State* L, int index, const std::string& what, const Model& model);
/// The loads of a run: its field 'loads', or those of the run before.
LoadChoice read_choice(Options& o, const Model& model, const RunRecord* from, bool is_static);
void open_cases(lua_State* L);

/// Makes the run that model:static{} and model:dynamic{} return.
int make_run(lua_State* L, std::shared_ptr<Run> run, std::shared_ptr<ScriptModel> model, int record_every,
             std::vector<Warning> likely_mistakes = {});

/// Reason for the failure of a run or of the run that it continues, with a warning that may be the cause.
std::string reason_of(const RunRecord& record);

NodeBox& node_argument(lua_State* L, int index, const std::string& what, const Model* model);
MemberBox& member_argument(lua_State* L, int index, const std::string& what, const Model* model);
/// The fields 'member' and 'group', of which one may be given: their indices; left alone where a field is not given.
void read_members(Options& o, const ScriptModel& model, int& member, int& group);
const std::shared_ptr<RunRecord>& run_argument(lua_State* L, int index, const std::string& what,
                                               const Model* model = nullptr);
void prepare_folder(const Context& c, const std::string& file);
/// True if core.on_run is set: such runs write no files.
bool runs_are_measured(lua_State* L);
/// The run made last of the model, nullptr when there is none.
std::shared_ptr<RunRecord> latest_run(lua_State* L, const ScriptModel& model);
/// The index of a group given by handle or name. `copy`: the model's copy that a run or a picture holds, if that is
/// what is asked.
int group_argument(lua_State* L, int index, const std::string& what, const Model& model, const Model* copy = nullptr);
/// Calls the function of core.on_run with the run on top of the stack.
void tell_of_run(lua_State* L);
/// The index of a node that the run has.
int node_of_run(lua_State* L, int index, const RunRecord& r, const std::string& what);
/// Refuses a node that was fixed after the run was made: the run has no reaction there.
void must_be_fixed_in(const RunRecord& r, int node, const std::string& what);
/// Names of nodal quantities for probes and run:read: displacement, velocity, acceleration and reaction, six each, in
/// the order of Probe::Quantity.
const std::vector<std::string>& node_quantities();
/// Number of the member's element that broke first and the time (s) of it, -inf where that was before this run.
std::optional<std::pair<int, double>> break_of(const RunRecord& r, int member);
std::pair<int, int> elements_of(const Structure& structure, int member);  ///< first and one past the last
std::string group_names(const Model& model, const std::string& typed);

}  // namespace hinge::script

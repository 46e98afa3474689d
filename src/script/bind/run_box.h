// Handles of a script to its runs and probes, and arguments that are such handles.
#pragma once

#include "record/run_record.h"
#include "script/bind/model_box.h"
#include "script/lua/context.h"
#include "script/lua/probe_list.h"

namespace hinge::script {

/// A run that a script has made.
struct ScriptRun : RunRecord {
    std::shared_ptr<ScriptModel> model;  ///< the script's own, to know its nodes and groups again
    std::vector<LuaFunction> on_step;    ///< called after each step
};
struct RunBox {
    static constexpr const char* lua_name = "hinge.run";
    std::shared_ptr<ScriptRun> value;
};

std::string name_of(const RunBox& r);
std::string gone(const RunBox& r);

/// Makes the run that model:static{} and model:dynamic{} return.
int make_run(lua_State* L, std::shared_ptr<Run> run, std::shared_ptr<ScriptModel> model, int record_every,
             std::vector<Warning> likely_mistakes = {});

/// One step, recorded. False at the end.
bool advance(lua_State* L, const std::shared_ptr<ScriptRun>& record);

/// The run that the summary speaks of; null where there is none.
std::shared_ptr<ScriptRun> last_run(const ScriptContext& c);

const std::shared_ptr<ScriptRun>& run_argument(lua_State* L, int index, const std::string& what,
                                               const Model* model = nullptr);
/// The run made last of the model, nullptr when there is none.
std::shared_ptr<ScriptRun> latest_run(lua_State* L, const ScriptModel& model);
/// The run that a handle's method reads: the one given as that argument, or the latest of its model.
std::shared_ptr<ScriptRun> run_to_read(lua_State* L, const std::string& function, const ScriptModel& model,
                                       int index = 2);
/// The index of a node that the run has.
int node_of_run(lua_State* L, int index, const ScriptRun& r, const std::string& what);
/// Refuses a node that was fixed after the run was made: the run has no reaction there.
void must_be_fixed_in(const ScriptRun& r, int node, const std::string& what);

/// True if core.on_run is set: such runs write no files.
bool runs_are_measured(lua_State* L);
/// Calls the function of core.on_run with the run on top of the stack.
void tell_of_run(lua_State* L);

}  // namespace hinge::script

// Fields that loads and runs have in common: histories, load cases, and the loads that a run takes.
#pragma once

#include "model/load_cases.h"
#include "record/run_record.h"
#include "script/bind/model_box.h"

namespace hinge::script {

/// Reads a quantity over time from a field of the options: a function, or points with linear interpolation. `each`: the
/// value of a point beside its time. Empty if the field is absent. `jumps`: two points may have the same time.
History read_history(Options& o, const char* field, const std::string& each, const Model& model, bool jumps);

/// The case in field 'case' of a load, by name or handle; -1 where there is none.
int case_of(Options& o, const Model& model);
int case_argument(lua_State* L, int index, const std::string& what, const Model& model);

/// The loads of a run: its field 'loads', or those of the run before.
LoadChoice read_choice(Options& o, const Model& model, const RunRecord* from, bool is_static);

/// Members in the field 'member', or those of the group in 'group', which is -1 where there is none.
struct LoadedMembers {
    std::vector<int> members;
    int group = -1;
};
LoadedMembers read_loaded_members(Options& o, const Model& model);
/// The part of a member's length in the fields 'from' and 'to', 0 and 1 where they are absent.
void read_part(Options& o, double& from, double& to);

/// The loads and the masses of the groups that a member has joined act on it too.
void join_loads(ScriptModel& model, int member);

}  // namespace hinge::script

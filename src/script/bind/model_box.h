// Handles of a script to a model, its nodes, members, groups, loads and load cases, and arguments that are such
// handles.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "effects/line_mass.h"
#include "model/model.h"
#include "script/lua/model_registry.h"
#include "script/lua/options.h"

namespace hinge::script {

struct ScriptRun;

/// A model that a script has made.
struct ScriptModel : Model {
    using Model::Model;
    std::string closed_at;  ///< the script's line that closed it, "" while it is open
    std::vector<std::weak_ptr<ScriptRun>> runs;
    std::optional<int> gravity_case;                     ///< that gravity belongs to, -1 for none
    std::vector<Vec3> crooked;                           ///< by what imperfections have moved the first nodes, m
    std::vector<std::pair<int, LineMass>> group_masses;  ///< of model:mass { group = }
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

std::string name_of(const NodeBox& n);
std::string name_of(const MemberBox& m);
std::string name_of(const GroupBox& g);
std::string name_of(const LoadBox& l);
std::string name_of(const CaseBox& c);
std::string name_of(const ModelBox& m);

/// "" for an object that exists, else the reason, as " of a model that was closed at script.lua:12".
std::string gone(const ScriptModel& model);
template <class T>
std::string gone(const T& handle) {
    return gone(*handle.model);
}
std::string gone(const LoadBox& l);
std::string gone(const ModelBox& m);

template <class T>
requires requires(const T& handle) { name_of(handle); }
void refuse_gone(const T& handle, const std::string& function) {
    if (const std::string since = gone(handle); !since.empty())
        throw InputError(function + ": this is " + name_of(handle) + since);
}

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

NodeBox& node_argument(lua_State* L, int index, const std::string& what, const Model* model);
MemberBox& member_argument(lua_State* L, int index, const std::string& what, const Model* model);
/// The index of a group given by handle or name. `copy`: the model's copy that a run or a picture holds, if that is
/// what is asked.
int group_argument(lua_State* L, int index, const std::string& what, const Model& model, const Model* copy = nullptr);
std::string group_names(const Model& model, const std::string& typed);
/// The fields 'member' and 'group', of which one may be given: their indices; left alone where a field is not given.
void read_members(Options& o, const ScriptModel& model, int& member, int& group);

}  // namespace hinge::script

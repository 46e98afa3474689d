// Nodes, members, groups and loads as objects of a script: their fields, and error messages for those that are gone.
#include <algorithm>

#include "core/text.h"
#include "effects/loads.h"
#include "model/inner_nodes.h"
#include "model/member_ends.h"
#include "section/material_law.h"
#include "script/bind/bind_joints.h"
#include "record/recording.h"
#include "script/bind/model_methods.h"
#include "script/bind/modules.h"
#include "script/bind/run_box.h"
#include "script/bind/value_box.h"

namespace hinge::script {

std::string name_of(const NodeBox& n) { return "node " + std::to_string(n.index + 1); }
std::string name_of(const MemberBox& m) { return "member " + std::to_string(m.index + 1); }
std::string name_of(const GroupBox& g) { return "group '" + g.name + "'"; }
std::string name_of(const LoadBox& l) { return "the load on node " + std::to_string(l.node + 1); }
std::string name_of(const ModelBox&) { return "a model"; }
std::string name_of(const RunBox& r) { return "the run made at " + r.value->asked_at; }

std::string gone(const ScriptModel& model) {
    return model.closed_at.empty() ? "" : " of a model that was closed at " + model.closed_at;
}
std::string gone(const LoadBox& l) {
    return l.removed_at.empty() ? gone(*l.model) : ", which was removed at " + l.removed_at;
}
std::string gone(const ModelBox& m) {
    return m.value->closed_at.empty() ? "" : " that was closed at " + m.value->closed_at;
}
std::string gone(const RunBox& r) { return gone(*r.value->model); }

void push_group(lua_State* L, const std::shared_ptr<ScriptModel>& model, int index) {
    push_handle<GroupBox>(L, model, index, model->groups()[index]);
}
void push_load(lua_State* L, const std::shared_ptr<ScriptModel>& model, int number) {
    push_handle<LoadBox>(L, model, number, find_load(*model, number)->node);
}

void note_change(lua_State* L, ScriptModel& model, const char* name) {
    for (const auto& run : model.runs)
        if (const auto r = run.lock(); r && !r->closed && r->changed.empty())
            r->changed = std::string(name) + " at " + where(L);
}

int declaring(lua_State* L, const char* name, Body body) {
    const auto* box = find<ModelBox>(L, 1);
    const std::shared_ptr<ScriptModel> model = box ? box->value : nullptr;
    const int results = body(L);
    if (model) note_change(L, *model, name);
    return results;
}

namespace {

/// Refuses what is no T of this model. `made_by`: where a script gets one.
template <class T>
T& handle_argument(lua_State* L, int index, const std::string& what, const Model* model, const char* made_by) {
    auto* handle = find<T>(L, index);
    if (!handle) throw InputError(what + " is " + show(L, index) + "; must be " + made_by);
    if (const std::string since = gone(*handle); !since.empty())
        throw InputError(what + " is " + name_of(*handle) + since);
    if (model && handle->model.get() != model)
        throw InputError(what + " is " + name_of(*handle) + " of another model; use one of this model");
    return *handle;
}

}  // namespace

NodeBox& node_argument(lua_State* L, int index, const std::string& what, const Model* model) {
    return handle_argument<NodeBox>(L, index, what, model, "a node made by model:node{x, y, z}");
}

MemberBox& member_argument(lua_State* L, int index, const std::string& what, const Model* model) {
    return handle_argument<MemberBox>(L, index, what, model, "a member made by model:member{a, b, ...}");
}

namespace {
bool in_group(const MemberData& d, int group) {
    return std::find(d.groups.begin(), d.groups.end(), group) != d.groups.end();
}
}  // namespace

std::string group_names(const Model& model, const std::string& typed) {
    std::string list;
    for (const auto& g : model.groups()) list += (list.empty() ? "" : ", ") + ("'" + g + "'");
    return did_you_mean(typed, model.groups()) +
           (list.empty() ? "; the model has no groups" : "; the model has " + list);
}

int group_argument(lua_State* L, int index, const std::string& what, const Model& model, const Model* copy) {
    const Model& asked = copy ? *copy : model;
    int found;
    if (find<GroupBox>(L, index)) {
        found = handle_argument<GroupBox>(L, index, what, &model, "").index;
    } else {
        if (lua_type(L, index) != LUA_TSTRING)
            throw InputError(what + " is " + show(L, index) + "; must be a group or the name of one");
        const std::string name = lua_tostring(L, index);
        found = model.find_group(name);
        if (found < 0) throw InputError(what + ": no group '" + name + "'" + group_names(asked, name));
    }
    if (!copy || copy == &model) return found;
    for (std::size_t i = copy->members().size(); i < model.members().size(); ++i)
        if (in_group(model.members()[i], found))
            throw InputError(what + " is group '" + model.groups()[found] + "', of which member " +
                             std::to_string(i + 1) + " was declared after this run was made");
    return found;
}

namespace {

template <class Push>
int push_list(lua_State* L, std::size_t n, Push push_item) {
    lua_createtable(L, int(n), 0);
    for (std::size_t i = 0; i < n; ++i) {
        push_item(i);
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    return 1;
}

int push_nodes(lua_State* L, const std::shared_ptr<ScriptModel>& m, const std::vector<int>& nodes) {
    return push_list(L, nodes.size(), [&](std::size_t i) { push_handle<NodeBox>(L, m, nodes[i]); });
}

void push_triple(lua_State* L, const Vec3& v) { push_array(L, v.data(), 3); }

int push_text(lua_State* L, const std::string& text) { return lua_pushlstring(L, text.data(), text.size()), 1; }

std::string show_vector(const Vec3& v) {
    return "{" + script::show(v.x()) + ", " + script::show(v.y()) + ", " + script::show(v.z()) + "}";
}

/// What model:fix takes to fix these degrees of freedom.
std::string degrees_of_freedom(std::uint8_t fixed) {
    if (fixed == 63) return "all";
    std::string text;
    for (int i = 0; i < 6; ++i)
        if (fixed >> i & 1) text += (text.empty() ? "" : ",") + std::string(i < 3 ? "" : "r") + "xyz"[i % 3];
    return text;
}

double length_of(const Model& m, int member) {
    return (end_position(m, member, 1) - end_position(m, member, 0)).norm();
}

// ---- lists --------------------------------------------------------------------------------------------------------

int model_nodes(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:nodes").value;
    return push_list(L, m->nodes().size(), [&](std::size_t i) { push_handle<NodeBox>(L, m, int(i)); });
}

int model_members(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:members").value;
    return push_list(L, m->members().size(), [&](std::size_t i) { push_handle<MemberBox>(L, m, int(i)); });
}

int model_groups(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:groups").value;
    return push_list(L, m->groups().size(), [&](std::size_t i) { push_group(L, m, int(i)); });
}

int model_loads(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:loads").value;
    const auto& loads = m->declared<NodalLoad>(loads_effect);
    return push_list(L, loads.size(), [&](std::size_t i) { push_load(L, m, loads[i].number); });
}

int group_members(lua_State* L) {
    auto& g = self<GroupBox>(L, "group:members");
    std::vector<int> members;
    for (std::size_t i = 0; i < g.model->members().size(); ++i)
        if (in_group(g.model->members()[i], g.index)) members.push_back(int(i));
    return push_list(L, members.size(), [&](std::size_t i) { push_handle<MemberBox>(L, g.model, members[i]); });
}

int group_nodes(lua_State* L) {
    auto& g = self<GroupBox>(L, "group:nodes");
    return push_nodes(L, g.model, g.model->nodes_of_group(g.index));
}

int member_nodes(lua_State* L) {
    auto& m = self<MemberBox>(L, "member:nodes");
    const auto& node = m.model->members()[m.index].node;
    return push_nodes(L, m.model, {node[0], node[1]});
}

/// member:node(after)
int member_node(lua_State* L) {
    auto& m = self<MemberBox>(L, "member:node");
    int is_integer = 0;
    const lua_Integer after = lua_tointegerx(L, 2, &is_integer);
    if (!is_integer)
        throw InputError("member:node: the number of elements before it is " + script::show(L, 2) +
                         "; must be an integer from 1");
    int node = 0;
    const std::size_t nodes = m.model->nodes().size();
    try {
        node = name_inner_node(*m.model, m.index, int(std::clamp<lua_Integer>(after, -1, 1 << 30)));
    } catch (const InputError& e) { throw InputError(std::string("member:node: ") + e.what()); }
    if (m.model->nodes().size() > nodes) note_change(L, *m.model, "member:node");
    push_handle<NodeBox>(L, m.model, node);
    return 1;
}

int member_groups(lua_State* L) {
    auto& m = self<MemberBox>(L, "member:groups");
    const auto& groups = m.model->members()[m.index].groups;
    return push_list(L, groups.size(), [&](std::size_t i) { push_group(L, m.model, groups[i]); });
}

// ---- fields and text ----------------------------------------------------------------------------------------------

int node_fields(lua_State* L) {
    if (push_method(L)) return 1;
    const std::string key = key_argument(L);
    auto& n = self<NodeBox>(L, "node." + key);
    const NodeData& data = n.model->nodes()[n.index];
    if (key == "x" || key == "y" || key == "z") lua_pushnumber(L, data.position[key[0] - 'x']);
    else if (key == "index") lua_pushinteger(L, n.index + 1);
    else if (key == "fixed") data.fixed ? (void)push_text(L, degrees_of_freedom(data.fixed)) : lua_pushnil(L);
    else refuse_field(L, "node", key);
    return 1;
}

int node_text(lua_State* L) {
    auto& n = self_or_gone<NodeBox>(L, "tostring");
    if (!gone(n).empty()) return push_text(L, name_of(n) + gone(n));
    const NodeData& data = n.model->nodes()[n.index];
    std::string text = name_of(n) + " at " + show_vector(data.position) + " m";
    if (data.fixed) text += ", fixed: " + degrees_of_freedom(data.fixed);
    if (const auto r = latest_run(L, *n.model);
        r && n.index < int(r->left_at.size()) && !std::isnan(r->left_at[n.index]))
        text += ", left by its last member " + (std::isinf(r->left_at[n.index])
                                                    ? "before the latest run"
                                                    : "at t = " + script::show(r->left_at[n.index]) + " s");
    return push_text(L, text);
}

int member_fields(lua_State* L) {
    if (push_method(L)) return 1;
    const std::string key = key_argument(L);
    auto& m = self<MemberBox>(L, "member." + key);
    const MemberData& data = m.model->members()[m.index];
    if (key == "index") lua_pushinteger(L, m.index + 1);
    else if (key == "length") lua_pushnumber(L, length_of(*m.model, m.index));
    else if (key == "mass") lua_pushnumber(L, length_of(*m.model, m.index) * data.mass_per_length());
    else if (key == "a" || key == "b") push_handle<NodeBox>(L, m.model, data.node[key == "b"]);
    else if (key == "group")
        data.groups.empty() ? lua_pushnil(L) : (void)push_text(L, m.model->groups()[data.groups[0]]);
    else if (key == "offset") push_offsets_of(L, *m.model, m.index);
    else if (key == "section") push<SectionBox>(L, data.section);
    else if (key == "material") push<MaterialBox>(L, data.material);
    else if (key == "backbone") data.backbone ? (void)push<BackboneBox>(L, data.backbone) : lua_pushnil(L);
    else if (key == "law") data.law ? (void)push_text(L, "a function") : lua_pushnil(L);
    else if (key == "ends") push_joints_of(L, *m.model, m.index);
    else if (key == "up") push_triple(L, data.up);
    else if (key == "carries") push_text(L, carries_word(data.carries));
    else if (key == "elements")
        data.elements_by == ElementsBy::undecided ? (void)push_text(L, "auto") : lua_pushinteger(L, data.elements);
    else refuse_field(L, "member", key);
    return 1;
}

int member_text(lua_State* L) {
    auto& m = self_or_gone<MemberBox>(L, "tostring");
    if (!gone(m).empty()) return push_text(L, name_of(m) + gone(m));
    const MemberData& d = m.model->members()[m.index];
    std::string text = name_of(m) + (d.groups.empty() ? "" : " (" + m.model->groups()[d.groups[0]] + ")") + ", nodes " +
                       std::to_string(d.node[0] + 1) + "-" + std::to_string(d.node[1] + 1);
    if (const auto r = latest_run(L, *m.model))
        if (const auto broke = break_of(*r, m.index))
            text += ", broken " + (std::isinf(broke->second) ? "before the latest run"
                                                             : "at t = " + script::show(broke->second) + " s");
    return push_text(L, text);
}

lua_Integer size_of(const GroupBox& g) {
    return std::count_if(g.model->members().begin(), g.model->members().end(),
                         [&](const MemberData& d) { return in_group(d, g.index); });
}

int group_size(lua_State* L) { return lua_pushinteger(L, size_of(self<GroupBox>(L, "#group"))), 1; }

int group_fields(lua_State* L) {
    if (push_method(L)) return 1;
    const std::string key = key_argument(L);
    auto& g = self<GroupBox>(L, "group." + key);
    double mass = 0, length = 0;
    if (key == "mass" || key == "length")
        for (std::size_t i = 0; i < g.model->members().size(); ++i) {
            const MemberData& d = g.model->members()[i];
            if (!in_group(d, g.index)) continue;
            const double l = length_of(*g.model, int(i));
            length += l, mass += l * d.mass_per_length();
        }
    if (key == "name") push_text(L, g.name);
    else if (key == "size") lua_pushinteger(L, size_of(g));
    else if (key == "mass") lua_pushnumber(L, mass);
    else if (key == "length") lua_pushnumber(L, length);
    else refuse_field(L, "group", key);
    return 1;
}

int group_text(lua_State* L) {
    auto& g = self_or_gone<GroupBox>(L, "tostring");
    if (!gone(g).empty()) return push_text(L, name_of(g) + gone(g));
    const lua_Integer n = size_of(g);
    return push_text(L, name_of(g) + ", " + std::to_string(n) + (n == 1 ? " member" : " members"));
}

int load_fields(lua_State* L) {
    if (push_method(L)) return 1;
    const std::string key = key_argument(L);
    auto& l = self<LoadBox>(L, "load." + key);
    const NodalLoad& data = *find_load(*l.model, l.index);
    if (key == "node") push_handle<NodeBox>(L, l.model, data.node);
    else if (key == "force") push_triple(L, data.force);
    else if (key == "moment") push_triple(L, data.moment);
    else if (key == "case") data.load_case < 0 ? lua_pushnil(L) : (void)push_text(L, l.model->cases()[data.load_case]);
    else refuse_field(L, "load", key);
    return 1;
}

int load_text(lua_State* L) {
    auto& l = self_or_gone<LoadBox>(L, "tostring");
    if (!gone(l).empty()) return push_text(L, name_of(l) + gone(l));
    const NodalLoad& data = *find_load(*l.model, l.index);
    std::string text = "load on node " + std::to_string(l.node + 1) + ":";
    if (!data.force.isZero()) text += " force " + show_vector(data.force) + " N";
    if (!data.moment.isZero())
        text += std::string(data.force.isZero() ? "" : ",") + " moment " + show_vector(data.moment) + " N m";
    if (data.load_case >= 0) text += ", case '" + l.model->cases()[data.load_case] + "'";
    return push_text(L, text + (data.history ? ", times its history" : ""));
}

int remove_load(lua_State* L) {
    auto& l = self<LoadBox>(L, "load:remove");
    hinge::remove_load(*l.model, l.index);
    l.removed_at = where(L);
    note_change(L, *l.model, "load:remove");
    return 0;
}

int model_text(lua_State* L) {
    auto& m = self_or_gone<ModelBox>(L, "tostring");
    if (!gone(m).empty()) return push_text(L, name_of(m) + gone(m));
    return push_text(L, "model: " + count_text(long(m.value->nodes().size()), "node") + ", " +
                            count_text(long(m.value->members().size()), "member"));
}

int model_fields(lua_State* L) {
    if (push_method(L)) return 1;
    const std::string key = key_argument(L);
    self<ModelBox>(L, "model." + key);
    refuse_field(L, "model", key);
}

/// Frees the model and its runs at once, however many handles are about. The run that summary.json speaks of keeps its
/// last state.
int close_model(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:close").value;
    const auto c = context(L);
    for (const auto& run : m->runs)
        if (const auto r = run.lock(); r && r->stepping)
            throw InputError("model:close: a run of this model is in a step; close it when the step is done");
    for (const auto& run : m->runs)
        if (const auto r = run.lock(); r && r != c->runs.last) r->run.reset();
    m->runs.clear();
    const std::string place = where(L);
    m->closed_at = place.empty() ? "an unknown line" : place;
    static_cast<Model&>(*m) = Model(m->options());
    push_registry(L, *m);
    lua_pushnil(L);
    lua_setfield(L, -2, "latest");
    return 0;
}

}  // namespace

void open_objects(lua_State* L) {
    static const luaL_Reg model[] = {{"nodes", guarded<takes<"model:nodes", 1, model_nodes>>},
                                     {"members", guarded<takes<"model:members", 1, model_members>>},
                                     {"groups", guarded<takes<"model:groups", 1, model_groups>>},
                                     {"loads", guarded<takes<"model:loads", 1, model_loads>>},
                                     {"close", guarded<takes<"model:close", 1, close_model>>},
                                     {nullptr, nullptr}};
    static const luaL_Reg none[] = {{nullptr, nullptr}};
    static const luaL_Reg member[] = {{"nodes", guarded<takes<"member:nodes", 1, member_nodes>>},
                                      {"node", guarded<takes<"member:node", 2, member_node>>},
                                      {"groups", guarded<takes<"member:groups", 1, member_groups>>},
                                      {nullptr, nullptr}};
    static const luaL_Reg group[] = {{"members", guarded<takes<"group:members", 1, group_members>>},
                                     {"nodes", guarded<takes<"group:nodes", 1, group_nodes>>},
                                     {nullptr, nullptr}};
    static const luaL_Reg load[] = {{"remove", guarded<takes<"load:remove", 1, remove_load>>}, {nullptr, nullptr}};
    make_metatable(L, ModelBox::lua_name, model, guarded<model_fields>, collect<ModelBox>, guarded<model_text>,
                   nullptr);
    open_cases(L);
    make_metatable(L, NodeBox::lua_name, none, guarded<node_fields>, collect<NodeBox>, guarded<node_text>, nullptr);
    make_metatable(L, MemberBox::lua_name, member, guarded<member_fields>, collect<MemberBox>, guarded<member_text>,
                   nullptr);
    make_metatable(L, LoadBox::lua_name, load, guarded<load_fields>, collect<LoadBox>, guarded<load_text>, nullptr);
    make_metatable(L, GroupBox::lua_name, group, guarded<group_fields>, collect<GroupBox>, guarded<group_text>,
                   nullptr);
    name_fields(L, NodeBox::lua_name, {"x", "y", "z", "index", "fixed"});
    name_fields(L, MemberBox::lua_name,
                {"index", "length", "mass", "a", "b", "group", "section", "material", "up", "elements", "backbone",
                 "law", "carries", "ends", "offset"});
    name_fields(L, LoadBox::lua_name, {"node", "force", "moment", "case"});
    name_fields(L, GroupBox::lua_name, {"name", "size", "mass", "length"});
    luaL_getmetatable(L, GroupBox::lua_name);
    lua_pushcfunction(L, guarded<group_size>);
    lua_setfield(L, -2, "__len");
    lua_pop(L, 1);
}

}  // namespace hinge::script

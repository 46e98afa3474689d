// Results of a run that a script reads: of a node or member, and of all of them in one array.
#include <algorithm>
#include <cmath>

#include "script/bind/bind_along.h"
#include "script/bind/bind_joints.h"
#include "script/bind/modules.h"
#include "script/bind/run_box.h"
#include "record/recording.h"

namespace hinge::script {

const std::shared_ptr<ScriptRun>& run_argument(lua_State* L, int index, const std::string& what, const Model* model) {
    auto* box = find<RunBox>(L, index);
    if (!box)
        throw InputError(what + " is " + show(L, index) +
                         "; must be one that model:static{} or model:dynamic{} returned");
    if (const std::string since = gone(*box); !since.empty()) throw InputError(what + " is " + name_of(*box) + since);
    if (model && box->value->model.get() != model)
        throw InputError(what + " is " + name_of(*box) + ", of another model; use one of this model");
    return box->value;
}

std::shared_ptr<ScriptRun> latest_run(lua_State* L, const ScriptModel& model) {
    push_registry(L, model);
    lua_getfield(L, -1, "latest");
    const auto* box = find<RunBox>(L, -1);
    lua_pop(L, 2);
    return box ? box->value : nullptr;
}

int node_of_run(lua_State* L, int index, const ScriptRun& r, const std::string& what) {
    const int n = node_argument(L, index, what, r.model.get()).index;
    if (n >= int(r.run->structure().model().nodes().size()))
        throw InputError(what + " is node " + std::to_string(n + 1) + ", declared after this run was made");
    return n;
}

void must_be_fixed_in(const ScriptRun& r, int node, const std::string& what) {
    if (r.model->nodes()[node].fixed & ~r.run->structure().model().nodes()[node].fixed)
        throw InputError(what + " is node " + std::to_string(node + 1) + ", fixed after this run was made");
}

std::shared_ptr<ScriptRun> run_to_read(lua_State* L, const std::string& function, const ScriptModel& model, int index) {
    if (!lua_isnoneornil(L, index)) return run_argument(L, index, function + ": run", &model);
    if (auto latest = latest_run(L, model)) return latest;
    throw InputError(function +
                     ": no run has been made of this model yet; make one with model:static{} or model:dynamic{}");
}

namespace {

struct AskedPart {
    std::shared_ptr<ScriptRun> record;
    int index;
};

/// run:name(node), or node:name(run).
template <class Self>
AskedPart asked_node(lua_State* L, const char* name) {
    if constexpr (std::is_same_v<Self, RunBox>) {
        const std::string function = std::string("run:") + name;
        const auto record = self<RunBox>(L, function).value;
        return {record, node_of_run(L, 2, *record, function + ": node")};
    } else {
        const std::string function = std::string("node:") + name;
        const auto& node = self<NodeBox>(L, function);
        const auto record = run_to_read(L, function, *node.model);
        return {record, node_of_run(L, 1, *record, function + ": this")};
    }
}

/// run:name(member), or member:name(run).
template <class Self>
AskedPart asked_member(lua_State* L, const char* name) {
    const bool of_run = std::is_same_v<Self, RunBox>;
    const std::string function = (of_run ? "run:" : "member:") + std::string(name),
                      what = function + (of_run ? ": member" : ": this");
    std::shared_ptr<ScriptRun> record;
    if constexpr (of_run) record = self<RunBox>(L, function).value;
    else record = run_to_read(L, function, *self<MemberBox>(L, function).model);
    const int member = member_argument(L, of_run ? 2 : 1, what, record->model.get()).index;
    if (member >= int(record->run->structure().model().members().size()))
        throw InputError(what + " is member " + std::to_string(member + 1) + ", declared after this run was made");
    return {record, member};
}

// ---- nodes --------------------------------------------------------------------------------------------------------

template <class Self>
int six(lua_State* L, const char* name, Vec6 (*read)(const Run&, int)) {
    const AskedPart a = asked_node<Self>(L, name);
    const Vec6 v = read(*a.record->run, a.index);
    for (int i = 0; i < 6; ++i) lua_pushnumber(L, v[i]);
    return 6;
}

template <class Self>
int displacement(lua_State* L) {
    return six<Self>(L, "displacement", [](const Run& r, int n) { return r.displacement(n); });
}
template <class Self>
int velocity(lua_State* L) {
    return six<Self>(L, "velocity", [](const Run& r, int n) { return r.state().velocity[n]; });
}
template <class Self>
int acceleration(lua_State* L) {
    return six<Self>(L, "acceleration", [](const Run& r, int n) { return r.state().acceleration[n]; });
}
template <class Self>
int reaction(lua_State* L) {
    const AskedPart a = asked_node<Self>(L, "reaction");
    must_be_fixed_in(*a.record, a.index, std::is_same_v<Self, RunBox> ? "run:reaction: node" : "node:reaction: this");
    return six<Self>(L, "reaction", [](const Run& r, int n) { return r.reaction(n); });
}

Vec3 position_of(const Run& run, int node) { return run.structure().position()[node] + run.state().displacement[node]; }

template <class Self>
int position(lua_State* L) {
    const AskedPart a = asked_node<Self>(L, "position");
    const Vec3 x = position_of(*a.record->run, a.index);
    for (int i = 0; i < 3; ++i) lua_pushnumber(L, x[i]);
    return 3;
}

// ---- members ------------------------------------------------------------------------------------------------------

const std::vector<std::string> resultants = {"N", "Mx", "My", "Mz", "Qx", "Qy", "f_y"};

/// The section resultants at an element's end, in that order, zero in a broken one; side: -1 or 1.
std::array<double, 7> resultants_at(const Run& run, int element, double side) {
    if (run.state().broken[element]) return {};
    const SectionForces f = run.section_forces(element, side);
    return {f.N, f.Mx, f.My, f.Mz, f.Qx, f.Qy, run.yield_value(element, side)};
}

/// member:joint(end, run?)
int joint(lua_State* L) {
    const auto& m = self<MemberBox>(L, "member:joint");
    const std::string end = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
    if (end != "a" && end != "b") throw InputError("member:joint: the end is " + show(L, 2) + "; must be 'a' or 'b'");
    const auto record = run_to_read(L, "member:joint", *m.model, 3);
    push_joint(L, *record->run, m.index, end == "b");
    return 1;
}

/// run:along(member, parts?), member:along(run?, parts?)
template <class Self>
int along(lua_State* L) {
    const AskedPart a = asked_member<Self>(L, "along");
    const std::string what = std::string(std::is_same_v<Self, RunBox> ? "run" : "member") + ":along: parts";
    int parts = 8;
    if (!lua_isnoneornil(L, 3)) {
        const lua_Number n = lua_type(L, 3) == LUA_TNUMBER ? lua_tonumber(L, 3) : 0;
        if (!(n >= 1 && n <= 10000 && n == std::floor(n)))
            throw InputError(what + " is " + show(L, 3) + "; must be a whole number from 1 to 10000");
        parts = int(n);
    }
    const auto [first, end] = elements_of(a.record->run->structure(), a.index);
    return push_along(L, *a.record->run, first, end - first, parts);
}

template <class Self>
int forces(lua_State* L) {
    const AskedPart a = asked_member<Self>(L, "forces");
    const auto [first, end] = elements_of(a.record->run->structure(), a.index);
    for (const auto& [index, side] : {std::pair{first, -1.0}, std::pair{end - 1, 1.0}}) {
        const auto values = resultants_at(*a.record->run, index, side);
        lua_createtable(L, 0, 7);
        for (std::size_t i = 0; i < values.size(); ++i)
            lua_pushnumber(L, values[i]), lua_setfield(L, -2, resultants[i].c_str());
    }
    return 2;
}

/// What becomes of the member's elements, the largest or the sum.
struct Whole {
    double f_y = 0, N = 0, broken = 0, yielded = 0, touched = 0, plastic_work = 0;
};
Whole whole(const Run& run, int first, int end) {
    const State& s = run.state();
    Whole w;
    for (int e = first; e < end; ++e) {
        w.f_y = std::max(w.f_y, run.yield_value(e));
        w.broken = std::max(w.broken, double(s.broken[e] != 0));
        w.yielded = std::max(w.yielded, double(s.yielded[e] != 0));
        w.touched = std::max(w.touched, double(s.touched[e] != 0));
        w.plastic_work += s.plastic_work[e];
        w.N += s.force[e][4] / (end - first);
    }
    if (w.broken != 0) w.N = 0;
    return w;
}

/// "elastic", "yielded" or "broken"; f_y now; and of a broken one when it broke and which of its elements did.
template <class Self>
int member_state(lua_State* L) {
    const AskedPart a = asked_member<Self>(L, "state");
    const auto [first, end] = elements_of(a.record->run->structure(), a.index);
    const Whole w = whole(*a.record->run, first, end);
    lua_pushstring(L, w.broken != 0 ? "broken" : w.yielded != 0 ? "yielded" : "elastic");
    lua_pushnumber(L, w.f_y);
    const auto broke = break_of(*a.record, a.index);
    if (!broke) return 2;
    std::isinf(broke->second) ? lua_pushnil(L) : lua_pushnumber(L, broke->second);
    lua_pushinteger(L, broke->first);
    return 4;
}

// ---- arrays -------------------------------------------------------------------------------------------------------

std::string quoted(const std::vector<std::string>& names) {
    std::string list;
    for (const auto& n : names) list += (list.empty() ? "'" : ", '") + n + "'";
    return list;
}

/// One number a joint of the group (-1: all), in the order they were declared.
std::vector<double> read_nodes(const ScriptRun& r, const std::string& what, int group) {
    const Model& model = r.run->structure().model();
    std::vector<int> nodes(group < 0 ? model.nodes().size() : 0);
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = int(i);
    if (group >= 0) nodes = model.nodes_of_group(group);
    const std::string quantity = what.starts_with("reaction_") ? what.substr(9) : what;
    const int q =
        int(std::find(node_quantities().begin(), node_quantities().end(), quantity) - node_quantities().begin());
    std::vector<double> values;
    values.reserve(nodes.size());
    for (const int n : nodes) {
        if (what.starts_with("reaction_")) must_be_fixed_in(r, n, "run:read: a joint");
        values.push_back(what == "node" ? n + 1.0
                         : what.starts_with("node_")
                             ? position_of(*r.run, n)[what.back() - 'x']
                             : value_of(*r.run, {n, Probe::Quantity(q / 6), q % 6, {}, {}, {}}));
    }
    return values;
}

/// One number a member of the group (-1: all), in the order they were declared.
std::vector<double> read_members(const ScriptRun& r, const std::string& what, int group) {
    const Run& run = *r.run;
    const auto& elements = run.structure().elements();
    const bool at_end = what.ends_with("_a") || what.ends_with("_b");
    const std::size_t resultant =
        std::find(resultants.begin(), resultants.end(), what.substr(0, what.size() - 2)) - resultants.begin();
    std::vector<double> values;
    for (int first = 0, end; first < int(elements.size()); first = end) {
        const int member = elements[first].member;
        for (end = first; end < int(elements.size()) && elements[end].member == member;) ++end;
        if (group >= 0 && !run.structure().in_group(first, group)) continue;
        if (at_end) {
            values.push_back(what.back() == 'a' ? resultants_at(run, first, -1)[resultant]
                                                : resultants_at(run, end - 1, 1)[resultant]);
        } else if (what == "member") {
            values.push_back(member + 1);
        } else if (what == "temperature") {
            values.push_back(heat_of(run.state().heat, first).temperature);
        } else if (what.size() == 1 && what != "N") {
            values.push_back(0.5 * (position_of(run, elements[first].node[0]) +
                                    position_of(run, elements[end - 1].node[1]))[what[0] - 'x']);
        } else {
            const Whole w = whole(run, first, end);
            values.push_back(what == "f_y"       ? w.f_y
                             : what == "N"       ? w.N
                             : what == "broken"  ? w.broken
                             : what == "yielded" ? w.yielded
                             : what == "touched" ? w.touched
                                                 : w.plastic_work);
        }
    }
    return values;
}

int read(lua_State* L) {
    const auto& r = *self<RunBox>(L, "run:read").value;
    static const std::vector<std::string> of_members = [] {
        std::vector<std::string> names = {"f_y",         "N",      "broken", "yielded", "touched", "plastic_work",
                                          "temperature", "member", "x",      "y",       "z"};
        for (const char* end : {"_a", "_b"})
            for (const auto& q : resultants) names.push_back(q + end);
        return names;
    }();
    static const std::vector<std::string> of_nodes = [] {
        std::vector<std::string> names = {"node", "node_x", "node_y", "node_z"};
        // a bare "fy" would stand for a reaction where "f_y" was meant
        for (const auto& n : node_quantities())
            names.push_back((&n - node_quantities().data() < 18 ? "" : "reaction_") + n);
        return names;
    }();
    const std::string what = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
    const bool members = std::find(of_members.begin(), of_members.end(), what) != of_members.end();
    if (!members && std::find(of_nodes.begin(), of_nodes.end(), what) == of_nodes.end()) {
        std::vector<std::string> all = of_members;
        all.insert(all.end(), of_nodes.begin(), of_nodes.end());
        throw InputError("run:read: quantity is " + show(L, 2) + "; must be one of members' " + quoted(of_members) +
                         ", or of nodes' " + quoted(of_nodes) + did_you_mean(what, all));
    }
    const int group =
        lua_isnoneornil(L, 3) ? -1 : group_argument(L, 3, "run:read: group", *r.model, &r.run->structure().model());
    const std::vector<double> values = members ? read_members(r, what, group) : read_nodes(r, what, group);
    push_array(L, values.data(), int(values.size()));
    return 1;
}

}  // namespace

void open_reading(lua_State* L) {
    static const luaL_Reg run[] = {{"displacement", guarded<takes<"run:displacement", 2, displacement<RunBox>>>},
                                   {"velocity", guarded<takes<"run:velocity", 2, velocity<RunBox>>>},
                                   {"acceleration", guarded<takes<"run:acceleration", 2, acceleration<RunBox>>>},
                                   {"reaction", guarded<takes<"run:reaction", 2, reaction<RunBox>>>},
                                   {"position", guarded<takes<"run:position", 2, position<RunBox>>>},
                                   {"forces", guarded<takes<"run:forces", 2, forces<RunBox>>>},
                                   {"along", guarded<takes<"run:along", 3, along<RunBox>>>},
                                   {"state", guarded<takes<"run:state", 2, member_state<RunBox>>>},
                                   {"read", guarded<takes<"run:read", 3, read>>},
                                   {nullptr, nullptr}};
    static const luaL_Reg node[] = {{"displacement", guarded<takes<"node:displacement", 2, displacement<NodeBox>>>},
                                    {"velocity", guarded<takes<"node:velocity", 2, velocity<NodeBox>>>},
                                    {"acceleration", guarded<takes<"node:acceleration", 2, acceleration<NodeBox>>>},
                                    {"reaction", guarded<takes<"node:reaction", 2, reaction<NodeBox>>>},
                                    {"position", guarded<takes<"node:position", 2, position<NodeBox>>>},
                                    {nullptr, nullptr}};
    static const luaL_Reg member[] = {{"forces", guarded<takes<"member:forces", 2, forces<MemberBox>>>},
                                      {"along", guarded<takes<"member:along", 3, along<MemberBox>>>},
                                      {"state", guarded<takes<"member:state", 2, member_state<MemberBox>>>},
                                      {"joint", guarded<takes<"member:joint", 3, joint>>},
                                      {nullptr, nullptr}};
    add_methods(L, RunBox::lua_name, run);
    add_methods(L, NodeBox::lua_name, node);
    add_methods(L, MemberBox::lua_name, member);
}

}  // namespace hinge::script

// The plastic hinges and the joints of a run, for run:hinges (lua/hinge/results/hinges.lua).

#include <algorithm>
#include <cmath>
#include <cstring>

#include "script/bind/modules.h"
#include "script/bind/run_box.h"
#include "record/joint_ratings.h"
#include "record/storeys.h"
#include "state/hinge_records.h"

namespace hinge::script {
namespace {

/// Where a hinge is: its share of the member's length from end a, and the place at the start.
struct Place {
    double at;
    Vec3 position;
};

Place place_of(const Structure& structure, const HingeRecord& h) {
    const auto& elements = structure.elements();
    const Element& e = elements[std::size_t(h.element)];
    const auto [first, end] = elements_of(structure, e.member);
    double before = 0, all = 0;
    for (int i = first; i < end; ++i) {
        if (i == h.element) before = all + (h.end == 0 ? 0.5 : h.end - 1) * e.length;
        all += elements[std::size_t(i)].length;
    }
    const Vec3 a = structure.position()[std::size_t(e.node[0])], b = structure.position()[std::size_t(e.node[1])];
    return {before / all, h.end == 1 ? a : h.end == 2 ? b : Vec3((a + b) / 2)};
}

/// The elements that meet in the section: one, or two of the same member.
std::pair<int, int> elements_at(const Structure& structure, const HingeRecord& h) {
    const auto& elements = structure.elements();
    const std::size_t next = std::size_t(h.element) + 1;
    const bool inside =
        h.end == 2 && next < elements.size() && elements[next].member == elements[std::size_t(h.element)].member;
    return {h.element, inside ? int(next) : -1};
}

/// f_y in the section now, the larger of the two sides.
double yield_at(const Run& run, const HingeRecord& h) {
    const auto [first, second] = elements_at(run.structure(), h);
    const double there = run.yield_value(first, h.end == 0 ? 0 : h.end == 1 ? -1 : 1);
    return second < 0 ? there : std::max(there, run.yield_value(second, -1));
}

bool is_broken(const Run& run, const HingeRecord& h) {
    const auto [first, second] = elements_at(run.structure(), h);
    return run.state().broken[std::size_t(first)] != 0 || (second >= 0 && run.state().broken[std::size_t(second)] != 0);
}

/// What a limit is compared with, rad. Where two elements of different members meet, and no third, they share the
/// moment there and may share the rotation of what is one hinge of the structure.
double demand_of(const Structure& structure, const HingeRecords& all, const HingeRecord& h) {
    if (h.end == 0) return h.largest;
    const int node = structure.elements()[std::size_t(h.element)].node[h.end - 1];
    const auto at = structure.elements_at(node);
    if (at.size() != 2 || elements_at(structure, h).second >= 0) return h.largest;
    const int other = at[0] == h.element ? at[1] : at[0];
    const auto begin = std::lower_bound(all.list.begin(), all.list.end(), 3L * other,
                                        [](const HingeRecord& o, long place) { return o.place() < place; });
    for (auto o = begin; o != all.list.end() && o->element == other; ++o)
        if (o->end > 0 && structure.elements()[std::size_t(other)].node[o->end - 1] == node)
            return h.largest + o->largest;
    return h.largest;
}

/// Fields of the table on the stack.
struct Fields {
    lua_State* L;
    void number(const char* name, double value) const { lua_pushnumber(L, value), lua_setfield(L, -2, name); }
    void whole(const char* name, lua_Integer value) const { lua_pushinteger(L, value), lua_setfield(L, -2, name); }
    void flag(const char* name, bool value) const { lua_pushboolean(L, value), lua_setfield(L, -2, name); }
    void text(const char* name, const char* value) const { lua_pushstring(L, value), lua_setfield(L, -2, name); }
};

/// Member, group, storey, node (the script's, -1: none) and place.
void push_place(const Fields& to, const ScriptRun& r, int element, int end, int node, int storey, const Place& place) {
    lua_State* L = to.L;
    const Structure& structure = r.run->structure();
    const int member = structure.elements()[std::size_t(element)].member;
    push_handle<MemberBox>(L, r.model, member), lua_setfield(L, -2, "member");
    if (node >= 0) push_handle<NodeBox>(L, r.model, node), lua_setfield(L, -2, "node");
    if (const auto& groups = structure.model().members()[std::size_t(member)].groups; !groups.empty())
        to.text("group", structure.model().groups()[std::size_t(groups[0])].c_str());
    if (storey > 0) to.whole("storey", storey);
    to.whole("element", element + 1), to.whole("end", end);
    to.number("at", place.at);
    to.number("x", place.position.x()), to.number("y", place.position.y()), to.number("z", place.position.z());
}

void push_first_yield(const Fields& to, double first, bool statics, bool before) {
    to.number("first_yield", first);
    to.text("first_kind", statics ? "static" : "dynamic");
    to.flag("before", before);
}

/// Leaves a table on the stack: a hinge as run:hinges gives it, without what follows from limits.
void push_hinge(lua_State* L, const ScriptRun& r, const HingeRecords& all, const HingeRecord& h, int storey) {
    const Run& run = *r.run;
    const Structure& structure = run.structure();
    const Element& e = structure.elements()[std::size_t(h.element)];
    lua_createtable(L, 0, 24);
    const Fields to{L};
    push_place(to, r, h.element, h.end, h.end == 0 ? -1 : structure.declared_node(e.node[h.end - 1]), storey,
               place_of(structure, h));
    to.flag("yielded", true);
    to.number("rotation_x", h.rotation[0]), to.number("rotation_y", h.rotation[1]);
    to.number("rotation", std::hypot(h.rotation[0], h.rotation[1])), to.number("largest", h.largest);
    to.number("demand", demand_of(structure, all, h));
    to.number("elongation", h.elongation), to.number("work", h.work);
    const double f_y = yield_at(run, h);
    to.number("f_y", f_y), to.number("utilisation", std::sqrt(std::max(0.0, f_y)));
    push_first_yield(to, h.first, h.statics, h.runs_ago > 0);
    to.flag("broken", is_broken(run, h));
}

/// The same of a joint, with the fields that it has beside those of a hinge.
void push_joint_rating(lua_State* L, const ScriptRun& r, const JointRating& j, int storey) {
    const Structure& structure = r.run->structure();
    lua_createtable(L, 0, 36);
    const Fields to{L};
    HingeRecord at;
    at.element = j.element, at.end = j.end;
    push_place(to, r, j.element, j.end, j.node, storey, place_of(structure, at));
    const std::string name = j.connector ? connector_name(structure, j.joint) : joint_name(structure, j.joint);
    to.text("joint", name.c_str()), to.text("axis", joint_rating_names[j.which]);
    to.number(j.is_force() ? "force" : "moment", j.force);
    to.number(j.is_force() ? "largest_force" : "largest_moment", j.largest_force);
    if (std::isfinite(j.strength)) to.number("strength", j.strength), to.number("utilisation", j.utilisation);
    const Joint* declared =
        j.connector ? nullptr : &structure.model().declared<Joint>(joints_effect)[std::size_t(j.joint)];
    to.flag("between_nodes", !declared || declared->is_between_nodes());
    if (j.connector) to.whole("connector", j.joint + 1);
    if (declared && declared->is.tension_weakens) to.text("interaction", "linear");
    const auto about = [&](int k) {
        return declared && declared->is.axis[k].is_spring() && !j.is_force() ? j.now->rotation[k] : 0;
    };
    to.number("rotation_x", about(0)), to.number("rotation_y", about(1)), to.number("rotation_z", about(2));
    to.number("rotation", j.which == JointRating::z ? std::abs(about(2)) : std::hypot(about(0), about(1)));
    to.number("largest", j.largest), to.number("demand", j.demand);
    if (std::isfinite(j.capacity)) to.number("capacity", j.capacity);
    if (!j.is_force()) to.number("stiffness", declared->is.axis[j.which].stiffness);
    to.number("elongation", 0), to.number("work", j.record ? j.record->work : 0);
    to.flag("yielded", j.record && j.record->yielded);
    if (j.record && j.record->yielded) push_first_yield(to, j.record->first, j.record->statics, j.record->runs_ago > 0);
    to.flag("broken", j.broken), to.flag("failed", j.failed);
}

/// A hinge or a joint, and where it stands in the list: by storey, then by element and end.
struct Row {
    int storey;
    long place;
    const HingeRecord* hinge;
    const JointRating* joint;
};

std::vector<Row> rows_of(const Structure& structure, const HingeRecords* records,
                         const std::vector<JointRating>& joints, int group) {
    const std::vector<int> storeys = storeys_of(structure);
    std::vector<Row> rows;
    const auto add = [&](int element, int end, const HingeRecord* h, const JointRating* j) {
        if (group >= 0 && !structure.in_group(element, group)) return;
        const int member = structure.elements()[std::size_t(element)].member;
        rows.push_back({storeys[std::size_t(member)], 3L * element + end, h, j});
    };
    if (records)
        for (const HingeRecord& h : records->list) add(h.element, h.end, &h, nullptr);
    for (const JointRating& j : joints) add(j.element, j.end, nullptr, &j);
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        return a.storey != b.storey ? a.storey < b.storey : a.place < b.place;
    });
    return rows;
}

/// core.hinges_of(run, function, group, joints): a list of them, by storey, member and place in it; group: nil for all;
/// joints: true for joints and connectors alone.
int hinges_of(lua_State* L) {
    const std::string function = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "hinges_of";
    const auto r = run_argument(L, 1, function + ": this");
    const Structure& structure = r->run->structure();
    const int group =
        lua_isnoneornil(L, 3) ? -1 : group_argument(L, 3, function + ": field 'group'", *r->model, &structure.model());
    const HingeRecords* records =
        lua_toboolean(L, 4) ? nullptr : r->run->state().data.find<HingeRecords>(hinge_records);
    const std::vector<JointRating> joints = joint_ratings(*r->run);
    const std::vector<Row> rows = rows_of(structure, records, joints, group);
    lua_createtable(L, int(rows.size()), 0);
    lua_Integer i = 0;
    for (const Row& row : rows) {
        if (row.hinge) push_hinge(L, *r, *records, *row.hinge, row.storey);
        else push_joint_rating(L, *r, *row.joint, row.storey);
        lua_rawseti(L, -2, ++i);
    }
    return 1;
}

/// core.pins_of(run): how many axes of joints are free, and the largest rotation about one of them now, rad.
int pins_of(lua_State* L) {
    const auto r = run_argument(L, 1, "pins_of: this");
    const auto& declared = r->run->structure().model().declared<Joint>(joints_effect);
    const auto* now = r->run->state().data.find<JointStates>(joints_effect);
    lua_Integer count = 0;
    double largest = 0;
    for (std::size_t i = 0; now && i < declared.size() && i < now->list.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            if (!declared[i].is.axis[k].is_free()) continue;
            ++count;
            if (!now->list[i].broken) keep_largest(largest, now->list[i].rotation[k]);
        }
    lua_pushinteger(L, count), lua_pushnumber(L, largest);
    return 2;
}

/// core.last_run(): the run that the summary speaks of, nil where there is none.
int push_last_run(lua_State* L) {
    const auto record = last_run(*context(L));
    if (!record || !record->run || !record->model->closed_at.empty()) return lua_pushnil(L), 1;
    push<RunBox>(L, record);
    hold_registry(L, *record->model);
    return 1;
}

/// core.add_run_method(name, function): run:name(...) is then function(run, ...). core.add_model_method likewise.
template <class Box>
int add_method(lua_State* L) {
    if (lua_type(L, 1) != LUA_TSTRING || !lua_isfunction(L, 2))
        throw InputError("a method takes a name and a function");
    luaL_getmetatable(L, Box::lua_name);
    lua_getfield(L, -1, "methods");
    lua_pushvalue(L, 2);
    lua_setfield(L, -2, lua_tostring(L, 1));
    return 0;
}

}  // namespace

void open_hinges(lua_State* L, int module) {
    static const luaL_Reg functions[] = {{"hinges_of", guarded<hinges_of>},
                                         {"pins_of", guarded<pins_of>},
                                         {"last_run", guarded<push_last_run>},
                                         {"add_run_method", guarded<add_method<RunBox>>},
                                         {"add_model_method", guarded<add_method<ModelBox>>},
                                         {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script

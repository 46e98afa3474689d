// The plastic hinges of a run, for run:hinges (lua/hinge/hinges.lua).
#include "script/bind/bind_hinges.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "script/lua/objects.h"
#include "script/record/storeys.h"
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

/// Leaves a table on the stack: a hinge as run:hinges gives it, without what follows from limits.
void push_row(lua_State* L, const RunRecord& r, const HingeRecords& all, const HingeRecord& h, int storey) {
    const Run& run = *r.run;
    const Structure& structure = run.structure();
    const Element& e = structure.elements()[std::size_t(h.element)];
    const auto number = [L](const char* name, double value) { lua_pushnumber(L, value), lua_setfield(L, -2, name); };
    const auto whole = [L](const char* name, lua_Integer value) {
        lua_pushinteger(L, value), lua_setfield(L, -2, name);
    };
    lua_createtable(L, 0, 24);
    push_handle<MemberBox>(L, r.model, e.member), lua_setfield(L, -2, "member");
    if (const int node = h.end == 0 ? -1 : structure.declared_node(e.node[h.end - 1]); node >= 0)
        push_handle<NodeBox>(L, r.model, node), lua_setfield(L, -2, "node");
    if (const auto& groups = structure.model().members()[std::size_t(e.member)].groups; !groups.empty())
        lua_pushstring(L, structure.model().groups()[std::size_t(groups[0])].c_str()), lua_setfield(L, -2, "group");
    if (storey > 0) whole("storey", storey);
    whole("element", h.element + 1), whole("end", h.end);
    const Place place = place_of(structure, h);
    number("at", place.at);
    number("x", place.position.x()), number("y", place.position.y()), number("z", place.position.z());
    number("rotation_x", h.rotation[0]), number("rotation_y", h.rotation[1]);
    number("rotation", std::hypot(h.rotation[0], h.rotation[1])), number("largest", h.largest);
    number("demand", demand_of(structure, all, h));
    number("elongation", h.elongation), number("work", h.work);
    const double f_y = yield_at(run, h);
    number("f_y", f_y), number("utilisation", std::sqrt(std::max(0.0, f_y)));
    number("first_yield", h.first);
    lua_pushstring(L, h.statics ? "static" : "dynamic"), lua_setfield(L, -2, "first_kind");
    lua_pushboolean(L, h.runs_ago > 0), lua_setfield(L, -2, "before");
    lua_pushboolean(L, is_broken(run, h)), lua_setfield(L, -2, "broken");
}

/// core.hinges_of(run, function, group): a list of them, by storey, member and place in it; group: nil for all.
int hinges_of(lua_State* L) {
    const std::string function = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "hinges_of";
    const auto r = run_argument(L, 1, function + ": this");
    const Structure& structure = r->run->structure();
    const int group =
        lua_isnoneornil(L, 3) ? -1 : group_argument(L, 3, function + ": field 'group'", *r->model, &structure.model());
    const std::vector<int> storeys = storeys_of(structure);
    std::vector<const HingeRecord*> chosen;
    const HingeRecords* records = r->run->state().data.find<HingeRecords>(hinge_records);
    if (records)
        for (const HingeRecord& h : records->list)
            if (group < 0 || structure.in_group(h.element, group)) chosen.push_back(&h);
    const auto storey = [&](const HingeRecord* h) {
        return storeys[std::size_t(structure.elements()[std::size_t(h->element)].member)];
    };
    std::stable_sort(chosen.begin(), chosen.end(), [&](auto* a, auto* b) { return storey(a) < storey(b); });
    lua_createtable(L, int(chosen.size()), 0);
    lua_Integer i = 0;
    for (const HingeRecord* h : chosen) push_row(L, *r, *records, *h, storey(h)), lua_rawseti(L, -2, ++i);
    return 1;
}

/// core.last_run(): the run that the summary speaks of, nil where there is none.
int last_run(lua_State* L) {
    const auto record = context(L)->runs.last;
    if (!record || !record->run || !record->model->closed_at.empty()) return lua_pushnil(L), 1;
    push<RunBox>(L, record);
    hold_registry(L, *record->model);
    return 1;
}

/// core.add_run_method(name, function): run:name(...) is then function(run, ...).
int add_run_method(lua_State* L) {
    if (lua_type(L, 1) != LUA_TSTRING || !lua_isfunction(L, 2))
        throw InputError("add_run_method: takes a name and a function");
    luaL_getmetatable(L, RunBox::lua_name);
    lua_getfield(L, -1, "methods");
    lua_pushvalue(L, 2);
    lua_setfield(L, -2, lua_tostring(L, 1));
    return 0;
}

}  // namespace

void open_hinges(lua_State* L, int module) {
    static const luaL_Reg functions[] = {{"hinges_of", guarded<hinges_of>},
                                         {"last_run", guarded<last_run>},
                                         {"add_run_method", guarded<add_run_method>},
                                         {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script

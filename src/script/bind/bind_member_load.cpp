// model:load on members: per length, or at a point between the ends.
#include <algorithm>

#include "effects/line_mass.h"
#include "effects/member_loads.h"
#include "script/bind/model_methods.h"

namespace hinge::script {
namespace {

/// {x, y, z}, or { a = {x, y, z}, b = {x, y, z} } where the load begins and ends, of which one may be left out. False
/// where the field is absent.
bool read_spread(Options& o, const char* field, const char* unit, Vec3 (&ends)[2]) {
    lua_State* L = o.L();
    if (o.push_field(field) == LUA_TNIL) return lua_pop(L, 1), false;
    const int table = lua_gettop(L);
    bool by_ends = false;
    if (lua_istable(L, table))
        for (const char* end : {"a", "b"}) {
            lua_pushstring(L, end);
            by_ends |= lua_rawget(L, table) != LUA_TNIL;
            lua_pop(L, 1);
        }
    if (by_ends) {
        Options both(L, table, o.function() + ": field '" + field + "'");
        both.expect({"a", "b"});
        ends[0] = both.triple("a", unit).value_or(Vec3::Zero());
        ends[1] = both.triple("b", unit).value_or(Vec3::Zero());
    } else {
        ends[0] = ends[1] = read_triple(L, table, o.function() + ": field '" + field + "'", unit);
    }
    lua_pop(L, 1);
    return true;
}

}  // namespace

LoadedMembers read_loaded_members(Options& o, const Model& m) {
    lua_State* L = o.L();
    LoadedMembers loaded;
    if (o.has("node")) o.complain("node", "given beside a member or group", "give one of them");
    if (o.has("member")) {
        if (o.has("group")) o.complain("group", "given beside member", "give one of the two");
        o.push_field("member");
        loaded.members.push_back(member_argument(L, -1, o.function() + ": field 'member'", &m).index);
    } else {
        o.push_field("group");
        loaded.group = group_argument(L, -1, o.function() + ": field 'group'", m);
        for (std::size_t i = 0; i < m.members().size(); ++i) {
            const auto& of = m.members()[i].groups;
            if (std::find(of.begin(), of.end(), loaded.group) != of.end()) loaded.members.push_back(int(i));
        }
        if (loaded.members.empty())
            o.complain("group", "'" + m.groups()[loaded.group] + "'", "there must be a member in it by now");
    }
    lua_pop(L, 1);
    return loaded;
}

void read_part(Options& o, double& from, double& to) {
    constexpr const char* unit = "part of the member's length";
    const auto first = o.maybe_number("from", unit, Range::not_negative),
               last = o.maybe_number("to", unit, Range::not_negative);
    from = first.value_or(0), to = last.value_or(1);
    if (to > 1) o.complain("to", show(to), "must be from 0, the member's first end, to 1");
    if (!(from < to))
        o.complain(
            first ? "from" : "to", show(first ? from : to),
            "'from' must be less than 'to': they cover " + show(from) + " to " + show(to) + " of the member's length");
}

void join_loads(ScriptModel& m, int member) {
    const auto& groups = m.members()[member].groups;
    for (const auto& [group, first] : m.group_loads) {
        if (std::find(groups.begin(), groups.end(), group) == groups.end()) continue;
        MemberLoad load = m.declared<MemberLoad>(member_loads_effect)[std::size_t(first)];
        load.member = member;
        load.number = int(m.declared<MemberLoad>(member_loads_effect).size());
        m.declare(member_loads_effect, std::move(load));
    }
    for (auto [group, mass] : m.group_masses) {
        if (std::find(groups.begin(), groups.end(), group) == groups.end()) continue;
        mass.member = member;
        add_line_mass(m, mass);
    }
}

int add_member_load(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:load").value;
    Options o(L, 2, "model:load");
    o.expect({"node", "member", "group", "q", "force", "moment", "axes", "at", "from", "to", "history", "case"});
    const LoadedMembers loaded = read_loaded_members(o, *m);
    const std::vector<int>& members = loaded.members;
    MemberLoad load{};
    const std::string axes = o.word("axes", {"global", "projected", "local"}, "global");
    load.axes = axes == "local" ? LoadAxes::local : axes == "projected" ? LoadAxes::projected : LoadAxes::global;
    if (const auto at = o.maybe_number("at", "part of the member's length", Range::not_negative)) {
        if (*at > 1) o.complain("at", show(*at), "must be from 0, the member's first end, to 1");
        load.at = *at;
    }
    for (const char* field : {"from", "to"})
        if (!load.spread() && o.has(field))
            o.complain(field, "given beside 'at'", "is where a spread load begins or ends, and 'at' is a point");
    read_part(o, load.from, load.to);
    bool given = false;
    if (load.spread()) {
        if (o.has("force"))
            o.complain("force", "given without 'at'",
                       "is a point load, in N; give 'at' (0 to 1), or 'q' in N/m for the whole length");
        given = read_spread(o, "q", "N/m", load.force);
        given |= read_spread(o, "moment", "N m/m", load.moment);
        if (load.axes == LoadAxes::projected && o.has("moment"))
            o.complain("axes", "'projected'", "is for 'q' alone; give 'moment' in a call of its own");
    } else {
        if (o.has("q"))
            o.complain("q", "given beside 'at'",
                       "is for the whole length; a point load is 'force' (N) or 'moment' (N m)");
        if (load.axes == LoadAxes::projected)
            o.complain("axes", "'projected'", "is for 'q'; a point load has no length to be projected");
        if (const auto force = o.triple("force", "N")) load.force[0] = *force, given = true;
        if (const auto moment = o.triple("moment", "N m")) load.moment[0] = *moment, given = true;
    }
    if (!given)
        throw InputError(load.spread()
                             ? "model:load: neither 'q' (N/m) nor 'moment' (N m/m) is given; give {x, y, z}, or "
                               "{ a = {x, y, z}, b = {x, y, z} } for its first and its last value"
                             : "model:load: neither 'force' (N) nor 'moment' (N m) is given beside 'at'");
    load.history = read_history(o, "history", "factor", *m, true);
    load.load_case = case_of(o, *m);
    load.has_history = bool(load.history);
    if (loaded.group >= 0)
        m->group_loads.emplace_back(loaded.group, int(m->declared<MemberLoad>(member_loads_effect).size()));
    for (const int member : members) {
        load.member = member;
        load.number = int(m->declared<MemberLoad>(member_loads_effect).size());
        m->declare(member_loads_effect, load);
        if (load.history.points() && member == members[0])
            m->ask("member load " + std::to_string(load.number), where(L));
    }
    m->ask(member_loads_effect, where(L));
    return 0;
}

}  // namespace hinge::script

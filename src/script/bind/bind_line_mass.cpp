// model:mass on members: masses per length; panels of floors, which model:floor loads (lua/hinge/model/floor.lua).
#include "effects/line_mass.h"

#include "script/bind/load_options.h"
#include "script/bind/model_methods.h"
#include "script/bind/modules.h"

namespace hinge::script {
namespace {

/// A number, or { a =, b = } where the mass begins and where it ends, of which one may be left out.
void read_per_length(Options& o, LineMass& mass) {
    lua_State* L = o.L();
    if (o.push_field("per_length") == LUA_TTABLE) {
        Options both(L, lua_gettop(L), o.function() + ": field 'per_length'");
        both.expect({"a", "b"});
        mass.per_length[0] = both.number("a", "kg/m", Range::not_negative, 0);
        mass.per_length[1] = both.number("b", "kg/m", Range::not_negative, 0);
    } else {
        mass.per_length[0] = mass.per_length[1] = o.number("per_length", "kg/m", Range::not_negative);
    }
    lua_pop(L, 1);
}

/// core.add_panel(model, nodes, members): a panel of a floor, for pictures.
int add_floor_panel(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:floor").value;
    FloorPanel panel;
    for (lua_Integer i = 1; lua_rawgeti(L, 2, i) != LUA_TNIL; ++i) {
        panel.nodes.push_back(node_argument(L, -1, "model:floor", m.get()).index);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    for (lua_Integer i = 1; lua_rawgeti(L, 3, i) != LUA_TNIL; ++i) {
        panel.members.push_back(member_argument(L, -1, "model:floor", m.get()).index);
        lua_pop(L, 1);
    }
    m->declare(floor_panels, std::move(panel));
    return 0;
}

}  // namespace

int add_mass_on_member(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:mass").value;
    Options o(L, 2, "model:mass");
    for (const char* field : {"mass", "inertia", "offset"})
        if (o.has(field))
            o.complain(field, "given beside a member or group", "along members give 'per_length', in kg/m");
    o.expect({"node", "member", "group", "per_length", "from", "to"});
    const LoadedMembers loaded = read_loaded_members(o, *m);
    LineMass mass{0};
    read_part(o, mass.from, mass.to);
    read_per_length(o, mass);
    for (const int member : loaded.members) {
        mass.member = member;
        add_line_mass(*m, mass);
    }
    if (loaded.group >= 0) m->group_masses.emplace_back(loaded.group, mass);
    if (!m->asked(line_mass_effect)) m->ask(line_mass_effect, where(L));
    return 0;
}

void open_floors(lua_State* L, int module) {
    static const luaL_Reg functions[] = {{"add_panel", guarded<add_floor_panel>}, {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script

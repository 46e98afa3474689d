// System functions for measuring runs: a clock, peak memory, a callback for every run that is made, and runs without
// one of their effects.
#include <malloc.h>

#include <cstdio>
#include <fstream>

#include "core/files.h"
#include "effects/all_effects.h"
#include "model/section_laws.h"
#include "script/bind/changed_runs.h"
#include "script/bind/modules.h"
#include "script/bind/run_box.h"

namespace hinge::script {
namespace {

const char* const run_listener = "hinge.on_run";

/// A line of /proc/self/status in bytes; -1 where there is none.
double memory_of(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name + ":")) return 1024 * std::atof(line.c_str() + name.size() + 1);
    return -1;
}

/// core.clock(): s, of a clock that only goes forward.
int clock(lua_State* L) {
    lua_pushnumber(L, std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count());
    return 1;
}

/// core.forget_peak(): gives free memory back and forgets how much there was. Returns what is held, in bytes, or nil
/// where the system does not tell.
int forget_peak(lua_State* L) {
    malloc_trim(0);
    const bool forgotten = bool(std::ofstream("/proc/self/clear_refs") << "5" << std::flush);
    const double held = memory_of("VmRSS");
    if (forgotten && held >= 0) lua_pushnumber(L, held);
    else lua_pushnil(L);
    return 1;
}

/// core.peak(): the most memory held since, bytes.
int peak(lua_State* L) {
    lua_pushnumber(L, memory_of("VmHWM"));
    return 1;
}

/// core.on_run(function or nil): called with every run that is made from now on.
int on_run(lua_State* L) {
    lua_settop(L, 1);
    lua_setfield(L, LUA_REGISTRYINDEX, run_listener);
    return 0;
}

/// core.optional_effects(): names of those that can be left out.
int list_optional_effects(lua_State* L) {
    const std::vector<std::string> names = optional_effects();
    lua_createtable(L, int(names.size()), 0);
    for (std::size_t i = 0; i < names.size(); ++i)
        lua_pushstring(L, names[i].c_str()), lua_rawseti(L, -2, lua_Integer(i) + 1);
    return 1;
}

/// core.optional_laws(run): names of the laws of its sections that can be left out.
int list_optional_laws(lua_State* L) {
    const auto r = run_argument(L, 1, "optional_laws: this");
    const std::vector<std::string> names = optional_laws(r->run->structure());
    lua_createtable(L, int(names.size()), 0);
    for (std::size_t i = 0; i < names.size(); ++i)
        lua_pushstring(L, names[i].c_str()), lua_rawseti(L, -2, lua_Integer(i) + 1);
    return 1;
}

/// core.leave_out(name or nil): runs that are made from now on do without this effect, or this law of sections.
int leave_out(lua_State* L) {
    context(L)->mode.left_out = lua_type(L, 1) == LUA_TSTRING ? lua_tostring(L, 1) : "";
    return 0;
}

}  // namespace

bool runs_are_measured(lua_State* L) {
    const bool listening = lua_getfield(L, LUA_REGISTRYINDEX, run_listener) == LUA_TFUNCTION;
    lua_pop(L, 1);
    return listening;
}

void tell_of_run(lua_State* L) {
    if (lua_getfield(L, LUA_REGISTRYINDEX, run_listener) == LUA_TFUNCTION) {
        lua_pushvalue(L, -2);
        must_be_ok(L, lua_pcall(L, 1, 0, 0));
    } else {
        lua_pop(L, 1);
    }
}

void open_measure(lua_State* L, int module) {
    static const luaL_Reg functions[] = {{"clock", guarded<clock>},
                                         {"forget_peak", guarded<forget_peak>},
                                         {"peak", guarded<peak>},
                                         {"on_run", guarded<on_run>},
                                         {"optional_effects", guarded<list_optional_effects>},
                                         {"optional_laws", guarded<list_optional_laws>},
                                         {"leave_out", guarded<leave_out>},
                                         {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    add_changed_runs(L);
    lua_pop(L, 1);
}

}  // namespace hinge::script

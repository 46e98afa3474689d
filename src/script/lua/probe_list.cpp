#include "script/lua/probe_list.h"

#include <algorithm>

#include "script/lua/lua_support.h"

// Lua calls these functions directly, and their errors jump: nothing in them has a destructor.
namespace hinge::script {
namespace {

const char mark = 0;  ///< key in the metatables of such tables

struct Numbers {
    const double* first;
    lua_Integer count;
};

/// Of a metamethod: upvalue 1 is the probe, 2 whether its times are meant, 3 how many.
Numbers numbers_of(lua_State* L) {
    const auto* box = static_cast<const ProbeBox*>(lua_touserdata(L, lua_upvalueindex(1)));
    const std::vector<double>& all = lua_toboolean(L, lua_upvalueindex(2)) ? box->value->time : box->value->value;
    return {all.data(), std::min(lua_tointeger(L, lua_upvalueindex(3)), lua_Integer(all.size()))};
}

int index(lua_State* L) {
    int is_whole = 0;
    const lua_Integer i = lua_tointegerx(L, 2, &is_whole);
    const Numbers list = numbers_of(L);
    if (!is_whole || lua_type(L, 2) != LUA_TNUMBER || i < 1 || i > list.count) return 0;
    return lua_pushnumber(L, list.first[i - 1]), 1;
}

int length(lua_State* L) { return lua_pushinteger(L, numbers_of(L).count), 1; }

/// The table at 1 becomes a plain list.
void fill(lua_State* L) {
    const Numbers list = numbers_of(L);
    lua_pushnil(L);
    lua_setmetatable(L, 1);
    for (lua_Integer i = 1; i <= list.count; ++i) {
        lua_pushnumber(L, list.first[i - 1]);
        ::lua_rawseti(L, 1, i);
    }
}

int new_index(lua_State* L) {
    fill(L);
    lua_settop(L, 3);
    lua_rawset(L, 1);
    return 0;
}

int next_probe(lua_State* L) {
    lua_settop(L, 2);
    if (lua_next(L, 1)) return 2;
    return lua_pushnil(L), 1;
}

int pairs(lua_State* L) {
    fill(L);
    ::lua_pushcclosure(L, next_probe, 0);
    lua_pushvalue(L, 1);
    lua_pushnil(L);
    return 3;
}

int fill_only(lua_State* L) { return fill(L), 0; }

/// A metatable for lists of `count` numbers of the probe at index 1.
void push_metatable(lua_State* L, bool times, lua_Integer count) {
    ::lua_createtable(L, 0, 5);
    const auto set = [&](const char* event, lua_CFunction f) {
        lua_pushvalue(L, 1);
        lua_pushboolean(L, times);
        lua_pushinteger(L, count);
        ::lua_pushcclosure(L, f, 3);
        if (event) ::lua_setfield(L, -2, event);
        else ::lua_rawsetp(L, -2, &mark);
    };
    set("__index", index), set("__len", length), set("__newindex", new_index), set("__pairs", pairs);
    set(nullptr, fill_only);
}

}  // namespace

int push_probe_list(lua_State* L, bool times) {
    const lua_Integer count = lua_Integer(find<ProbeBox>(L, 1)->value->value.size());
    lua_pushvalue(L, 1);
    protect(L, 1, 1, [times, count](lua_State* inner) {
        // the probe's own value: { metatable of times, of values, how many they are for }
        if (lua_getiuservalue(inner, 1, 1) != LUA_TTABLE) {
            ::lua_createtable(inner, 4, 0);
            lua_pushvalue(inner, -1);
            lua_setiuservalue(inner, 1, 1);
        }
        const int kept = lua_gettop(inner), which = times ? 1 : 2;
        lua_rawgeti(inner, kept, which + 2);
        const bool known = lua_tointeger(inner, -1) == count && lua_type(inner, -1) == LUA_TNUMBER;
        lua_settop(inner, kept);
        ::lua_createtable(inner, 0, 0);
        if (known) {
            lua_rawgeti(inner, kept, which);
        } else {
            push_metatable(inner, times, count);
            lua_pushvalue(inner, -1);
            ::lua_rawseti(inner, kept, which);
            lua_pushinteger(inner, count);
            ::lua_rawseti(inner, kept, which + 2);
        }
        lua_setmetatable(inner, -2);
        lua_replace(inner, 1);
        lua_settop(inner, 1);
    });
    return 1;
}

void fill_probe_list(lua_State* L, int index) {
    if (lua_type(L, index) != LUA_TTABLE) return;
    lua_pushvalue(L, index);
    protect(L, 1, 0, [](lua_State* inner) {
        if (lua_getmetatable(inner, 1) && lua_rawgetp(inner, 2, &mark) == LUA_TFUNCTION) {
            lua_pushvalue(inner, 1);
            lua_call(inner, 1, 0);
        }
        lua_settop(inner, 0);
    });
}

}  // namespace hinge::script

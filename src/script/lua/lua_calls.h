// Lua's calls that may run out of memory, made safe for C++: they throw instead of jumping over destructors.
//
// Inside hinge::script each of these names stands for the object here and not for Lua's function (an object also keeps
// C++ from looking for functions by their arguments). It makes the call within lua_pcall, which takes some 50 ns. Calls
// that cannot raise are Lua's own; so is `::lua_rawseti`, for one, where it is certain that the table has room.
#pragma once

#include <lua.hpp>

#include <new>
#include <type_traits>

namespace hinge::script {

/// Raised unchanged: a Lua error value that is already on the stack (a hook's own error).
struct LuaErrorOnStack {};

/// Throws an exception for a status other than LUA_OK; the error value is on top.
inline void must_be_ok(lua_State* L, int status) {
    if (status == LUA_ERRMEM) lua_settop(L, -2), throw std::bad_alloc();
    if (status != LUA_OK) throw LuaErrorOnStack();
}

/// Runs f(L) as a function of Lua's, with `arguments` values of the stack as its own, leaving `results`. Nothing in f
/// may have a destructor.
template <class F>
void protect(lua_State* L, int arguments, int results, F f) {
    if (!lua_checkstack(L, 4)) throw std::bad_alloc();
    ::lua_pushcclosure(
        L,
        [](lua_State* inner) {
            F& body = *static_cast<F*>(lua_touserdata(inner, -1));
            lua_settop(inner, -2);
            body(inner);
            return lua_gettop(inner);
        },
        0);
    lua_rotate(L, -arguments - 1, 1);
    lua_pushlightuserdata(L, &f);
    must_be_ok(L, lua_pcall(L, arguments + 1, results, 0));
}

/// A call that pushes one value.
template <auto function>
struct Pushing {
    template <class... A>
    auto operator()(lua_State* L, A... a) const {
        if constexpr (std::is_void_v<decltype(function(L, a...))>) {
            protect(L, 0, 1, [&](lua_State* inner) { function(inner, a...); });
        } else {
            decltype(function(L, a...)) result{};
            protect(L, 0, 1, [&](lua_State* inner) { result = function(inner, a...); });
            return result;
        }
    }
};

/// A call on the table at `index` that takes `values` from the stack and pushes `results`.
template <auto function, int values, int results>
struct OnTable {
    template <class Key>
    int operator()(lua_State* L, int index, Key key) const {
        if (!lua_checkstack(L, 1)) throw std::bad_alloc();
        lua_pushvalue(L, index);
        lua_rotate(L, -values - 1, 1);
        protect(L, values + 1, results, [&](lua_State* inner) {
            function(inner, 1, key), results ? lua_remove(inner, 1) : lua_settop(inner, 0);
        });
        return results ? lua_type(L, -1) : LUA_TNONE;
    }
};

inline constexpr Pushing<::lua_pushlstring> lua_pushlstring;
inline constexpr Pushing<::lua_pushstring> lua_pushstring;
inline constexpr Pushing<::lua_pushfstring> lua_pushfstring;
inline constexpr Pushing<::lua_createtable> lua_createtable;
inline constexpr Pushing<::lua_newuserdatauv> lua_newuserdatauv;
inline constexpr Pushing<::lua_getglobal> lua_getglobal;
inline constexpr Pushing<::luaL_newmetatable> luaL_newmetatable;
inline constexpr OnTable<::lua_setfield, 1, 0> lua_setfield;
inline constexpr OnTable<::lua_getfield, 0, 1> lua_getfield;
inline constexpr OnTable<::lua_rawseti, 1, 0> lua_rawseti;
inline constexpr OnTable<::lua_rawsetp, 1, 0> lua_rawsetp;

inline constexpr struct {
    void operator()(lua_State* L, lua_CFunction f, int upvalues) const {
        if (upvalues == 0) return ::lua_pushcclosure(L, f, 0);
        protect(L, upvalues, 1, [=](lua_State* inner) { ::lua_pushcclosure(inner, f, upvalues); });
    }
} lua_pushcclosure;

inline constexpr struct {
    void operator()(lua_State* L, const luaL_Reg* functions, int) const {
        protect(L, 1, 1, [=](lua_State* inner) { ::luaL_setfuncs(inner, functions, 0); });
    }
} luaL_setfuncs;  // without upvalues

inline constexpr struct {
    const char* operator()(lua_State* L, int index, std::size_t* length) const {
        if (lua_type(L, index) != LUA_TNUMBER) return ::lua_tolstring(L, index, length);
        index = lua_absindex(L, index);
        lua_pushvalue(L, index);
        protect(L, 1, 1, [](lua_State* inner) { ::lua_tolstring(inner, 1, nullptr); });
        lua_replace(L, index);
        return ::lua_tolstring(L, index, length);
    }
} lua_tolstring;

}  // namespace hinge::script

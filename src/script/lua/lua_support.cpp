#include "script/lua/lua_support.h"

#include <algorithm>
#include <cstring>

#include "core/files.h"
#include "core/suggestion.h"
#include "script/lua/interrupts.h"

namespace hinge::script {
namespace {

const char library_key = 0;

std::string library_folder(lua_State* L) {
    lua_rawgetp(L, LUA_REGISTRYINDEX, &library_key);
    const char* text = lua_tostring(L, -1);
    std::string folder = text ? text : "";
    lua_pop(L, 1);
    return folder;
}

}  // namespace

void set_library_folder(lua_State* L, const std::string& folder) {
    lua_pushlstring(L, folder.data(), folder.size());
    lua_rawsetp(L, LUA_REGISTRYINDEX, &library_key);
}

std::string where(lua_State* L) {
    const std::string library = "@" + library_folder(L);
    lua_Debug frame;
    for (int level = 0; lua_getstack(L, level, &frame); ++level) {
        if (!lua_getinfo(L, "Sl", &frame) || frame.currentline <= 0) continue;
        if (library.size() > 1 && std::strncmp(frame.source, library.c_str(), library.size()) == 0) continue;
        return std::string(frame.short_src) + ":" + std::to_string(frame.currentline);
    }
    return "";
}

namespace {

/// The text of an error, after the script's line.
std::string with_place(lua_State* L, const std::exception& e) {
    const std::string place = where(L);
    return (place.empty() ? "" : place + ": ") + e.what();
}

/// Leaves what was caught on the stack as a Lua error's value.
void explain_caught(lua_State* L) {
    std::string message;
    try {
        throw;
    } catch (const LuaErrorOnStack&) {
        return;
    } catch (const std::length_error&) {  // more of something than there can be
        throw std::bad_alloc();
    } catch (const std::bad_alloc&) { throw; } catch (const HookError& e) {
        message = e.what();
        note_error(L, message, "hook");
    } catch (const Interrupted& e) {
        message = *e.what() ? e.what() : ended_halfway(L);
        note_error(L, message, "interrupted");
    } catch (const WriteError& e) {
        message = e.what();
        note_error(L, message, "outside", e.path, e.why);
    } catch (const OutsideError& e) {
        message = e.what();
        note_error(L, message, "outside");
    } catch (const FieldError& e) {
        message = with_place(L, e);
        note_error(L, message, "input", e.field, e.why);
    } catch (const std::exception& e) {
        message = with_place(L, e);
        note_error(L, message, "input");
    }
    lua_pushlstring(L, message.data(), message.size());
}

}  // namespace

int guarded_call(lua_State* L, Body body) {
    try {
        return body(L);
    } catch (...) {
        try {
            explain_caught(L);
        } catch (...) {
            ::lua_pushstring(L, "not enough memory");  // Lua has this one ready, and knows it for what it is
        }
    }
    return lua_error(L);
}

std::string show(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

std::string show(lua_State* L, int index) {
    switch (lua_type(L, index)) {
        case LUA_TNONE:
        case LUA_TNIL: return "nil";
        case LUA_TBOOLEAN: return lua_toboolean(L, index) ? "true" : "false";
        case LUA_TNUMBER: return show(lua_tonumber(L, index));
        case LUA_TSTRING: return "'" + std::string(lua_tostring(L, index)) + "'";
        case LUA_TTABLE: return "a table";
        case LUA_TFUNCTION: return "a function";
        case LUA_TUSERDATA:
            if (luaL_getmetafield(L, index, "__name") == LUA_TSTRING) {
                std::string name = lua_tostring(L, -1);
                lua_pop(L, 1);
                return "a " + name;
            }
            return "a userdata";
        default: return std::string("a ") + luaL_typename(L, index);
    }
}

int taking(lua_State* L, const char* name, int most, Body body) {
    const int own = std::strchr(name, ':') ? most - 1 : most;
    for (int i = most + 1; i <= lua_gettop(L); ++i)
        if (!lua_isnil(L, i))
            throw InputError(std::string(name) + ": takes " +
                             (own == 0   ? "no argument"
                              : own == 1 ? "one argument"
                                         : std::to_string(own) + " arguments") +
                             ", got also " + show(L, i) +
                             (own == 1 && lua_isnumber(L, i) && lua_isnumber(L, i + 1)
                                  ? "; several numbers go into one table, { x, y, z }"
                                  : ""));
    return body(L);
}

void make_metatable(lua_State* L, const char* name, const luaL_Reg* methods, lua_CFunction fields, lua_CFunction gc,
                    lua_CFunction to_string, lua_CFunction equal) {
    luaL_newmetatable(L, name);
    const auto set = [&](const char* event, lua_CFunction f) {
        if (f) lua_pushcfunction(L, f), lua_setfield(L, -2, event);
    };
    set("__gc", gc);
    set("__tostring", to_string);
    set("__eq", equal);
    lua_newtable(L);
    luaL_setfuncs(L, methods, 0);
    lua_pushvalue(L, -1);
    lua_setfield(L, -3, "methods");
    if (fields) {
        lua_pushcclosure(L, fields, 1);  // the methods are its upvalue
    }
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 1);
}

void add_methods(lua_State* L, const char* name, const luaL_Reg* methods) {
    luaL_getmetatable(L, name);
    lua_getfield(L, -1, "methods");
    luaL_setfuncs(L, methods, 0);
    lua_pop(L, 2);
}

std::string key_argument(lua_State* L) { return lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : show(L, 2); }

bool push_method(lua_State* L) {
    lua_pushvalue(L, 2);
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return true;
    lua_pop(L, 1);
    return false;
}

void refuse_field(lua_State* L, const char* object, const std::string& key) {
    std::vector<std::string> names;
    if (luaL_getmetafield(L, 1, "fields") == LUA_TTABLE)
        for (lua_Integer i = 1, n = lua_rawlen(L, -1); i <= n; ++i) {
            lua_rawgeti(L, -1, i);
            names.push_back(lua_tostring(L, -1));
            lua_pop(L, 1);
        }
    const auto methods = names.size();
    lua_pushnil(L);
    while (lua_next(L, lua_upvalueindex(1))) {
        lua_pop(L, 1);
        names.push_back(lua_tostring(L, -1));
    }
    std::sort(names.begin() + long(methods), names.end());
    std::string list;
    for (const auto& n : names) list += (list.empty() ? "" : ", ") + n;
    throw InputError(std::string(object) + " has no field or method '" + key + "'" + did_you_mean(key, names) +
                     "; it has " + list);
}

void name_fields(lua_State* L, const char* name, const std::vector<const char*>& fields) {
    luaL_getmetatable(L, name);
    lua_newtable(L);
    for (const char* field : fields) lua_pushstring(L, field), lua_rawseti(L, -2, lua_Integer(lua_rawlen(L, -2)) + 1);
    lua_setfield(L, -2, "fields");
    lua_pop(L, 1);
}

void push_array(lua_State* L, const double* values, int n) {
    lua_createtable(L, n, 0);
    for (int i = 0; i < n; ++i) {
        lua_pushnumber(L, values[i]);
        ::lua_rawseti(L, -2, i + 1);
    }
}

}  // namespace hinge::script

#include "script/bind/lua_json.h"

#include <cmath>
#include <map>

#include "script/lua/lua_support.h"
#include "script/lua/probe_list.h"

namespace hinge::script {
namespace {

/// The string at that place, with the zeros in it.
std::string string_at(lua_State* L, int index) {
    std::size_t n = 0;
    const char* text = lua_tolstring(L, index, &n);
    return {text, n};
}

}  // namespace

Json to_json(lua_State* L, int index, int depth) {
    index = lua_absindex(L, index);
    switch (lua_type(L, index)) {
        case LUA_TBOOLEAN: return bool(lua_toboolean(L, index));
        case LUA_TNUMBER:
            if (lua_isinteger(L, index)) return lua_tointeger(L, index);
            return std::isfinite(lua_tonumber(L, index)) ? Json(lua_tonumber(L, index))
                                                         : Json(show(lua_tonumber(L, index)));
        case LUA_TSTRING: return string_at(L, index);
        case LUA_TTABLE: break;
        default: return nullptr;
    }
    if (depth > 16 || !lua_checkstack(L, 4)) return "...";
    fill_probe_list(L, index);
    if (const lua_Integer n = lua_rawlen(L, index); n > 0) {
        Json list = Json::array();
        for (lua_Integer i = 1; i <= n; ++i) {
            lua_rawgeti(L, index, i);
            list.push_back(to_json(L, -1, depth + 1));
            lua_pop(L, 1);
        }
        return list;
    }
    std::map<std::string, Json> sorted;
    lua_pushnil(L);
    while (lua_next(L, index)) {
        if (lua_type(L, -2) == LUA_TSTRING) sorted[string_at(L, -2)] = to_json(L, -1, depth + 1);
        lua_pop(L, 1);
    }
    Json object = Json::object();
    for (auto& [k, v] : sorted) object[k] = std::move(v);
    return object;
}

}  // namespace hinge::script

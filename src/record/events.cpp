#include "record/events.h"

#include "script/bind/probe_list.h"

#include <cmath>

namespace hinge::script {

void write_event(const Context& c, const char* kind, const Json& fields) {
    if (!c.messages.events) return;
    Json j = {{"event", kind}};
    j.update(fields);
    const std::string line = j.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    std::fwrite(line.data(), 1, line.size(), c.messages.events);
    std::fflush(c.messages.events);
}

namespace {

/// The string at that place, with the zeros in it.
std::string whole_text(lua_State* L, int index) {
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
        case LUA_TSTRING: return whole_text(L, index);
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
        if (lua_type(L, -2) == LUA_TSTRING) sorted[whole_text(L, -2)] = to_json(L, -1, depth + 1);
        lua_pop(L, 1);
    }
    Json object = Json::object();
    for (auto& [k, v] : sorted) object[k] = std::move(v);
    return object;
}

}  // namespace hinge::script

// The state a script runs in.
#include "script/objects.h"

namespace hinge::script {
namespace {

const char context_key = 0;
struct ContextBox { static constexpr const char* lua_name = "hinge.context"; std::shared_ptr<Context> value; };

}  // namespace

std::shared_ptr<Context> context(lua_State* L) {
    lua_rawgetp(L, LUA_REGISTRYINDEX, &context_key);
    auto* box = static_cast<ContextBox*>(lua_touserdata(L, -1));
    std::shared_ptr<Context> found = box ? box->value : nullptr;
    lua_pop(L, 1);
    return found;
}

void set_context(lua_State* L, std::shared_ptr<Context> c) {
    if (luaL_newmetatable(L, ContextBox::lua_name)) {
        lua_pushcfunction(L, collect<ContextBox>);
        lua_setfield(L, -2, "__gc");
    }
    lua_pop(L, 1);
    push<ContextBox>(L, std::move(c));
    lua_rawsetp(L, LUA_REGISTRYINDEX, &context_key);
}

void tell_collector(lua_State* L, std::size_t bytes) {
    const auto c = context(L);
    c->unseen += bytes;
    if (c->unseen < 16e6 || !lua_gc(L, LUA_GCISRUNNING)) return;
    c->unseen = 0;
    lua_gc(L, LUA_GCCOLLECT);
}

void note_error(lua_State* L, const std::string& message, const char* kind) {
    if (const auto c = context(L)) c->last_error = message, c->last_error_kind = kind;
}

}  // namespace hinge::script

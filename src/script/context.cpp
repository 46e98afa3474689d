// The state a script runs in, and calls from C++ back into it.
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

void note_error(lua_State* L, const std::string& message, const char* kind) {
    if (const auto c = context(L)) c->last_error = message, c->last_error_kind = kind;
}

struct LuaFunction::Slot {
    lua_State* main;
    int reference;
    ~Slot() { luaL_unref(main, LUA_REGISTRYINDEX, reference); }
};

LuaFunction::LuaFunction(lua_State* L, int index) : context_(context(L)) {
    lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_MAINTHREAD);
    lua_State* main = lua_tothread(L, -1);
    lua_pop(L, 1);
    lua_pushvalue(L, index);
    lua_Debug about;
    lua_pushvalue(L, -1);
    lua_getinfo(L, ">S", &about);
    place_ = std::string(about.short_src) + ":" + std::to_string(about.linedefined);
    slot_.reset(new Slot{main, luaL_ref(L, LUA_REGISTRYINDEX)});  // in place: a copy's destructor would give the reference back
}

void LuaFunction::push(lua_State* L) const { lua_rawgeti(L, LUA_REGISTRYINDEX, slot_->reference); }

void call_hook(lua_State* L, const LuaFunction& function, int arguments, int results) {
    if (lua_pcall(L, arguments, results, 0) == LUA_OK) return;
    const char* text = lua_tostring(L, -1);
    std::string message = text ? text : function.place() + ": the function raised a value that is not a string";
    lua_pop(L, 1);
    throw HookError(message);
}

}  // namespace hinge::script

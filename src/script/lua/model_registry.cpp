#include "script/lua/model_registry.h"

#include "script/lua/context.h"

namespace hinge::script {
namespace {

const char registries_key = 0;

/// Pushes the model's registry, or nil when no object of the script holds one.
bool find_registry(lua_State* L, const Model* model) {
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &registries_key) == LUA_TTABLE) lua_rawgetp(L, -1, model), lua_remove(L, -2);
    return lua_istable(L, -1);
}

/// Pushes a new table that does not keep its values.
void push_weak_table(lua_State* L) {
    lua_newtable(L);
    lua_createtable(L, 0, 1);
    lua_pushliteral(L, "v");
    lua_setfield(L, -2, "__mode");
    lua_setmetatable(L, -2);
}

/// Pushes the table of all registries.
void push_registries(lua_State* L) {
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &registries_key) == LUA_TTABLE) return;
    lua_pop(L, 1);
    push_weak_table(L);
    lua_pushvalue(L, -1);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &registries_key);
}

}  // namespace

void push_registry(lua_State* L, const Model& model) {
    if (find_registry(L, &model)) return;
    lua_pop(L, 1);
    push_registries(L);
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_rawsetp(L, -3, &model);
    lua_remove(L, -2);
}

void hold_registry(lua_State* L, const Model& model) {
    push_registry(L, model);
    lua_setiuservalue(L, -2, 1);
}

void push_handles(lua_State* L, const Model& model, const char* kind) {
    push_registry(L, model);
    if (lua_getfield(L, -1, kind) != LUA_TTABLE) {
        lua_pop(L, 1);
        push_weak_table(L);
        lua_pushvalue(L, -1);
        lua_setfield(L, -3, kind);
    }
}

/// The value's place in the registry: its own address is the key.
struct LuaValue::Slot {
    lua_State* main;
    const Model* model;
    Slot(lua_State* of_main, const Model* of_model) : main(of_main), model(of_model) {}
    Slot(const Slot&) = delete;
    /// The model may be gone by now and its address another's: then that one's registry knows nothing of this key.
    ~Slot() {
        const int top = lua_gettop(main);
        if (find_registry(main, model) && lua_rawgetp(main, -1, this) != LUA_TNIL) {
            lua_pushnil(main);
            ::lua_rawsetp(main, -3, this);
        }
        lua_settop(main, top);
    }
};

LuaValue::LuaValue(lua_State* L, int index, const Model& model) {
    index = lua_absindex(L, index);
    lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_MAINTHREAD);
    slot_ = std::make_shared<Slot>(lua_tothread(L, -1), &model);
    push_registry(L, model);
    lua_pushvalue(L, index);
    lua_rawsetp(L, -2, slot_.get());
    lua_pop(L, 2);
}

LuaFunction::LuaFunction(lua_State* L, int index, const Model& model)
    : LuaValue(L, index, model), context_(context(L)) {
    lua_Debug about;
    lua_pushvalue(L, index);
    lua_getinfo(L, ">S", &about);
    place_ = std::string(about.short_src) + ":" + std::to_string(about.linedefined);
}

void LuaValue::push(lua_State* L) const {
    find_registry(L, slot_->model);
    lua_rawgetp(L, -1, slot_.get());
    lua_remove(L, -2);
}

lua_State* LuaFunction::running() const { return context_->running; }

void hook_failed(lua_State* L, const LuaFunction& function, int status, const std::string& what) {
    if (status == LUA_ERRMEM) lua_pop(L, 1), throw std::bad_alloc();
    const char* text = lua_tostring(L, -1);
    std::string message = text ? text : function.place() + ": the function raised a value that is not a string";
    lua_pop(L, 1);
    if (!what.empty()) message += " (" + what + ")";
    throw HookError(message);
}

}  // namespace hinge::script

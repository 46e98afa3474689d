// Registry of a model's Lua functions: one table a model, referred to by every object of the script that keeps the
// model.
#pragma once

#include <memory>
#include <string>

#include "script/lua/lua_support.h"

namespace hinge {
class Model;
}

namespace hinge::script {

struct ScriptContext;

/// Pushes the model's registry, a Lua table made when it is first asked for.
void push_registry(lua_State* L, const Model& model);

/// Makes the userdata on top of the stack refer to the model's registry. Every object that keeps a model alive must.
void hold_registry(lua_State* L, const Model& model);

/// Pushes the registry, and its table of handles of one kind in use, by number: weak references.
void push_handles(lua_State* L, const Model& model, const char* kind);

/// A Lua value that C++ holds. The model's registry keeps it, not Lua's: a rule that refers to its own model is then a
/// cycle that Lua sees and collects. It may be used as long as an object of the script holds that registry.
class LuaValue {
public:
    LuaValue(lua_State* L, int index, const Model& model);  ///< the value at `index`
    void push(lua_State* L) const;

private:
    struct Slot;
    std::shared_ptr<Slot> slot_;
};

/// A Lua function that C++ calls.
class LuaFunction : public LuaValue {
public:
    LuaFunction(lua_State* L, int index, const Model& model);
    lua_State* running() const;
    const std::string& place() const { return place_; }  ///< "script.lua:12", where the function begins

private:
    std::shared_ptr<ScriptContext> context_;
    std::string place_;
};

/// Throws HookError for a call that ended with `status`: its message and `what`.
[[noreturn]] void hook_failed(lua_State* L, const LuaFunction& function, int status, const std::string& what);

/// Calls the function below its arguments; a Lua error becomes HookError with its message and the text that what()
/// makes then.
template <class What>
void call_hook(lua_State* L, const LuaFunction& function, int arguments, int results, What what) {
    if (const int status = lua_pcall(L, arguments, results, 0); status != LUA_OK)
        hook_failed(L, function, status, what());
}
inline void call_hook(lua_State* L, const LuaFunction& function, int arguments, int results) {
    call_hook(L, function, arguments, results, [] { return ""; });
}

}  // namespace hinge::script

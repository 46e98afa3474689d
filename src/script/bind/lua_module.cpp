// The module any Lua 5.4 loads with `require "hinge"`: the engine as hinge.core, then the Lua library around it.
#include <cstdlib>

#include "script/lua/interrupts.h"
#include "script/bind/lua_module.h"
#include "script/bind/modules.h"
#include "script/lua/installed_files.h"

namespace hinge::script {
namespace {

/// core.input_error(message): wrong input found by the Lua library, raised at the script's own line.
int input_error(lua_State* L) {
    const char* text = lua_tostring(L, 1);
    throw InputError(text ? text : "wrong input");
}

/// core.error_kind(failure): "input", "outside", "hook", "interrupted" for a message that the engine raised, nil for
/// others; of "interrupted" the exit status too.
int error_kind(lua_State* L) {
    const auto c = context(L);
    const char* text = lua_type(L, 1) == LUA_TSTRING ? lua_tostring(L, 1) : nullptr;
    if (text && !c->errors.last.empty() && c->errors.last == text) lua_pushstring(L, c->errors.kind);
    else lua_pushnil(L);
    if (c->errors.kind != std::string_view("interrupted") || lua_isnil(L, -1)) return 1;
    lua_pushinteger(L, c->signals.exit_status);
    return 2;
}

/// What the error of that kind is about, and why; nil where the message is of another one.
int push_about(lua_State* L, std::string_view kind) {
    const auto& last = context(L)->errors;
    const char* text = lua_type(L, 1) == LUA_TSTRING ? lua_tostring(L, 1) : nullptr;
    if (!text || last.about.empty() || last.kind != kind || last.last != text) return lua_pushnil(L), 1;
    lua_pushlstring(L, last.about.data(), last.about.size());
    lua_pushlstring(L, last.why.data(), last.why.size());
    return 2;
}

/// core.unwritten(failure): the path of a file or a folder that could not be written, and why; nil for other failures.
int unwritten(lua_State* L) { return push_about(L, "outside"); }

/// core.wrong_field(failure): the field whose value is wrong, and "VALUE; what is allowed"; nil for other failures.
int wrong_field(lua_State* L) { return push_about(L, "input"); }

/// core.did_you_mean(word, names): " (did you mean 'x'?)", or "".
int suggest(lua_State* L) {
    const char* word = lua_tostring(L, 1);
    if (!word || !lua_istable(L, 2)) throw InputError("did_you_mean: takes a word and a list of names");
    std::vector<std::string> names;
    for (lua_Integer i = 1, n = lua_rawlen(L, 2); i <= n; ++i) {
        lua_rawgeti(L, 2, i);
        if (const char* name = lua_tostring(L, -1)) names.push_back(name);
        lua_pop(L, 1);
    }
    lua_pushstring(L, did_you_mean(word, names).c_str());
    return 1;
}

/// kind_of(value): "model", "member", "run", ... of an object of hinge, nil of any other value.
int kind_of(lua_State* L) {
    constexpr std::string_view before = "hinge.";
    const bool named = lua_type(L, 1) == LUA_TUSERDATA && luaL_getmetafield(L, 1, "__name") == LUA_TSTRING;
    const std::string_view name = named ? lua_tostring(L, -1) : "";
    if (name.substr(0, before.size()) != before) return lua_pushnil(L), 1;
    lua_pushstring(L, name.data() + before.size());
    return 1;
}

int open_core(lua_State* L) {
    prepare(L);
    lua_newtable(L);
    const int module = lua_gettop(L);
    open_values(L, module);
    open_backbone(L, module);
    open_joints(L, module);
    open_objects(L);
    open_model(L, module);
    open_run(L);
    open_reading(L);
    open_modes(L);
    open_checkpoint(L, module);
    open_output(L, module);
    open_pictures(L, module);
    open_plots(L, module);
    open_frames(L, module);
    open_hinges(L, module);
    open_floors(L, module);
    open_measure(L, module);
    open_processes(L, module);
    open_interpreters(L, module);
    open_interrupts(L, module);
    open_film(L, module);
    open_walls(L, module);
    static const luaL_Reg functions[] = {{"input_error", guarded<input_error>},
                                         {"error_kind", guarded<error_kind>},
                                         {"unwritten", guarded<unwritten>},
                                         {"wrong_field", guarded<wrong_field>},
                                         {"did_you_mean", guarded<suggest>},
                                         {"kind_of", guarded<kind_of>},
                                         {nullptr, nullptr}};
    luaL_setfuncs(L, functions, 0);
    lua_pushstring(L, HINGE_VERSION);
    lua_setfield(L, module, "version");
    return 1;
}

int open_module(lua_State* L) {
    const std::string init = prepare(L)->library + "/hinge/init.lua";
    protect(L, 0, 1, [file = init.c_str()](lua_State* inner) {
        if (luaL_loadfilex(inner, file, "t") != LUA_OK) lua_error(inner);
        lua_call(inner, 0, 1);
    });
    return 1;
}

}  // namespace

std::shared_ptr<ScriptContext> prepare(lua_State* L) {
    if (has_context(L)) return context(L);
    auto c = std::make_shared<ScriptContext>();
    c->running = L;
    c->library = library_folder();
    c->picture_module = picture_module();
    c->mode.looks_over = c->messages.warns = c->messages.tells_failures =
        std::getenv("HINGE_QUIET") == nullptr;  // the program says otherwise
    set_library_folder(L, c->library + "/hinge/");
    lua_getglobal(L, "package");
    lua_getfield(L, -1, "path");
    const std::string path =
        c->library + "/?.lua;" + c->library + "/?/init.lua;" + (lua_isstring(L, -1) ? lua_tostring(L, -1) : "");
    lua_pop(L, 1);
    lua_pushstring(L, path.c_str());
    lua_setfield(L, -2, "path");
    lua_getfield(L, -1, "preload");
    lua_pushcfunction(L, guarded<open_core>);
    lua_setfield(L, -2, "hinge.core");
    lua_pop(L, 2);
    set_context(L, c);  // last: all of this is done, or none of it counts
    return c;
}

}  // namespace hinge::script

/// Where Lua finds hinge/init.lua by itself (a rock), it comes here for the engine alone.
extern "C" __attribute__((visibility("default"))) int luaopen_hinge_core(lua_State* L) {
    return hinge::script::guarded<hinge::script::open_core>(L);
}

extern "C" __attribute__((visibility("default"))) int luaopen_hinge(lua_State* L) {
    return hinge::script::guarded<hinge::script::open_module>(L);
}

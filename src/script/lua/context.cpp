// The context in which a script runs.
#include "script/lua/context.h"

namespace hinge::script {
namespace {

const char context_key = 0;

constexpr int most_told = 10;  ///< runs that failed

/// Where nobody asked how a run went, it says so at the end.
void tell_failures(const ScriptContext& c) {
    int told = 0;
    for (const auto& [number, text, cause] : c.runs.failed)
        if (c.runs.asked.count(number) == 0 && ++told <= most_told) std::fprintf(stderr, "hinge: %s\n", text.c_str());
    if (told > most_told) std::fprintf(stderr, "hinge: %d more runs failed\n", told - most_told);
}

struct ContextBox {
    static constexpr const char* lua_name = "hinge.context";
    std::shared_ptr<ScriptContext> value;
    ~ContextBox() {  // the last run's rules hold the context, which holds the run
        if (!value) return;
        if (value->messages.tells_failures) tell_failures(*value);
        value->runs.last = value->runs.writer = nullptr;
    }
};

/// Null before the module is opened, and in a finalizer that runs after the context's own.
std::shared_ptr<ScriptContext> find_context(lua_State* L) {
    lua_rawgetp(L, LUA_REGISTRYINDEX, &context_key);
    auto* box = find<ContextBox>(L, -1);
    std::shared_ptr<ScriptContext> found = box ? box->value : nullptr;
    lua_pop(L, 1);
    return found;
}

}  // namespace

std::shared_ptr<ScriptContext> context(lua_State* L) {
    if (auto c = find_context(L)) return c;
    throw InputError("hinge: called while Lua is closed");
}

bool has_context(lua_State* L) { return find_context(L) != nullptr; }

void set_context(lua_State* L, std::shared_ptr<ScriptContext> c) {
    luaL_newmetatable(L, ContextBox::lua_name);
    lua_pushcfunction(L, collect<ContextBox>);
    lua_setfield(L, -2, "__gc");
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

void note_error(lua_State* L, const std::string& message, const char* kind, const std::string& about,
                const std::string& why) {
    if (const auto c = find_context(L)) c->errors = {message, kind, about, why};
}

}  // namespace hinge::script

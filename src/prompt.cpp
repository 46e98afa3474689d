#include "prompt.h"

#include <csignal>
#include <unistd.h>

#include "core/doing.h"
#include "script/lua/context.h"
#include "terminal.h"

namespace hinge {
namespace {

using namespace script;

struct TerminalBox {
    static constexpr const char* lua_name = "hinge.terminal";
    std::unique_ptr<Terminal> value;
};

/// Calls the function that read_line was given; what goes wrong in it is no reason to disturb who types.
std::vector<std::string> completions(lua_State* L, const std::string& line) {
    std::vector<std::string> names;
    lua_pushvalue(L, 2);
    lua_pushlstring(L, line.data(), line.size());
    if (lua_pcall(L, 1, 1, 0) == LUA_OK && lua_istable(L, -1))
        for (lua_Integer i = 1, n = lua_rawlen(L, -1); i <= n; ++i) {
            lua_rawgeti(L, -1, i);
            if (const char* name = lua_tostring(L, -1)) names.push_back(name);
            lua_pop(L, 1);
        }
    lua_pop(L, 1);
    return names;
}

int read_line(lua_State* L) {
    Terminal& terminal = *static_cast<TerminalBox*>(lua_touserdata(L, lua_upvalueindex(1)))->value;
    const auto line = terminal.read(lua_tostring(L, 1));
    if (line) lua_pushlstring(L, line->data(), line->size());
    else lua_pushnil(L);
    lua_pushboolean(L, terminal.given_up());
    return 2;
}

lua_State* evaluating = nullptr;
ScriptContext* its_context = nullptr;

/// At the next step that Lua takes; between the steps of a run, `advance` looks for itself.
void stop_script(lua_State* L, lua_Debug*) {
    lua_sethook(L, nullptr, 0, 0);
    asked_to_end = 0;
    if (const auto c = context(L)) c->signals.interrupted = 0;
    lua_pushliteral(L, "interrupted");
    lua_error(L);
}

}  // namespace

void push_line_reader(lua_State* L) {
    if (!isatty(STDIN_FILENO) || !isatty(STDOUT_FILENO)) return lua_pushnil(L);
    if (luaL_newmetatable(L, TerminalBox::lua_name))
        lua_pushcfunction(L, collect<TerminalBox>), lua_setfield(L, -2, "__gc");
    lua_pop(L, 1);
    push<TerminalBox>(L, std::make_unique<Terminal>([L](const std::string& line) { return completions(L, line); }));
    lua_pushcclosure(L, guarded<read_line>, 1);
}

void stop_on_interrupt(lua_State* L) {
    evaluating = L;
    its_context = context(L).get();
    struct sigaction stop = {};
    stop.sa_handler = [](int) {
        asked_to_end = SIGINT;
        its_context->signals.interrupted = SIGINT;
        lua_sethook(evaluating, stop_script, LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT, 1);
    };
    stop.sa_flags = SA_RESTART;
    sigaction(SIGINT, &stop, nullptr);
}

}  // namespace hinge

#include "script/lua/interrupts.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>
#include <ctime>

#include "core/doing.h"
#include "record/run_record.h"

namespace hinge::script {
namespace {

constexpr int patience = 10;  ///< s, that the script of a run that is under way has until its next step

ScriptContext* its_context = nullptr;
lua_State* its_lua = nullptr;
volatile std::sig_atomic_t is_script = 0, is_stepping = 0;
volatile std::sig_atomic_t seconds = 0;  ///< since the signal
timer_t timer;
pid_t timed = 0;  ///< the process that the timer belongs to: one that was forked has none

constexpr int all_events = LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT;
lua_Hook hook_before = nullptr;  ///< the sandbox's
int mask_before = 0, count_before = 0;

int push_message(lua_State* L) {
    const std::string text = ended_halfway(L);
    note_error(L, text, "interrupted");
    lua_pushlstring(L, text.data(), text.size());
    return 1;
}

/// At the next thing that the script does.
void stop_script(lua_State* L, lua_Debug*) {
    lua_sethook(L, hook_before, mask_before, count_before);
    lua_pushcfunction(L, guarded<push_message>);
    lua_call(L, 0, 1);
    lua_error(L);
}

void stop_at_next_line() {
    if (lua_gethook(its_lua) == stop_script) return;
    hook_before = lua_gethook(its_lua);
    mask_before = lua_gethookmask(its_lua), count_before = lua_gethookcount(its_lua);
    lua_sethook(its_lua, stop_script, all_events, 1);
}

/// Says what the program waits for.
void say_what() {
    const Doing* now = Doing::now;
    char size[80] = "", text[400];
    if (now && now->size > 0) std::snprintf(size, sizeof size, " of %ld %s", now->size, now->of);
    const int n = std::snprintf(text, sizeof text, "hinge: %s: it ends after %s%s; once more ends it at once\n",
                                its_context->signals.interrupted == SIGTERM ? "SIGTERM" : "Ctrl-C",
                                now           ? now->what
                                : is_stepping ? "the step of the run that is under way"
                                              : "the call that the script is in, or the coroutine",
                                size);
    if (n > 0 && ::write(2, text, std::size_t(n)) < 0) return;
}

/// Once a second after the signal.
void on_second(int) {
    if (!its_context || !is_script) return;
    seconds = seconds + 1;
    if (seconds == 1) say_what();
    if (seconds == patience) stop_at_next_line();
}

void on_signal(int signal) {
    its_context->signals.interrupted = signal;
    asked_to_end = signal;
    for (const int other : {SIGINT, SIGTERM}) std::signal(other, SIG_DFL);
    if (is_script && !is_stepping) stop_at_next_line();
    if (timed != ::getpid()) return;
    const itimerspec each_second = {{1, 0}, {1, 0}};
    ::timer_settime(timer, 0, &each_second, nullptr);
}

/// core.script_runs(is): see script_runs.
int set_script_runs(lua_State* L) {
    lua_pushboolean(L, script_runs(lua_toboolean(L, 1)));
    return 1;
}

}  // namespace

std::string ended_halfway(lua_State* L) {
    ScriptContext& c = *context(L);
    if (!c.signals.ends_on_signals) {  // the prompt goes on
        asked_to_end = 0;
        c.signals.interrupted = 0;
        lua_sethook(L, nullptr, 0, 0);
        return "interrupted";
    }
    c.signals.exit_status = 128 + c.signals.interrupted;
    const std::string place = where(L);
    std::string text = (place.empty() ? "" : place + ": ") + interrupted_by(c);
    const RunRecord* r = c.runs.last.get();
    if (!r || !r->begun || r->closed || !r->checkpoint) return text;
    c.signals.exit_status = 3;
    return text + "; " + r->checkpoint->file +
           " has the run up to its last checkpoint, and the same command with --resume goes on from there";
}

const char* interrupted_by(const ScriptContext& c) {
    return c.signals.interrupted == SIGTERM ? "interrupted by SIGTERM" : "interrupted by Ctrl-C";
}

void end_on_signals(lua_State* L) {
    its_lua = L;
    its_context = context(L).get();
    its_context->signals.ends_on_signals = true;
    struct sigaction tick = {};
    tick.sa_handler = on_second;
    tick.sa_flags = SA_RESTART;
    sigaction(SIGRTMIN, &tick, nullptr);
    struct sigevent event = {};
    event.sigev_notify = SIGEV_THREAD_ID;  // the script's own thread: the hook is set where Lua runs
    event.sigev_signo = SIGRTMIN;
    event._sigev_un._tid = pid_t(::syscall(SYS_gettid));
    if (::timer_create(CLOCK_MONOTONIC, &event, &timer) == 0) timed = ::getpid();
    struct sigaction note = {};
    note.sa_handler = on_signal;
    note.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &note, nullptr);
}

void forget_signals() {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
    if (timed == ::getpid()) ::timer_delete(timer);
    timed = 0;
    its_context = nullptr;
}

bool script_runs(bool is) {
    const bool before = is_script != 0;
    is_script = is;
    return before;
}

void run_is_under_way(bool is) { is_stepping = is; }

void open_interrupts(lua_State* L, int module) {
    static const luaL_Reg functions[] = {{"script_runs", guarded<set_script_runs>}, {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script

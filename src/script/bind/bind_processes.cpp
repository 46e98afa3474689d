// System functions for studies: cases in separate processes, with limits of time and memory; a number for the contents
// of a file; JSON as Lua values.
#include <dlfcn.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <vector>

#include "core/doing.h"
#include "core/errors.h"
#include "core/files.h"
#include "core/text.h"
#include "core/thread_pool.h"
#include "record/events.h"
#include "record/run_observer.h"
#include "script/bind/modules.h"
#include "script/bind/lua_json.h"
#include "script/lua/context.h"

namespace hinge::script {
namespace {

/// Processes that were started here and have not been waited for.
std::vector<pid_t> children;

std::string system_says(const std::string& what) { return what + ": " + std::strerror(errno); }

/// From now on the end of a child is a signal that waits until somebody asks.
void hold_back_sigchld(bool back) {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGCHLD);
    sigprocmask(back ? SIG_BLOCK : SIG_UNBLOCK, &set, nullptr);
}

/// In the child: it ends with its parent, writes to `output`, may take `memory` bytes beyond what it has, and belongs
/// to no terminal.
void settle_in(pid_t parent, const char* output, double memory) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(137);
    setpgid(0, 0);
    hold_back_sigchld(false);
    children.clear();
    const int file = open(output, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666), none = open("/dev/null", O_RDONLY);
    if (file < 0 || dup2(file, STDOUT_FILENO) < 0 || dup2(file, STDERR_FILENO) < 0) _exit(126);
    if (none >= 0) dup2(none, STDIN_FILENO);
    if (memory > 0) {
        long pages = 0;
        if (std::FILE* f = std::fopen("/proc/self/statm", "r")) {
            if (std::fscanf(f, "%ld", &pages) != 1) pages = 0;
            std::fclose(f);
        }
        rlimit limit = {};
        limit.rlim_cur = limit.rlim_max = rlim_t(memory + double(pages) * double(sysconf(_SC_PAGESIZE)));
        setrlimit(RLIMIT_AS, &limit);
    }
}

/// What a new process starts with: nothing of the runs that were made before.
void forget_runs(ScriptContext& c) {
    c.runs.last = nullptr, c.runs.writer = nullptr;
    c.runs.made = c.runs.histories = c.runs.begun = c.messages.warnings_told = c.messages.looked_over = 0;
    c.runs.failed.clear(), c.output.frames.clear(), c.messages.warned.clear(), c.output.checkpoints.clear(),
        c.output.lost.clear();
    c.runs.asked.clear();
    c.messages.progress = false, c.messages.events = nullptr;
    c.output.folder.clear(), c.output.owner.clear();
    c.output.owner_written = false;
    asked_to_end = 0;
    c.signals.interrupted = 0;
    if (c.messages.observer) c.messages.observer->forked(), c.messages.observer = nullptr;
}

constexpr int status_of_memory = 5;  ///< of a process that ran out of it (lua/hinge/study/case.lua)

/// core.start(f, output, memory, resume, jobs): calls f() in a process of its own, which ends with what f returns as
/// its status. `output`: a file that what is printed there is added to; memory: bytes, 0 for no limit; resume: runs go
/// on from their checkpoints; jobs: how many such processes share the cores. Returns the process's number.
int start(lua_State* L) {
    luaL_checktype(L, 1, LUA_TFUNCTION);
    const char* output = luaL_checkstring(L, 2);
    const double memory = luaL_checknumber(L, 3);
    const bool resume = lua_toboolean(L, 4);
    const int jobs = int(luaL_optinteger(L, 5, 1));
    std::fflush(nullptr);
    hold_back_sigchld(true);
    const pid_t parent = getpid(), child = fork();
    if (child < 0) throw OutsideError(system_says("a process could not be started"));
    if (child > 0) return children.push_back(child), lua_pushinteger(L, child), 1;
    settle_in(parent, output, memory);
    forget_runs(*context(L));
    share_cores_among(jobs);
    context(L)->mode.resume = resume;
    lua_settop(L, 1);
    int status = 2;
    const int how = lua_pcall(L, 0, 1, 0);
    if (how == LUA_OK) status = int(lua_tointeger(L, -1));
    else std::fprintf(stderr, "hinge: %s\n", lua_tostring(L, -1) ? lua_tostring(L, -1) : "the case failed");
    if (how == LUA_ERRMEM) status = status_of_memory;
    std::fflush(nullptr);
    _exit(status & 0xff);
}

/// A child that has ended, or 0.
pid_t ended(int& status, rusage& used) {
    for (const pid_t child : children)
        if (wait4(child, &status, WNOHANG, &used) == child) return child;
    return 0;
}

/// core.wait(seconds): the next process of core.start that ends: its number, "exit" or "signal", the status or the
/// signal, and the most memory it held, bytes. Nothing where none ends in that time, "interrupted" where a signal came
/// (core.wait(seconds, true): signals do not matter).
int wait(lua_State* L) {
    const double seconds = std::min(1e6, std::max(0.0, luaL_checknumber(L, 1)));
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGCHLD);
    for (;;) {
        int status = 0;
        rusage used = {};
        if (const pid_t child = ended(status, used)) {
            std::erase(children, child);
            lua_pushinteger(L, child);
            lua_pushstring(L, WIFSIGNALED(status) ? "signal" : "exit");
            lua_pushinteger(L, WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
            lua_pushnumber(L, 1024.0 * double(used.ru_maxrss));
            return 4;
        }
        if (context(L)->signals.interrupted && !lua_toboolean(L, 2)) return lua_pushstring(L, "interrupted"), 1;
        const double left = std::chrono::duration<double>(until - std::chrono::steady_clock::now()).count();
        if (left <= 0) return 0;
        const timespec most = {time_t(left), long((left - double(time_t(left))) * 1e9)};
        sigtimedwait(&set, nullptr, &most);
    }
}

/// core.kill(process, gently): ends a process of core.start and those that it has started; gently: as Ctrl-C would.
int end_process(lua_State* L) {
    const pid_t child = pid_t(luaL_checkinteger(L, 1));
    const int signal = lua_toboolean(L, 2) ? SIGTERM : SIGKILL;
    if (std::find(children.begin(), children.end(), child) == children.end()) return 0;
    if (kill(-child, signal) != 0) kill(child, signal);
    return 0;
}

/// core.drop_checkpoints(): removes the files that this script's runs have named; they are not needed any more.
int drop_checkpoints(lua_State* L) {
    for (const std::string& file : context(L)->output.checkpoints) unlink(file.c_str());
    return 0;
}

/// core.cores(): processors that this process may use.
int cores(lua_State* L) { return lua_pushinteger(L, usable_cores()), 1; }

/// core.width(): columns of the terminal that stderr is, or nil where it is none.
int width(lua_State* L) {
    winsize size = {};
    if (!isatty(STDERR_FILENO)) lua_pushnil(L);
    else lua_pushinteger(L, ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80);
    return 1;
}

/// FNV-1a, 64 bits.
std::string fingerprint_of(std::string_view bytes) {
    std::uint64_t h = 0xcbf29ce484222325u;
    for (const char c : bytes) h = (h ^ std::uint8_t(c)) * 0x100000001b3u;
    return hex_text(h);
}

/// core.fingerprint(text): sixteen hexadecimal digits.
int fingerprint(lua_State* L) {
    std::size_t n = 0;
    const char* text = luaL_checklstring(L, 1, &n);
    return lua_pushstring(L, fingerprint_of({text, n}).c_str()), 1;
}

/// core.engine(): hinge's version and a fingerprint of the program or module that runs.
int engine(lua_State* L) {
    static const std::string own = [] {
        Dl_info info;
        const bool known = dladdr(reinterpret_cast<void*>(&engine), &info) && info.dli_fname && *info.dli_fname;
        std::string path = known ? info.dli_fname : "";
        if (path.find(".so") == std::string::npos) path = "/proc/self/exe";
        return std::string(HINGE_VERSION) + "-" + fingerprint_of(read_whole(path));
    }();
    return lua_pushstring(L, own.c_str()), 1;
}

/// core.program(): path of the program that runs.
int program(lua_State* L) {
    char path[4096];
    const ssize_t n = readlink("/proc/self/exe", path, sizeof path);
    if (n <= 0) lua_pushstring(L, "hinge");
    else lua_pushlstring(L, path, std::size_t(n));
    return 1;
}

void push_json(lua_State* L, const Json& j) {
    luaL_checkstack(L, 4, "JSON is nested too deeply");
    switch (j.type()) {
        case Json::value_t::boolean: lua_pushboolean(L, j.get<bool>()); return;
        case Json::value_t::number_integer:
        case Json::value_t::number_unsigned: lua_pushinteger(L, j.get<lua_Integer>()); return;
        case Json::value_t::number_float: lua_pushnumber(L, j.get<double>()); return;
        case Json::value_t::string: {
            const auto& text = j.get_ref<const std::string&>();
            lua_pushlstring(L, text.data(), text.size());
            return;
        }
        case Json::value_t::array: {
            lua_createtable(L, int(j.size()), 0);
            lua_Integer i = 0;
            for (const Json& item : j) push_json(L, item), lua_rawseti(L, -2, ++i);
            return;
        }
        case Json::value_t::object:
            lua_createtable(L, 0, int(j.size()));
            for (const auto& [name, value] : j.items()) {
                lua_pushlstring(L, name.data(), name.size());
                push_json(L, value);
                lua_rawset(L, -3);
            }
            return;
        default: lua_pushnil(L);
    }
}

/// core.from_json(text): the value, or nil where the text is not JSON.
int from_json(lua_State* L) {
    std::size_t n = 0;
    const char* text = luaL_checklstring(L, 1, &n);
    const Json j = Json::parse(text, text + n, nullptr, false);
    if (j.is_discarded()) lua_pushnil(L);
    else push_json(L, j);
    return 1;
}

/// core.to_json(value): on one line.
int json_text(lua_State* L) {
    const std::string text = to_json(L, 1).dump(-1, ' ', false, Json::error_handler_t::replace);
    return lua_pushlstring(L, text.data(), text.size()), 1;
}

}  // namespace

void open_processes(lua_State* L, int module) {
    static const luaL_Reg functions[] = {{"start", guarded<start>},
                                         {"wait", guarded<wait>},
                                         {"kill", guarded<end_process>},
                                         {"drop_checkpoints", guarded<drop_checkpoints>},
                                         {"cores", guarded<cores>},
                                         {"width", guarded<width>},
                                         {"fingerprint", guarded<fingerprint>},
                                         {"engine", guarded<engine>},
                                         {"program", guarded<program>},
                                         {"from_json", guarded<from_json>},
                                         {"to_json", guarded<json_text>},
                                         {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script

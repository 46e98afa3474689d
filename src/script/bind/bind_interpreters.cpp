// Interpreters of other languages, which run a file of somebody else behind walls of the kernel: hinge.import.
#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <thread>

#include "core/programs.h"
#include "script/bind/modules.h"
#include "core/walls.h"
#include "script/lua/context.h"

namespace hinge::script {
namespace {

namespace fs = std::filesystem;

constexpr double most_output = 400e6;  ///< bytes that an interpreter may write

/// What an interpreter reads of its own: its library, also that of a virtual environment.
void add_library(std::vector<std::string>& read, const fs::path& program) {
    std::error_code none;
    for (const fs::path& path : {program, fs::canonical(program, none)})
        for (const char* part : {"lib", "lib64", "pyvenv.cfg"})
            read.push_back((path.parent_path().parent_path() / part).string());
    read.emplace_back("/usr/share/tcltk");
}

/// The words of a command or of the surroundings as exec takes them.
std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> list;
    for (std::string& word : words) list.push_back(word.data());
    list.push_back(nullptr);
    return list;
}

/// Nothing of the user's own settings; the same order of sets in each run; one thread.
std::vector<std::string> surroundings() {
    return {"PATH=/usr/bin:/bin",        "LANG=C.UTF-8",           "HOME=/nonexistent", "PYTHONHASHSEED=0",
            "PYTHONDONTWRITEBYTECODE=1", "OPENBLAS_NUM_THREADS=1", "OMP_NUM_THREADS=1"};
}

struct Started {
    const char* program;
    char *const *words, *const *around;
    const char* folder;
    int out, err, rules;
    double seconds, memory;
    pid_t parent;
    KernelWalls walls;
};

/// Of the time of the processor the hard limit is a second later: at the soft one the system sends SIGXCPU, which tells
/// that it was the time.
void limit(int what, double most) {
    const rlimit value = {rlim_t(most), rlim_t(most) + (what == int(RLIMIT_CPU) ? 1 : 0)};
    ::setrlimit(__rlimit_resource_t(what), &value);
}

/// The child, between fork and exec: nothing here takes memory.
[[noreturn]] void become(const Started& s) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != s.parent) ::_exit(127);
    ::setsid();
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    const int nothing = ::open("/dev/null", O_RDONLY);
    if (::chdir(s.folder) != 0 || ::dup2(nothing, 0) < 0 || ::dup2(s.out, 1) < 0 || ::dup2(s.err, 2) < 0) ::_exit(127);
    ::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
    limit(RLIMIT_AS, s.memory), limit(RLIMIT_CPU, s.seconds + 2), limit(RLIMIT_FSIZE, most_output);
    limit(RLIMIT_CORE, 0);
    if (::unshare(CLONE_NEWNET) != 0) ::unshare(CLONE_NEWUSER | CLONE_NEWNET);  // where the system lets it
    if (s.walls.landlock > 0 && !restrict_files(s.rules)) ::_exit(126);
    if (s.walls.seccomp && !refuse_calls(true)) ::_exit(126);
    ::execve(s.program, s.words, s.around);
    ::_exit(127);
}

std::string whole(int file) {
    std::string text(std::size_t(std::max<off_t>(0, ::lseek(file, 0, SEEK_END))), '\0');
    std::size_t n = 0;
    while (n < text.size()) {
        const ssize_t got = ::pread(file, text.data() + n, text.size() - n, off_t(n));
        if (got <= 0) break;
        n += std::size_t(got);
    }
    text.resize(n);
    return text;
}

/// Waits for the child: "exit", "signal", "time" or "interrupted"; the status or the signal in `number`.
const char* wait_for(pid_t child, double seconds, const ScriptContext& c, int& number) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    const char* ended = nullptr;
    for (int status = 0, pause = 1;; pause = std::min(2 * pause, 20)) {
        const pid_t done = ::waitpid(child, &status, ended ? 0 : WNOHANG);
        if (done < 0 && errno == EINTR) continue;
        if (done != 0) {
            ::kill(-child, SIGKILL);  // what it may have started, where the kernel lacks a wall
            number = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
            return ended ? ended : WIFSIGNALED(status) ? "signal" : "exit";
        }
        if (c.signals.interrupted) ended = "interrupted";
        else if (std::chrono::steady_clock::now() > until) ended = "time";
        if (ended) ::kill(-child, SIGKILL), ::kill(child, SIGKILL);
        else std::this_thread::sleep_for(std::chrono::milliseconds(pause));
    }
}

/// A list of texts, field `name` of the table at the top of the stack.
std::vector<std::string> texts_of(lua_State* L, const char* name) {
    std::vector<std::string> list;
    lua_getfield(L, -1, name);
    for (lua_Integer i = 1, n = lua_istable(L, -1) ? lua_Integer(lua_rawlen(L, -1)) : 0; i <= n; ++i) {
        lua_rawgeti(L, -1, i);
        if (const char* text = lua_tostring(L, -1)) list.emplace_back(text);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return list;
}

double number_of(lua_State* L, const char* name) {
    lua_getfield(L, -1, name);
    const double x = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return x;
}

/// core.interpret { program =, words =, file =, script =, seconds =, memory = }: runs `program words... script file`,
/// the interpreter's own script and the path of the file with symbolic links resolved, in the folder of the file. The
/// process reads that folder, the script's and the interpreter's library, writes nothing, starts nothing, and reaches
/// no network. Returns nil where the program is not installed; else a table { out =, err =, ended =, number = }:
/// what it wrote, how it ended ("exit", "signal", "time", "interrupted") with its status or signal, and after how many
/// `seconds`.
int interpret(lua_State* L) {
    const auto c = context(L);
    luaL_checktype(L, 1, LUA_TTABLE);
    lua_settop(L, 1);
    if (c->mode.sandbox) throw InputError("a script in the sandbox starts no program");
    const auto text = [&](const char* name) {
        lua_getfield(L, 1, name);
        const std::string value = lua_tostring(L, -1) ? lua_tostring(L, -1) : "";
        lua_pop(L, 1);
        return value;
    };
    const std::string program = find_program(text("program"), true);
    if (program.empty()) return lua_pushnil(L), 1;
    std::error_code none;
    const fs::path file = fs::canonical(text("file"), none), script = fs::canonical(text("script"), none);
    std::vector<std::string> words = texts_of(L, "words"), more = texts_of(L, "more"), around = surroundings();
    words.insert(words.begin(), program);
    words.insert(words.end(), {script.string(), file.string()});
    words.insert(words.end(), more.begin(), more.end());
    const std::vector<char*> argv = pointers(words), envp = pointers(around);
    Reach reach = {system_files(), {"/dev/null"}, {program, program_loader()}};
    reach.read.push_back(file.parent_path().string()), reach.read.push_back(script.string());
    add_library(reach.read, program);
    Started s = {program.c_str(),
                 argv.data(),
                 envp.data(),
                 file.parent_path().c_str(),
                 -1,
                 -1,
                 -1,
                 number_of(L, "seconds"),
                 number_of(L, "memory"),
                 ::getpid(),
                 kernel_walls()};
    const std::string folder = file.parent_path().string();
    s.folder = folder.c_str();
    s.out = ::memfd_create("interpreter-output", MFD_CLOEXEC), s.err = ::memfd_create("messages", MFD_CLOEXEC);
    s.rules = make_rules(reach);
    std::fflush(nullptr);
    const auto began = std::chrono::steady_clock::now();
    const pid_t child = s.out < 0 || s.err < 0 ? -1 : ::fork();
    if (child == 0) become(s);
    int number = 0;
    const char* ended = child < 0 ? nullptr : wait_for(child, s.seconds + 5, *c, number);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    const std::string out = whole(s.out), err = whole(s.err);
    for (const int opened : {s.out, s.err, s.rules})
        if (opened >= 0) ::close(opened);
    if (!ended) throw OutsideError(program + " could not be started");
    lua_createtable(L, 0, 5);
    lua_pushlstring(L, out.data(), out.size()), lua_setfield(L, -2, "out");
    lua_pushlstring(L, err.data(), std::min<std::size_t>(err.size(), 2000)), lua_setfield(L, -2, "err");
    lua_pushstring(L, ended), lua_setfield(L, -2, "ended");
    lua_pushinteger(L, number), lua_setfield(L, -2, "number");
    lua_pushnumber(L, took.count()), lua_setfield(L, -2, "seconds");
    return 1;
}

/// core.lacking_walls(): the walls of core.interpret that this kernel does not have; "" where it has both.
int lacking_walls(lua_State* L) { return lua_pushstring(L, lacking(kernel_walls()).c_str()), 1; }

}  // namespace

void open_interpreters(lua_State* L, int module) {
    static const luaL_Reg functions[] = {
        {"interpret", guarded<interpret>}, {"lacking_walls", guarded<lacking_walls>}, {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script

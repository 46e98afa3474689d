// Plots: writes commands and data for gnuplot beside the picture, and runs gnuplot behind walls of its own.
#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <system_error>
#include <thread>

#include "core/files.h"
#include "core/programs.h"
#include "record/folders.h"
#include "core/walls.h"
#include "script/bind/modules.h"
#include "script/bind/run_box.h"
#include "record/recording.h"

namespace hinge::script {
namespace {

namespace fs = std::filesystem;

/// What a program that is started gets: a folder, no standard input, its messages in a file, no signals held back.
class Surroundings {
public:
    Surroundings(const std::string& folder, int messages) {
        ::posix_spawn_file_actions_init(&files);
        ::posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
        ::posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_adddup2(&files, messages, 1);
        ::posix_spawn_file_actions_adddup2(&files, messages, 2);
        ::posix_spawnattr_init(&attributes);
        sigset_t none, all;
        ::sigemptyset(&none);
        ::sigfillset(&all);
        ::posix_spawnattr_setsigmask(&attributes, &none);
        ::posix_spawnattr_setsigdefault(&attributes, &all);
        // Ctrl-C belongs to the run, which may still want to draw what it has.
        ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSID);
    }
    ~Surroundings() {
        ::posix_spawn_file_actions_destroy(&files);
        ::posix_spawnattr_destroy(&attributes);
    }
    Surroundings(const Surroundings&) = delete;
    Surroundings& operator=(const Surroundings&) = delete;

    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
};

std::string text_of(int file) {
    char text[600];
    const ssize_t n = ::pread(file, text, sizeof text, 0);
    std::string all(text, n > 0 ? std::size_t(n) : 0);
    while (!all.empty() && (all.back() == '\n' || all.back() == ' ')) all.pop_back();
    return all;
}

/// What gnuplot may open: it writes beside the picture alone, and starts nothing. It has no option for that: `system`,
/// `!` and names that begin with < or | are part of its language.
Reach reach_of_gnuplot(const std::string& folder, const std::string& program) {
    Reach reach = {{"/"}, {folder, "/dev/null"}, {program, program_loader()}};
    if (is_wrapper(program)) reach.execute = {"/"};
    return reach;
}

constexpr rlim_t longest = 600;  ///< s of the processor for a plot, which may outlive a run that is stopped

/// Starts a program under these rules, which hold for the thread that starts it and whatever it starts. 0, or errno.
int start_under(int rules, const std::string& program, const Surroundings& around, char* const* words, pid_t& pid) {
    int problem = 0;
    std::thread([&] {
        if (rules >= 0 && !restrict_files(rules)) problem = EPERM;
        else problem = ::posix_spawn(&pid, program.c_str(), &around.files, &around.attributes, words, environ);
    }).join();
    return problem;
}

/// Runs `gnuplot FILE` in the folder, without the user's own settings; throws what it complains of.
void run_gnuplot(const std::string& folder, const std::string& file) {
    const std::string program = find_program("gnuplot"), here = folder.empty() ? "." : folder;
    if (program.empty())
        throw OutsideError("plots need the program gnuplot, which is not installed: apt-get install gnuplot-nox; " +
                           file + " is there for it");
    const int messages = ::memfd_create("gnuplot-messages", MFD_CLOEXEC);
    if (messages < 0) throw OutsideError("gnuplot was not started: no memory for its messages");
    std::string words[] = {"gnuplot", "-d", "./" + file};  // a name that begins with - is no option
    char* const argv[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
    const int rules = make_rules(reach_of_gnuplot(here, program));
    pid_t pid = 0;
    int status = 0, problem = 0;
    try {
        const Surroundings around(here, messages);
        problem = start_under(rules, program, around, argv, pid);
    } catch (const std::system_error& e) { problem = e.code().value(); }  // no thread
    const rlimit most = {longest, longest};
    if (problem == 0) ::prlimit(pid, RLIMIT_CPU, &most, nullptr);
    if (problem == 0)
        while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {}
    const std::string said = problem == 0 ? text_of(messages) : "";
    ::close(messages);
    if (rules >= 0) ::close(rules);
    if (problem != 0) throw OutsideError(std::string("gnuplot was not started: ") + std::strerror(problem));
    if (status != 0) throw OutsideError("gnuplot failed on " + file + (said.empty() ? "" : ": " + said));
}

/// Whether a picture ends as one does that was written whole.
bool is_whole(const std::string& path) {
    std::error_code none;
    if (!fs::is_regular_file(path, none)) return false;
    const std::string all = read_whole(path);
    const std::string end = all.substr(all.size() - std::min<std::size_t>(all.size(), 16));
    return end.find("IEND") != std::string::npos || end.find("</svg>") != std::string::npos ||
           end.find("%%EOF") != std::string::npos;
}

/// core.draw_plot(path, commands, data, problem): writes NAME.gp and NAME.dat beside the picture NAME.png, .svg or .pdf
/// and has gnuplot draw it; `problem`: why there is nothing to draw.
int draw_plot(lua_State* L) {
    const fs::path picture = luaL_checkstring(L, 1), gp = fs::path(picture).replace_extension(".gp"),
                   data = fs::path(picture).replace_extension(".dat");
    for (const fs::path& file : {picture, gp, data}) prepare_folder(*context(L), file);
    if (lua_type(L, 4) == LUA_TSTRING) throw OutsideError(std::string("plot: ") + lua_tostring(L, 4));
    std::size_t size = 0;
    const char* text = luaL_checklstring(L, 3, &size);
    write_whole(data, {text, size});
    text = luaL_checklstring(L, 2, &size);
    write_whole(gp, {text, size});
    std::error_code none;
    fs::remove(picture, none);
    run_gnuplot(picture.parent_path(), gp.filename());
    if (is_whole(picture)) return 0;
    fs::remove(picture, none);
    throw WriteError(picture.string(), "gnuplot did not finish it; is the disk full?");
}

/// core.sandboxed(): whether the script is not trusted.
int sandboxed(lua_State* L) { return lua_pushboolean(L, context(L)->mode.sandbox), 1; }

/// core.run_history(run, function): { columns = { names in order }, parts = { names of parts of accounts }, [name] = {
/// values } }, the present state last (history_of).
int run_history(lua_State* L) {
    const auto r =
        run_argument(L, 1, (lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) + std::string(": ") : "") + "the run");
    const RunHistory history = history_of(*r);
    const auto put_names = [L](const std::vector<std::string>& names, const char* field) {
        lua_newtable(L);
        for (std::size_t i = 0; i < names.size(); ++i) {
            lua_pushstring(L, names[i].c_str());
            lua_rawseti(L, -2, lua_Integer(i) + 1);
        }
        lua_setfield(L, -2, field);
    };
    lua_newtable(L);
    put_names(history.columns, "columns");
    put_names(history.parts, "parts");
    const std::size_t n = history.columns.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::vector<double> column;
        for (std::size_t i = k; i < history.values.size(); i += n) column.push_back(history.values[i]);
        push_array(L, column.data(), int(column.size()));
        lua_setfield(L, -2, history.columns[k].c_str());
    }
    return 1;
}

}  // namespace

void open_plots(lua_State* L, int module) {
    static const luaL_Reg functions[] = {{"draw_plot", guarded<draw_plot>},
                                         {"run_history", guarded<run_history>},
                                         {"sandboxed", guarded<sandboxed>},
                                         {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script

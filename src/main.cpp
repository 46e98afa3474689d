// The program hinge: runs scripts, describes planned simulations, draws written results.
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <unistd.h>

#include "command_line.h"
#include "core/files.h"
#include "live/live.h"
#include "new_project.h"
#include "prompt.h"
#include "record/folders.h"
#include "script/lua/interrupts.h"
#include "script/bind/lua_module.h"
#include "script/lua/context.h"
#include "version.h"
#include "core/suggestion.h"
#include "record/run_record.h"

namespace {

namespace fs = std::filesystem;
using hinge::Request, hinge::script::ScriptContext;

/// Calls require("hinge.<module>").<function>(table) and returns its status.
int call_library(lua_State* L, const char* module, const char* function, Request& request) {
    lua_getglobal(L, "require");
    lua_pushstring(L, module);
    if (lua_pcall(L, 1, 1, 0) != LUA_OK) return std::cerr << "hinge: " << lua_tostring(L, -1) << "\n", 2;
    lua_getfield(L, -1, function);
    lua_newtable(L);
    const auto set = [&](const char* name, const std::string& value) {
        if (!value.empty()) lua_pushstring(L, value.c_str()), lua_setfield(L, -2, name);
    };
    set("script", request.script);
    set("verb", request.verb);
    set("case", request.case_name);
    set("out", request.out);
    if (request.out_given) set("out_given", "yes");
    if (request.sandbox) set("sandbox", std::to_string(std::llround(request.limits.memory / (1 << 20))) + "M");
    set("code", request.code);
    set("search", request.search);
    set("within", request.within);
    set("budget", request.budget);
    set("quantity", request.quantity);
    if (request.effects) set("effects", "all");
    if (request.quiet) set("quiet", "yes");
    if (request.resume) set("resume", "yes");
    for (const auto& [name, value] : request.texts) set(name.c_str(), value);
    if (request.verb == "study") {
        lua_newtable(L);
        for (std::size_t i = 0; i < request.overrides.size(); ++i)
            lua_pushstring(L, request.overrides[i].c_str()), lua_rawseti(L, -2, lua_Integer(i) + 1);
        lua_setfield(L, -2, "words");
        request.overrides.clear();
    }
    if (request.verb == "report") {
        lua_newtable(L);
        for (std::size_t i = 0; i < request.folders.size(); ++i)
            lua_pushstring(L, request.folders[i].c_str()), lua_rawseti(L, -2, lua_Integer(i) + 1);
        lua_setfield(L, -2, "folders");
    }
    if (request.verb == "prompt") {
        hinge::stop_on_interrupt(L);
        hinge::push_line_reader(L), lua_setfield(L, -2, "read");
    }
    lua_newtable(L);
    int n = 0;
    for (const std::string& pair : request.overrides) {
        const auto equals = pair.find('=');
        lua_createtable(L, 2, 0);
        lua_pushlstring(L, pair.data(), equals), lua_rawseti(L, -2, 1);
        lua_pushstring(L, pair.c_str() + equals + 1), lua_rawseti(L, -2, 2);
        lua_rawseti(L, -2, ++n);
    }
    lua_setfield(L, -2, "overrides");
    if (lua_pcall(L, 1, 1, 0) != LUA_OK)
        return std::cerr << "hinge: " << (lua_tostring(L, -1) ? lua_tostring(L, -1) : "the script failed") << "\n", 2;
    return lua_isinteger(L, -1) ? int(lua_tointeger(L, -1)) : 0;
}

/// --json: objects alone go to standard output; what else would be printed there goes to standard error.
std::FILE* events_alone_on_stdout() {
    std::fflush(stdout);
    const int own = dup(STDOUT_FILENO);
    if (own < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return nullptr;
    return fdopen(own, "w");
}

/// --live: serves the page from now on; its address goes to standard error.
std::unique_ptr<hinge::live::Live> begin_live(lua_State* L, ScriptContext& context, int port) {
    auto live = std::make_unique<hinge::live::Live>(port);
    lua_getglobal(L, "require");
    lua_pushstring(L, "hinge.report.page");
    bool ok = lua_pcall(L, 1, 1, 0) == LUA_OK;
    if (ok) {
        lua_getfield(L, -1, "live");
        lua_pushstring(L, live->id().c_str());
        ok = lua_pcall(L, 1, 1, 0) == LUA_OK;
    }
    if (!ok) throw hinge::OutsideError(lua_tostring(L, -1) ? lua_tostring(L, -1) : "the page could not be made");
    live->show(lua_tostring(L, -1));
    lua_settop(L, 0);
    std::cerr << "live until the program ends: " << live->address() << std::endl;
    hinge::write_event(context, "live", {{"address", live->address()}});
    context.messages.observer = live.get();
    return live;
}

/// The program ends with that status: who looks is told how, and of what it leaves.
void end_live(hinge::live::Live& live, ScriptContext& context, int status) {
    context.messages.observer = nullptr;
    hinge::Json last = {{"status", status}, {"folder", context.output.folder}};
    const std::string summary = context.output.folder + "/summary.json";
    if (status <= 1 && context.runs.last && context.runs.last->number == live.shown() && fs::exists(summary)) {
        auto whole = hinge::Json::parse(hinge::read_whole(summary), nullptr, false);
        if (whole.is_object()) last["summary"] = std::move(whole);
    }
    live.end(last);
}

int with_lua(Request& request, const char* module, const char* function, bool progress) {
    std::unique_ptr<lua_State, void (*)(lua_State*)> state(luaL_newstate(), lua_close);
    lua_State* L = state.get();
    if (!L) return std::cerr << "hinge: not enough memory to start Lua\n", 1;
    luaL_openlibs(L);
    const auto context = hinge::script::prepare(L);
    luaL_requiref(L, "hinge", luaopen_hinge, 0);
    lua_pop(L, 1);
    const bool one_run = request.verb != "cost" && request.verb != "study" && request.verb != "report" &&
                         (request.verb != "run" || request.within.empty());
    if (one_run) context->output.folder = request.out;  // runs that are only compared leave nothing
    context->messages.progress = progress && !request.quiet && !request.json;
    context->messages.warns = context->messages.progress;
    context->messages.tells_failures = false;  // the verdict is told by itself
    context->mode.looks_over = progress;
    if (request.json) context->messages.events = events_alone_on_stdout();
    context->mode.sandbox = request.sandbox;
    context->mode.resume = request.resume && one_run;  // cases go on in processes of their own
    const bool ends_on_signals = request.verb == "run" || request.verb == "study" || request.verb == "render";
    if (ends_on_signals) hinge::script::end_on_signals(L);
    std::unique_ptr<hinge::live::Live> live;
    if (request.live_port) try {
            live = begin_live(L, *context, *request.live_port);
        } catch (const hinge::OutsideError& e) { return std::cerr << "hinge: " << e.what() << "\n", 2; }
    if (request.sandbox) hinge::script::confine(L, request.limits);
    const int status = call_library(L, module, function, request);
    if (live) end_live(*live, *context, status);
    if (request.verb == "run" && one_run) request.out = context->output.folder;  // its name may tell the parameters
    if (ends_on_signals) hinge::script::forget_signals();
    return status;
}

bool are_settings(const std::vector<std::string>& words) {
    for (const std::string& pair : words)
        if (pair.find('=') == std::string::npos || pair[0] == '=')
            return std::cerr << "hinge: '" << pair << "' is not a setting; write key=value, for example speed=100\n",
                   false;
    return true;
}

int run(Request request, bool named, const std::vector<std::string>& verbs) {
    if (request.verb != "study" && (named || fs::exists(request.script)) && !are_settings(request.overrides)) return 2;
    if (!fs::exists(request.script) && !named && request.script.find_first_of("./") == std::string::npos)
        return std::cerr << "hinge: there is no verb and no script '" << request.script << "'"
                         << hinge::did_you_mean(request.script, verbs) << "; hinge --help lists the verbs\n",
               2;
    if (!fs::exists(request.script)) return std::cerr << "hinge: there is no script " << request.script << "\n", 2;
    const bool only_looks = request.verb == "plan" || request.verb == "check";
    if (only_looks) return with_lua(request, "hinge.program.runner", "main", false);
    request.out_given = !request.out.empty();
    if (!request.out_given)
        request.out = (fs::path("out") / fs::path(request.script).stem()).string() +
                      (request.case_name.empty() ? "" : "-" + request.case_name) +
                      (request.verb == "study"  ? "-study"
                       : request.verb != "cost" ? ""
                       : request.effects        ? "-effects"
                                                : "-cost");
    if (request.verb == "cost") return with_lua(request, "hinge.cost.program", "main", false);
    if (request.verb == "study") return with_lua(request, "hinge.study.program", "main", false);
    if (request.verb == "run" && !request.within.empty())
        return with_lua(request, "hinge.accuracy.program", "main", false);
    const int status = with_lua(request, "hinge.program.runner", "main", true);
    if (status <= 1 && !request.quiet && !request.json && fs::exists(fs::path(request.out) / "summary.json"))
        std::cout << "written to " << request.out << "\n";
    return status;
}

int program(int argc, char** argv) {
    hinge::CommandLine line = hinge::read_command_line({argv + 1, argv + argc});
    if (!line.unknown_verb.empty())
        return std::cerr << "hinge: there is no verb '" << line.unknown_verb << "'"
                         << hinge::did_you_mean(line.unknown_verb, line.verbs)
                         << "; hinge --help lists the verbs, hinge reference NAME tells about a call\n",
               2;
    if (line.status) return *line.status;
    Request& request = line.request;
    const std::string verb = request.verb;
    if (verb == "render") return with_lua(request, "hinge.render", "main", false);
    if (verb == "report") return with_lua(request, "hinge.report.page", "main", false);
    if (verb == "export") return with_lua(request, "hinge.import.export", "main", false);
    if (verb == "reference") return with_lua(request, "hinge.program.help", "main", false);
    if (verb == "new") return hinge::new_project(request.out);
    if (verb == "history") {
        if (request.folders.empty()) request.folders = {"out"};
        if (hinge::print_history(request.folders)) return 0;
        return std::cerr << "hinge: no run was written to " << request.folders[0] << "\n", 2;
    }
    if (verb == "completion") {
        if (request.code == "names") return with_lua(request, "hinge.program.completion", "main", false);
        std::cout << line.completion;
        return 0;
    }
    if (verb == "do" || verb == "prompt") {
        if (!are_settings(request.overrides)) return 2;
        return with_lua(request, "hinge.program.prompt", verb == "do" ? "line" : "main", verb == "prompt");
    }
    return run(std::move(request), line.named, line.verbs);
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): what is left are the streams, which are not told to throw
int main(int argc, char** argv) {
    int status = 1;
    try {
        status = program(argc, argv);
    } catch (const std::exception& e) { std::cerr << "hinge: " << e.what() << "\n"; }
    if (std::fflush(stdout) == 0 && !std::ferror(stdout) && std::cout.flush()) return status;
    std::cerr << "hinge: cannot write to standard output: " << std::strerror(errno) << "\n";
    return status == 0 ? 1 : status;
}

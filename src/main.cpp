// The program: runs scripts, says what would be simulated, draws what was written.
#include <CLI/CLI.hpp>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <unistd.h>

#include "completion.h"
#include "core/files.h"
#include "live/live.h"
#include "new_project.h"
#include "prompt.h"
#include "script/folders.h"
#include "script/module.h"
#include "script/objects.h"
#include "script/sandbox.h"
#include "version.h"

namespace {

namespace fs = std::filesystem;
using hinge::script::Context;

struct Request {
    std::string verb = "run", script, case_name, out, code, search, within, budget, quantity;
    std::vector<std::string> overrides, folders;
    std::map<std::string, std::string> texts;  ///< options of hinge study and hinge render, which Lua reads
    std::optional<int> live_port;              ///< of hinge run --live; 0: any
    bool sandbox = false, effects = false, resume = false, quiet = false, json = false, out_given = false;
    hinge::script::Limits limits;
};

/// --sandbox and its limits, for the verbs that run a script.
void add_sandbox(CLI::App& verb, Request& request) {
    auto* sandbox = verb.add_flag("--sandbox", request.sandbox,
                                  "For a script that is not trusted: no files but its output folder, no processes, no "
                                  "native modules, and limits");
    verb.add_option("--memory", request.limits.memory,
                    "Most memory in the sandbox, in bytes or as 512M, 2G; default 1G")
        ->needs(sandbox)
        ->transform(CLI::AsSizeValue(false))
        ->check(CLI::Range(16e6, 1e15))
        ->type_name("SIZE");
    verb.add_option("--seconds", request.limits.seconds, "Most wall time in the sandbox, s")
        ->needs(sandbox)
        ->check(CLI::Range(1e-3, 1e9))
        ->capture_default_str()
        ->type_name("TIME");
    verb.add_option("--instructions", request.limits.instructions, "Most instructions of Lua's machine in the sandbox")
        ->needs(sandbox)
        ->check(CLI::Range(1.0, 1e18))
        ->capture_default_str()
        ->type_name("NUMBER");
}

/// hinge study and its options.
CLI::App* add_study(CLI::App& app, Request& request) {
    auto* study_verb = app.add_subcommand(
        "study", "Run a script with many values of its parameters, each case in a process of its own");
    study_verb->add_option("script", request.script, "Lua script")->required();
    study_verb->add_option(
        "settings", request.overrides,
        "What varies: key=a,b,c, key=first:last:step, or drawn at random: key~normal(mean,deviation), "
        "key~lognormal(median,deviation of the logarithm), key~uniform(lowest,highest), "
        "key~triangular(lowest,likeliest,highest), key~weibull(scale,shape), key~choice(a,b,...). Cases are the "
        "product "
        "of all values. Nothing given: what the scenario's own vary has");
    const auto study_option = [&](const char* flags, const char* name, const char* help) {
        return study_verb->add_option_function<std::string>(
            flags, [&request, name](const std::string& text) { request.texts[name] = text; }, help);
    };
    study_option("--cases", "cases", "The scenario's cases: all, or names such as I,III");
    study_option("-j,--jobs", "jobs", "Cases at a time (default: as many as there are cores)");
    study_option("--table", "table", "CSV file: names in its first line, a combination of values a row");
    study_option("--samples", "samples", "How many draws (default 100)");
    study_option("--method", "method", "How to draw: lhs (Latin hypercube, the default), sobol, plain");
    study_option("--seed", "seed", "A whole number; the same one gives the same draws (default 1)");
    study_option("--propose", "propose", "One of the scenario's proposals, a function that gives the next case");
    study_option("--timeout", "timeout", "Most time a case may take, such as 60s, 5min or 1h");
    study_option("--memory", "memory", "Most memory a case may take, such as 500M or 2G");
    study_verb->add_option("--out", request.out,
                           "Folder for results.csv, summary.json, pictures and the cases' own folders (default "
                           "out/SCRIPT-study)");
    study_verb->add_flag("--resume", request.resume, "Keep the cases that are finished, and run the others");
    study_verb->add_flag_callback(
        "--restart", [&] { request.texts["restart"] = "yes"; }, "Run all cases anew, also those that are finished");
    study_verb->add_flag("-q,--quiet", request.quiet, "Print the last lines only");
    study_verb->add_flag_callback(
        "--list", [&] { request.texts["list"] = "yes"; },
        "Print all cases, a line each: number, case, parameters; runs nothing");
    study_option("--case", "number",
                 "Run this case alone, by its number, or several as 3-7: for GNU parallel or any other queue. Finished "
                 "ones are left alone; --collect gathers");
    study_verb->add_flag_callback(
        "--collect", [&] { request.texts["collect"] = "yes"; },
        "Gather what --case and --slurm have finished so far, also while they run");
    study_verb->add_flag_callback(
        "--slurm", [&] { request.texts["slurm"] = "yes"; }, "Submit the study to Slurm as a job array");
    study_option("--per-task", "per_task", "With --slurm: cases a task of the array (default 1)");
    study_option("--sbatch", "sbatch", "With --slurm: options for sbatch, such as '-p long -t 2:00:00'");
    study_verb->add_flag_callback(
        "--dry-run", [&] { request.texts["dry_run"] = "yes"; },
        "With --slurm: print what would be submitted, and submit nothing");
    study_verb->footer(
        "Exit status: 0 all cases have an answer; 1 some of them failed; 2 the script or its input is wrong; 3 "
        "interrupted, the same command with --resume goes on.");
    return study_verb;
}

/// hinge render and its options.
CLI::App* add_render(CLI::App& app, Request& request) {
    auto* verb = app.add_subcommand("render", "Draw the frames of a run: a PNG picture beside each, or all as a film");
    verb->add_option("folder", request.out, "A run's output folder")->required();
    const auto text = [&](const char* flags, const char* name, const char* help, const char* type) {
        verb->add_option_function<std::string>(
                flags, [&request, name](const std::string& value) { request.texts[name] = value; }, help)
            ->type_name(type);
    };
    const auto flag = [&](const char* flags, const char* name, const char* help) {
        verb->add_flag_callback(
            flags, [&request, name] { request.texts[name] = "yes"; }, help);
    };
    flag("--film", "film", "Make a film: MP4, or a GIF where ffmpeg is not installed");
    flag("--mp4", "mp4", "Make a film as MP4 (H.264), by the program ffmpeg");
    flag("--webm", "webm", "Make a film as WebM (VP9), by the program ffmpeg");
    flag("--gif", "gif", "Make a film as GIF, which needs no other program");
    text("--out", "film_file", "The film's file, which ends in .mp4, .webm or .gif (default film.mp4 in the folder)",
         "FILE");
    text("--fps", "fps", "Pictures a second of the film (default 25)", "N");
    text("--seconds", "seconds", "How long the film is (default: a picture for each frame)", "S");
    text("--size", "size", "Pixels (default 1600x1200; of a film 1920x1080, of a GIF 960x540)", "WxH");
    text("--view", "view", "Where the eye is: front, back, left, right, top, iso or perspective", "NAME");
    text("--from", "from", "Direction from the scene to the eye instead, such as -1,-1.4,0.55", "X,Y,Z");
    text("--show", "show",
         "Colours by f_y (the default) or group, or none; or a diagram of N, Qx, Qy, Mx, My or Mz along the members",
         "WHAT");
    text("--scale", "scale", "Magnify displacements so many times; auto: so that the largest can be seen", "K");
    flag("--ghost", "ghost", "Draw the shape at the start, too, in grey");
    flag("--loads", "loads", "Draw the loads, with their values");
    flag("--labels", "labels", "Write the numbers of nodes and members");
    text("--groups", "groups", "Only the members of these groups, such as columns,beams", "NAMES");
    text("--title", "title", "Text above", "TEXT");
    text("-j,--jobs", "jobs", "Pictures at a time (default: as many as there are cores)", "N");
    verb->footer(
        "Exit status: 0; 1 a frame could not be drawn (it is named, the others are drawn) or the film not be written; "
        "2 "
        "there are no frames, or an option is wrong; 130 (Ctrl-C) or 143 (SIGTERM) interrupted, and no film is left.");
    return verb;
}

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

Context* to_interrupt = nullptr;

/// Ctrl-C and SIGTERM end the run under way after its step; the second one ends the program at once.
void end_on_signals(Context& context) {
    to_interrupt = &context;
    context.ends_on_signals = true;
    struct sigaction note = {};
    note.sa_handler = [](int signal) { to_interrupt->interrupted = signal; };
    note.sa_flags = int(SA_RESTART | SA_RESETHAND);
    for (int signal : {SIGINT, SIGTERM}) sigaction(signal, &note, nullptr);
}

/// --json: objects alone go to standard output; what else would be printed there goes to standard error.
std::FILE* events_alone_on_stdout() {
    std::fflush(stdout);
    const int own = dup(STDOUT_FILENO);
    if (own < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return nullptr;
    return fdopen(own, "w");
}

/// --live: serves the page from now on; its address goes to standard error.
std::unique_ptr<hinge::live::Live> begin_live(lua_State* L, Context& context, int port) {
    auto live = std::make_unique<hinge::live::Live>(port);
    lua_getglobal(L, "require");
    lua_pushstring(L, "hinge.report_page");
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
    hinge::script::write_event(context, "live", {{"address", live->address()}});
    context.onlooker = live.get();
    return live;
}

/// The program ends with that status: who looks is told how, and of what it leaves.
void end_live(hinge::live::Live& live, Context& context, int status) {
    context.onlooker = nullptr;
    hinge::script::Json last = {{"status", status}, {"folder", context.out_dir}};
    const std::string summary = context.out_dir + "/summary.json";
    if (status <= 1 && context.record && context.record->number == live.shown() && fs::exists(summary)) {
        auto whole = hinge::script::Json::parse(hinge::read_whole(summary), nullptr, false);
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
    const bool one_run = request.verb != "cost" && request.verb != "study" && request.verb != "report";
    if (one_run) context->out_dir = request.out;  // runs that are only compared leave nothing
    context->progress = progress && !request.quiet && !request.json;
    context->warns = context->progress;
    context->tells_failures = false;  // the verdict is told by itself
    context->looks_over = progress;
    if (request.json) context->events = events_alone_on_stdout();
    context->sandbox = request.sandbox;
    context->resume = request.resume;
    const bool ends_on_signals = request.verb == "run" || request.verb == "study" || request.verb == "render";
    if (ends_on_signals) end_on_signals(*context);
    std::unique_ptr<hinge::live::Live> live;
    if (request.live_port) try {
            live = begin_live(L, *context, *request.live_port);
        } catch (const hinge::OutsideError& e) { return std::cerr << "hinge: " << e.what() << "\n", 2; }
    if (request.sandbox) hinge::script::confine(L, request.limits);
    const int status = call_library(L, module, function, request);
    if (live) end_live(*live, *context, status);
    if (request.verb == "run") request.out = context->out_dir;  // its name may tell the parameters
    if (ends_on_signals)
        for (int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
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
                         << hinge::script::did_you_mean(request.script, verbs) << "; hinge --help lists the verbs\n",
               2;
    if (!fs::exists(request.script)) return std::cerr << "hinge: there is no script " << request.script << "\n", 2;
    if (request.verb == "plan" || request.verb == "check") return with_lua(request, "hinge.runner", "main", false);
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
    const int status = with_lua(request, "hinge.runner", "main", true);
    if (status <= 1 && !request.quiet && !request.json && fs::exists(fs::path(request.out) / "summary.json"))
        std::cout << "written to " << request.out << "\n";
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"hinge: collapse of framed structures under impact, scripted in Lua 5.4", "hinge"};
    app.set_version_flag("--version", hinge::version_text, "Print version, build and libraries, and exit");
    app.require_subcommand(1);
    Request request;
    auto* run_verb = app.add_subcommand("run", "Run a script; 'hinge SCRIPT' is the same");
    run_verb->add_option("script", request.script, "Lua script")->required();
    run_verb->add_option("settings", request.overrides, "Parameters of the script's scenario, key=value");
    run_verb->add_option("--case", request.case_name, "One of the scenario's cases");
    run_verb->add_option(
        "--out", request.out,
        "Folder for summary.json, history.csv, frames and pictures (default out/SCRIPT[-CASE] with what differs "
        "from the script's defaults, such as out/frame-II-speed=100; -2, -3 ... where that holds a run of "
        "another script of that name)");
    run_verb->add_flag("--resume", request.resume, "Resume each run that names a checkpoint, where its file exists");
    auto* quiet = run_verb->add_flag("-q,--quiet", request.quiet,
                                     "Print what the script prints and why a run failed: no progress, changes of "
                                     "state, warnings (summary.json has them)");
    run_verb
        ->add_flag("--json", request.json,
                   "Print one JSON object a line, each with its 'event': run_begun, progress, state, warning, note, "
                   "run_ended, summary, error; what the script prints goes to standard error")
        ->excludes(quiet);
    run_verb
        ->add_option("--live", request.live_port,
                     "Serve the page of hinge report while the program runs, to browsers on this computer alone: the "
                     "newest frame, the energies, what has happened. Its address is printed. --live=PORT sets the port")
        ->expected(0, 1)
        ->check(CLI::Range(0, 65535))
        ->type_name("[=PORT]");
    run_verb->footer(
        "Exit status: 0 done; 1 the run failed; 2 the script or its input is wrong; 3 interrupted, and a checkpoint "
        "was written; 130 (Ctrl-C) or 143 (SIGTERM) interrupted, and no checkpoint was written.");
    add_sandbox(*run_verb, request);
    auto* plan_verb = app.add_subcommand(
        "plan",
        "List the effects that a script simulates, with the reason and the line of the script for each; runs nothing");
    plan_verb->add_option("script", request.script, "Lua script")->required();
    plan_verb->add_option("settings", request.overrides, "Parameters of the script's scenario, key=value");
    plan_verb->add_option("--case", request.case_name, "One of the scenario's cases");
    add_sandbox(*plan_verb, request);
    auto* check_verb = app.add_subcommand("check",
                                          "Print counts, mass and natural periods of the models that a script runs, "
                                          "and warn of likely mistakes in them; runs nothing");
    check_verb->add_option("script", request.script, "Lua script")->required();
    check_verb->add_option("settings", request.overrides, "Parameters of the script's scenario, key=value");
    check_verb->add_option("--case", request.case_name, "One of the scenario's cases");
    add_sandbox(*check_verb, request);
    check_verb->footer("Exit status: 0 done, also with warnings; 2 the script or its input is wrong.");
    auto* cost_verb = app.add_subcommand(
        "cost",
        "Compare a scenario's accuracy settings: what each costs in time and how far it is from a finer reference");
    cost_verb->add_option("script", request.script, "Lua script that returns a hinge.scenario")->required();
    cost_verb->add_option(
        "settings", request.overrides,
        "Parameters of the script's scenario, key=value; an accuracy setting given here is not varied");
    cost_verb->add_option("--within", request.within, "Largest error accepted, such as 1% or 0.01 (default 1%)");
    cost_verb->add_option("--quantity", request.quantity,
                          "Compare settings by this answer alone (default: by the worst of all)");
    cost_verb->add_option("--case", request.case_name, "One of the scenario's cases");
    cost_verb->add_option(
        "--budget", request.budget,
        "Time limit, such as 60s, 5min or 1h; finished runs are kept, and a second call goes on from them");
    cost_verb->add_flag(
        "--effects", request.effects,
        "Leave out one effect at a time instead (contact, plasticity, ...), and print what each changes in "
        "the answers and costs in time");
    cost_verb->add_option(
        "--out", request.out,
        "Folder for cost.csv, cost.png, summary.json and what is finished (default out/SCRIPT[-CASE]-cost with the "
        "settings given, such as out/frame-cost-speed=100; with --effects effects.csv and summary.json, "
        "out/SCRIPT[-CASE]-effects)");
    auto* study_verb = add_study(app, request);
    auto* render_verb = add_render(app, request);
    auto* report_verb =
        app.add_subcommand("report",
                           "Write a page about a run, or several side by side: what was run, what happened, energies, "
                           "and a player to look at it in 3D; any browser shows it, without a network");
    report_verb->add_option("folders", request.folders, "Output folders of the runs")->required();
    report_verb->add_option("--out", request.out, "HTML file (default report.html in the first folder)");
    report_verb->footer("Exit status: 0; 1 it cannot be written; 2 where no run was written.");
    auto* history_verb = app.add_subcommand(
        "history", "Print whose each output folder is: script, parameters, verdict, version of hinge, time");
    history_verb->add_option("folders", request.folders, "Output folders, or folders that hold them (default out)");
    history_verb->footer("Exit status: 0; 2 where no run was written.");
    auto* reference_verb = app.add_subcommand(
        "reference", "Print the reference of all that a script can call, as Markdown; or what one call is and takes");
    auto* name = reference_verb->add_option("name", request.code, "Such as material, model:member, hinge.run, verdict");
    reference_verb->add_option("-s,--search", request.search, "List where the texts speak of a word, such as buckling")
        ->type_name("WORD")
        ->excludes(name);
    reference_verb->footer("Exit status: 0; 2 where nothing is found.");
    auto* do_verb = app.add_subcommand(
        "do", "Run a line of Lua, with 'hinge' loaded, and print what it returns; 'hinge -e CODE' is the same");
    do_verb->add_option("code", request.code, "Lua, an expression or statements")->required();
    do_verb->add_option("settings", request.overrides, "key=value, in a table, '...'");
    auto* prompt_verb = app.add_subcommand(
        "prompt",
        "Prompt for lines of Lua, which are run one by one; after a script, if one is given; 'hinge -i' is the same");
    prompt_verb->add_option("script", request.script, "Lua script to run first; its globals stay");
    prompt_verb->add_option("settings", request.overrides, "Parameters of the script's scenario, key=value");
    prompt_verb->add_option("--case", request.case_name, "One of the scenario's cases");
    prompt_verb->add_option("--out", request.out, "Folder for what is written (default: nothing is written)");
    auto* new_verb = app.add_subcommand("new", "Write a small project to start from into a folder of that name");
    new_verb->add_option("name", request.out, "Folder; what it holds already is not overwritten")->required();
    new_verb->footer("Exit status: 0; 1 it cannot be written; 2 there is something of that name.");
    std::vector<std::string> completed = hinge::completed_shells;
    completed.push_back("names");
    auto* completion_verb = app.add_subcommand(
        "completion", "Print what makes a shell complete verbs, options, files, cases and parameters after 'hinge'");
    completion_verb
        ->add_option("shell", request.code,
                     "bash, fish or zsh; names: what a script has of cases and parameters, or the reference of calls")
        ->required()
        ->check(CLI::IsMember(completed));
    completion_verb->add_option("script", request.script, "Lua script, of names; it is read, not run");
    completion_verb->footer("For bash: source <(hinge completion bash), in ~/.bashrc.");

    std::vector<std::string> verbs, words(argv + 1, argv + argc);
    for (const CLI::App* verb : app.get_subcommands([](CLI::App*) { return true; })) verbs.push_back(verb->get_name());
    if (!words.empty() && (words[0] == "-e" || words[0] == "-i")) words[0] = words[0] == "-e" ? "do" : "prompt";
    const bool named =
        !words.empty() && (words[0][0] == '-' || std::find(verbs.begin(), verbs.end(), words[0]) != verbs.end());
    if (!words.empty() && (!named || words[0] == "--sandbox" || words[0].rfind("--live", 0) == 0))
        words.insert(words.begin(), "run");  // hinge SCRIPT is hinge run SCRIPT
    std::replace(words.begin(), words.end(), std::string("--live"),
                 std::string("--live=0"));     // what follows is no port
    std::reverse(words.begin(), words.end());  // CLI11 takes them from the back
    try {
        app.parse(words);
    } catch (const CLI::ParseError& e) { return app.exit(e) == 0 ? 0 : 2; }
    if (*render_verb) {
        request.verb = "render";
        return with_lua(request, "hinge.render", "main", false);
    }
    if (*report_verb) {
        request.verb = "report";
        return with_lua(request, "hinge.report_page", "main", false);
    }
    if (*history_verb) {
        if (request.folders.empty()) request.folders = {"out"};
        if (hinge::script::print_history(request.folders)) return 0;
        return std::cerr << "hinge: no run was written to " << request.folders[0] << "\n", 2;
    }
    if (*reference_verb) return with_lua(request, "hinge.help", "main", false);
    if (*new_verb) return hinge::new_project(request.out);
    if (*completion_verb) {
        if (request.code == "names") return with_lua(request, "hinge.completion", "main", false);
        std::cout << hinge::completion_script(app, request.code);
        return 0;
    }
    if (*do_verb || *prompt_verb) {
        request.verb = *do_verb ? "do" : "prompt";
        if (!are_settings(request.overrides)) return 2;
        return with_lua(request, "hinge.prompt", *do_verb ? "line" : "main", bool(*prompt_verb));
    }
    for (const CLI::App* verb : {plan_verb, check_verb, cost_verb, study_verb})
        if (*verb) request.verb = verb->get_name();
    return run(std::move(request), named, verbs);
}

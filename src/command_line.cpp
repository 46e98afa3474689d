// The verbs of the program and their options.
#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "completion.h"
#include "version.h"

namespace hinge {
namespace {

/// What `hinge help accuracy` prints.
constexpr const char* help_on_accuracy =
    "How far the numbers of a run may be from the exact ones, and what better ones would cost\n"
    "\n"
    "hinge run SCRIPT --within 2%      chooses time step and elements so that the answers have this error at most.\n"
    "                                  Tells each error, what it rests on, and what half of it would cost\n"
    "  --answers peak_mm,broken        the answers that count (default: all numbers that the script returns)\n"
    "  --budget 5min                   ends the search in time\n"
    "hinge study SCRIPT --within 2%    chooses them once, and checks them in some of the cases\n"
    "hinge cost SCRIPT                 compares settings of your own by error and time; --effects: effects and laws\n"
    "\n"
    "An answer that hangs on everything, as after an impact, is chaotic. Several runs then tell its mean and its\n"
    "scatter, and which members break in all, in some and in none of them.\n"
    "\n"
    "hinge report OUT                  a page with the errors, what was tried, and members coloured by who broke\n"
    "hinge render OUT --show broken    pictures with these colours\n"
    "OUT/summary.json                  has all of it under `accuracy`; OUT/broken.csv the members that broke\n"
    "\n"
    "The guide's page accuracy.md says how an error is estimated.\n";

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

/// --within, --answers and --budget, for the verbs that choose settings by their accuracy.
void add_within(CLI::App& verb, Request& request, const std::string& help) {
    auto* within = verb.add_option("--within", request.within, help);
    verb.add_option_function<std::string>(
            "--answers", [&request](const std::string& names) { request.texts["answers"] = names; },
            "With --within: the answers that count, such as peak_mm,plastic_kJ:0.1, where differences of 0.1 do not "
            "matter (default: the scenario's answers, or all numbers that it returns)")
        ->needs(within);
    verb.add_option("--budget", request.budget,
                    "With --within: most time that the search may take, such as 60 (seconds), 60s, 5min or 1h")
        ->needs(within);
}

void add_run(CLI::App& app, Request& request) {
    auto* verb = app.add_subcommand("run", "Run a script; 'hinge SCRIPT' is the same");
    verb->add_option("script", request.script, "Lua script")->required();
    verb->add_option("settings", request.overrides,
                     "Parameters of the script's scenario, key=value; the key may be an option, too");
    verb->add_option("--case", request.case_name, "One of the scenario's cases");
    verb->add_option(
        "--out", request.out,
        "Folder for summary.json, history.csv, frames and pictures (default out/SCRIPT[-CASE] with what differs "
        "from the script's defaults, such as out/frame-II-speed=100; -2, -3 ... where that holds a run of "
        "another script of that name)");
    verb->add_flag("--resume", request.resume, "Resume each run that names a checkpoint, where its file exists");
    add_within(*verb, request,
               "Choose dt, elements a member and integrator so that the answers have this error at most, such as 2%; "
               "tell the error, what it rests on and what it cost");
    auto* quiet = verb->add_flag("-q,--quiet", request.quiet,
                                 "Print what the script prints and why a run failed: no progress, changes of "
                                 "state, warnings (summary.json has them)");
    verb->add_flag("--json", request.json,
                   "Print one JSON object a line, each with its 'event': run_begun, progress, state, warning, note, "
                   "run_ended, summary, error; what the script prints goes to standard error")
        ->excludes(quiet);
    verb->add_option("--live", request.live_port,
                     "Serve the page of hinge report while the program runs, to browsers on this computer alone: the "
                     "newest frame, the energies, what has happened. Its address is printed. --live=PORT sets the port")
        ->expected(0, 1)
        ->check(CLI::Range(0, 65535))
        ->type_name("[=PORT]");
    verb->footer(
        "Exit status: 0 done; 1 the run failed; 2 the script or its input is wrong; 3 interrupted, and a checkpoint "
        "was written; 130 (Ctrl-C) or 143 (SIGTERM) interrupted, and no checkpoint was written.");
    add_sandbox(*verb, request);
}

void add_plan(CLI::App& app, Request& request) {
    auto* verb = app.add_subcommand(
        "plan",
        "List the effects that a script simulates, with the reason and the line of the script for each; runs nothing");
    verb->add_option("script", request.script, "Lua script")->required();
    verb->add_option("settings", request.overrides,
                     "Parameters of the script's scenario, key=value; the key may be an option, too");
    verb->add_option("--case", request.case_name, "One of the scenario's cases");
    add_sandbox(*verb, request);
}

void add_check(CLI::App& app, Request& request) {
    auto* verb = app.add_subcommand("check",
                                    "Print counts, mass and natural periods of the models that a script runs, "
                                    "and warn of likely mistakes in them; runs nothing");
    verb->add_option("script", request.script, "Lua script")->required();
    verb->add_option("settings", request.overrides,
                     "Parameters of the script's scenario, key=value; the key may be an option, too");
    verb->add_option("--case", request.case_name, "One of the scenario's cases");
    add_sandbox(*verb, request);
    verb->footer("Exit status: 0 done, also with warnings; 2 the script or its input is wrong.");
}

void add_cost(CLI::App& app, Request& request) {
    auto* verb = app.add_subcommand(
        "cost",
        "Compare a scenario's accuracy settings: what each costs in time, and its error with a band; of chaotic "
        "answers mean and scatter");
    verb->add_option("script", request.script, "Lua script that returns a hinge.scenario")->required();
    verb->add_option("settings", request.overrides,
                     "Parameters of the script's scenario, key=value; an accuracy setting given here is not varied");
    verb->add_option("--within", request.within,
                     "Largest error accepted, its band included, such as 1% or 0.01 (default 1%)");
    verb->add_option("--quantity", request.quantity,
                     "Compare settings by this answer alone (default: by the worst of all)");
    verb->add_option("--case", request.case_name, "One of the scenario's cases");
    verb->add_option(
        "--budget", request.budget,
        "Time limit, such as 60 (seconds), 60s, 5min or 1h; measured times decide what is run, and what is left out is "
        "named; finished runs are kept, and a second call goes on from them");
    verb->add_flag("--effects", request.effects,
                   "Leave out one effect at a time instead (contact, plasticity, ...), and print what each changes in "
                   "the answers and costs in time");
    verb->add_option(
        "--out", request.out,
        "Folder for cost.csv, cost.png, summary.json and what is finished (default out/SCRIPT[-CASE]-cost with the "
        "settings given, such as out/frame-cost-speed=100; with --effects effects.csv and summary.json, "
        "out/SCRIPT[-CASE]-effects)");
}

void add_report(CLI::App& app, Request& request) {
    auto* verb =
        app.add_subcommand("report",
                           "Write a page about a run, or several side by side: what was run, what happened, energies, "
                           "and a player to look at it in 3D; any browser shows it, without a network");
    verb->add_option("folders", request.folders, "Output folders of the runs")->required();
    verb->add_option("--out", request.out, "HTML file (default report.html in the first folder)");
    verb->footer(
        "A frame that cannot be read is left out; stderr and the page name it. Exit status: 0; 1 where a frame was "
        "left "
        "out, or the page cannot be written; 2 where no run was written.");
}

void add_export(CLI::App& app, Request& request) {
    auto* verb = app.add_subcommand(
        "export",
        "Write a frame of SAP2000, ETABS, OpenSees or of tables in CSV as a script of hinge, and name what was "
        "not read");
    verb->add_option("file", request.script,
                     "File .s2k, .e2k, .tcl or .py; or a folder with nodes.csv, members.csv, sections.csv, ...")
        ->required();
    const auto text = [&](const char* flags, const char* name, const char* help, const char* type) {
        verb->add_option_function<std::string>(
                flags, [&request, name](const std::string& value) { request.texts[name] = value; }, help)
            ->type_name(type);
    };
    text("--out", "file", "The script, whose name ends in .lua (default: the file's name, in this folder)", "FILE");
    text("--units", "units",
         "Of a script of OpenSees: force and length, such as kN,m or kip,inch; a third one for masses", "FORCE,LENGTH");
    text("--model", "model",
         "Of a script of OpenSees that makes several models, one after the other (wipe, remove): which one, from 1 "
         "(default: the one at its end)",
         "N");
    verb->add_flag_callback(
        "--run-python", [&request] { request.texts["run_python"] = "yes"; },
        "A file .py is a program: run it, with limits of time and memory, without files of others and network");
    text("--sections", "sections",
         "Of a file of SAP2000 or ETABS: a table of sections that hinge has in place of the file's, one a line, such "
         "as W14X999,W14X873",
         "CSV");
    text("--slabs", "slabs",
         "Of a file of SAP2000 or ETABS: floors become plates with stiffness. Area of the bars in concrete each way, "
         "m^2/m, and their yield stress, Pa, such as 393e-6,500e6; or 'file': the file has them",
         "AREA,YIELD");
    verb->footer(
        "Exit status: 0 the script was written, also where something was not read; 1 it cannot be written; 2 the file "
        "is wrong.");
}

void add_history_command(CLI::App& app, Request& request) {
    auto* verb = app.add_subcommand(
        "history", "Print whose each output folder is: script, parameters, verdict, version of hinge, time");
    verb->add_option("folders", request.folders, "Output folders, or folders that hold them (default out)");
    verb->footer("Exit status: 0; 2 where no run was written.");
}

void add_reference(CLI::App& app, Request& request) {
    auto* verb = app.add_subcommand(
        "reference", "Print the reference of all that a script can call, as Markdown; or what one call is and takes");
    auto* name = verb->add_option("name", request.code, "Such as material, model:member, hinge.run, verdict");
    verb->add_option("-s,--search", request.search, "List where the texts speak of a word, such as buckling")
        ->type_name("WORD")
        ->excludes(name);
    verb->footer("Exit status: 0; 2 where nothing is found.");
}

void add_do(CLI::App& app, Request& request) {
    auto* verb = app.add_subcommand(
        "do", "Run a line of Lua, with 'hinge' loaded, and print what it returns; 'hinge -e CODE' is the same");
    verb->add_option("code", request.code, "Lua, an expression or statements")->required();
    verb->add_option("settings", request.overrides, "key=value, in a table, '...'");
}

void add_prompt(CLI::App& app, Request& request) {
    auto* verb = app.add_subcommand(
        "prompt",
        "Prompt for lines of Lua, which are run one by one; after a script, if one is given; 'hinge -i' is the same");
    verb->add_option("script", request.script, "Lua script to run first; its globals stay");
    verb->add_option("settings", request.overrides, "Parameters of the script's scenario, key=value");
    verb->add_option("--case", request.case_name, "One of the scenario's cases");
    verb->add_option("--out", request.out, "Folder for what is written (default: nothing is written)");
}

void add_new(CLI::App& app, Request& request) {
    auto* verb = app.add_subcommand("new", "Write a small project to start from into a folder of that name");
    verb->add_option("name", request.out, "Folder; what it holds already is not overwritten")->required();
    verb->footer("Exit status: 0; 1 it cannot be written; 2 there is something of that name.");
}

void add_completion(CLI::App& app, Request& request) {
    std::vector<std::string> completed = hinge::completed_shells;
    completed.push_back("names");
    auto* verb = app.add_subcommand(
        "completion", "Print what makes a shell complete verbs, options, files, cases and parameters after 'hinge'");
    verb->add_option("shell", request.code,
                     "bash, fish or zsh; names: what a script has of cases and parameters, or the reference of calls")
        ->required()
        ->check(CLI::IsMember(completed));
    verb->add_option("script", request.script, "Lua script, of names; it is read, not run");
    verb->footer("For bash: source <(hinge completion bash), in ~/.bashrc.");
}

void add_study(CLI::App& app, Request& request) {
    auto* verb = app.add_subcommand(
        "study", "Run a script with many values of its parameters, each case in a process of its own");
    verb->add_option("script", request.script, "Lua script")->required();
    verb->add_option(
        "settings", request.overrides,
        "What varies: key=a,b,c, key=first:last:step, or drawn at random: key~normal(mean,deviation), "
        "key~lognormal(median,deviation of the logarithm), key~uniform(lowest,highest), "
        "key~triangular(lowest,likeliest,highest), key~weibull(scale,shape), key~choice(a,b,...). Cases are the "
        "product "
        "of all values. Nothing given: what the scenario's own vary has");
    const auto study_option = [&](const char* flags, const char* name, const char* help) {
        return verb->add_option_function<std::string>(
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
    add_within(*verb, request,
               "Choose dt, elements a member and integrator once, for answers with this error at most, such as 2%, and "
               "check the choice in some of the cases; --list and --slurm choose for --case and --collect");
    study_option("--memory", "memory", "Most memory a case may take, such as 500M or 2G");
    verb->add_option("--out", request.out,
                     "Folder for results.csv, summary.json, pictures and the cases' own folders (default "
                     "out/SCRIPT-study)");
    verb->add_flag("--resume", request.resume, "Keep the cases that are finished, and run the others");
    verb->add_flag_callback(
        "--restart", [&] { request.texts["restart"] = "yes"; }, "Run all cases anew, also those that are finished");
    verb->add_flag("-q,--quiet", request.quiet, "Print the last lines only");
    verb->add_flag_callback(
        "--list", [&] { request.texts["list"] = "yes"; },
        "Print all cases, a line each: number, case, parameters; runs none of them");
    study_option("--case", "number",
                 "Run this case alone, by its number, or several as 3-7: for GNU parallel or any other queue. Finished "
                 "ones are left alone; --collect gathers");
    verb->add_flag_callback(
        "--collect", [&] { request.texts["collect"] = "yes"; },
        "Gather what --case and --slurm have finished so far, also while they run");
    verb->add_flag_callback(
        "--slurm", [&] { request.texts["slurm"] = "yes"; }, "Submit the study to Slurm as a job array");
    study_option("--per-task", "per_task", "With --slurm: cases a task of the array (default 1)");
    study_option("--sbatch", "sbatch", "With --slurm: options for sbatch, such as '-p long -t 2:00:00'");
    verb->add_flag_callback(
        "--dry-run", [&] { request.texts["dry_run"] = "yes"; },
        "With --slurm: print what would be submitted, and submit nothing");
    verb->footer(
        "Exit status: 0 all cases have an answer; 1 some of them failed; 2 the script or its input is wrong; 3 "
        "interrupted, the same command with --resume goes on.");
}

void add_render(CLI::App& app, Request& request) {
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
         "Colours by f_y (the default), group, or broken (in how many of the runs that asking for an accuracy made), "
         "or none; or a diagram of N, Qx, Qy, Mx, My or Mz along the members",
         "WHAT");
    text("--scale", "scale", "Magnify displacements so many times; auto: so that the largest can be seen", "K");
    flag("--ghost", "ghost", "Draw the shape at the start, too, in grey");
    flag("--loads", "loads", "Draw the loads, with their values");
    flag("--labels", "labels", "Write the numbers of nodes and members");
    text("--groups", "groups", "Only the members of these groups, such as columns,beams", "NAMES");
    text("--plane", "plane", "Only what lay in this plane at the start, m: y=0 for one line of frames, z=3 for a floor",
         "AXIS=M");
    text("--title", "title", "Text above", "TEXT");
    text("-j,--jobs", "jobs", "Pictures at a time (default: as many as there are cores)", "N");
    verb->footer(
        "Exit status: 0; 1 a frame could not be drawn (it is named, the others are drawn) or the film not be written; "
        "2 "
        "there are no frames, or an option is wrong; 130 (Ctrl-C) or 143 (SIGTERM) interrupted, and no film is left.");
}

/// Declares all verbs. The values of options go into `request`, without the verb's name.
void declare_verbs(CLI::App& app, Request& request) {
    for (const auto add : {add_run, add_plan, add_check, add_cost, add_study, add_render, add_report, add_export,
                           add_history_command, add_reference, add_do, add_prompt, add_new, add_completion})
        add(app, request);
}

/// Whether the words differ by one letter, or by two neighbours that have changed places.
bool is_slip(const std::string& a, const std::string& b) {
    std::size_t from = 0, to_a = a.size(), to_b = b.size();
    while (from < to_a && from < to_b && a[from] == b[from]) ++from;
    while (to_a > from && to_b > from && a[to_a - 1] == b[to_b - 1]) --to_a, --to_b;
    const std::size_t left_a = to_a - from, left_b = to_b - from;
    return (left_a <= 1 && left_b <= 1) ||
           (left_a == 2 && left_b == 2 && a[from] == b[from + 1] && a[from + 1] == b[from]);
}

/// "--filter plastic" and "--filter=plastic" behind the script are filter=plastic, where the verb has no such option,
/// nor one of nearly that name.
void take_parameters(const CLI::App& verb, std::vector<std::string>& words) {
    const std::string& name_of_verb = verb.get_name();  // hinge study passes what it does not know on to sbatch
    if (name_of_verb != "run" && name_of_verb != "plan" && name_of_verb != "check") return;
    std::vector<std::string> options;
    for (const CLI::Option* option : verb.get_options()) options.push_back(option->get_name(false, false));
    bool script = false;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word.rfind("--", 0) != 0) {
            script = script || word.rfind('-', 0) != 0;
            continue;
        }
        const std::size_t equals = word.find('=');
        const std::string option = word.substr(0, equals), name = option.substr(2);
        const bool is_name = !name.empty() && std::all_of(name.begin(), name.end(),
                                                          [](unsigned char c) { return std::isalnum(c) || c == '_'; });
        if (!script || !is_name || option == "--help" || verb.get_option_no_throw(option) != nullptr ||
            std::any_of(options.begin(), options.end(), [&](const auto& other) { return is_slip(option, other); }))
            continue;
        if (equals != std::string::npos) {
            words[i] = word.substr(2);
        } else if (i + 1 < words.size() && words[i + 1].rfind('-', 0) != 0) {
            words[i] = name + "=" + words[i + 1];
            words.erase(words.begin() + long(i) + 1);
        }
    }
}

}  // namespace

CommandLine read_command_line(std::vector<std::string> words) {
    CLI::App app{"hinge: collapse of framed structures under impact, scripted in Lua 5.4", "hinge"};
    app.set_version_flag("--version", version_text, "Print version, build and libraries, and exit");
    app.require_subcommand(1);
    CommandLine line;
    declare_verbs(app, line.request);
    for (const CLI::App* verb : app.get_subcommands([](CLI::App*) { return true; }))
        line.verbs.push_back(verb->get_name());
    const auto is_verb = [&](const std::string& word) {
        return std::find(line.verbs.begin(), line.verbs.end(), word) != line.verbs.end();
    };

    if (!words.empty() && words[0] == "help") {  // hinge help VERB is hinge VERB --help
        words.erase(words.begin());
        if (!words.empty() && words[0] == "accuracy")
            return std::fputs(help_on_accuracy, stdout), line.status = 0, line;
        if (!words.empty() && !is_verb(words[0])) return line.unknown_verb = words[0], line;
        words.resize(std::min<std::size_t>(words.size(), 1));
        words.emplace_back("--help");
    }
    if (!words.empty() && (words[0] == "-e" || words[0] == "-i")) words[0] = words[0] == "-e" ? "do" : "prompt";
    line.named = !words.empty() && (words[0][0] == '-' || is_verb(words[0]));
    if (!words.empty() && (!line.named || words[0] == "--sandbox" || words[0].rfind("--live", 0) == 0))
        words.insert(words.begin(), "run");  // hinge SCRIPT is hinge run SCRIPT
    std::replace(words.begin(), words.end(), std::string("--live"),
                 std::string("--live=0"));  // the next word is no port
    if (!words.empty() && is_verb(words[0])) take_parameters(*app.get_subcommand(words[0]), words);
    std::reverse(words.begin(), words.end());  // CLI11 takes them from the back
    try {
        app.parse(words);
    } catch (const CLI::ParseError& e) { return line.status = app.exit(e) == 0 ? 0 : 2, line; }
    line.request.verb = app.get_subcommands().front()->get_name();
    if (line.request.verb == "completion" && line.request.code != "names")
        line.completion = completion_script(app, line.request.code);
    return line;
}

}  // namespace hinge

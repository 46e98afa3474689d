// Output files of a script: summary.json and others, and their folder.
#include <algorithm>
#include <filesystem>

#include "core/files.h"
#include "core/text.h"
#include "advice/chain.h"
#include "advice/check.h"
#include "record/events.h"
#include "record/folder_lock.h"
#include "record/folders.h"
#include "script/files/quoting.h"
#include "record/element_events.h"
#include "record/summary.h"
#include "run/dynamics.h"

namespace hinge::script {

/// Makes the folder of a file that is to be written. A script that is not trusted stays inside its output folder,
/// whatever links are there. Names go into other files and to other programs: none has a line break in it.
void prepare_folder(const Context& c, const std::string& file) {
    namespace fs = std::filesystem;
    if (const auto at =
            std::find_if(file.begin(), file.end(), [](unsigned char letter) { return letter < ' ' || letter == 127; });
        at != file.end())
        throw InputError("the file name '" + std::string(file.begin(), at) + "...' goes on with the character number " +
                         std::to_string(int(*at)) + "; it must not have line breaks or other control characters");
    const fs::path folder = fs::path(file).parent_path();
    if (c.mode.sandbox) {
        const fs::path own = fs::weakly_canonical(fs::absolute(c.output.folder)),
                       there = fs::weakly_canonical(fs::absolute(folder.empty() ? "." : folder));
        if (std::mismatch(own.begin(), own.end(), there.begin(), there.end()).first != own.end() ||
            fs::is_symlink(file))
            throw InputError("'" + file + "' is outside the output folder " + c.output.folder +
                             "; a script in the sandbox writes nowhere else");
    }
    refuse_removed(file);
    if (folder.empty()) return;
    make_folder(folder.string());
    const fs::path within = fs::path(c.output.folder).lexically_normal(), here = folder.lexically_normal();
    if (!c.output.folder.empty() &&
        std::mismatch(within.begin(), within.end(), here.begin(), here.end()).first == within.end())
        take_lock(c.output.folder);
}

namespace {

/// core.plan(check): from now on runs are described, not stepped, and nothing is written; `check`: what they work on is
/// looked over.
int plan(lua_State* L) {
    context(L)->mode.planning = true;
    context(L)->mode.checking = lua_toboolean(L, 1);
    return 0;
}

/// core.time_product(run, repeats): the shortest time of a product of its operator with a vector, s
int time_product(lua_State* L) {
    const auto* d = dynamic_cast<const Dynamics*>(run_argument(L, 1, "time_product: the run")->run.get());
    if (!d) throw InputError("time_product: the run is static; only a dynamic one has a yardstick");
    lua_pushnumber(L, d->time_product(int(luaL_checkinteger(L, 2))));
    return 1;
}

/// core.runs_made()
int runs_made(lua_State* L) {
    lua_pushinteger(L, context(L)->runs.made);
    return 1;
}

/// core.planning()
int planning(lua_State* L) {
    lua_pushboolean(L, context(L)->mode.planning);
    return 1;
}

constexpr int most_failed = 10;  ///< lines about runs that failed before the last one

/// Verdict of the script, and why.
struct Outcome {
    std::string verdict = "completed", reason, cause;
};

/// That of the last run, or of the one before it that failed without the script having asked for its verdict.
Outcome outcome_of_runs(const Context& c) {
    if (!c.runs.last) return {};
    const RunRecord& r = *c.runs.last;
    const bool running = r.run->verdict() == Verdict::running;
    Outcome out{running ? "stopped" : name(verdict_of(r)),
                running ? "the script stopped before the last step" : reason_of(r), cause_of(r)};
    if (is_weak(r)) out = {"failed", reason_of(r), "from_failed_run"};
    if (r.run->failure()) out.cause = cause_of(r);
    if (const std::string other = unasked_failure(c); out.verdict != "failed" && !other.empty())
        out = {"failed", other, unasked_cause(c)};
    return out;
}

/// A script some of whose files could not be written has failed.
void count_lost_files(const Context& c, Outcome& out) {
    const auto& lost = c.output.lost;
    if (lost.empty()) return;
    const std::string missing =
        lost.front() + (lost.size() > 1 ? "; and " + std::to_string(lost.size() - 1) + " more" : "");
    out = {"failed", (out.verdict == "failed" ? out.reason + "; " : "") + "not all was written: " + missing,
           out.cause.empty() ? "not_written" : out.cause};
}

/// Lists the runs that failed before the last one, whose failure is the verdict and is told by itself.
void list_failed_runs(const Context& c, Json& j) {
    int told = 0;
    for (const auto& [number, text, cause] : c.runs.failed) {
        if (c.runs.last && number == c.runs.last->number) continue;
        j["failed_runs"].push_back(text);
        if (++told <= most_failed) std::fprintf(stderr, "hinge: %s\n", text.c_str());
    }
    if (told > most_failed)
        std::fprintf(stderr, "hinge: %d more runs failed; summary.json names them all\n", told - most_failed);
}

/// Warns of a script that made runs and never stepped one.
void warn_of_idle_runs(const Context& c, Json& j) {
    const int idle = c.runs.made - c.runs.begun;
    if (idle <= 0 || c.runs.begun > 0) return;
    const std::string text = count_text(idle, "run") + " made, and none has taken a step";
    j["warnings"].push_back(text);
    if (c.messages.warns)
        std::fprintf(stderr, "warning: %s; call run:finish(), or step: for step in run:steps() do ... end\n",
                     text.c_str());
}

/// core.write_summary{ results =, parameters =, case =, script =, notes =, whole = }: summary.json of the last run,
/// with the verdict and reason of `whole` where the script says how all its runs went. Returns verdict, reason.
int write_summary(lua_State* L) {
    const auto c = context(L);
    const auto field = [&](const char* name) {
        lua_getfield(L, 1, name);
        Json v = to_json(L, -1, 0);
        lua_pop(L, 1);
        return v;
    };
    Json j;
    if (c->runs.last) tell_findings(*c, *c->runs.last);
    Outcome out = outcome_of_runs(*c);
    if (const Json whole = field("whole"); !whole.is_null())
        out = {whole.value("verdict", out.verdict), whole.value("reason", ""), ""};
    count_lost_files(*c, out);
    if (!c->output.lost.empty()) j["lost"] = c->output.lost;
    j["verdict"] = out.verdict;
    if (!out.reason.empty()) j["reason"] = out.reason;
    if (out.verdict == "failed" && !out.cause.empty()) j["cause"] = out.cause;
    for (const char* name : {"script", "case", "parameters"})
        if (Json v = field(name); !v.is_null()) j[name] = v;
    j["hinge"] = HINGE_VERSION;
    if (const auto& r = c->runs.last) {
        describe_run(j, *r);
        j["state_hash"] = hex_text(hash(r->run->state()));
    }
    Json results = field("results");
    j["results"] = results.is_null() ? Json::object() : results;
    if (Json notes = field("notes"); !notes.is_null() && !notes.empty()) j["notes"] = notes;
    if (!c->messages.warned.empty()) j["warnings"] = c->messages.warned;
    list_failed_runs(*c, j);
    warn_of_idle_runs(*c, j);
    if (!c->output.folder.empty()) {
        take_folder(*c);
        if (c->runs.last) leave_happenings(*c, *c->runs.last);
        write_whole(c->output.folder + "/summary.json", j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    }
    write_event(*c, "summary", {{"folder", c->output.folder}, {"summary", j}});
    lua_pushstring(L, out.verdict.c_str());
    lua_pushstring(L, out.reason.c_str());
    return 2;
}

/// core.write_text(path, text), core.write_json(path, value): whole files; core.append(path, text).
int write_text(lua_State* L) {
    const char *file = luaL_checkstring(L, 1),
               *text = luaL_checkstring(L, 2);  // these raise: nothing may be pending yet
    prepare_folder(*context(L), file);
    write_whole(file, text);
    return 0;
}

/// core.read_text(path): all of a file; or nil and why not.
int read_text(lua_State* L) {
    const char* file = luaL_checkstring(L, 1);
    try {
        const std::string text = read_whole(file);
        lua_pushlstring(L, text.data(), text.size());
        return 1;
    } catch (const OutsideError& e) { return lua_pushnil(L), lua_pushstring(L, e.what()), 2; }
}

/// core.leads_out(folder, path): whether a link on the way to the file leads out of the folder; then where to.
int leads_out(lua_State* L) {
    namespace fs = std::filesystem;
    const fs::path folder = luaL_checkstring(L, 1), file = luaL_checkstring(L, 2);
    std::error_code error;
    const fs::path inside = fs::weakly_canonical(folder, error), to = fs::weakly_canonical(file.parent_path(), error);
    const auto end = std::mismatch(inside.begin(), inside.end(), to.begin(), to.end()).first;
    if (end == inside.end()) return lua_pushnil(L), 1;
    return lua_pushstring(L, to.c_str()), 1;
}

int write_json(lua_State* L) {
    const char* file = luaL_checkstring(L, 1);
    prepare_folder(*context(L), file);
    write_whole(file, to_json(L, 2, 0).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    return 0;
}

/// core.event(kind, fields): a line of hinge run --json. Returns whether somebody listens.
int event(lua_State* L) {
    const char* kind = luaL_checkstring(L, 1);
    const auto c = context(L);
    write_event(*c, kind, to_json(L, 2));
    return lua_pushboolean(L, c->messages.events != nullptr), 1;
}

int append_text(lua_State* L) {
    const char *file = luaL_checkstring(L, 1), *text = luaL_checkstring(L, 2);
    prepare_folder(*context(L), file);
    append(file, text);
    return 0;
}

/// core.own_output(folder, owner, given): what this program's run writes goes there, or beside it where the folder is
/// not given by the user and holds a run of something else; `owner`: script, case, parameters, for run.json. Returns
/// the folder.
int own_output(lua_State* L) {
    const char* folder = luaL_checkstring(L, 1);  // this raises: nothing may be pending yet
    const auto c = context(L);
    c->output.owner = to_json(L, 2).dump(-1, ' ', false, Json::error_handler_t::replace);
    c->output.folder = lua_toboolean(L, 3) ? folder : free_folder(folder, c->output.owner);
    return lua_pushstring(L, c->output.folder.c_str()), 1;
}

/// core.lock(folder, shared): makes the folder, which this process alone writes to from now on; shared: beside other
/// tasks of a study, each to cases of its own.
int lock(lua_State* L) {
    const char* folder = luaL_checkstring(L, 1);
    make_folder(folder);
    take_lock(folder, lua_toboolean(L, 2) ? Share::with_tasks : Share::alone);
    return 0;
}

/// core.unlock(folder)
int unlock(lua_State* L) {
    leave_lock(luaL_checkstring(L, 1));
    return 0;
}

/// core.refuse_locked(folder): an error where another process writes there.
int refuse_taken(lua_State* L) {
    refuse_locked(luaL_checkstring(L, 1));
    return 0;
}

/// core.lose(text): what the script asked for and could not be written, and why; the job has failed.
int lose(lua_State* L) {
    context(L)->output.lost.emplace_back(luaL_checkstring(L, 1));
    return 0;
}

/// core.whole_path(path): from the root, without links.
int whole_path(lua_State* L) {
    const char* path = luaL_checkstring(L, 1);
    std::error_code none;
    const auto whole = std::filesystem::weakly_canonical(std::filesystem::absolute(path, none), none);
    return lua_pushstring(L, none ? path : whole.c_str()), 1;
}

/// core.file_size(path): bytes; nothing where there is no such thing.
int file_size(lua_State* L) {
    const std::filesystem::path path = luaL_checkstring(L, 1);
    std::error_code none;
    if (!std::filesystem::exists(path, none)) return 0;
    const bool regular = std::filesystem::is_regular_file(path, none);
    return lua_pushnumber(L, regular ? double(std::filesystem::file_size(path, none)) : 0), 1;
}

/// core.csv_text(text, plain): a field of a CSV file; plain: without quotes where none are needed.
int csv_field(lua_State* L) {
    std::size_t n = 0;
    const char* text = luaL_checklstring(L, 1, &n);
    const auto field = csv_text({text, n}, lua_toboolean(L, 2) ? CsvQuotes::where_needed : CsvQuotes::always);
    return lua_pushlstring(L, field.data(), field.size()), 1;
}

/// core.shell_text(text): one word of a shell.
int shell_word(lua_State* L) {
    const std::string word = shell_text(luaL_checkstring(L, 1));
    return lua_pushlstring(L, word.data(), word.size()), 1;
}

int out_dir(lua_State* L) {
    const std::string& dir = context(L)->output.folder;
    lua_pushstring(L, dir.empty() ? "." : dir.c_str());
    return 1;
}

}  // namespace

void open_output(lua_State* L, int module) {
    static const luaL_Reg functions[] = {{"plan", guarded<plan>},
                                         {"planning", guarded<planning>},
                                         {"runs_made", guarded<runs_made>},
                                         {"time_product", guarded<time_product>},
                                         {"write_text", guarded<write_text>},
                                         {"read_text", guarded<read_text>},
                                         {"leads_out", guarded<leads_out>},
                                         {"write_json", guarded<write_json>},
                                         {"append", guarded<append_text>},
                                         {"event", guarded<event>},
                                         {"write_summary", guarded<write_summary>},
                                         {"out_dir", guarded<out_dir>},
                                         {"own_output", guarded<own_output>},
                                         {"lock", guarded<lock>},
                                         {"unlock", guarded<unlock>},
                                         {"refuse_locked", guarded<refuse_taken>},
                                         {"lose", guarded<lose>},
                                         {"whole_path", guarded<whole_path>},
                                         {"file_size", guarded<file_size>},
                                         {"csv_text", guarded<csv_field>},
                                         {"shell_text", guarded<shell_word>},
                                         {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script

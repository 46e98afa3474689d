// Output files of a script: summary.json and others, and their folder.
#include <algorithm>
#include <filesystem>

#include "core/files.h"
#include "core/text.h"
#include "record/chain.h"
#include "record/events.h"
#include "record/folder_lock.h"
#include "record/folders.h"
#include "core/quoting.h"
#include "record/element_events.h"
#include "record/summary.h"
#include "run/dynamics.h"
#include "script/bind/modules.h"
#include "script/bind/run_box.h"
#include "script/bind/lua_json.h"

namespace hinge::script {

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
    const Dynamics* d = run_argument(L, 1, "time_product: the run")->run->dynamics();
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

/// core.write_summary{ results =, parameters =, case =, script =, notes =, whole = }: summary.json of the last run,
/// with the verdict and reason of `whole` where the script says how all its runs went. Returns verdict, reason.
int write_summary(lua_State* L) {
    const auto field = [&](const char* name) {
        lua_getfield(L, 1, name);
        Json v = to_json(L, -1, 0);
        lua_pop(L, 1);
        return v;
    };
    OwnSummary own;
    for (const char* name : {"script", "case", "parameters"})
        if (Json v = field(name); !v.is_null()) own.head[name] = v;
    own.whole = field("whole"), own.results = field("results"), own.notes = field("notes");
    const Outcome out = write_summary(*context(L), own);
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
    write_whole(file, whole_text(to_json(L, 2, 0)));
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
    c->output.owner = line_text(to_json(L, 2));
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

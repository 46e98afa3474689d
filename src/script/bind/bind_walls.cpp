// Walls of the kernel around the script that runs in the sandbox.
#include <cstdio>
#include <filesystem>

#include "core/files.h"
#include "script/bind/drawing.h"
#include "record/folder_lock.h"
#include "record/folders.h"
#include "core/walls.h"
#include "script/bind/modules.h"
#include "script/lua/context.h"
#include "record/events.h"

namespace hinge::script {
namespace {

/// What a script's process still reads: hinge's own library and the script, beside the system's files.
std::vector<std::string> files_to_read(const ScriptContext& c, const std::string& script) {
    std::vector<std::string> files = system_files();
    files.insert(files.begin(), {c.library, script});
    return files;
}

/// core.raise_walls(script, folder): from now on this process reads the script and hinge's own files alone, writes
/// into that folder (nil: nowhere), and starts no program; another process draws. To be called before anything of the
/// script has run. Where the kernel lacks a wall a line on stderr says so.
int raise_walls(lua_State* L) {
    const auto c = context(L);
    const char *script = lua_tostring(L, 1), *folder = lua_tostring(L, 2);
    c->mode.sandbox = true;  // in the process that draws, too
    Reach reach = {files_to_read(*c, script ? script : ""), {"/dev/null"}, {}};
    if (folder) {
        make_folder(folder);
        take_lock(folder);  // before the other process starts, which would find it taken
        reach.write.emplace_back(folder);
        start_drawer(L);
    }
    KernelWalls stand = kernel_walls();
    if (stand.landlock > 0 && !restrict_files(make_rules(reach))) stand.landlock = 0;
    if (stand.seccomp && !refuse_calls()) stand.seccomp = false;
    const std::string missing = missing_walls(stand);
    if (missing.empty()) return 0;
    std::fprintf(stderr, "%s\n", missing.c_str());
    write_event(*c, "warning", {{"text", missing}});
    return 0;
}

/// core.draw_packed(path, plot): has the process that draws make the plot, which hinge.plot.data has packed.
int draw_packed(lua_State* L) {
    std::size_t n = 0;
    const char *path = luaL_checkstring(L, 1), *plot = luaL_checklstring(L, 2, &n);  // these raise: nothing is pending
    DrawingOrder order;
    order.what = DrawingOrder::What::plot;
    order.path = path;
    order.plot.assign(plot, n);
    draw(L, order);
    return 0;
}

int is_drawn_elsewhere(lua_State* L) { return lua_pushboolean(L, drawn_elsewhere()), 1; }

}  // namespace

void open_walls(lua_State* L, int module) {
    static const luaL_Reg functions[] = {{"raise_walls", guarded<raise_walls>},
                                         {"draw_packed", guarded<draw_packed>},
                                         {"drawn_elsewhere", guarded<is_drawn_elsewhere>},
                                         {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script

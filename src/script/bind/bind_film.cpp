// System functions for hinge render: a display and a number that several processes share, folders, and GIF.
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "core/files.h"
#include "output/film.h"
#include "script/lua/picture_module.h"
#include "script/bind/modules.h"

namespace hinge::script {
namespace {

/// A number that processes share that were started after it was made.
struct SharedNumber {
    static constexpr const char* lua_name = "hinge.shared_number";
    std::atomic<long>* value;
};

/// number:next(): one more than before, in any of the processes; the first is 1.
int next_frame(lua_State* L) {
    const SharedNumber* n = find<SharedNumber>(L, 1);
    if (!n) throw InputError("next: takes a shared number, got " + show(L, 1));
    return lua_pushinteger(L, ++*n->value), 1;
}

/// number:so_far(): what next gave last; 0 at first.
int so_far(lua_State* L) {
    const SharedNumber* n = find<SharedNumber>(L, 1);
    if (!n) throw InputError("so_far: takes a shared number, got " + show(L, 1));
    return lua_pushinteger(L, *n->value), 1;
}

int forget(lua_State* L) {
    if (const SharedNumber* n = find<SharedNumber>(L, 1)) ::munmap(n->value, sizeof *n->value);
    return 0;
}

/// core.shared_number(): see above.
int shared_number(lua_State* L) {
    void* room = ::mmap(nullptr, sizeof(std::atomic<long>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) throw OutsideError("not enough memory for a number that processes share");
    push<SharedNumber>(L, new (room) std::atomic<long>(0));
    return 1;
}

/// A file without a disk, for what processes tell: a full disk is one of the things that they have to tell of.
struct MemoryFile {
    static constexpr const char* lua_name = "hinge.memory_file";
    int descriptor;
};

/// file:path(): a name under which this process and those that it starts can open it.
int path(lua_State* L) {
    const MemoryFile* file = find<MemoryFile>(L, 1);
    if (!file) throw InputError("path: takes a memory file, got " + show(L, 1));
    const std::string name = "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(file->descriptor);
    return lua_pushlstring(L, name.data(), name.size()), 1;
}

int close_file(lua_State* L) {
    if (const MemoryFile* file = find<MemoryFile>(L, 1)) ::close(file->descriptor);
    return 0;
}

/// core.memory_file(): see above; it is gone with its last reference.
int memory_file(lua_State* L) {
    const int descriptor = ::memfd_create("hinge", MFD_CLOEXEC);
    if (descriptor < 0) throw OutsideError("no file descriptors left; raise the limit (ulimit -n)");
    push<MemoryFile>(L, descriptor);
    return 1;
}

/// core.share_display(threads): the processes that are started from now on draw on one display, which is there, each
/// with so many threads.
int share_display(lua_State* L) {
    const std::string threads = std::to_string(luaL_checkinteger(L, 1));
    char error[512] = "";
    must_work(picture_function<hinge_share_display>(*context(L), "hinge_share_display")(error, sizeof error), error);
    ::setenv("LP_NUM_THREADS", threads.c_str(), 0);  // of Mesa's software renderer
    return 0;
}

/// core.write_gif(path, pictures, hundredths, number): PNG files joined into a GIF, each for so many 1/100 s; the
/// shared number goes on by two for each.
int write_gif(lua_State* L) {
    const char* path = luaL_checkstring(L, 1);
    luaL_checktype(L, 2, LUA_TTABLE);
    luaL_checktype(L, 3, LUA_TTABLE);
    const SharedNumber* number = find<SharedNumber>(L, 4);
    if (!number) throw InputError("write_gif: takes a shared number, got " + show(L, 4));
    std::vector<std::string> files;
    std::vector<int> hundredths;
    for (lua_Integer i = 1, n = lua_Integer(lua_rawlen(L, 2)); i <= n; ++i) {
        lua_rawgeti(L, 2, i), lua_rawgeti(L, 3, i);
        files.emplace_back(lua_tostring(L, -2) ? lua_tostring(L, -2) : "");
        hundredths.push_back(int(lua_tointeger(L, -1)));
        lua_pop(L, 2);
    }
    std::vector<const char*> pictures;
    for (const std::string& file : files) pictures.push_back(file.c_str());
    char error[512] = "";
    const auto tick = [](void* with) { ++*static_cast<std::atomic<long>*>(with); };
    must_work(
        picture_function<hinge_write_gif>(*context(L), "hinge_write_gif")(
            path, int(pictures.size()), pictures.data(), hundredths.data(), tick, number->value, error, sizeof error),
        error, path);
    return 0;
}

/// core.make_folder(path), with those above it; core.remove_folder(path), with all in it.
int make_folder_for_script(lua_State* L) {
    const std::string path = luaL_checkstring(L, 1);
    hinge::make_folder(path);
    return 0;
}
int remove_folder(lua_State* L) {
    std::error_code ignored;
    std::filesystem::remove_all(luaL_checkstring(L, 1), ignored);
    return 0;
}

/// core.rename(from, to): both in one folder's file system; replaces a file of that name.
int rename(lua_State* L) {
    const char *from = luaL_checkstring(L, 1), *to = luaL_checkstring(L, 2);
    std::error_code error;
    std::filesystem::rename(from, to, error);
    if (error) throw WriteError(to, error.message());
    return 0;
}

/// core.process(): this process's number. core.signal(): the signal that came, or nil.
int process(lua_State* L) { return lua_pushinteger(L, ::getpid()), 1; }
int signal(lua_State* L) {
    if (const int came = context(L)->signals.interrupted) lua_pushinteger(L, came);
    else lua_pushnil(L);
    return 1;
}

}  // namespace

void open_film(lua_State* L, int module) {
    const auto type = [&](const char* name, lua_CFunction gone, const luaL_Reg* methods) {
        luaL_newmetatable(L, name);
        lua_pushcfunction(L, gone);
        lua_setfield(L, -2, "__gc");
        lua_createtable(L, 0, 2);
        luaL_setfuncs(L, methods, 0);
        lua_setfield(L, -2, "__index");
        lua_pop(L, 1);
    };
    static const luaL_Reg of_number[] = {
        {"next", guarded<next_frame>}, {"so_far", guarded<so_far>}, {nullptr, nullptr}};
    static const luaL_Reg of_file[] = {{"path", guarded<path>}, {nullptr, nullptr}};
    type(SharedNumber::lua_name, forget, of_number);
    type(MemoryFile::lua_name, close_file, of_file);
    static const luaL_Reg functions[] = {{"shared_number", guarded<shared_number>},
                                         {"memory_file", guarded<memory_file>},
                                         {"share_display", guarded<share_display>},
                                         {"write_gif", guarded<write_gif>},
                                         {"make_folder", guarded<make_folder_for_script>},
                                         {"remove_folder", guarded<remove_folder>},
                                         {"rename", guarded<rename>},
                                         {"process", guarded<process>},
                                         {"signal", guarded<signal>},
                                         {nullptr, nullptr}};
    lua_pushvalue(L, module);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace hinge::script

#include "script/lua/installed_files.h"

#include <dlfcn.h>
#include <filesystem>
#include <link.h>

namespace hinge::script {
namespace {

namespace fs = std::filesystem;

/// The file of the program or module that this code is in. Of a program dladdr knows only how it was called, which may
/// be a name found on PATH; the kernel knows the file, symbolic links resolved.
fs::path own_file() {
    std::error_code none;
    Dl_info info = {};
    link_map* map = nullptr;
    void* here = reinterpret_cast<void*>(&library_folder);
    if (!dladdr1(here, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP)) return {};
    if (!map || !map->l_name || !*map->l_name) return fs::read_symlink("/proc/self/exe", none);
    return fs::canonical(map->l_name, none);
}

/// Found once: a path that the module was loaded by may be relative, and the working folder may change.
const fs::path& own_folder() {
    static const fs::path folder = [] {
        const fs::path file = own_file();
        return file.empty() ? fs::path(".") : file.parent_path();
    }();
    return folder;
}

bool in_build_folder() { return fs::exists(own_folder() / "CMakeCache.txt"); }

}  // namespace

std::string library_folder() {
    if (in_build_folder()) return HINGE_LUA_FOLDER;
    // seen from bin, lib/lua/5.4 and lib/x86_64-linux-gnu/lua/5.4; and both of the former as a rock
    for (const char* place : {"../share/hinge/lua", "../../../share/hinge/lua", "../../../../share/hinge/lua",
                              "../share/lua/5.4", "../../../share/lua/5.4"})
        if (fs::exists(own_folder() / place / "hinge/init.lua")) return fs::canonical(own_folder() / place).string();
    return HINGE_LUA_FOLDER;
}

std::string picture_module() {
    const fs::path beside = own_folder() / "libhinge_output.so";
    if (in_build_folder() || fs::exists(beside)) return beside.string();
    // seen from bin, lib/lua/5.4, lib/x86_64-linux-gnu/lua/5.4 and lib64/lua/5.4
    for (const char* place : {"../lib/hinge", "../lib", "../../hinge", "../../../hinge", "../../../lib/hinge"})
        if (const auto file = own_folder() / place / "libhinge_output.so"; fs::exists(file))
            return fs::canonical(file).string();
    return beside.string();
}

}  // namespace hinge::script

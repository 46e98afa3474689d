#include "new_project.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "script/lua/installed_files.h"
#include "core/quoting.h"

namespace hinge {
namespace {

namespace fs = std::filesystem;

void replace(std::string& text, const std::string& word, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += by.size())
        text.replace(at, word.size(), by);
}

/// What the project's editor is told: Lua 5.4, and where hinge's types are declared.
std::string editor_settings(const fs::path& library) {
    nlohmann::ordered_json settings;
    settings["$schema"] = "https://raw.githubusercontent.com/LuaLS/vscode-lua/master/setting/schema.json";
    settings["runtime.version"] = "Lua 5.4";
    settings["workspace.library"] = {(library / "hinge.d.lua").string(), (library / "words").string()};
    settings["workspace.checkThirdParty"] = false;
    return settings.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

bool write(const fs::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) std::cerr << "hinge: cannot write " << path.string() << ": " << std::strerror(errno) << "\n";
    return bool(file);
}

}  // namespace

int new_project(const std::string& folder) {
    std::error_code problem;
    const fs::path target = folder, library = fs::path(script::library_folder()) / "hinge";
    if (fs::exists(target, problem) && !(fs::is_directory(target, problem) && fs::is_empty(target, problem)))
        return std::cerr << "hinge: there is a " << folder << " already; nothing was written\n", 2;
    fs::create_directories(target, problem);
    if (problem) return std::cerr << "hinge: cannot make " << folder << ": " << problem.message() << "\n", 1;

    const std::string name = plain_name(fs::canonical(target, problem).filename().string());
    for (const auto& entry : fs::directory_iterator(library / "program/template", problem)) {
        std::ostringstream text;
        text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
        std::string content = text.str();
        replace(content, "PROJECT", name);
        if (!write(target / entry.path().filename(), content)) return 1;
    }
    if (problem) return std::cerr << "hinge: no template in " << library.string() << "\n", 1;
    if (!write(target / ".gitignore", "/out/\n") || !write(target / ".luarc.json", editor_settings(library))) return 1;
    std::cout << "written to " << folder << ": main.lua, README.md, .luarc.json, .gitignore\nnext: cd "
              << shell_text(folder) << " && hinge run main.lua\n";
    return 0;
}

}  // namespace hinge

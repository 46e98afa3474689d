#include "record/folders.h"

#include <sys/stat.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>

#include "core/files.h"
#include "core/text.h"
#include "run/checkpoint.h"
#include "record/events.h"
#include "record/folder_lock.h"

namespace hinge {
namespace {

namespace fs = std::filesystem;

/// The JSON object in a file; null where there is none.
Json read_json(const std::string& path) {
    if (!fs::is_regular_file(path)) return nullptr;
    Json j = Json::parse(read_whole(path), nullptr, false);
    return j.is_object() ? j : Json();
}

/// Whose the folder is, without the version that wrote it; null where nobody says.
Json owner_of(const std::string& folder) {
    Json j = read_json(folder + "/run.json");
    if (j.is_object()) j.erase("hinge");
    return j;
}

std::string text_of(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return number_text(value.get<double>(), 10);
    if (!value.is_array()) return value.dump();
    std::string list;
    for (const Json& item : value) list += (list.empty() ? "{ " : ", ") + text_of(item);
    return list.empty() ? "{}" : list + " }";
}

std::string text_of_parameters(const Json& list) {
    std::string text;
    for (const auto& [name, value] : list.items()) text += (text.empty() ? "" : ", ") + name + " = " + text_of(value);
    return text;
}

/// Its path from here.
std::string script_of(const Json& owner) {
    const std::string path = owner.value("script", "?");
    std::error_code none;
    const auto near = fs::proximate(path, none);
    return none || near.string().starts_with("../..") ? path : near.string();
}

/// "frame.lua, case II, speed = 100"
std::string whose(const Json& owner) {
    std::string text = script_of(owner);
    if (owner.contains("case")) text += ", case " + text_of(owner["case"]);
    const std::string changed = owner.contains("changed") ? text_of_parameters(owner["changed"]) : "";
    return text + ", " + (changed.empty() ? "default parameters" : changed);
}

std::string written_at(const std::string& file) {
    struct stat info = {};
    if (::stat(file.c_str(), &info) != 0) return "?";
    char text[40] = "";
    std::tm local = {};
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", ::localtime_r(&info.st_mtime, &local));
    return text;
}

/// The names of the checkpoints in a folder, "" for none.
std::string checkpoints_in(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (const fs::path& file = entry.path(); file.extension() != ".before" && entry.is_regular_file(none)) {
            char bytes[8] = {};
            std::ifstream(file, std::ios::binary).read(bytes, sizeof bytes);
            if (begins_checkpoint({bytes, sizeof bytes})) names.push_back(file.filename().string());
        }
    std::sort(names.begin(), names.end());
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// Of a folder without a summary.
std::string how_far(const std::string& folder) {
    const std::string stopped = "the script has not ended, or stumbled", there = checkpoints_in(folder);
    if (there.empty()) return "no summary: " + stopped;
    return "no summary, but a checkpoint, " + there + ": " + stopped +
           "; the same command with --resume goes on from it";
}

bool print_folder(const std::string& folder, bool in_full) {
    const Json run = read_json(folder + "/run.json"), summary = read_json(folder + "/summary.json");
    if (run.is_null() && summary.is_null()) return false;
    const Json& known = run.is_null() ? summary : run;
    std::printf("%s\n  %s\n", folder.c_str(), run.is_null() ? script_of(known).c_str() : whose(run).c_str());
    if (in_full) {
        std::printf("  script %s\n", known.value("script", "?").c_str());
        if (known.contains("parameters") && !known["parameters"].empty())
            std::printf("  parameters %s\n", text_of_parameters(known["parameters"]).c_str());
    }
    const std::string verdict = summary.is_null() ? how_far(folder) : summary.value("verdict", "?");
    std::printf("  %s; hinge %s; %s\n", verdict.c_str(), known.value("hinge", "of unknown version").c_str(),
                written_at(folder + (summary.is_null() ? "/run.json" : "/summary.json")).c_str());
    if (in_full && summary.is_object() && summary.contains("reason"))
        std::printf("  %s\n", text_of(summary["reason"]).c_str());
    return true;
}

}  // namespace

std::string free_folder(const std::string& wanted, const std::string& owner) {
    const Json mine = Json::parse(owner, nullptr, false);
    for (int n = 1;; ++n) {
        std::string folder = n == 1 ? wanted : wanted + "-" + std::to_string(n);
        const Json theirs = owner_of(folder);
        if (theirs.is_null() || theirs == mine) return folder;
    }
}

void prepare_folder(const Context& c, const std::string& file) {
    // names go into other files and to other programs
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

void take_folder(Context& c) {
    if (c.output.folder.empty()) return;
    refuse_removed(c.output.folder);
    make_folder(c.output.folder);
    take_lock(c.output.folder);
    if (c.output.owner.empty() || c.output.owner_written) return;
    c.output.owner_written = true;
    Json mine = Json::parse(c.output.owner);
    if (const Json before = owner_of(c.output.folder); !before.is_null() && before != mine) {
        const std::string becomes = c.mode.resume ? "; what has a checkpoint there goes on as the run of " + whose(mine)
                                                  : ", which is replaced",
                          text = c.output.folder + " held the run of " + whose(before) + becomes;
        if (c.messages.progress) std::fprintf(stderr, "%s\n", text.c_str());
        write_event(c, "warning", {{"text", text}, {"advice", "give another --out"}});
    }
    mine["hinge"] = HINGE_VERSION;
    write_whole(c.output.folder + "/run.json", whole_text(mine));
}

bool print_history(const std::vector<std::string>& folders) {
    bool any = false;
    for (const std::string& folder : folders) {
        if (print_folder(folder, true)) {
            any = true;
            continue;
        }
        std::vector<std::string> inside;
        std::error_code none;
        for (const auto& entry : fs::directory_iterator(folder, none))
            if (entry.is_directory()) inside.push_back(entry.path().string());
        std::sort(inside.begin(), inside.end());
        for (const std::string& one : inside) any = print_folder(one, false) || any;
    }
    return any;
}

}  // namespace hinge

#include "version.h"

#include <filesystem>
#include <sstream>
#include <string_view>

#include "core/thread_pool.h"
#include "hinge_commit.h"
#include "script/lua/installed_files.h"

namespace hinge {
namespace {

std::string pictures() {
    const std::string_view vtk = HINGE_VTK;
    if (vtk.empty()) return "none: built without pictures (HINGE_PICTURES=OFF)";
    const std::string module = script::picture_module();
    return std::string(vtk) + (std::filesystem::exists(module) ? ", " : ", but there is no ") + module;
}

}  // namespace

std::string version_text() {
    std::ostringstream out;
    out << "hinge " HINGE_VERSION "\n";
    const auto line = [&](const char* what, const std::string& text) {
        if (!text.empty()) out << what << text << "\n";
    };
    line("build      ", HINGE_BUILD ", " HINGE_COMPILER);
    line("processor  ", HINGE_PROCESSOR);
    line("sanitizer  ", HINGE_WATCHED);
    line("commit     ", HINGE_COMMIT);
    line("threads    ",
         std::to_string(usable_cores()) + " at most; a run takes one for each 1,000 elements, or threads = N");
    line("Lua        ", HINGE_LUA ", library in " + script::library_folder());
    line("Eigen      ", HINGE_EIGEN);
    line("VTK        ", pictures());
    std::string text = out.str();
    text.pop_back();
    return text;
}

}  // namespace hinge

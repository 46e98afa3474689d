-- For LuaRocks: `luarocks make lua/hinge-scm-1.rockspec` in the repository's folder builds the module and
-- installs it with its library.
rockspec_format = "3.0"
package = "hinge"
version = "scm-1"
source = { url = "git+file://." }
description = {
  summary = "Collapse of framed structures under impact, scripted in Lua",
  detailed = "Linear Timoshenko beams with plastic hinges, members that break and hit each other, and an energy balance. "
    .. "Needs a C++20 compiler, CMake, Eigen, nlohmann-json and CLI11.",
  license = "MIT",
}
supported_platforms = { "linux" }
dependencies = { "lua >= 5.4, < 5.5" }
build = {
  type = "cmake",
  variables = {
    CMAKE_BUILD_TYPE = "Release",
    CMAKE_INSTALL_PREFIX = "$(PREFIX)",
    HINGE_MODULE_FOLDER = "$(LIBDIR)",
    HINGE_LIBRARY_FOLDER = "$(LUADIR)",
    HINGE_PICTURES = "OFF",
    HINGE_TESTS = "OFF",
  },
  copy_directories = {},
}

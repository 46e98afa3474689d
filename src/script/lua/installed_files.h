// Paths of the Lua library and the picture module, relative to the program or module. They are searched in the build
// folder and in the folders of src/install.cmake, so an installation may be moved as a whole.
#pragma once

#include <string>

namespace hinge::script {

/// The folder that holds hinge/init.lua.
std::string library_folder();

/// The file libhinge_output.so; if there is none, its path beside the program.
std::string picture_module();

}  // namespace hinge::script

// Where the program or module lies, and from there the Lua library and the picture module. They are looked for in the
// build folder and in the folders of src/install.cmake, so an installation may be moved as a whole.
#pragma once

#include <string>

namespace hinge::script {

/// The folder that holds hinge/init.lua.
std::string library_folder();

/// The file libhinge_output.so; where there is none, the place beside the program.
std::string picture_module();

}  // namespace hinge::script

// Keeps VTK off stdout and stderr: what it complains of becomes part of our own message.
#pragma once

#include <string>

namespace hinge::output {

void silence_vtk();

/// The first complaint since the last call, in one line; empty if there was none.
std::string take_vtk_complaint();

}  // namespace hinge::output

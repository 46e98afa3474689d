// Redirects VTK's messages from stdout and stderr into our own error messages.
#pragma once

#include <string>

namespace hinge::output {

void silence_vtk();

/// The first VTK message since the last call, in one line; empty if there was none.
std::string take_vtk_complaint();

}  // namespace hinge::output

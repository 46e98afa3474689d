// Virtual X server (Xvfb) for machines without a display.
#pragma once

#include <string>

namespace hinge::output {

/// Starts Xvfb unless ours still runs, and returns its display (":7"). It ends with this process in all cases. Throws
/// OutsideError saying how to get pictures when it is not installed or does not start.
std::string virtual_display();

}  // namespace hinge::output

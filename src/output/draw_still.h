// A still as a picture.
#pragma once

#include <array>
#include <string>

#include "output/picture.h"

namespace hinge::output {

/// PNG bytes.
std::string draw_still(const Still& still, const View& view);

/// xmin, xmax, ymin, ymax, zmin, zmax of what draw_still would fit its camera to.
std::array<double, 6> frame_box(const Still& still, const View& view);

}  // namespace hinge::output

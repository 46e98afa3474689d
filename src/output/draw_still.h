// A still as a picture.
#pragma once

#include <array>
#include <string>

#include "output/picture.h"

namespace hinge::output {

/// PNG bytes.
std::string draw_still(const Still& still, const View& view);

/// PNG bytes: stills side by side, `columns` in a row, each of the first one's size.
std::string draw_strip(int count, const Still* const* stills, const View* views, int columns);

/// xmin, xmax, ymin, ymax, zmin, zmax of what draw_still would fit its camera to.
std::array<double, 6> frame_box(const Still& still, const View& view);

}  // namespace hinge::output

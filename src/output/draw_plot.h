// A line plot as a picture.
#pragma once

#include <string>

#include "output/plot.h"

namespace hinge::output {

/// PNG bytes.
std::string draw_plot(const Plot& plot, int width, int height);

}  // namespace hinge::output

// A plot as a picture.
#pragma once

#include <string>

#include "output/plot.h"

namespace hinge::output {

/// The bytes of the file at `path`: SVG where its name ends so, else PNG.
std::string draw_plot(const std::string& path, const Plot& plot, int width, int height);

}  // namespace hinge::output

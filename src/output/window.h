// The off-screen window that renders all pictures.
#pragma once

#include <span>

#include "output/png.h"

class vtkRenderer;

namespace hinge::output {

/// Throws InputError unless a picture of this size is possible.
void check_size(int width, int height);

/// Renders the layers, the first lowest.
Pixels take_pixels(int width, int height, std::span<vtkRenderer* const> layers);

}  // namespace hinge::output

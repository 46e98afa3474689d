// The one off-screen window all pictures are taken in.
#pragma once

#include <span>

#include "output/png.h"

class vtkRenderer;

namespace hinge::output {

/// Throws InputError unless a picture of this size can be taken.
void check_size(int width, int height);

/// Draws the layers, the first lowest.
Pixels take_pixels(int width, int height, std::span<vtkRenderer* const> layers);

}  // namespace hinge::output

// The one off-screen window all pictures are taken in.
#pragma once

#include <span>
#include <string>
#include <vector>

class vtkRenderer;

namespace hinge::output {

/// Throws InputError unless a picture of this size can be taken.
void check_size(int width, int height);

/// Three bytes a pixel, from the lower left corner, row by row.
struct Pixels {
    int width = 0, height = 0;
    std::vector<unsigned char> rgb;
};

/// Draws the layers, the first lowest.
Pixels take_pixels(int width, int height, std::span<vtkRenderer* const> layers);

std::string encode_png(const Pixels& pixels);

}  // namespace hinge::output

// Encodes and decodes PNG pictures.
#pragma once

#include <string>
#include <vector>

namespace hinge::output {

/// A picture of three bytes a pixel, from the lower left corner, row by row.
struct Pixels {
    int width = 0, height = 0;
    std::vector<unsigned char> rgb;
};

/// Encodes quickly: pictures of lines on white need no filter, and higher levels of zlib save little.
std::string encode_png(const Pixels& pixels);

/// Decodes a PNG. `name`: name of the file, for messages.
Pixels decode_png(const std::string& name);

}  // namespace hinge::output

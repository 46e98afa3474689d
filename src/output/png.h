// Pictures as PNG bytes, and back.
#pragma once

#include <string>
#include <vector>

namespace hinge::output {

/// Three bytes a pixel, from the lower left corner, row by row.
struct Pixels {
    int width = 0, height = 0;
    std::vector<unsigned char> rgb;
};

/// Quick: pictures of lines on white paper need no filter, and higher levels of zlib save little.
std::string encode_png(const Pixels& pixels);

/// `name` is the file's, for messages.
Pixels decode_png(const std::string& name);

}  // namespace hinge::output

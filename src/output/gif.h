// Encodes pictures as a GIF, without another program.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace hinge::output {

struct GifFrame {
    std::string file;  ///< a PNG
    int hundredths;    ///< duration, 1/100 s
};

/// Returns the bytes of a GIF that repeats for ever. All pictures have the first one's size. One palette serves all;
/// each picture after the first holds only the rectangle in which it differs. `tick` is called twice for each picture.
std::string encode_gif(const std::vector<GifFrame>& frames, const std::function<void()>& tick);

}  // namespace hinge::output

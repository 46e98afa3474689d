// What stands around the drawn structure: title, time, legend of colours and the directions of the axes.
#pragma once

#include <string>

#include "output/framing.h"
#include "output/picture.h"
#include "output/sketch.h"

namespace hinge::output {

/// Pixels kept free above and below the structure.
struct Margins {
    int top, bottom;
};

Margins caption_margins(const View& view);

/// The moment of a snapshot as pictures show it: "t = 12.5 ms", "load factor 0.62".
std::string moment_text(const Snapshot& snapshot);

/// `when`: that; `nothing`: no bar is drawn, which the picture then says.
void draw_caption(Pen& pen, const View& view, const std::string& when, const Camera& camera, bool nothing);

}  // namespace hinge::output

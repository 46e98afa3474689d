// Caption of a picture: title, time, legend of colours and directions of the axes.
#pragma once

#include <string>
#include <vector>

#include "output/diagram.h"
#include "output/framing.h"
#include "output/picture.h"
#include "output/sketch.h"

namespace hinge::output {

/// Contents of the caption.
struct CaptionInput {
    const View& view;
    const Snapshot& snapshot;
    double scale;              ///< of displacements
    const Diagram* diagram;    ///< null: none
    double dot_unit;           ///< pixels of the largest dot of a hinge; 0: none is drawn
    bool broken, nothing;      ///< a broken element is drawn; no bar is
    std::vector<char> groups;  ///< of the snapshot's groups whether one of their bars is drawn
    int words_left_out = 0;
};

/// The size of plain text, pixels; all other sizes follow from it.
double text_size(const View& view);

/// Pixels kept free above and below the structure.
struct Margins {
    int top, bottom;
};

Margins caption_margins(const CaptionInput& input);

/// Text of the time or load factor of a snapshot in pictures: "t = 12.5 ms", "load factor 0.62".
std::string moment_text(const Snapshot& snapshot);

void draw_caption(Pen& pen, const CaptionInput& input, const Camera& camera);

}  // namespace hinge::output

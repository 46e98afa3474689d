// What a film takes of the output module, beside the pictures of its frames (picture.h).
#pragma once

#include "output/picture.h"

namespace hinge::output {

/// What the pictures of a film agree on before the first is drawn; see frame_box.h.
struct FrameBox {
    std::optional<std::array<double, 6>> box;  ///< xmin, xmax, ymin, ymax, zmin, zmax in m; nothing without bars
    double scale = 1;                          ///< by which displacements are drawn
    double largest = 0;                        ///< magnitude of the diagram's largest value, N or N m; 0 without one
};

}  // namespace hinge::output

extern "C" {
/// What a picture of `snapshot` would show. Returns 0, or 1 with a message in `error` (at most `room` bytes), as all
/// do.
using hinge_frame_box = int (*)(const hinge::output::Snapshot& snapshot, const hinge::output::View& view,
                                hinge::output::FrameBox* box, char* error, int room);
/// Joins n PNG pictures of one size into a GIF that repeats for ever; each stays for so many hundredths of a second.
/// `tick` is called twice for each.
using hinge_write_gif = int (*)(const char* path, int n, const char* const* pictures, const int* hundredths,
                                void (*tick)(void* with), void* with, char* error, int room);
/// Sees to it that the processes that this one starts find a display by DISPLAY: where that does not answer, starts a
/// virtual one and sets DISPLAY. It has no OpenGL of its own afterwards, so that a fork is harmless.
using hinge_share_display = int (*)(char* error, int room);
}

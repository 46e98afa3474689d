// Functions of the output module for films, in addition to picture.h.
#pragma once

#include "output/picture.h"

namespace hinge::output {

/// Common box and scales of all pictures of a film; see frame_box.h.
struct FrameBox {
    std::optional<std::array<double, 6>> box;  ///< xmin, xmax, ymin, ymax, zmin, zmax in m; nothing without bars
    double scale = 1;                          ///< by which displacements are drawn
    double largest = 0;                        ///< magnitude of the diagram's largest value, N or N m; 0 without one
};

}  // namespace hinge::output

extern "C" {
/// Computes the frame box of a picture of `snapshot`. Returns 0, or 1 with a message in `error` (at most `room` bytes),
/// as all functions do.
using hinge_frame_box = int (*)(const hinge::output::Snapshot& snapshot, const hinge::output::View& view,
                                hinge::output::FrameBox* box, char* error, int room);
/// Joins n PNG pictures of one size into a GIF that repeats for ever; each stays for so many hundredths of a second.
/// `tick` is called twice for each.
using hinge_write_gif = int (*)(const char* path, int n, const char* const* pictures, const int* hundredths,
                                void (*tick)(void* with), void* with, char* error, int room);
/// Provides a display in DISPLAY for the processes that this one starts: if DISPLAY does not answer, starts a virtual
/// one and sets DISPLAY. No OpenGL is left open in this process, so that a fork is harmless.
using hinge_share_display = int (*)(char* error, int room);
}

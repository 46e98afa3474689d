// What a film takes of the output module, beside the pictures of its frames (picture.h).
#pragma once

#include "output/picture.h"

extern "C" {
/// What a picture of `snapshot` would show, without stray fragments: xmin, xmax, ymin, ymax, zmin, zmax in m. *empty is
/// 1 where there is nothing to show. Returns 0, or 1 with a message in `error` (at most `room` bytes), as all do.
using hinge_frame_box = int (*)(const hinge::output::Snapshot& snapshot, const hinge::output::View& view, double* box,
                                int* empty, char* error, int room);
/// Joins n PNG pictures of one size into a GIF that repeats for ever; each stays for so many hundredths of a second.
/// `tick` is called twice for each.
using hinge_write_gif = int (*)(const char* path, int n, const char* const* pictures, const int* hundredths,
                                void (*tick)(void* with), void* with, char* error, int room);
/// Sees to it that the processes that this one starts find a display by DISPLAY: where that does not answer, starts a
/// virtual one and sets DISPLAY. It has no OpenGL of its own afterwards, so that a fork is harmless.
using hinge_share_display = int (*)(char* error, int room);
}

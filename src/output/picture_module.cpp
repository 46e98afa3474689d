// Functions that the module exports: with C names, and without exceptions to the caller.
#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <mutex>
#include <new>
#include <string>

#include "core/errors.h"
#include "core/files.h"
#include "output/display.h"
#include "output/draw_snapshot.h"
#include "output/film.h"
#include "output/frame_box.h"
#include "output/gif.h"
#include "output/picture.h"
#include "output/quiet_vtk.h"
#include "output/snapshot_file.h"

#define HINGE_EXPORT __attribute__((visibility("default")))

namespace hinge::output {
namespace {

/// VTK's one window, its message sink and the display are shared: callers take turns.
std::mutex turn;

/// Where standard output is closed, our files and the display's socket would become it, and take what others print.
void hold_standard_streams() {
    for (int fd = 0; fd <= 2; ++fd)
        if (::fcntl(fd, F_GETFD) < 0 && errno == EBADF && ::open("/dev/null", O_RDWR) < 0) return;
}

void tell(const std::string& message, char* error, int room) {
    if (!error || room <= 0) return;
    const std::size_t n = std::min(message.size(), static_cast<std::size_t>(room - 1));
    std::memcpy(error, message.data(), n);
    error[n] = '\0';
}

template <class Work>
int guarded(char* error, int room, Work work) noexcept {
    try {
        const std::lock_guard lock(turn);
        hold_standard_streams();
        silence_vtk();
        take_vtk_complaint();
        work();
        return 0;
    } catch (const std::bad_alloc&) {
        tell("out of memory while writing a picture or frame; make it smaller", error, room);
    } catch (const WriteError& e) {
        tell(e.why, error, room);
        return not_written;
    } catch (const std::exception& e) { tell(e.what(), error, room); } catch (...) {
        tell("unknown failure while writing a picture or frame", error, room);
    }
    return 1;
}

std::string given(const char* path) {
    if (!path || !*path) throw InputError("the file name of a picture or frame is empty; give one");
    return path;
}

}  // namespace

// In a namespace because the global names are taken by the types of these functions.
extern "C" {

HINGE_EXPORT int hinge_write_snapshot(const char* path, const Snapshot& snapshot, char* error, int room) {
    return guarded(error, room, [&] { write_whole(given(path), encode_snapshot(snapshot)); });
}

HINGE_EXPORT int hinge_write_collection(const char* path, int n, const double* times, const char* const* files,
                                        char* error, int room) {
    return guarded(error, room, [&] { write_whole(given(path), encode_collection(n, times, files)); });
}

HINGE_EXPORT int hinge_read_snapshot(const char* path, Snapshot& snapshot, char* error, int room) {
    return guarded(error, room, [&] { snapshot = decode_snapshot(read_whole(given(path)), path); });
}

HINGE_EXPORT int hinge_render(const char* path, const Snapshot& snapshot, const View& view, char* error, int room) {
    return guarded(error, room, [&] { write_whole(given(path), draw_snapshot(snapshot, view)); });
}

HINGE_EXPORT int hinge_render_strip(const char* path, int n, const Snapshot* const* snapshots, const View* views,
                                    int columns, char* error, int room) {
    return guarded(error, room, [&] { write_whole(given(path), draw_strip(n, snapshots, views, columns)); });
}

HINGE_EXPORT int hinge_frame_box(const Snapshot& snapshot, const View& view, FrameBox* box, char* error, int room) {
    return guarded(error, room, [&] { *box = frame_box(snapshot, view); });
}

HINGE_EXPORT int hinge_write_gif(const char* path, int n, const char* const* pictures, const int* hundredths,
                                 void (*tick)(void* with), void* with, char* error, int room) {
    return guarded(error, room, [&] {
        std::vector<GifFrame> frames;
        for (int i = 0; i < n; ++i) frames.push_back({given(pictures[i]), hundredths[i]});
        write_whole(given(path), encode_gif(frames, [&] { tick(with); }));
    });
}

HINGE_EXPORT int hinge_share_display(char* error, int room) { return guarded(error, room, share_display); }
}  // extern "C"

}  // namespace hinge::output

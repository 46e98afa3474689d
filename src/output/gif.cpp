#include "output/gif.h"

#include <gif_lib.h>

#include <algorithm>
#include <future>

#include "core/errors.h"
#include "output/palette.h"
#include "output/png.h"

namespace hinge::output {
namespace {

constexpr int unchanged = 255;  // the index of "as before"

[[noreturn]] void cannot(int error) {
    const char* why = ::GifErrorString(error);
    throw OutsideError(std::string("cannot put the GIF together: ") + (why ? why : "out of memory?"));
}

int append_bytes(GifFileType* gif, const GifByteType* bytes, int n) {
    try {
        static_cast<std::string*>(gif->UserData)->append(reinterpret_cast<const char*>(bytes), std::size_t(n));
        return n;
    } catch (...) { return 0; }  // no exception may cross giflib
}

/// Where two pictures differ: columns left to right and rows top to bottom, the ends not counted.
struct Rectangle {
    int left, top, right, bottom;
};

/// A picture as indices into the palette, from its top.
struct Indexed {
    int width, height;
    std::vector<std::uint8_t> index;
    const std::uint8_t* row(int y) const { return &index[std::size_t(y) * std::size_t(width)]; }
};

Indexed indexed(const Pixels& pixels, const Palette& palette) {
    Indexed out{pixels.width, pixels.height, {}};
    out.index.resize(std::size_t(pixels.width) * std::size_t(pixels.height));
    auto to = out.index.begin();
    for (int y = pixels.height; y-- > 0;) {
        const unsigned char* from = &pixels.rgb[3 * std::size_t(y) * std::size_t(pixels.width)];
        for (int x = 0; x < pixels.width; ++x, from += 3) *to++ = palette.of_bin[Histogram::bin(from)];
    }
    return out;
}

Rectangle difference(const Indexed& a, const Indexed& b) {
    Rectangle r{a.width, a.height, 0, 0};
    for (int y = 0; y < a.height; ++y) {
        const auto [p, q] = std::mismatch(a.row(y), a.row(y) + a.width, b.row(y));
        if (p == a.row(y) + a.width) continue;
        r.top = std::min(r.top, y), r.bottom = y + 1;
        r.left = std::min(r.left, int(p - a.row(y)));
        int last = a.width;
        while (a.row(y)[last - 1] == b.row(y)[last - 1]) --last;
        r.right = std::max(r.right, last);
    }
    return r.bottom > 0 ? r : Rectangle{0, 0, 1, 1};  // a picture of no size is none
}

class Gif {
public:
    Gif(int width, int height, const Palette& palette) {
        int error = 0;
        gif_ = ::EGifOpen(&bytes_, append_bytes, &error);
        if (!gif_) cannot(error);
        colours_ = ::GifMakeMapObject(256, nullptr);
        if (!colours_) {
            close();
            cannot(0);
        }
        for (std::size_t i = 0; i < palette.colours.size(); ++i) {
            const Rgb& c = palette.colours[i];
            colours_->Colors[i] = {c[0], c[1], c[2]};
        }
        ::EGifSetGifVersion(gif_, true);
        check(::EGifPutScreenDesc(gif_, width, height, 8, 0, colours_));
        check(::EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE));
        check(::EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0"));
        check(::EGifPutExtensionBlock(gif_, 3, "\1\0\0"));  // for ever
        check(::EGifPutExtensionTrailer(gif_));
    }
    ~Gif() { close(); }
    Gif(const Gif&) = delete;
    Gif& operator=(const Gif&) = delete;

    /// `before`: what is seen until then; none for the first picture.
    void add(const Indexed& now, const Indexed* before, int hundredths) {
        GraphicsControlBlock control = {};
        control.DisposalMode = DISPOSE_DO_NOT;
        control.DelayTime = std::clamp(hundredths, 1, 65535);
        control.TransparentColor = before ? unchanged : NO_TRANSPARENT_COLOR;
        GifByteType extension[4];
        const std::size_t size = ::EGifGCBToExtension(&control, extension);
        check(::EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, int(size), extension));
        const Rectangle r = before ? difference(*before, now) : Rectangle{0, 0, now.width, now.height};
        check(::EGifPutImageDesc(gif_, r.left, r.top, r.right - r.left, r.bottom - r.top, false, nullptr));
        std::vector<GifPixelType> line(std::size_t(r.right - r.left));
        for (int y = r.top; y < r.bottom; ++y) {
            for (int x = r.left; x < r.right; ++x)
                line[std::size_t(x - r.left)] =
                    before && before->row(y)[x] == now.row(y)[x] ? unchanged : now.row(y)[x];
            check(::EGifPutLine(gif_, line.data(), int(line.size())));
        }
    }

    std::string finish() {
        int error = 0;
        const int done = ::EGifCloseFile(gif_, &error);
        gif_ = nullptr;
        if (done != GIF_OK) cannot(error);
        return std::move(bytes_);
    }

private:
    void check(int status) {
        if (status != GIF_OK) cannot(gif_->Error);
    }
    void close() {
        int error = 0;
        if (gif_) ::EGifCloseFile(gif_, &error);
        if (colours_) ::GifFreeMapObject(colours_);
        gif_ = nullptr, colours_ = nullptr;
    }

    GifFileType* gif_ = nullptr;
    ColorMapObject* colours_ = nullptr;
    std::string bytes_;
};

}  // namespace

std::string encode_gif(const std::vector<GifFrame>& frames, const std::function<void()>& tick) {
    if (frames.empty()) throw InputError("a GIF needs at least one picture");
    Histogram all;
    int width = 0, height = 0;
    for (const GifFrame& frame : frames) {
        const Pixels pixels = decode_png(frame.file);
        if (width == 0) width = pixels.width, height = pixels.height;
        if (pixels.width != width || pixels.height != height)
            throw InputError("the pictures of a GIF must have one size; " + frame.file + " has another");
        all.add(pixels.rgb);
        tick();
    }
    const Palette palette = make_palette(all);
    Gif gif(width, height, palette);
    const auto read = [&](std::size_t i) { return indexed(decode_png(frames[i].file), palette); };
    std::future<Indexed> next = std::async(std::launch::async, read, 0);
    Indexed before;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        Indexed now = next.get();
        if (i + 1 < frames.size()) next = std::async(std::launch::async, read, i + 1);
        gif.add(now, i > 0 ? &before : nullptr, frames[i].hundredths);
        before = std::move(now);
        tick();
    }
    return gif.finish();
}

}  // namespace hinge::output

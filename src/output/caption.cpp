// What stands around the drawn structure: title, time, legend of colours and the directions of the axes.
#include "output/caption.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "output/bars.h"

namespace hinge::output {
namespace {

/// The size of plain text, pixels; everything else is measured by it.
double text_size(const View& view) { return std::clamp(std::min(view.height / 44.0, view.width / 52.0), 7.0, 60.0); }

std::string time_text(double seconds) {
    char text[48];
    if (std::abs(seconds) >= 10) std::snprintf(text, sizeof text, "t = %.2f s", seconds);
    else
        std::snprintf(text, sizeof text, "t = %.*f ms", std::abs(seconds) < 1e-3 && seconds != 0 ? 3 : 1,
                      seconds * 1e3);
    return text;
}

/// What the view leaves out, so that nobody takes a part for the whole.
std::string left_out(const View& view) {
    std::vector<std::string> notes;
    if (view.above > -1e299) {
        char text[48];
        std::snprintf(text, sizeof text, "above %g m", view.above);
        notes.push_back(text);
    }
    if (view.leave_out_broken) notes.push_back("without fractured elements");
    std::string line;
    for (const std::string& note : notes) line += (line.empty() ? "" : ", ") + note;
    return line;
}

void draw_heading(Pen& pen, const View& view, const std::string& when, double em) {
    const double top = view.height - 1.25 * em;
    TextStyle left{.size = 1.3 * em, .bold = true};
    TextStyle right{.size = 1.3 * em, .across = 1};
    // A long title shrinks before it runs into the time.
    const double room = view.width - 3 * em - pen.size_of(when, right)[0] - 2 * em;
    const double wide = pen.size_of(view.title, left)[0];
    if (wide > room) left.size = std::max(0.6 * em, left.size * room / wide);
    pen.text(1.5 * em, top, view.title, left);
    pen.text(view.width - 1.5 * em, top, when, right);
    pen.text(1.5 * em, top - 1.6 * em, left_out(view), {.size = 0.9 * em, .colour = faint_ink});
}

void draw_legend(Pen& pen, const View& view, double em) {
    static const char* const labels[n_classes] = {
        "0.0\xE2\x80\x93"
        "0.2",
        "0.2\xE2\x80\x93"
        "0.4",
        "0.4\xE2\x80\x93"
        "0.6",
        "0.6\xE2\x80\x93"
        "0.8",
        "0.8\xE2\x80\x93"
        "1.0",
        "1.0 hinge",
        "fractured"};
    const int shown = view.leave_out_broken ? broken_class : n_classes;
    const double swatch = 5.2 * em, high = 0.85 * em, gap = 0.7 * em;
    // The five bands touch, as one scale; a hinge and a fracture stand apart.
    const double total = shown * swatch + (shown - hinge_class) * gap;
    const double foot = 1.15 * em;
    double x = (view.width - total) / 2;
    const double symbol = x - 0.9 * em;
    pen.text(symbol, foot + 1.15 * em, "y", {.size = 0.75 * em, .italic = true, .across = 1});
    pen.text(symbol - 0.38 * em, foot + 1.45 * em, "f", {.size = 1.15 * em, .italic = true, .across = 1});
    for (int i = 0; i < shown; ++i) {
        if (i >= hinge_class) x += gap;
        pen.box(x, foot + em, swatch, high, class_colours[static_cast<std::size_t>(i)]);
        pen.text(x + swatch / 2, foot + 0.4 * em, labels[i], {.size = 0.85 * em, .across = 0.5});
        x += swatch;
    }
}

void draw_axes(Pen& pen, const View& view, const Camera& camera, double em) {
    const double x0 = 3.6 * em, y0 = caption_margins(view).bottom + 2.6 * em, reach = 2.4 * em;
    const char* const names[3] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
        const double dx = reach * camera.right[i], dy = reach * camera.up[i];
        const double seen = std::hypot(dx, dy);
        if (seen < 0.25 * reach) continue;  // it points at the reader
        const double ex = dx / seen, ey = dy / seen, barb = 0.4 * em;
        pen.line(x0, y0, x0 + dx, y0 + dy, em / 13, faint_ink);
        for (const double turn : {0.5, -0.5})
            pen.line(x0 + dx, y0 + dy, x0 + dx - barb * (ex - turn * ey), y0 + dy - barb * (ey + turn * ex), em / 13,
                     faint_ink);
        pen.text(x0 + dx + 0.6 * em * ex, y0 + dy + 0.6 * em * ey, names[i],
                 {.size = 0.85 * em, .colour = faint_ink, .italic = true, .across = 0.5});
    }
}

}  // namespace

std::string moment_text(const Snapshot& snapshot) {
    if (!snapshot.factor) return time_text(snapshot.time);
    char text[48];
    std::snprintf(text, sizeof text, "load factor %.4g", *snapshot.factor);
    return text;
}

Margins caption_margins(const View& view) {
    const double em = text_size(view);
    const double heading = left_out(view).empty() ? 2.4 : 3.8;
    return {static_cast<int>(heading * em), static_cast<int>(3.6 * em)};
}

void draw_caption(Pen& pen, const View& view, const std::string& when, const Camera& camera, bool nothing) {
    const double em = text_size(view);
    draw_heading(pen, view, when, em);
    draw_legend(pen, view, em);
    draw_axes(pen, view, camera, em);
    if (nothing)
        pen.text(view.width / 2.0, view.height / 2.0, "no bars to show",
                 {.size = 1.2 * em, .colour = faint_ink, .across = 0.5});
}

}  // namespace hinge::output

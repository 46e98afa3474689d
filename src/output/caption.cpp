// Caption of a picture: title, time, legend of colours and directions of the axes.
#include "output/caption.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "output/hinge_marks.h"
#include "output/symbols.h"
#include "output/words.h"

namespace hinge::output {
namespace {

std::string time_text(double seconds) {
    char text[48];
    if (std::abs(seconds) >= 1)
        std::snprintf(text, sizeof text, "t = %.*f s", std::abs(seconds) >= 10 ? 2 : 3, seconds);
    else
        std::snprintf(text, sizeof text, "t = %.*f ms", std::abs(seconds) < 1e-3 && seconds != 0 ? 3 : 1,
                      seconds * 1e3);
    return text;
}

/// Remarks on parts that the picture leaves out or enlarges.
std::string remarks(const CaptionInput& input) {
    const View& view = input.view;
    std::vector<std::string> notes;
    const auto note = [&](const char* format, double value) {
        char text[96];
        std::snprintf(text, sizeof text, format, value);
        notes.push_back(text);
    };
    if (input.scale != 1) note("displacements \xC3\x97 %g", input.scale);
    if (view.ghost) notes.push_back("grey lines: at the start");
    if (const double most = largest_panel_force(input.snapshot); view.floors && most > 0)
        note("panels: tension blue, compression orange, up to %.3g kN/m", most / 1e3);
    if (view.above > -1e299) note("above %g m", view.above);
    if (view.leave_out_broken) notes.push_back("without fractured elements");
    if (view.show == Show::yield && input.snapshot.laws.size() == 1)
        notes.push_back("yield law: " + input.snapshot.laws[0]);
    std::string line;
    for (const std::string& text : notes) line += (line.empty() ? "" : ", ") + text;
    return line;
}

void draw_heading(Pen& pen, const CaptionInput& input, double em) {
    const View& view = input.view;
    const std::string when = moment_text(input.snapshot);
    const double top = view.height - 1.25 * em;
    TextStyle left{.size = 1.3 * em, .bold = true};
    TextStyle right{.size = 1.3 * em, .across = 1};
    // A long title shrinks before it runs into the time.
    const double room = view.width - 3 * em - pen.size_of(when, right)[0] - 2 * em;
    const double wide = pen.size_of(view.title, left)[0];
    if (wide > room) left.size = std::max(0.6 * em, left.size * room / wide);
    pen.text(1.5 * em, top, view.title, left);
    pen.text(view.width - 1.5 * em, top, when, right);
    pen.text(1.5 * em, top - 1.6 * em, remarks(input), {.size = 0.9 * em, .colour = faint_ink});
}

/// One entry of the legend: a swatch, or a dot, with a text below it.
struct Entry {
    std::string text;
    Colour colour;
    double wide, gap;   ///< of the swatch, or of a dot's text, and before it, em
    double radius = 0;  ///< of a dot, pixels
};

/// Text of a class of share_colours: "1-2 of 5"; empty where no number of runs is in it.
std::string share_text(int share, int runs) {
    int least = runs + 1, most = 0;
    for (int count = 0; count <= runs; ++count)
        if (share_class(count, runs) == share) least = std::min(least, count), most = count;
    if (least > most) return "";
    const std::string numbers =
        least == most ? std::to_string(most)
                      : std::to_string(least) + (most == least + 1 ? " or " : "\u2013") + std::to_string(most);
    return numbers + " of " + std::to_string(runs);
}

/// `dots`: how many tell the sizes of hinges.
std::vector<Entry> legend(const CaptionInput& input, int dots) {
    std::vector<Entry> entries;
    const View& view = input.view;
    if (input.diagram && !input.diagram->empty()) {
        const Diagram& d = *input.diagram;
        const Unit unit = unit_for(std::max(d.largest, -d.smallest), unit_of(d.which));
        const auto say = [&](const char* what, double v) {
            return what + short_number(v / unit.size) + " " + unit.name;
        };
        if (d.largest > 0) entries.push_back({say("largest ", d.largest), plus_fill, 9, 0});
        if (d.smallest < 0) entries.push_back({say("smallest ", d.smallest), minus_fill, 9, 0.7});
    } else if (view.show == Show::yield) {
        for (int i = 0; i <= plastic_class; ++i) {
            char text[24] = "1.0";
            if (i < plastic_class) std::snprintf(text, sizeof text, "%.1f\u2013%.1f", 0.2 * i, 0.2 * (i + 1));
            entries.push_back({text, class_colours[static_cast<std::size_t>(i)], 4.4, i == plastic_class ? 0.4 : 0});
        }
    } else if (view.show == Show::group) {
        const std::size_t most = 8;
        for (std::size_t i = 0; i < input.snapshot.groups.size() && entries.size() < most; ++i) {
            if (i >= input.groups.size() || !input.groups[i]) continue;
            std::string name = input.snapshot.groups[i];
            if (name.size() > 14) name = name.substr(0, 13) + "\xE2\x80\xA6";
            entries.push_back({name, group_colours[i % std::size(group_colours)], 5.5, entries.empty() ? 0 : 0.5});
        }
    }
    if (view.show == Show::broken_in) {
        for (int k = 0; k < n_shares; ++k)
            if (const std::string text = share_text(k, view.runs); !text.empty())
                entries.push_back({text, share_colours[static_cast<std::size_t>(k)], 6.4, k == 0 ? 0 : 0.5});
    } else if (input.broken && !view.leave_out_broken && view.show != Show::nothing)
        entries.push_back({"fractured", class_colours[broken_class], 4.4, 0.7});
    if (input.dot_unit > 0 && is_compared(input.snapshot)) {
        for (int band = 1; band <= hinge_bands && dots > 0; ++band) {
            const double of_limit = 0.5 * band * (band == hinge_bands ? 4.0 / 3 : 1);
            entries.push_back({hinge_band_names[band - 1], band_colour(band), band == 2 ? 6.8 : 5.0,
                               band == 1 ? 1.4 : 0, dot_radius(0.2 * of_limit / most_of_limit, input.dot_unit)});
        }
    } else if (input.dot_unit > 0)
        for (const double rotation : {0.01, 0.05, 0.2}) {
            if (dots == 0 || (dots == 1 && rotation != 0.2)) continue;
            char text[32];
            std::snprintf(text, sizeof text, rotation < 0.2 ? "%g" : "%g rad", rotation);
            entries.push_back({text, class_colours[plastic_class], rotation < 0.2 ? 3.0 : 4.2,
                               rotation == (dots == 1 ? 0.2 : 0.01) ? 1.4 : 0, dot_radius(rotation, input.dot_unit)});
        }
    return entries;
}

/// Meaning of the dots. It depends on what can yield, not on what has: all pictures of a film have the same words.
const char* text_of_dots(const Snapshot& snapshot) {
    if (is_compared(snapshot))
        return snapshot.joints ? "rotation or force against the limit" : "rotation against the limit";
    if (!snapshot.joints) return "plastic rotation";
    const bool hinges =
        std::any_of(snapshot.bars.begin(), snapshot.bars.end(), [](const Bar& bar) { return bar.N0 > 0; });
    return hinges ? "rotation of hinges and joints" : "rotation of joints";
}

void draw_legend(Pen& pen, const CaptionInput& input, double em) {
    const View& view = input.view;
    // Beside the axes, which stand on the left. Where it is too narrow for that it has fewer dots, and all shrinks.
    std::vector<Entry> entries;
    double total = 0, dots_wide = 0, fit = 0;
    for (const int sizes : {3, 1, 0}) {
        entries = legend(input, sizes);
        total = dots_wide = 0;
        for (const Entry& e : entries) total += e.wide + e.gap, dots_wide += 2 * e.radius;
        fit = std::clamp((view.width - 2 * 7.5 * em - dots_wide) / em / std::max(total, 1e-9), 0.3, 1.0);
        if (fit > 0.7) break;
    }
    if (entries.empty()) return;
    const double unit = fit * em;
    const double high = 0.85 * em, foot = 1.15 * em;
    double x = (view.width - total * unit - dots_wide) / 2;
    const double symbol = x - 0.9 * em;
    const bool named = view.show == Show::yield || view.show == Show::broken_in;
    const std::string name = input.diagram ? name_of(input.diagram->which) : named ? name_of(view.show) : "";
    if (name == "f_y") {
        pen.text(symbol, foot + 1.15 * em, "y", {.size = 0.75 * em, .italic = true, .across = 1});
        pen.text(symbol - 0.38 * em, foot + 1.45 * em, "f", {.size = 1.15 * em, .italic = true, .across = 1});
    } else {
        pen.text(symbol, foot + 1.4 * em, name, {.size = 1.1 * em, .italic = false, .across = 1});
    }
    double dots = -1;  // where those of the hinges begin
    for (const Entry& e : entries) {
        x += e.gap * unit;
        const double wide = e.wide * unit, middle = x + wide / 2;
        if (e.radius > 0) {
            const double centre = x + e.radius, level = foot + em + high / 2 + 0.25 * em;
            pen.dot(centre, level, e.radius + 1.3, ink);
            pen.dot(centre, level, e.radius, e.colour);
            pen.text(centre + e.radius + 0.3 * unit, level, e.text, {.size = 0.85 * em * std::max(fit, 0.75)});
            if (dots < 0) dots = x;
            x += 2 * e.radius + wide;
            continue;
        }
        pen.box(x, foot + em, wide, high, e.colour);
        TextStyle text{.size = 0.85 * em * std::max(fit, 0.75), .across = 0.5};
        if (const double long_ = pen.size_of(e.text, text)[0]; long_ > wide * 1.02)
            text.size = std::max(0.5 * em, text.size * wide / long_);
        pen.text(middle, foot + 0.4 * em, e.text, text);
        x += wide;
    }
    if (dots >= 0)
        pen.text(dots, foot + 0.4 * em, text_of_dots(input.snapshot), {.size = 0.85 * em * std::max(fit, 0.75)});
}

/// In the lower left corner, below the structure.
void draw_axes(Pen& pen, const Camera& camera, double em) {
    const double x0 = 3.0 * em, y0 = 2.0 * em, reach = 1.5 * em;
    const char* const names[3] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
        const double dx = reach * camera.right[i], dy = reach * camera.up[i];
        const double seen = std::hypot(dx, dy);
        if (seen < 0.25 * reach) continue;  // it points at the reader
        const double ex = dx / seen, ey = dy / seen, barb = 0.35 * em;
        pen.line(x0, y0, x0 + dx, y0 + dy, em / 13, faint_ink);
        for (const double turn : {0.5, -0.5})
            pen.line(x0 + dx, y0 + dy, x0 + dx - barb * (ex - turn * ey), y0 + dy - barb * (ey + turn * ex), em / 13,
                     faint_ink);
        pen.text(x0 + dx + 0.55 * em * ex, y0 + dy + 0.55 * em * ey, names[i],
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

double text_size(const View& view) { return std::clamp(std::min(view.height / 44.0, view.width / 52.0), 7.0, 60.0); }

Margins caption_margins(const CaptionInput& input) {
    const double em = text_size(input.view);
    const double heading = remarks(input).empty() ? 2.4 : 3.8;
    return {static_cast<int>(heading * em), static_cast<int>(4.2 * em)};
}

void draw_caption(Pen& pen, const CaptionInput& input, const Camera& camera) {
    const double em = text_size(input.view);
    draw_heading(pen, input, em);
    draw_legend(pen, input, em);
    draw_axes(pen, camera, em);
    const auto say = [&](const char* text) {
        pen.text(input.view.width / 2.0, input.view.height / 2.0, text,
                 {.size = 1.2 * em, .colour = faint_ink, .across = 0.5});
    };
    if (input.nothing) say("no bars to show");
    else if (input.diagram && input.diagram->empty())
        pen.text(input.view.width / 2.0, 2.2 * em, std::string(name_of(input.diagram->which)) + " is zero everywhere",
                 {.size = em, .colour = faint_ink, .across = 0.5});
}

}  // namespace hinge::output

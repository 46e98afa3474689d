// Level and upright lines through a panel, and their names.
#include <algorithm>
#include <cmath>

#include "output/curves.h"

namespace hinge::output {

std::optional<double> Curves::place_of(const ReferenceLine& line) const {
    const Box& f = axes_.frame();
    if ((line.upright ? panel_.log_x : panel_.log_y) && line.at <= 0) return {};
    const Pixel p = line.upright ? axes_.pixel(line.at, 0) : axes_.pixel(0, line.at);
    const double at = std::round(line.upright ? p[0] : p[1]);
    const bool inside = line.upright ? at >= f.left && at <= f.right : at >= f.bottom && at <= f.top;
    return inside ? std::optional(at) : std::nullopt;
}

TextStyle Curves::name_style(const ReferenceLine& line) const {
    return {.size = 0.85 * em_, .colour = line.colour.value_or(faint_ink), .upright = 0, .upwards = line.upright};
}

/// Names of upright lines stand at their left, where there is room.
bool Curves::stands_right(const ReferenceLine& line, double at) const {
    return line.upright && at - axes_.frame().left < 1.5 * em_;
}

/// At the end of the line where the name hides less of `drawn`.
Box Curves::name_box(const ReferenceLine& line, double at, const std::vector<Pixel>& drawn) const {
    const Box& f = axes_.frame();
    const TextStyle style = name_style(line);
    const double wide = axes_.pen().size_of(line.name, style)[0], high = style.size, gap = 0.4 * em_;
    const auto end = [&](bool far) -> Box {
        if (line.upright) {
            const double y = far ? f.top - gap - wide : f.bottom + gap, x = stands_right(line, at) ? at : at - high;
            return {x, y, x + high, y + wide};
        }
        const double x = far ? f.right - gap - wide : f.left + gap;
        return {x, at, x + wide, at + high};
    };
    const auto hidden = [&](const Box& b) {
        return std::ranges::count_if(drawn, [&](const Pixel& p) { return b.holds(p[0], p[1]); });
    };
    return end(hidden(end(true)) <= hidden(end(false)));
}

void Curves::draw_line(const ReferenceLine& line) const {
    const auto at = place_of(line);
    if (!at) return;
    const Box& f = axes_.frame();
    const auto a = static_cast<float>(*at);
    const Pixel from = line.upright ? Pixel{a, float(f.bottom)} : Pixel{float(f.left), a},
                to = line.upright ? Pixel{a, float(f.top)} : Pixel{float(f.right), a};
    TextStyle style = name_style(line);
    axes_.pen().path({from, to}, std::max(1.0, em_ / 14), style.colour,
                     line.dashed ? Dashes{0.45 * em_, 0.3 * em_} : Dashes{});
    if (line.name.empty()) return;
    const Box box = name_box(line, *at, places_of_series(0.5 * em_));
    if (line.upright) style.upright = stands_right(line, *at) ? 1.15 : -0.15;
    axes_.pen().text(line.upright ? *at : box.left, line.upright ? box.bottom : *at + 0.1 * em_, line.name, style);
}

std::vector<Box> Curves::name_boxes() const {
    std::vector<Box> all;
    if (panel_.lines.empty()) return all;
    const std::vector<Pixel> drawn = places_of_series(0.5 * em_);
    for (const ReferenceLine& line : panel_.lines)
        if (const auto at = place_of(line); at && !line.name.empty()) all.push_back(name_box(line, *at, drawn));
    return all;
}

std::vector<Pixel> Curves::places(double apart) const {
    std::vector<Pixel> all = places_of_series(apart);
    for (const Box& b : name_boxes())
        for (double x = b.left; x <= b.right; x += 0.4 * em_)
            for (double y = b.bottom; y <= b.top; y += 0.4 * em_)
                all.push_back({static_cast<float>(x), static_cast<float>(y)});
    return all;
}

}  // namespace hinge::output

// The series of one panel of a plot: curves, dots, bands, bars and lines through the panel.
#include "output/curves.h"

#include <algorithm>
#include <cmath>

namespace hinge::output {
namespace {

constexpr Colour curve_colours[] = {{0, 114, 178}, {213, 94, 0},   {0, 158, 115}, {204, 121, 167},
                                    {230, 159, 0}, {86, 180, 233}, {0, 0, 0},     {240, 228, 66}};
constexpr double band_opacity = 0.28;

/// Adds places between p and q, q among them.
void add_places(std::vector<Pixel>& places, const Pixel& p, const Pixel& q, double apart) {
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::hypot(q[0] - p[0], q[1] - p[1]) / apart)));
    for (int k = 1; k <= pieces; ++k) {
        const float share = static_cast<float>(k) / static_cast<float>(pieces);
        places.push_back({p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])});
    }
}

}  // namespace

Colour colour_of(const Series& series, std::size_t place) {
    return series.colour.value_or(curve_colours[place % std::size(curve_colours)]);
}

bool is_dashed(const Series& series, std::size_t place) {
    return series.dashed != (!series.colour && place / std::size(curve_colours) % 2 == 1);
}

/// The colour as drawn.
Colour Curves::paint_of(std::size_t series) const {
    Colour colour = colour_of(panel_.series[series], series);
    if (panel_.series[series].faint)
        for (auto& part : colour) part = static_cast<std::uint8_t>(std::lround(0.42 * part + 0.58 * 255));
    return colour;
}

double Curves::curve_width() const { return std::max(1.5, em_ / 9); }

double Curves::dot_radius(const Series& series) const {
    return series.style == SeriesStyle::points ? em_ / 4.5 : series.style == SeriesStyle::both ? em_ / 5 : 0;
}

/// The curve without its gaps, cut at the frame.
std::vector<std::vector<Pixel>> Curves::runs(const Series& s) const {
    std::vector<std::vector<Pixel>> all;
    std::vector<Pixel> run;
    for (std::size_t i = 0; i <= s.x.size(); ++i) {
        if (i < s.x.size() && drawable(panel_, s, i)) {
            run.push_back(axes_.pixel(s.x[i], s.y[i]));
            continue;
        }
        for (auto& piece : clip(thin(run), axes_.frame())) all.push_back(std::move(piece));
        run.clear();
    }
    return all;
}

/// Points of a curve that no line shows, for there is none beside them, or it has no length: they get dots.
std::vector<Pixel> Curves::lone_points(const Series& s) const {
    std::vector<Pixel> all;
    if (s.style != SeriesStyle::line) return all;
    Pixel first{};
    bool alone = false;
    for (std::size_t i = 0; i <= s.x.size(); ++i) {
        if (i < s.x.size() && drawable(panel_, s, i)) {
            const Pixel p = axes_.pixel(s.x[i], s.y[i]);
            const bool begins = i == 0 || !drawable(panel_, s, i - 1);
            if (begins) first = p;
            alone = begins || (alone && std::hypot(p[0] - first[0], p[1] - first[1]) < 0.5);
            continue;
        }
        if (alone && axes_.frame().holds(first[0], first[1], 1)) all.push_back(first);
        alone = false;
    }
    return all;
}

std::vector<Strip> Curves::strips(const Series& s) const {
    std::vector<Strip> all;
    Strip strip;
    for (std::size_t i = 0; i <= s.x.size(); ++i) {
        if (i < s.x.size() && drawable(panel_, s, i)) {
            strip.low.push_back(axes_.pixel(s.x[i], s.y[i]));
            strip.high.push_back(axes_.pixel(s.x[i], s.high[i]));
            continue;
        }
        if (strip.low.size() > 1) all.push_back(clip(strip, axes_.frame()));
        strip = {};
    }
    return all;
}

std::vector<Box> Curves::bars(std::size_t series) const {
    const Series& s = panel_.series[series];
    std::size_t n = 0, at = 0;
    for (std::size_t i = 0; i < panel_.series.size(); ++i) {
        if (panel_.series[i].style != SeriesStyle::bars) continue;
        if (i < series) ++at;
        ++n;
    }
    const double width = bars_share * bar_spacing(panel_) / static_cast<double>(n);
    const double off = (static_cast<double>(at) - static_cast<double>(n) / 2) * width;
    const Box& f = axes_.frame();
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        if (!drawable(panel_, s, i)) {
            boxes.push_back({});
            continue;
        }
        const bool flat = lies(panel_);
        const Pixel p = flat ? axes_.pixel(0, s.y[i] + off) : axes_.pixel(s.x[i] + off, 0);
        const Pixel q = flat ? axes_.pixel(s.x[i], s.y[i] + off + width) : axes_.pixel(s.x[i] + off + width, s.y[i]);
        const auto across = [&](double v) { return std::clamp(v, f.left, f.right); };
        const auto up = [&](double v) { return std::clamp(v, f.bottom, f.top); };
        boxes.push_back({across(std::min(p[0], q[0])), up(std::min(p[1], q[1])), across(std::max(p[0], q[0])),
                         up(std::max(p[1], q[1]))});
    }
    return boxes;
}

void Curves::draw_run(const std::vector<Pixel>& run, bool dashed, Colour colour) const {
    axes_.pen().path(run, curve_width(), colour, dashed ? Dashes{0.7 * em_, 0.35 * em_} : Dashes{});
}

void Curves::draw_series(std::size_t i) const {
    const Series& s = panel_.series[i];
    const Colour colour = paint_of(i);
    const bool dashed = is_dashed(s, i);
    if (s.style == SeriesStyle::bars) {
        const double gap = em_ / 14;
        const Box& f = axes_.frame();
        for (const Box& b : bars(i))
            if (lies(panel_))
                axes_.pen().box(b.left, b.bottom + gap, b.right - b.left, b.top - b.bottom - 2 * gap, colour);
            else axes_.pen().box(b.left + gap, b.bottom, b.right - b.left - 2 * gap, b.top - b.bottom, colour);
        const Pixel zero = axes_.pixel(0, 0);  // the line from which they rise
        if (lies(panel_)) axes_.pen().line(std::round(zero[0]), f.bottom, std::round(zero[0]), f.top, em_ / 16, ink);
        else if (!panel_.log_y)
            axes_.pen().line(f.left, std::round(zero[1]), f.right, std::round(zero[1]), em_ / 16, ink);
        return;
    }
    if (s.style == SeriesStyle::band) {
        for (const Strip& strip : strips(s)) axes_.pen().strip(strip.low, strip.high, colour, band_opacity);
        return;
    }
    if (s.style != SeriesStyle::points)
        for (const auto& run : runs(s)) draw_run(run, dashed, colour);
    for (const Pixel& p : lone_points(s)) axes_.pen().dot(p[0], p[1], lone_radius(), colour);
    if (s.style == SeriesStyle::line) return;
    for (std::size_t k = 0; k < s.x.size(); ++k) {
        if (!drawable(panel_, s, k)) continue;
        const Pixel p = axes_.pixel(s.x[k], s.y[k]);
        if (axes_.frame().holds(p[0], p[1], 1)) axes_.pen().dot(p[0], p[1], dot_radius(s), colour);
    }
}

void Curves::draw() const {
    // Areas beneath, so that they hide no curve.
    for (const bool areas : {true, false}) {
        for (std::size_t i = 0; i < panel_.series.size(); ++i) {
            const SeriesStyle style = panel_.series[i].style;
            if ((style == SeriesStyle::band || style == SeriesStyle::bars) == areas) draw_series(i);
        }
        if (areas)
            for (const ReferenceLine& line : panel_.lines) draw_line(line);
    }
}

void Curves::draw_sample(std::size_t i, double left, double right, double middle) const {
    const Series& s = panel_.series[i];
    const Colour colour = paint_of(i);
    if (s.style == SeriesStyle::band || s.style == SeriesStyle::bars)
        return axes_.pen().box(left, middle - 0.35 * em_, right - left, 0.7 * em_, colour,
                               s.style == SeriesStyle::band ? band_opacity : 1);
    const auto at = static_cast<float>(middle);
    if (s.style != SeriesStyle::points)
        draw_run({{static_cast<float>(left), at}, {static_cast<float>(right), at}}, is_dashed(s, i), colour);
    if (s.style != SeriesStyle::line) axes_.pen().dot((left + right) / 2, middle, dot_radius(s), colour);
}

/// A bar with its label behind its end.
Box Curves::with_label(const Box& bar, const Series& s, std::size_t i) const {
    if (i >= s.labels.size() || s.labels[i].empty()) return bar;
    Box box = bar;
    const bool flat = lies(panel_), back = (flat ? s.x[i] : s.y[i]) < 0;
    const auto [wide, high] = axes_.pen().size_of(s.labels[i], {.size = bar_label_size * em_});
    const double long_ = (flat ? wide : std::max(high, bar_label_size * em_)) + 0.35 * em_;
    (flat ? back ? box.left : box.right : back ? box.bottom : box.top) += back ? -long_ : long_;
    const double across = flat ? 0 : std::max(0.0, (wide - (box.right - box.left)) / 2);
    return {box.left - across, box.bottom, box.right + across, box.top};
}

Drawn Curves::drawn() const {
    Drawn all;
    for (std::size_t i = 0; i < panel_.series.size(); ++i) {
        const Series& s = panel_.series[i];
        if (s.style == SeriesStyle::bars) {
            const auto boxes = bars(i);
            for (std::size_t k = 0; k < boxes.size(); ++k)
                if (boxes[k].right > boxes[k].left) all.boxes.push_back(with_label(boxes[k], s, k));
            continue;
        }
        if (s.style == SeriesStyle::band) {
            for (Strip& strip : strips(s)) all.strips.push_back(std::move(strip));
            continue;
        }
        if (s.style != SeriesStyle::points)
            for (auto& run : runs(s)) all.curves.push_back(std::move(run));
        for (const Pixel& p : lone_points(s)) all.dots.push_back({p, lone_radius()});
        if (s.style == SeriesStyle::line) continue;
        for (std::size_t k = 0; k < s.x.size(); ++k)
            if (drawable(panel_, s, k)) all.dots.push_back({axes_.pixel(s.x[k], s.y[k]), dot_radius(s)});
    }
    for (const Box& name : name_boxes()) all.boxes.push_back(name);
    const Box& f = axes_.frame();
    for (const ReferenceLine& line : panel_.lines)
        if (const auto at = place_of(line)) {
            const auto a = static_cast<float>(*at);
            all.lines.push_back(line.upright ? std::vector<Pixel>{{a, float(f.bottom)}, {a, float(f.top)}}
                                             : std::vector<Pixel>{{float(f.left), a}, {float(f.right), a}});
        }
    return all;
}

std::vector<Pixel> Curves::places_of_series(double apart) const {
    std::vector<Pixel> all;
    for (std::size_t i = 0; i < panel_.series.size(); ++i) {
        const Series& s = panel_.series[i];
        if (s.style == SeriesStyle::bars) {
            for (const Box& b : bars(i))
                for (double x = b.left; x <= b.right && b.right > b.left; x += apart)
                    for (double y = b.bottom; y <= b.top; y += apart)
                        all.push_back({static_cast<float>(x), static_cast<float>(y)});
            continue;
        }
        if (s.style == SeriesStyle::band) {
            for (const Strip& strip : strips(s))
                for (std::size_t k = 0; k < strip.low.size(); ++k) {
                    add_places(all, strip.low[k], strip.high[k], 2 * apart);
                    if (k == 0) continue;
                    add_places(all, strip.low[k - 1], strip.low[k], apart);
                    add_places(all, strip.high[k - 1], strip.high[k], apart);
                }
            continue;
        }
        if (s.style != SeriesStyle::points)
            for (const auto& run : runs(s))
                for (std::size_t k = 0; k + 1 < run.size(); ++k) add_places(all, run[k], run[k + 1], apart);
        for (const Pixel& p : lone_points(s)) all.insert(all.end(), 4, p);
        if (s.style != SeriesStyle::line)
            for (std::size_t k = 0; k < s.x.size(); ++k)
                if (drawable(panel_, s, k)) all.insert(all.end(), s.x.size() > 60 ? 1 : 4, axes_.pixel(s.x[k], s.y[k]));
    }
    return all;
}

}  // namespace hinge::output

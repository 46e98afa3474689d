// A line plot as a picture.
//
// Drawn on VTK's flat canvas, not by VTK's charts (vtkChartXY of VTK 9.1), which were tried and look worse: words that
// touch or overlap the labels of their axis, ticks at 520,000, 570,000 and 620,000, no powers of ten, a grid of all
// digits, dots that are squares, a legend that stays in its corner whatever it hides, logarithmic curves that appear
// only when the picture is drawn twice. To mend that takes most of this file and `ticks` again, and the charts bring
// 16 more libraries to load. The same plot both ways: scripts/pictures/plot_own.png and plot_vtk_charts.png.
#include "output/draw_plot.h"

#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/errors.h"
#include "output/sketch.h"
#include "output/ticks.h"
#include "output/window.h"

namespace hinge::output {
namespace {

constexpr Colour curve_colours[] = {{31, 95, 168},  {209, 53, 43},  {47, 152, 91},  {226, 138, 30},
                                    {123, 82, 168}, {23, 158, 178}, {140, 109, 70}, {90, 96, 104}};
constexpr Colour grid = {226, 229, 233};

using Pixel = std::array<float, 2>;

bool drawable(const Plot& plot, const Series& s, std::size_t i) {
    return std::isfinite(s.x[i]) && std::isfinite(s.y[i]) && (!plot.log_x || s.x[i] > 0) && (!plot.log_y || s.y[i] > 0);
}

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(double v) {
        low = std::min(low, v);
        high = std::max(high, v);
    }
};

class Drawing {
public:
    Drawing(Pen& pen, const Plot& plot, int width, int height)
        : pen_(pen), plot_(plot), width_(width), height_(height) {
        em_ = std::clamp(std::min(height / 32.0, width / 40.0), 7.0, 60.0);
        label_ = {.size = 0.92 * em_};
        legend_.row = 1.45 * em_;
        legend_.sample = 2.8 * em_;
        legend_.pad = 0.6 * em_;
        set_axes();
        set_place();
        set_legend();
    }

    void draw() {
        draw_grid();
        for (std::size_t i = 0; i < plot_.series.size(); ++i) draw_series(plot_.series[i], colour(i));
        draw_frame();
        draw_words();
        draw_legend();
    }

private:
    static Colour colour(std::size_t i) { return curve_colours[i % std::size(curve_colours)]; }

    bool drawable(const Series& s, std::size_t i) const { return output::drawable(plot_, s, i); }
    Pixel pixel(double x, double y) const {
        return {static_cast<float>(left_ + x_.share(x) * (right_ - left_)),
                static_cast<float>(bottom_ + y_.share(y) * (top_ - bottom_))};
    }

    void set_axes() {
        Range x, y;
        bool any_points = false;
        for (const Series& s : plot_.series) {
            any_points = any_points || s.style == SeriesStyle::points;
            for (std::size_t i = 0; i < s.x.size(); ++i)
                if (drawable(s, i)) {
                    x.add(s.x[i]);
                    y.add(s.y[i]);
                }
        }
        // Curves may run edge to edge; dots must not be cut by the frame.
        x_ = make_axis(x.low, x.high, plot_.log_x, any_points ? 0.04 : 0,
                       std::clamp(static_cast<int>(width_ / (8 * em_)), 2, 9));
        y_ = make_axis(y.low, y.high, plot_.log_y, 0.06, std::clamp(static_cast<int>(height_ / (4 * em_)), 2, 8));
    }

    void set_place() {
        double widest = 0;
        for (const Tick& tick : y_.ticks) widest = std::max(widest, tick_width(tick));
        left_ = std::round(1.2 * em_ + (plot_.y_label.empty() ? 0 : 1.9 * em_) + widest + 0.6 * em_);
        right_ = std::round(width_ - 2.0 * em_);
        bottom_ = std::round(2.4 * em_ + (plot_.x_label.empty() ? 0 : 1.7 * em_));
        const bool above = !plot_.title.empty() || !y_.scale.empty();
        top_ = std::round(height_ - (plot_.title.empty() ? 1.2 : 3.0) * em_ -
                          (above && !y_.scale.empty() ? 1.2 * em_ : 0));
    }

    TextStyle power_style() const { return {.size = 0.7 * label_.size}; }
    double tick_width(const Tick& tick) {
        return pen_.size_of(tick.label, label_)[0] +
               (tick.power.empty() ? 0 : pen_.size_of(tick.power, power_style())[0]);
    }
    /// Label and raised power, `across` as in TextStyle.
    void tick_text(double x, double y, const Tick& tick, double across, double upright) {
        const double base = pen_.size_of(tick.label, label_)[0];
        const double start = x - across * tick_width(tick);
        TextStyle style = label_;
        style.upright = upright;
        pen_.text(start, y, tick.label, style);
        TextStyle small = power_style();
        small.upright = upright;
        pen_.text(start + base, y + 0.4 * label_.size, tick.power, small);
    }

    void draw_grid() {
        for (const Tick& tick : x_.ticks) {
            const double x = std::round(pixel(tick.at, y_.low)[0]);
            if (!tick.label.empty()) pen_.line(x, bottom_, x, top_, 1, grid);
        }
        for (const Tick& tick : y_.ticks) {
            const double y = std::round(pixel(x_.low, tick.at)[1]);
            if (!tick.label.empty()) pen_.line(left_, y, right_, y, 1, grid);
        }
    }

    void draw_frame() {
        const double line = std::max(1.0, em_ / 16);
        pen_.line(left_, bottom_, right_, bottom_, line, ink);
        pen_.line(left_, bottom_, left_, top_, line, ink);
        for (const Tick& tick : x_.ticks) {
            const double x = std::round(pixel(tick.at, y_.low)[0]), reach = (tick.label.empty() ? 0.2 : 0.38) * em_;
            pen_.line(x, bottom_, x, bottom_ - reach, line, ink);
            tick_text(x, bottom_ - 0.6 * em_, tick, 0.5, 1);
        }
        for (const Tick& tick : y_.ticks) {
            const double y = std::round(pixel(x_.low, tick.at)[1]), reach = (tick.label.empty() ? 0.2 : 0.38) * em_;
            pen_.line(left_, y, left_ - reach, y, line, ink);
            tick_text(left_ - 0.6 * em_, y, tick, 1, 0.5);
        }
        const std::string times =
            "\xC3\x97"
            "10";
        if (!y_.scale.empty()) tick_text(left_, top_ + 0.9 * em_, {0, times, y_.scale}, 0, 0.5);
        if (!x_.scale.empty()) tick_text(right_, bottom_ - 2.1 * em_, {0, times, x_.scale}, 1, 1);
    }

    void draw_words() {
        const double middle = (left_ + right_) / 2;
        pen_.text(middle, height_ - 1.6 * em_, plot_.title, {.size = 1.2 * em_, .bold = true, .across = 0.5});
        pen_.text(middle, 1.5 * em_, plot_.x_label, {.size = em_, .across = 0.5});
        pen_.text(1.5 * em_, (bottom_ + top_) / 2, plot_.y_label, {.size = em_, .across = 0.5, .upwards = true});
    }

    double curve_width() const { return std::max(1.5, em_ / 9); }

    void draw_series(const Series& s, Colour c) {
        if (s.style == SeriesStyle::points) {
            for (std::size_t i = 0; i < s.x.size(); ++i)
                if (drawable(s, i)) {
                    const Pixel p = pixel(s.x[i], s.y[i]);
                    pen_.dot(p[0], p[1], em_ / 4.5, c);
                }
            return;
        }
        std::vector<Pixel> run;
        for (std::size_t i = 0; i <= s.x.size(); ++i) {
            if (i < s.x.size() && drawable(s, i)) {
                run.push_back(pixel(s.x[i], s.y[i]));
                continue;
            }
            draw_run(run, s.dashed, c);
            run.clear();
        }
    }

    void draw_run(const std::vector<Pixel>& run, bool dashed, Colour c) {
        if (!dashed) return pen_.path(run, curve_width(), c);
        // Dashes by length along the curve: even ones, however densely it was sampled.
        const double dash = 0.7 * em_, gap = 0.35 * em_;
        bool down = true;
        double left = dash;
        std::vector<Pixel> piece;
        for (std::size_t i = 0; i + 1 < run.size(); ++i) {
            Pixel p = run[i];
            const Pixel q = run[i + 1];
            double rest = std::hypot(q[0] - p[0], q[1] - p[1]);
            if (down && piece.empty()) piece.push_back(p);
            while (rest > left) {
                const float share = static_cast<float>(left / rest);
                p = {p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])};
                rest -= left;
                if (down) {
                    piece.push_back(p);
                    pen_.path(piece, curve_width(), c);
                    piece.clear();
                } else {
                    piece = {p};
                }
                down = !down;
                left = down ? dash : gap;
            }
            left -= rest;
            if (down) piece.push_back(q);
        }
        if (down) pen_.path(piece, curve_width(), c);
    }

    /// How much of the curves a box would hide: dots, and pieces of line an em long.
    int hidden_by(double x, double y, double w, double h) const {
        int hidden = 0;
        const auto count = [&](double px, double py) { hidden += px >= x && px <= x + w && py >= y && py <= y + h; };
        for (const Series& s : plot_.series)
            for (std::size_t i = 0; i < s.x.size(); ++i) {
                if (!drawable(s, i)) continue;
                const Pixel p = pixel(s.x[i], s.y[i]);
                count(p[0], p[1]);
                if (s.style == SeriesStyle::points || i + 1 == s.x.size() || !drawable(s, i + 1)) continue;
                const Pixel q = pixel(s.x[i + 1], s.y[i + 1]);
                const int pieces = static_cast<int>(std::hypot(q[0] - p[0], q[1] - p[1]) / em_);
                for (int k = 1; k <= pieces; ++k)
                    count(p[0] + (q[0] - p[0]) * k / (pieces + 1.0), p[1] + (q[1] - p[1]) * k / (pieces + 1.0));
            }
        return hidden;
    }

    /// In the corner where it hides least; beside the axes where it would hide curves in every corner.
    void set_legend() {
        std::vector<std::size_t>& listed = listed_;
        double widest = 0;
        for (std::size_t i = 0; i < plot_.series.size(); ++i)
            if (!plot_.series[i].name.empty()) {
                listed.push_back(i);
                widest = std::max(widest, pen_.size_of(plot_.series[i].name, label_)[0]);
            }
        if (listed.empty()) return;
        const double away = 0.8 * em_;
        const double w = legend_.sample + 0.6 * em_ + widest + 2 * legend_.pad,
                     h = legend_.row * static_cast<double>(listed.size()) + legend_.pad;
        const double xs[] = {right_ - w - away, left_ + away}, ys[] = {top_ - h - 0.4 * em_, bottom_ + away};
        double &x = legend_.x, &y = legend_.y;
        int least = std::numeric_limits<int>::max();
        for (const double try_y : ys)
            for (const double try_x : xs)
                if (const int hidden = hidden_by(try_x, try_y, w, h); hidden < least) {
                    least = hidden;
                    x = try_x;
                    y = try_y;
                }
        if (least > 3 && w < 0.45 * (right_ - left_)) {
            right_ = std::round(right_ - w - 0.4 * em_);
            x = right_ + 0.6 * em_;
            y = ys[0];
        }
        legend_.w = w;
        legend_.h = h;
    }

    void draw_legend() {
        if (listed_.empty()) return;
        const double x = legend_.x, pad = legend_.pad, sample = legend_.sample, row = legend_.row;
        pen_.box(x, legend_.y, legend_.w, legend_.h, white, 0.88);
        double middle = legend_.y + legend_.h - pad / 2 - row / 2;
        for (const std::size_t i : listed_) {
            const Series& s = plot_.series[i];
            const auto from = static_cast<float>(x + pad), to = static_cast<float>(x + pad + sample);
            const auto at = static_cast<float>(middle);
            if (s.style == SeriesStyle::points) pen_.dot((from + to) / 2, at, em_ / 4.5, colour(i));
            else draw_run({{from, at}, {to, at}}, s.dashed, colour(i));
            pen_.text(to + 0.6 * em_, middle, s.name, label_);
            middle -= row;
        }
    }

    Pen& pen_;
    const Plot& plot_;
    int width_, height_;
    double em_;
    TextStyle label_;
    Axis x_, y_;
    std::vector<std::size_t> listed_;  // series in the legend
    struct {
        double x, y, w, h, row, sample, pad;
    } legend_{};
    double left_ = 0, right_ = 0, bottom_ = 0, top_ = 0;
};

void check_plot(const Plot& plot) {
    bool any = false;
    for (const Series& s : plot.series) {
        if (s.x.size() != s.y.size())
            throw InputError("plot: series \"" + s.name + "\" has " + std::to_string(s.x.size()) + " x and " +
                             std::to_string(s.y.size()) + " y values; they must be as many");
        for (std::size_t i = 0; i < s.x.size(); ++i) any = any || drawable(plot, s, i);
    }
    if (!any)
        throw InputError(std::string("plot: nothing to draw; give at least one finite point") +
                         (plot.log_x || plot.log_y ? ", positive on a logarithmic axis" : ""));
}

}  // namespace

std::string draw_plot(const Plot& plot, int width, int height) {
    check_size(width, height);
    check_plot(plot);
    const auto canvas = sketch([&](Pen& pen) { Drawing(pen, plot, width, height).draw(); });
    vtkRenderer* const layers[] = {canvas};
    return encode_png(take_pixels(width, height, layers));
}

}  // namespace hinge::output

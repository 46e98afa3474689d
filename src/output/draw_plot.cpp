// A plot as a picture: its panels beside and below each other, as PNG or SVG.
//
// Drawn on VTK's flat canvas, not by VTK's charts (vtkChartXY of VTK 9.1), which were tried and look worse: words that
// touch or overlap the labels of their axis, ticks at 520,000, 570,000 and 620,000, no powers of ten, a grid of all
// digits, dots that are squares, a legend that stays in its corner whatever it hides, logarithmic curves that appear
// only when the picture is drawn twice. To mend that takes most of these files again, and the charts bring
// 16 more libraries to load. The same plot both ways: scripts/pictures/plot_own.png and plot_vtk_charts.png.
#include "output/draw_plot.h"

#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/errors.h"
#include "output/labels.h"
#include "output/sketch.h"
#include "output/svg.h"
#include "output/window.h"

namespace hinge::output {
namespace {

/// A panel with what is drawn in it.
struct Part {
    Part(Pen& pen, const Panel& panel, double em, double width, double height, Range extent, bool words_below)
        : axes(pen, panel, em, width, height, extent, words_below), curves(axes), legend(axes, curves) {}
    Axes axes;
    Curves curves;
    Legend legend;
};

class Drawing {
public:
    Drawing(Pen& pen, const Plot& plot, int width, int height)
        : pen_(pen), plot_(plot), width_(width), height_(height) {
        columns_ = std::clamp<std::size_t>(std::size_t(plot.columns), 1, plot.panels.size());
        rows_ = (plot.panels.size() + columns_ - 1) / columns_;
        cell_width_ = width_ / static_cast<double>(columns_);
        em_ = std::clamp(std::min(height_ / static_cast<double>(rows_) / (rows_ > 1 ? 20.0 : 32.0), cell_width_ / 40),
                         7.0, 60.0);
        header_ = plot.title.empty() ? 0 : (alone() ? 1.8 : 2.6) * em_;
        cell_height_ = (height_ - header_) / static_cast<double>(rows_);
        make_parts();
        set_frames_and_legends();
    }

    void draw() {
        for (Part& part : parts_) {
            part.axes.draw_grid();
            part.curves.draw();
            part.axes.draw_frame();
            part.axes.draw_words(part.legend.room_above());
            if (!shows_something(part.axes.panel())) say_nothing(part.axes.frame());
            draw_labels(part.axes, part.curves, part.legend.box());
            part.legend.draw();
        }
        draw_title();
    }

    static bool shows_something(const Panel& panel) {
        for (const Series& s : panel.series)
            for (std::size_t i = 0; i < s.x.size(); ++i)
                if (drawable(panel, s, i)) return true;
        return false;
    }

private:
    bool alone() const { return plot_.panels.size() == 1; }
    std::size_t row(std::size_t i) const { return i / columns_; }
    std::size_t column(std::size_t i) const { return i % columns_; }

    void make_parts() {
        std::vector<Range> shared(columns_);
        for (std::size_t i = 0; i < plot_.panels.size(); ++i) {
            const Range own = x_extent(plot_.panels[i]);
            if (own.any()) shared[column(i)].add(own.low), shared[column(i)].add(own.high);
        }
        for (std::size_t i = 0; i < plot_.panels.size(); ++i) {
            const bool lowest = i + columns_ >= plot_.panels.size();
            parts_.emplace_back(pen_, plot_.panels[i], em_, cell_width_, cell_height_,
                                plot_.share_x ? shared[column(i)] : x_extent(plot_.panels[i]),
                                !plot_.share_x || lowest);
        }
    }

    /// Frames of a column have one left and right edge, frames of a row one foot and head.
    void set_frames() {
        std::vector<Margins4> of_column(columns_), of_row(rows_);
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            Margins4 m = parts_[i].axes.margins();
            m.right += parts_[i].legend.room_beside();
            m.top += parts_[i].legend.room_above();
            Margins4 &c = of_column[column(i)], &r = of_row[row(i)];
            c.left = std::max(c.left, m.left);
            c.right = std::max(c.right, m.right);
            r.bottom = std::max(r.bottom, m.bottom);
            r.top = std::max(r.top, m.top);
        }
        // Rows with less around them give their room to all frames.
        double around = 0;
        for (const Margins4& r : of_row) around += r.bottom + r.top;
        const double high = std::max(em_, (height_ - header_ - around) / static_cast<double>(rows_));
        std::vector<double> foot(rows_);
        double top = height_ - header_;
        for (std::size_t k = 0; k < rows_; ++k) {
            foot[k] = top - of_row[k].top - high;
            top = foot[k] - of_row[k].bottom;
        }
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Margins4& c = of_column[column(i)];
            const double left = cell_width_ * static_cast<double>(column(i));
            const double right = std::max(left + cell_width_ - c.right, left + c.left + em_);
            parts_[i].axes.set_frame({left + c.left, foot[row(i)], right, foot[row(i)] + high}, c.left);
        }
    }

    /// A legend that goes outside makes frames smaller, so that another one may find no place any more.
    void set_frames_and_legends() {
        for (bool moved = true; moved;) {
            set_frames();
            moved = false;
            for (Part& part : parts_)
                if (part.legend.goes_outside()) moved = true;
        }
        for (Part& part : parts_) part.legend.place();
    }

    void say_nothing(const Box& f) {
        pen_.text((f.left + f.right) / 2, (f.bottom + f.top) / 2, "nothing to draw",
                  {.size = em_, .colour = faint_ink, .across = 0.5});
    }

    void draw_title() {
        const Box& f = parts_.front().axes.frame();
        const double middle = alone() ? (f.left + f.right) / 2 : width_ / 2;
        const Fitted title = fit(pen_, plot_.title, {.size = 1.2 * em_, .bold = true, .across = 0.5},
                                 2 * std::min(middle, width_ - middle) - em_);
        pen_.text(middle, height_ - 1.6 * em_, title.words, title.style);
    }

    Pen& pen_;
    const Plot& plot_;
    double width_, height_, em_ = 0, header_ = 0;
    std::size_t columns_ = 1, rows_ = 1;
    double cell_width_ = 0, cell_height_ = 0;
    std::deque<Part> parts_;  // they refer to each other
};

std::string name_of(const Plot& plot, std::size_t panel, const Series& s) {
    return (plot.panels.size() > 1 ? "plot: panel " + std::to_string(panel + 1) + ", series \"" : "plot: series \"") +
           s.name + "\"";
}

void check_plot(const Plot& plot) {
    bool any = false, log = false;
    for (std::size_t i = 0; i < plot.panels.size(); ++i) {
        const Panel& panel = plot.panels[i];
        log = log || panel.log_x || panel.log_y;
        for (const Series& s : panel.series) {
            if (s.x.size() != s.y.size())
                throw InputError(name_of(plot, i, s) + " has " + std::to_string(s.x.size()) + " x and " +
                                 std::to_string(s.y.size()) + " y values; they must be as many");
            if (s.style == SeriesStyle::band && s.high.size() != s.x.size())
                throw InputError(name_of(plot, i, s) + " has " + std::to_string(s.x.size()) + " x and " +
                                 std::to_string(s.high.size()) + " high values; they must be as many");
        }
        any = any || Drawing::shows_something(panel);
    }
    if (!any)
        throw InputError(std::string("plot: nothing to draw; give at least one finite point") +
                         (log ? ", positive on a logarithmic axis" : ""));
}

/// With share_x the panels of a column have the x_range that one of them has.
Plot with_shared_ranges(Plot plot) {
    const std::size_t columns = std::clamp<std::size_t>(std::size_t(plot.columns), 1, plot.panels.size());
    for (std::size_t c = 0; c < columns && plot.share_x; ++c) {
        std::optional<std::array<double, 2>> range;
        for (std::size_t i = c; i < plot.panels.size(); i += columns)
            if (!range) range = plot.panels[i].x_range;
        for (std::size_t i = c; i < plot.panels.size(); i += columns)
            if (plot.panels[i].x_categories.empty()) plot.panels[i].x_range = range;
    }
    return plot;
}

bool ends_in_svg(const std::string& path) {
    if (path.size() < 4) return false;
    std::string end = path.substr(path.size() - 4);
    for (char& c : end) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return end == ".svg";
}

}  // namespace

std::string draw_plot(const std::string& path, const Plot& given, int width, int height) {
    check_size(width, height);
    check_plot(given);
    const Plot plot = with_shared_ranges(given);
    if (ends_in_svg(path)) {
        SvgPen pen(width, height, plot.title);
        Drawing(pen, plot, width, height).draw();
        return pen.file();
    }
    const auto canvas = sketch([&](Pen& pen) { Drawing(pen, plot, width, height).draw(); });
    vtkRenderer* const layers[] = {canvas};
    return encode_png(take_pixels(width, height, layers));
}

}  // namespace hinge::output

// The axes of one panel of a plot: ranges, marks, frame and the words around it.
#pragma once

#include <limits>

#include "output/clip.h"
#include "output/plot.h"
#include "output/ticks.h"

namespace hinge::output {

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(double v) {
        if (v < low) low = v;
        if (v > high) high = v;
    }
    bool any() const { return low <= high; }
};

/// Whether a value of a series can be shown: finite, and positive on a logarithmic axis.
bool drawable(const Panel& panel, const Series& series, std::size_t i);

/// Whether the bars of a panel lie, from left to right.
inline bool lies(const Panel& panel) { return !panel.y_categories.empty(); }

/// What the series of a panel take of the x axis.
Range x_extent(const Panel& panel);

/// How much of the 1 between two places on the axis all bars take there together, and how far places are apart.
double bar_spacing(const Panel& panel);
inline constexpr double bars_share = 0.8;
inline constexpr double bar_label_size = 0.8;  ///< em; of labels beside points too

/// Words that keep to a length: smaller, and cut where that is not enough.
struct Fitted {
    std::string words;
    TextStyle style;
};
Fitted fit(Pen& pen, std::string words, TextStyle style, double room);

/// Widths around the frame.
struct Margins4 {
    double left = 0, right = 0, bottom = 0, top = 0;
};

class Axes {
public:
    /// `extent`: what the x axis has to show. `words_below`: whether its numbers and name stand under the frame.
    Axes(Pen& pen, const Panel& panel, double em, double width, double height, Range extent, bool words_below);

    Margins4 margins() const { return margins_; }
    /// `left`: how wide the margin there is for all panels of the column.
    void set_frame(const Box& frame, double left);
    const Box& frame() const { return frame_; }
    const Panel& panel() const { return panel_; }
    double em() const { return em_; }
    Pen& pen() const { return pen_; }
    const TextStyle& label() const { return label_; }
    /// Room right above the frame that the power of its numbers takes.
    double room_for_scale() const { return y_.scale.empty() ? 0 : 1.2 * em_; }

    /// What is not positive on a logarithmic axis lies at its end.
    Pixel pixel(double x, double y) const;

    void draw_grid() const;
    void draw_frame() const;
    /// `above`: what stands between the frame and the title.
    void draw_words(double above) const;

private:
    void set_ranges(double width, double height, Range extent);
    void set_margins();
    Range y_extent() const;
    double widest(const Axis& axis) const;
    double room_for_bar_labels(double width) const;
    void tick_text(double x, double y, const Tick& tick, TextStyle style, double room = unbounded) const;
    static constexpr double unbounded = std::numeric_limits<double>::infinity();

    Pen& pen_;
    const Panel& panel_;
    double em_;
    bool words_below_;
    bool turned_ = false;  ///< the categories below are written upwards
    double category_room_ = 0;
    TextStyle label_;
    Axis x_, y_;
    Margins4 margins_;
    Box frame_;
};

}  // namespace hinge::output

// The series of one panel of a plot: curves, dots, bands, bars and lines through the panel.
#pragma once

#include "output/axes.h"

namespace hinge::output {

/// Blue, red, green, purple, orange, sky blue, black and yellow that all readers can tell apart (Okabe and Ito 2008).
Colour colour_of(const Series& series, std::size_t place);

/// The second eight series have the colours of the first, dashed.
bool is_dashed(const Series& series, std::size_t place);

struct Dot {
    Pixel at;
    double radius;
};

/// All that is drawn in a panel, for what must not hide it.
struct Drawn {
    std::vector<std::vector<Pixel>> curves, lines;  ///< lines: through the whole panel
    std::vector<Strip> strips;
    std::vector<Box> boxes;  ///< bars, with their labels; names of lines
    std::vector<Dot> dots;
};

class Curves {
public:
    explicit Curves(const Axes& axes) : axes_(axes), panel_(axes.panel()), em_(axes.em()) {}

    void draw() const;
    /// A short piece of a series, for the legend.
    void draw_sample(std::size_t series, double left, double right, double middle) const;

    /// Places `apart` or nearer to each other along all that is drawn, for what must not hide it.
    std::vector<Pixel> places(double apart) const;
    Drawn drawn() const;
    std::vector<Box> bars(std::size_t series) const;  ///< one for each value; empty where there is none
    double dot_radius(const Series& series) const;

private:
    std::vector<std::vector<Pixel>> runs(const Series& series) const;
    std::vector<Pixel> lone_points(const Series& series) const;
    Box with_label(const Box& bar, const Series& series, std::size_t i) const;
    Colour paint_of(std::size_t series) const;
    std::vector<Strip> strips(const Series& series) const;
    void draw_run(const std::vector<Pixel>& run, bool dashed, Colour colour) const;
    void draw_series(std::size_t series) const;
    std::vector<Pixel> places_of_series(double apart) const;
    /// Where a line stands, pixels along the axis that it crosses; none: beside the frame.
    std::optional<double> place_of(const ReferenceLine& line) const;
    std::vector<Box> name_boxes() const;
    Box name_box(const ReferenceLine& line, double at, const std::vector<Pixel>& drawn) const;
    bool stands_right(const ReferenceLine& line, double at) const;
    TextStyle name_style(const ReferenceLine& line) const;
    void draw_line(const ReferenceLine& line) const;
    double curve_width() const;
    double lone_radius() const { return em_ / 5; }

    const Axes& axes_;
    const Panel& panel_;
    double em_;
};

}  // namespace hinge::output

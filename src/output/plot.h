// What a plot shows, without a picture library: the second half of the output module's interface.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hinge::output {

enum class SeriesStyle { line, points, both, band, bars };

using Rgb8 = std::array<std::uint8_t, 3>;

/// One curve, band or group of bars. A value that is not finite, or not positive on a logarithmic axis, leaves a gap.
struct Series {
    std::string name;          ///< in the legend; empty: not listed
    std::vector<double> x, y;  ///< of a category: its number, from 1
    SeriesStyle style = SeriesStyle::line;
    bool dashed = false;
    std::vector<double> high{};         ///< the upper edge of a band, whose lower edge is y
    std::optional<Rgb8> colour{};       ///< none: by its place among the series
    std::vector<std::string> labels{};  ///< beside the points or bars; empty: none
    bool faint = false;                 ///< lighter; labels of its points are left out where there is no room
};

/// A level or upright line through a whole panel.
struct ReferenceLine {
    std::string name;  ///< beside it
    double at = 0;
    bool upright = false;
    bool dashed = true;
    std::optional<Rgb8> colour{};
};

struct Panel {
    std::string title{}, x_label{}, y_label{};
    bool log_x = false, log_y = false;
    std::optional<std::array<double, 2>> x_range{}, y_range{};  ///< none: what the series need
    std::vector<std::string> x_categories{}, y_categories{};    ///< names in place of numbers; at most one has any
    std::vector<Series> series{};
    std::vector<ReferenceLine> lines{};
};

struct Plot {
    std::string title;
    std::vector<Panel> panels;
    int columns = 1;
    /// The panels of a column have one x axis, which stands below the lowest. Its range is the first x_range among
    /// them.
    bool share_x = false;
};

}  // namespace hinge::output

extern "C" {
/// Draws `plot` into a picture of width x height pixels: SVG where the path ends in .svg, else PNG. 0, or 1 with a
/// message in `error` (at most `room` bytes).
using hinge_plot = int (*)(const char* path, const hinge::output::Plot& plot, int width, int height, char* error,
                           int room);
}

// What a line plot shows, without a picture library: the second half of the output module's interface.
#pragma once

#include <string>
#include <vector>

namespace hinge::output {

enum class SeriesStyle { line, points };

/// One curve. A value that is not finite, or not positive on a logarithmic axis, leaves a gap.
struct Series {
    std::string name;  ///< in the legend; empty: not listed
    std::vector<double> x, y;
    SeriesStyle style = SeriesStyle::line;
    bool dashed = false;
};

struct Plot {
    std::string title, x_label, y_label;
    bool log_x = false, log_y = false;
    std::vector<Series> series;
};

}  // namespace hinge::output

extern "C" {
/// Draws `plot` into a PNG of width x height pixels; 0, or 1 with a message in `error` (at most `room` bytes).
using hinge_plot = int (*)(const char* path, const hinge::output::Plot& plot, int width, int height, char* error,
                           int room);
}

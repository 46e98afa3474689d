// Where an axis has its marks, and what stands beside them.
#pragma once

#include <string>
#include <vector>

namespace hinge::output {

struct Tick {
    double at;          ///< data value
    std::string label;  ///< empty: a minor tick
    std::string power;  ///< set higher after the label: 10 to this
};

/// One axis of a plot: its range in data values and its marks.
struct Axis {
    bool log = false;
    double low = 0, high = 1;
    std::vector<Tick> ticks;
    std::string scale;  ///< exponent n of a common factor 10^n of all labels; empty: none

    /// 0 at low, 1 at high.
    double share(double value) const;
    bool shows(double value) const;
};

/// `padding`: share of the range left free at each end. About `wanted` labelled ticks.
Axis make_axis(double low, double high, bool log, double padding, int wanted);
/// From exactly `low` to exactly `high`.
Axis make_fixed_axis(double low, double high, bool log, int wanted);
/// The categories stand at 1, 2, 3, ...; `downwards`: the first at the far end.
Axis make_category_axis(const std::vector<std::string>& categories, bool downwards);

}  // namespace hinge::output

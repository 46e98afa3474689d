// Selects the bars of a view and computes their drawn positions and changes of colour.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "output/framing.h"
#include "output/colours.h"
#include "output/picture.h"
#include "output/resultants.h"

namespace hinge::output {

struct DrawnBar {
    const Bar* bar;
    Shape shape;
    Vec a, b;         ///< its ends as drawn, m
    Vec up;           ///< the section's y axis, of unit length, across the bar
    Vec tangent[2];   ///< of its centreline at its ends, m; length: that of the straight bar
    Vec cut[2];       ///< normal of the plane that its end lies in, along the bar
    double reach[2];  ///< length drawn beyond its ends, to fill the corners where members meet, m
    bool curved;
    Resultants carries;

    double length() const { return output::length(b - a); }
    Vec at(double t) const;                                         ///< t from 0 to 1
    Vec direction(double t) const;                                  ///< of unit length
    Vec across(Vec along) const { return unit(cross(up, along)); }  ///< the section's x axis
    double half_size() const { return std::max(shape.width, shape.depth) / 2; }
};

struct DrawnBars {
    std::vector<DrawnBar> list;
    double scale;  ///< of displacements
};

/// Returns the bars of `snapshot` that `view` selects, without those whose ends are not finite. Throws InputError if
/// the view selects something that the snapshot does not have.
DrawnBars choose_bars(const Snapshot& snapshot, const View& view);

/// Of each group of `snapshot` whether `view` may draw one of its bars, now or in another state of the run.
std::vector<char> groups_of_view(const Snapshot& snapshot, const View& view);

/// Drawn position of a point.
Vec drawn_at(const Snapshot& snapshot, std::size_t point, double scale);

/// Adds the initial positions of the bars' ends.
void add_start(std::vector<Vec>& to, const Snapshot& snapshot, std::span<const DrawnBar> bars);

std::vector<Vec> ends_of(std::span<const DrawnBar> bars);

}  // namespace hinge::output

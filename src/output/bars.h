// The bars that a view shows: which, where they are drawn, and where their colours change.
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
    Vec tangent[2];   ///< of its centreline at its ends, m: as long as the bar would be if it were straight
    Vec cut[2];       ///< normal of the plane that its end lies in, along the bar
    double reach[2];  ///< so far beyond its ends it is drawn, to fill the corners where members meet, m
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

/// The bars of `snapshot` that `view` asks for, without those whose ends are not finite. Throws InputError where it
/// asks for what the snapshot does not have.
DrawnBars choose_bars(const Snapshot& snapshot, const View& view);

/// Where a point is drawn.
Vec drawn_at(const Snapshot& snapshot, std::size_t point, double scale);

/// Adds where the bars' ends were at the start.
void add_start(std::vector<Vec>& to, const Snapshot& snapshot, std::span<const DrawnBar> bars);

std::vector<Vec> ends_of(std::span<const DrawnBar> bars);

}  // namespace hinge::output

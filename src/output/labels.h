// Words beside the points and bars of a panel, where they cover least, and its legend (legend.cpp).
#pragma once

#include "output/curves.h"

namespace hinge::output {

/// Where a legend stands: in the corner where it hides least, or beside the frame where it would hide much in each.
class Legend {
public:
    Legend(const Axes& axes, const Curves& curves);

    /// What the frame must leave free at its right for it; 0: it stands inside.
    double room_beside() const;
    /// Once the frame has its final size. `beside`: at its right.
    void place(bool beside);
    const Box& box() const { return box_; }
    void draw() const;

private:
    Box best_corner(int& hidden) const;

    const Axes& axes_;
    const Curves& curves_;
    std::vector<std::size_t> listed_;  ///< series with a name
    double width_ = 0, height_ = 0, row_, sample_, pad_;
    TextStyle style_;
    Box box_;
};

/// Writes the labels of all series; they avoid each other, the dots, the curves and the legend where there is room.
void draw_labels(const Axes& axes, const Curves& curves, const Box& legend);

}  // namespace hinge::output

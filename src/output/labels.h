// Words beside the points and bars of a panel, where they cover least, and its legend (legend.cpp).
#pragma once

#include "output/curves.h"

namespace hinge::output {

/// Where a legend stands: inside the frame where it covers nothing, a corner if one is free. Else beside the frame, or
/// above it where it is too wide or too high for that.
class Legend {
public:
    Legend(const Axes& axes, const Curves& curves);

    /// Once the frame has a size: whether it needs another room outside than before, so that frames must be set anew.
    bool goes_outside();
    /// What the frame must leave free for it; 0: it stands elsewhere.
    double room_beside() const;
    double room_above() const;
    /// Once the frame has its final size.
    void place();
    const Box& box() const { return box_; }
    void draw() const;

private:
    enum class Where { inside, beside, above };
    double height() const;
    bool covers(const Drawn& drawn, const Box& box) const;
    std::optional<Box> free_place() const;
    std::size_t columns_above() const;

    const Axes& axes_;
    const Curves& curves_;
    std::vector<std::size_t> listed_;  ///< series with a name
    Where where_ = Where::inside;
    std::size_t rows_ = 0;
    double width_ = 0, entry_ = 0, row_, sample_, pad_;
    TextStyle style_;
    Box box_;
};

/// Writes the labels of all series; they avoid each other, the dots, the curves and the legend where there is room.
void draw_labels(const Axes& axes, const Curves& curves, const Box& legend);

}  // namespace hinge::output

// Curves cut at the frame of a plot.
#pragma once

#include <vector>

#include "output/pen.h"

namespace hinge::output {

/// A rectangle in pixels from the lower left corner of the picture.
struct Box {
    double left = 0, bottom = 0, right = 0, top = 0;
    bool holds(double x, double y, double slack = 0) const {
        return x >= left - slack && x <= right + slack && y >= bottom - slack && y <= top + slack;
    }
};

/// Area that two boxes share.
double shared_area(const Box& a, const Box& b);

/// The pieces of a curve that are inside the box.
std::vector<std::vector<Pixel>> clip(const std::vector<Pixel>& curve, const Box& box);

/// A strip between two curves with the same x, cut to the box: points are added where an edge crosses it.
struct Strip {
    std::vector<Pixel> low, high;
};
Strip clip(const Strip& strip, const Box& box);

/// Whether some of a curve, or of a strip, is inside the box. A curve of one point is a point.
bool crosses(const std::vector<Pixel>& curve, const Box& box);
bool crosses(const Strip& strip, const Box& box);

/// The curve with at most four points to each column of pixels; what is drawn stays the same.
std::vector<Pixel> thin(const std::vector<Pixel>& curve);

}  // namespace hinge::output

// Closest points of two straight segments, with a name for every degenerate position.
#pragma once

#include "core/types.h"

namespace hinge::contact {

/// Relative position of two segments at their closest points.
enum class Nearness {
    crossing,     ///< inside both: the connection is perpendicular to both axes
    end_on_side,  ///< the end of one, inside the other
    end_to_end,   ///< an end of each (collinear segments that do not overlap, corners)
    alongside,    ///< parallel, or on one line, over a stretch: the middle of the stretch is given
    point         ///< at least one of the two has no length
};

/// Closest points of two segments.
struct Closest {
    double s = 0, t = 0;          ///< where: a0 + s (a1 - a0) and b0 + t (b1 - b0), both in [0, 1]
    Vec3 between = Vec3::Zero();  ///< from the point on a to the point on b, m
    double distance = 0;          ///< its length, m
    Nearness kind = Nearness::crossing;
};

/// Closest points of the segments a0 a1 and b0 b1 (m).
Closest closest_points(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

/// The distance alone, m.
inline double distance(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    return closest_points(a0, a1, b0, b1).distance;
}

}  // namespace hinge::contact

// A polyhedron within the convex set of forces (Mx, My, N) that a section can carry: a bound that is quick to ask.
#pragma once

#include <functional>
#include <vector>

#include "section/outline.h"

namespace hinge::beam {

/// Polyhedron whose corners are on a convex surface about its centre: at each of some axial forces a polygon. Where the
/// surface is symmetric about the centre, one side of it is enough.
class InnerPolyhedron {
public:
    static constexpr int levels = 24;  ///< axial forces from 0 to 1
    /// Point (Mx, My) of the surface at an axial force n from 0 to 1, for a curvature in the direction `angle`, rad.
    using Slice = std::function<Eigen::Vector2d(double n, double angle)>;

    /// Adds a side of the surface: first that of N >= 0; then, where it is different, that of N <= 0 with the signs of
    /// all forces changed. `quarter`: the side is symmetric in the sign of Mx and in that of My, so that a quarter of
    /// it is computed.
    void add_side(const Slice& slice, bool quarter = false);

    /// The face in the direction of a moment at an axial force: at axial force n (0 to 1) and in the direction of m the
    /// radius is a mean of those of two levels, each on the side between two rays.
    struct Face {
        double times = 0;  ///< of m: the radius; at least 1 inside
        double radius[2] = {1, 0};
        Eigen::Vector2d slope[2];
        double part = 0;
    };
    /// `side`: the sign of N before the change of signs.
    Face face_at(double n, const Eigen::Vector2d& m, double side) const;

private:
    std::vector<double> inverse_;  ///< 1 over the radius, of each ray of each level of each side
};

}  // namespace hinge::beam

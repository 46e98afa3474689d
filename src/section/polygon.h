// Polygons of cross-sections: rounded corners, and the properties of their areas.
//
// Corners are counterclockwise, m. An arc becomes three straight pieces. The two points between its ends lie a little
// outside of its circle, so that the sector keeps its area and its centroid. Areas and plastic moduli are then exact
// where no neutral axis goes through an arc, and second moments are within 5e-5.
#pragma once

#include <vector>

#include "core/types.h"

namespace hinge::beam {

using Corners = std::vector<Eigen::Vector2d>;

/// A corner, m; `r`: radius by which it is rounded.
struct RoundedCorner {
    double x, y, r = 0;
};
Corners rounded(const std::vector<RoundedCorner>& corners);

/// A rectangle about the origin: b along x, d along y, with corners of radius r.
Corners rectangle(double b, double d, double r = 0);

/// Area, first moments and second moments, integrals of x^2, y^2 and x y, by Green's theorem.
struct AreaMoments {
    double A = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
};
AreaMoments moments_of(const Corners& corners);

/// The corners with the point (x, y) moved to the origin and turned by -angle: an axis at `angle` becomes x.
Corners moved(const Corners& corners, double x, double y, double angle = 0);

/// Plastic modulus of bending about the axis along which `k` (0: x, 1: y) does not run: the first moments on both sides
/// of the line that halves the area.
double plastic_modulus(const Corners& corners, int k);

/// Shear area along the principal axis `k` of an open thin-walled section: I^2 over the integral of S^2 / t.
///   path  its walls' middle lines, points from one free end to the other about the centroid
///   t     their thicknesses
double shear_area(const Corners& path, const std::vector<double>& t, int k);

}  // namespace hinge::beam

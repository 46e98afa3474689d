// Cross-sections by their dimensions: properties, outline, and the walls that carry shear forces.
//
// x and y are the section's axes, y along the member's `up`; all lengths in m. Each function throws InputError, whose
// message begins with `what`, where the dimensions are not possible.
//
// Shear areas: Cowper (1966) with Poisson's ratio 0, which is the area of equal shear strain energy. It gives the
// paper's 5/6 for the rectangle and needs no material.
#pragma once

#include <optional>
#include <string>

#include "section/outline.h"
#include "section/section.h"

namespace hinge {

/// A section's properties, and its outline about any point.
struct Shape {
    Section section;
    beam::Outline outline;
};

/// The section of a shape: with the outline about its centroid, checked (make_section_outline, complete_section).
/// Concrete: strengths of concrete and bars, at places of the shape's outline.
Section make_section(Shape shape, std::optional<beam::Reinforcement> concrete = {},
                     const std::string& what = "section");

/// Solid rectangle: width along x, depth along y.
struct SolidSizes {
    double width, depth;
};
Shape solid_shape(const SolidSizes& size);

/// Closed box: outer width and depth, `web` (the walls along y) and `flange`. r: outer radius of the corners; r_inner:
/// the inner one, by default r less the thicker wall, at least 0.
/// J and the plastic torque by Bredt: 4 Am^2 / sum(length / t), and 2 Am t with the thinnest wall. With r the middle
/// line has corners of the mean radius, and J also has the walls' own sum(length t^3) / 3, as in EN 10210-2, annex B.
struct BoxSizes {
    double width, depth, web, flange, r = 0;
    std::optional<double> r_inner = {};
};
Shape box_shape(const BoxSizes& size, const std::string& what = "section");

/// H, also called I or wide flange: outer depth and width, thickness of web and flange, root radius r of rolled ones.
/// The web lies along y, so Ix is the strong axis. J = sum b t^3 / 3 of the three plates; with r that of El Darwish and
/// Johnston (1965). Plastic torque: the sand-heap analogy for each plate, for the web without slopes at its ends. It
/// and the shear areas leave the fillets out. Shear along x: 5/6 of the flanges.
struct HSizes {
    double depth, width, web, flange, r = 0;
};
Shape h_shape(const HSizes& size, const std::string& what = "section");

/// H with flanges that taper by the slope 1 : 6, as S have them; flange: the mean thickness of a flange beside the web.
Shape tapered_h_shape(const HSizes& size, const std::string& what = "section");

/// Channel: the web along y, both flanges towards +x. slope: of the inner faces of the flanges, as UPN have it;
/// `flange` is then the thickness at the distance flange_at from the back, by default half the width. r: root radius;
/// r_toe: of the toes. J: El Darwish and Johnston, with the flanges' thickness at flange_at. Shear areas: of the walls'
/// middle lines. Forces act at the centroid: that the shear centre is elsewhere, behind the web, is not modelled.
struct ChannelSizes {
    double depth, width, web, flange, r = 0, r_toe = 0, slope = 0;
    std::optional<double> flange_at = {};
};
Shape channel_shape(const ChannelSizes& size, const std::string& what = "section");

/// Angle of two legs, `depth` and `width`. x and y are its principal axes: Ix is the larger moment (u-u of tables), and
/// the corner where the legs meet is on the side of -x. Legs of equal length make 45 degrees with x. r: root radius;
/// r_toe: of the toes. J: El Darwish and Johnston. Shear areas of the legs' middle lines. Forces act at the centroid:
/// that the shear centre is where the legs meet is not modelled.
struct AngleSizes {
    double depth, width, thickness, r = 0, r_toe = 0;
};
Shape angle_shape(const AngleSizes& size, const std::string& what = "section");

/// Two angles back to back: depth of the legs along y, which are back to back at the distance gap, width of the other
/// two, on top. They act as one section. J: twice that of an angle. Shear areas: of the legs.
struct DoubleAngleSizes {
    double depth, width, thickness, gap = 0;
};
Shape double_angle_shape(const DoubleAngleSizes& size, const std::string& what = "section");

/// Tee: the flange on top, the stem below it; depth with the flange, width of the flange, web the stem's thickness, r
/// the radius between the two. J: sum of b t^3 / 3. Shear areas: 5/6 of the flange and of the stem with the full depth.
struct TeeSizes {
    double depth, width, web, flange, r = 0;
};
Shape tee_shape(const TeeSizes& size, const std::string& what = "section");

/// Round tube by its outer diameter, and a solid circle. All values exact but the shear area (Cowper).
Shape pipe_shape(double diameter, double thickness, const std::string& what = "section");
Shape round_shape(double diameter);

}  // namespace hinge

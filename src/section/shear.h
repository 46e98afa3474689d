// What of a section carries shear forces, and how much of its bending strength depends on that (EN 1993-1-1 6.2.6 to
// 6.2.8).
#pragma once

#include <optional>

#include "section/laws/laws.h"
#include "section/section.h"

namespace hinge {

/// Plastic shear strength of a section, and how much of its bending strength depends on what carries the shear force.
struct ShearProperties {
    /// m^2 along x and along y, by EN 1993-1-1 6.2.6(3) with eta = 1: of an H, a box, a pipe (2 A / pi) and of solid
    /// sections (all of it); of others the shear area of the section.
    double area[2] = {0, 0};
    /// Part of the plastic modulus about y and about x that lies in that area: 1, or that of the webs of an H or a box
    /// whose sizes are known. Negative where it is not known.
    double share[2] = {-1, -1};
};
ShearProperties shear_properties(const Section& section);

/// The same as shapes, for the exact interaction with shear; none where they are not known. Of an H and a
/// channel the web between the flanges and the flanges; of a box the walls without its corners.
std::optional<beam::ShearCarried> shear_carried(const Section& section);

/// rho of EN 1993-1-1 6.2.8(3), the part of its strength that what carries the shear force loses beside v = V / V0.
double lost_by_shear(double v);

/// What torsion leaves of V0, by t = Mz / Mz0: EN 1993-1-1 6.2.7(9), of an H and of hollow sections. Of others, for
/// which it gives nothing, as of hollow ones.
double shear_left_by_torsion(const Section& section, double t);

}  // namespace hinge

// When an element breaks: eq 16.
#pragma once

#include <cmath>

#include "core/types.h"

namespace hinge::beam {

/// Strains of the element as eq 16 reads them; the same at every section, since only shear depends on the point.
struct FractureStrains {
    double curvature_x, curvature_y;  ///< 1/m
    double axial;                     ///< -
    double twist;                     ///< 1/m
};

/// d: deformation of the element (timoshenko.h), elastic and plastic; L: its length, m.
inline FractureStrains fracture_strains(const Vec6& d, double L) {
    return {(d[1] - d[0]) / L, (d[3] - d[2]) / L, d[4] / L, d[5] / L};
}

/// Eq 16: true when one of kappa_x/kappa_fx, kappa_y/kappa_fy, eps_z/eps_fz has reached 1. Bending and (unless
/// tension_only) axial strain count in both directions.
inline bool reached(const FractureStrains& e, double curvature_x, double curvature_y, double axial, bool tension_only) {
    return std::abs(e.curvature_x) >= curvature_x || std::abs(e.curvature_y) >= curvature_y ||
           (tension_only ? e.axial : std::abs(e.axial)) >= axial;
}

}  // namespace hinge::beam

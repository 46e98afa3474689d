// The linear Timoshenko beam element with one integration point that can move (paper, eqs 1-13). Its local axes, basic
// deformations d and basic forces p: section/stiffness.h. p are the same for every position s of the integration point:
// moving s changes the stiffness k(s), never p.
#pragma once

#include "section/stiffness.h"

namespace hinge::beam {

/// Position of the integration point that puts the stress evaluation points of a pair of elements at the Gauss points
/// of the member (eqs 11a and 11b): |s_g| = 2/sqrt(3) - 1.
inline constexpr double gauss_point = 0.15470053837925152902;

/// Stiffness k(s) of an element (eqs 5, 7a and 12a): K = L B(s)^T D B(s) in the frame of the chord, B of eq 2. The
/// curvature (t2 - t1)/L is constant in the element; the shear strain is the rotation interpolated at s, so only the
/// shear rows of B depend on s.
inline Stiffness stiffness(const Rigidity& c, double L, double s) {
    const double n1 = (1 - s) / 2, n2 = (1 + s) / 2;
    const double bx = c.EIx / L, by = c.EIy / L, qy = c.GAy * L, qx = c.GAx * L;
    return {bx + qy * n1 * n1,  -bx + qy * n1 * n2, bx + qy * n2 * n2, by + qx * n1 * n1,
            -by + qx * n1 * n2, by + qx * n2 * n2,  c.EA / L,          c.GJ / L};
}

/// Matrix of the basic deformations d (6) from nodal displacements (12) in local axes, to first order: rotations
/// relative to the chord.
inline Eigen::Matrix<double, 6, 12> linear_deformation(double L) {
    Eigen::Matrix<double, 6, 12> T = Eigen::Matrix<double, 6, 12>::Zero();
    for (int row : {0, 1}) {
        T(row, 1) = -1 / L;
        T(row, 7) = 1 / L;
    }
    T(0, 3) = 1;
    T(1, 9) = 1;
    for (int row : {2, 3}) {
        T(row, 0) = 1 / L;
        T(row, 6) = -1 / L;
    }
    T(2, 4) = 1;
    T(3, 10) = 1;
    T(4, 2) = -1;
    T(4, 8) = 1;
    T(5, 5) = -1;
    T(5, 11) = 1;
    return T;
}

/// The bending moment, at section r in -1..1, of the components (m1, m2) of p (eqs 9a-b and 13a-b): linear in r.
inline double moment_at(double m1, double m2, double r) { return -m1 * (1 - r) / 2 + m2 * (1 + r) / 2; }

}  // namespace hinge::beam

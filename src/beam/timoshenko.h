// The linear Timoshenko beam element with one integration point that can move (paper, eqs 1-13).
//
// Local axes: z from node 1 to node 2, y the member's `up`, x = y x z. Rotations about x bend in the y-z plane.
// The element's deformation, seen from a frame that moves with its chord, has six components, the basic deformations:
//   d = [tx1 tx2 ty1 ty2 e phi]   end rotations about x and y relative to the chord (rad), extension (m), twist (rad)
// and the basic forces p = [mx1 mx2 my1 my2 N Mz] do work on them (N m, N m, N m, N m, N, N m). At the ends, the
// section's bending moments are M(-1) = -m1 and M(+1) = +m2. They are the same for every position s of the integration
// point: moving s changes the stiffness k(s), never p.
#pragma once

#include "core/types.h"

namespace hinge::beam {

/// Position of the integration point that puts the stress evaluation points of a pair of elements at the Gauss points
/// of the member (eqs 11a and 11b): |s_g| = 2/sqrt(3) - 1.
inline constexpr double gauss_point = 0.15470053837925152902;

/// Rigidities and mass per length of a cross-section: N m^2 for EI and GJ, N for EA and GA, kg/m for rhoA, kg m for
/// rhoI.
struct Rigidity {
    double EIx = 0, EIy = 0, EA = 0, GJ = 0, GAx = 0, GAy = 0;
    double rhoA = 0, rhoIx = 0, rhoIy = 0;
};

/// The stiffness k(s) between d and p: two 2x2 blocks (bending about x, about y) and two numbers.
struct Stiffness {
    double x11, x12, x22;  ///< bending about x, N m
    double y11, y12, y22;  ///< bending about y, N m
    double axial;          ///< EA/L, N/m
    double twist;          ///< GJ/L, N m

    Vec6 times(const Vec6& d) const {  // eqs 3, 7c and 12c
        Vec6 p;
        p << x11 * d[0] + x12 * d[1], x12 * d[0] + x22 * d[1], y11 * d[2] + y12 * d[3], y12 * d[2] + y22 * d[3],
            axial * d[4], twist * d[5];
        return p;
    }
    Mat6 matrix() const {
        Mat6 m = Mat6::Zero();
        m(0, 0) = x11;
        m(0, 1) = m(1, 0) = x12;
        m(1, 1) = x22;
        m(2, 2) = y11;
        m(2, 3) = m(3, 2) = y12;
        m(3, 3) = y22;
        m(4, 4) = axial;
        m(5, 5) = twist;
        return m;
    }
    friend Stiffness operator*(double factor, Stiffness k) {
        for (double* of : {&k.x11, &k.x12, &k.x22, &k.y11, &k.y12, &k.y22, &k.axial, &k.twist}) *of *= factor;
        return k;
    }
    /// Determinants of the two bending blocks, (N m)^2.
    double determinant_x() const { return x11 * x22 - x12 * x12; }
    double determinant_y() const { return y11 * y22 - y12 * y12; }
    /// Elastic deformation d under the forces p.
    Vec6 solve(const Vec6& p) const {
        const double x = determinant_x(), y = determinant_y();
        Vec6 d;
        d << (x22 * p[0] - x12 * p[1]) / x, (x11 * p[1] - x12 * p[0]) / x, (y22 * p[2] - y12 * p[3]) / y,
            (y11 * p[3] - y12 * p[2]) / y, p[4] / axial, p[5] / twist;
        return d;
    }
    /// Flexibility matrix, the inverse of matrix(). Its products differ from solve by rounding.
    Mat6 flexibility() const {
        const double x = determinant_x(), y = determinant_y();
        Mat6 F = Mat6::Zero();
        F.block<2, 2>(0, 0) << x22 / x, -x12 / x, -x12 / x, x11 / x;
        F.block<2, 2>(2, 2) << y22 / y, -y12 / y, -y12 / y, y11 / y;
        F(4, 4) = 1 / axial;
        F(5, 5) = 1 / twist;
        return F;
    }
};

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

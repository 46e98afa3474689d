// Rigidities of a cross-section, and the elastic stiffness of an element against which its sections flow.
//
// Local axes: z from node 1 to node 2, y the member's `up`, x = y x z. Rotations about x bend in the y-z plane.
// The element's deformation, seen from a frame that moves with its chord, has six components, the basic deformations:
//   d = [tx1 tx2 ty1 ty2 e phi]   end rotations about x and y relative to the chord (rad), extension (m), twist (rad)
// and the basic forces p = [mx1 mx2 my1 my2 N Mz] do work on them (N m, N m, N m, N m, N, N m). At the ends, the
// section's bending moments are M(-1) = -m1 and M(+1) = +m2.
#pragma once

#include "core/types.h"

namespace hinge::beam {

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

}  // namespace hinge::beam

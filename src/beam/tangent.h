// Tangent stiffness of an element, the derivative of its nodal forces: elastic or plastic part, and geometric
// (initial-stress) part.
#pragma once

#include "beam/corotation.h"
#include "core/types.h"

namespace hinge::beam {

/// Derivative of a rotation vector t by a spin on top of it, 3 x 3; t in rad, less than a full turn.
Mat3 inverse_tangent(const Vec3& t);

/// Derivative of inverse_tangent(t)^T m by t for a fixed m, 3 x 3, in the unit of m.
Mat3 inverse_tangent_derivative(const Vec3& t, const Vec3& m);

/// Tangent stiffness d(nodal forces)/d(nodal displacements), 12 x 12, order [u1 t1 u2 t2], in space. Rotations are
/// spins (a small rotation applied on top of the present one). Exact; symmetric only where the nodal moments vanish or
/// balance, so a solver takes its symmetric part.
///   placement  position of the element (corotation.h)
///   p          forces on its deformation, N m and N
///   k          dp/dd, 6 x 6: elastic, or the algorithmic tangent of the return to the yield surface
///   geometric  false leaves out the initial-stress part
Mat12 tangent(const ElementFrame<double>& placement, const Vec6& p, const Mat6& k, bool geometric);

/// Stiffness for geometry fixed at the start (small displacement), 12 x 12: T^T k T with T to first order. `axes`: rows
/// are the local axes.
Mat12 linear_tangent(const Mat3& axes, double L, const Mat6& k);

}  // namespace hinge::beam

// Matrix functions without fused products, for files that are compiled with them (fused_files in CMakeLists.txt).
#pragma once

#include "beam/element_mass.h"
#include "core/types.h"

namespace hinge {

/// The inverse of a symmetric positive matrix from its 3x3 quarters, which Eigen inverts without loops.
Mat6 inverse_by_halves(const Mat6& A);
/// Mass matrix of an element; `axes`: columns are its local axes.
Mat12 inertia_matrix(const beam::Inertia& inertia, const Mat3& axes);

}  // namespace hinge

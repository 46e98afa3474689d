// Vector and matrix types of all parts of the engine.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

static_assert(
    EIGEN_MAX_ALIGN_BYTES == HINGE_ALIGNMENT,
    "hinge was built for another processor than this file is compiled for, and its types would not be laid out alike: "
    "take the flags of the CMake target hinge::engine, or build hinge with HINGE_NATIVE=OFF");

namespace hinge {

using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat12 = Eigen::Matrix<double, 12, 12>;
using Quat = Eigen::Quaterniond;

/// The skew matrix of v: skew(v) * w == v.cross(w).
inline Mat3 skew(const Vec3& v) {
    Mat3 m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

}  // namespace hinge

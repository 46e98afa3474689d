// A panel in its plane: a triangle or a quadrilateral between nodes in space, which has forces along its surface alone.
//
// With b_I the mean gradient of the shape function of node I over the panel and g_I the factors that find the part of
// xi eta in what is given at the nodes, the places of the nodes give F = sum x_I b_I^T (3 x 2) and q = sum g_I x_I. The
// mean strain is E = (F^T F + |q|^2 H - the same at the start) / 2, H the mean of the squared gradient of that
// function, and what varies over the panel follows p = F^T q, less its value at the start. Both are the same in any
// rotation of the panel, exactly. At a point the strain is E + P p: P is that of the stresses of Pian and Sumihara
// (1984), one along each direction of a quadrilateral that varies across it, so that it bends in its plane without
// locking. Where places are linear, p is zero and all points have the mean strain (patch test).
#pragma once

#include <span>

#include "core/types.h"

namespace hinge::panel {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;
using Mat32 = Eigen::Matrix<double, 3, 2>;
using Vec5 = Eigen::Matrix<double, 5, 1>;
using Mat5 = Eigen::Matrix<double, 5, 5>;
using Mat53 = Eigen::Matrix<double, 5, 3>;

/// Part of a panel that has a strain of its own.
struct Point {
    double area = 0;          ///< m^2
    Mat32 P = Mat32::Zero();  ///< d(strain)/dp, 1/m^2
    Mat32 S = Mat32::Zero();  ///< stress of each of the two that vary
};

/// Shape of a panel where it was declared.
struct Shape {
    int nodes = 4;
    double area = 0;               ///< m^2
    Mat3 axes = Mat3::Identity();  ///< columns: the sheet's x and y, the normal
    Vec2 b[4];                     ///< 1/m
    double g[4] = {};
    Mat32 F = Mat32::Zero();  ///< F and q at the start
    Vec3 q = Vec3::Zero();    ///< m
    Mat2 H = Mat2::Zero();    ///< 1/m^2
    double share[4] = {};     ///< of the area that is a node's, m^2
    int points = 1;
    Point point[4];
};

/// Shape of a panel between places in their order around it. `along`: direction of x, projected; zero for that of the
/// first side. `poisson`: of what bends it in its plane. Its area is not positive where the places enclose none, or
/// where a corner points inward.
Shape shape_of(std::span<const Vec3> places, const Vec3& along, double poisson);

/// Where a panel is: what its strains and forces follow from.
struct Placed {
    Mat32 F = Mat32::Zero();
    Vec3 q = Vec3::Zero();       ///< m
    Vec3 strain = Vec3::Zero();  ///< mean, [e11, e22, 2 e12]
    Vec2 p = Vec2::Zero();       ///< m
    bool large = true;
};

/// From the displacements of its nodes, m. Small displacement: strains are linear in them.
Placed place(const Shape& shape, std::span<const Vec3> moved, bool large);

/// Work of the panel's stresses per change of its mean strain and of p: N m, and N.
struct Resultants {
    Vec3 mean = Vec3::Zero();
    Vec2 varying = Vec2::Zero();
};

/// Forces of the nodes, N.
void add_forces(const Shape& shape, const Placed& at, const Resultants& r, std::span<Vec3> forces);

/// Derivative of the mean strain and of p by the place of a node.
Mat53 strain_gradient(const Shape& shape, const Placed& at, int node);

/// Derivative of the forces by the displacements. `of_strain`: d(resultants)/d(mean strain, p). f(I, J, K) is called
/// for I <= J, K in N/m.
template <class F>
void for_each_stiffness(const Shape& s, const Placed& at, const Resultants& r, const Mat5& of_strain, F f) {
    Mat53 B[4];
    for (int i = 0; i < s.nodes; ++i) B[i] = strain_gradient(s, at, i);
    const Mat2 N = (Mat2() << r.mean[0], r.mean[2], r.mean[2], r.mean[1]).finished();
    const double NH = (N.array() * s.H.array()).sum();
    for (int i = 0; i < s.nodes; ++i)
        for (int j = i; j < s.nodes; ++j) {
            Mat3 K = B[i].transpose() * of_strain * B[j];
            if (at.large)
                K.diagonal().array() += s.b[i].dot(N * s.b[j]) + NH * s.g[i] * s.g[j] + s.b[i].dot(r.varying) * s.g[j] +
                                        s.g[i] * s.b[j].dot(r.varying);
            f(i, j, K);
        }
}

}  // namespace hinge::panel

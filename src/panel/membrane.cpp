#include "panel/membrane.h"

#include <cmath>

namespace hinge::panel {
namespace {

constexpr double gauss = 0.57735026918962576;
constexpr double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

/// The plane through the middle of the panel: its normal is that of the diagonals, of a triangle that of two sides.
Mat3 axes_of(std::span<const Vec3> x, const Vec3& along) {
    const Vec3 normal = x.size() == 4 ? (x[2] - x[0]).cross(x[3] - x[1]) : (x[1] - x[0]).cross(x[2] - x[0]);
    const Vec3 n = normal.normalized();
    Vec3 first = along.isZero(0) ? Vec3(x[1] - x[0]) : along;
    first = (first - n.dot(first) * n).normalized();
    Mat3 axes;
    axes << first, n.cross(first), n;
    return axes;
}

/// Of a quadrilateral: the points of two by two, and P of each.
void set_points(Shape& s, const Vec2 at[4], double poisson) {
    Vec2 a = Vec2::Zero(), b = Vec2::Zero();  // along xi and eta in the middle
    for (int i = 0; i < 4; ++i) a += 0.25 * corner[i][0] * at[i], b += 0.25 * corner[i][1] * at[i];
    s.points = 4, s.area = 0;
    Vec2 natural[4], gradient[4], mean = Vec2::Zero();
    for (int k = 0; k < 4; ++k) {
        natural[k] = gauss * Vec2(corner[k][0], corner[k][1]);
        Mat2 J = Mat2::Zero();  // d(place)/d(natural)
        for (int i = 0; i < 4; ++i) {
            const double xi = corner[i][0], eta = corner[i][1];
            J.col(0) += 0.25 * xi * (1 + eta * natural[k][1]) * at[i];
            J.col(1) += 0.25 * eta * (1 + xi * natural[k][0]) * at[i];
        }
        s.point[k].area = J.determinant();
        s.area += s.point[k].area;
        mean += s.point[k].area * natural[k];
        for (int i = 0; i < 4; ++i)
            s.share[i] +=
                0.25 * (1 + corner[i][0] * natural[k][0]) * (1 + corner[i][1] * natural[k][1]) * s.point[k].area;
        gradient[k] = J.transpose().inverse() * Vec2(natural[k][1], natural[k][0]);  // of xi eta
    }
    mean /= s.area;
    const auto strain_along = [&](const Vec2& d) {  // of a stress along d, that has the strain 1 along it
        const double dd = d.squaredNorm();
        Vec3 e = {d[0] * d[0], d[1] * d[1], 2 * d[0] * d[1]};
        e *= 1 + poisson;
        e.head<2>().array() -= poisson * dd;
        return Vec3(e / (dd * dd));
    };
    const Vec3 e_a = strain_along(a), e_b = strain_along(b);
    // work of each of the two stresses on the strain that p gives, and on its own
    Vec2 by_a = Vec2::Zero(), by_b = Vec2::Zero();
    double own_a = 0, own_b = 0;
    for (int k = 0; k < 4; ++k) {
        const double w = s.point[k].area, across_a = natural[k][1] - mean[1], across_b = natural[k][0] - mean[0];
        by_a += w * across_a * gradient[k].dot(a) * a, by_b += w * across_b * gradient[k].dot(b) * b;
        own_a += w * across_a * across_a, own_b += w * across_b * across_b;
        s.H += w * gradient[k] * gradient[k].transpose();
    }
    s.H /= s.area;
    for (int k = 0; k < 4; ++k) {
        const double across_a = natural[k][1] - mean[1], across_b = natural[k][0] - mean[0];
        s.point[k].P = across_a / own_a * e_a * by_a.transpose() + across_b / own_b * e_b * by_b.transpose();
        s.point[k].S << across_a * Vec3(a[0] * a[0], a[1] * a[1], a[0] * a[1]),
            across_b * Vec3(b[0] * b[0], b[1] * b[1], b[0] * b[1]);
    }
}

}  // namespace

Shape shape_of(std::span<const Vec3> x, const Vec3& along, double poisson) {
    Shape s;
    s.nodes = int(x.size());
    s.axes = axes_of(x, along);
    Vec2 at[4];
    Vec3 middle = Vec3::Zero();
    for (const Vec3& place : x) middle += place / double(x.size());
    for (int i = 0; i < s.nodes; ++i) at[i] = s.axes.leftCols<2>().transpose() * (x[i] - middle);
    const auto cross = [](const Vec2& u, const Vec2& v) { return u[0] * v[1] - u[1] * v[0]; };
    const bool quad = s.nodes == 4;
    const double twice = quad ? cross(at[2] - at[0], at[3] - at[1]) : cross(at[1] - at[0], at[2] - at[0]);
    s.area = 0.5 * twice;
    for (int i = 0; i < s.nodes; ++i)
        if (!(cross(at[(i + 1) % s.nodes] - at[i], at[(i + 2) % s.nodes] - at[i]) > 0)) s.area = -1;
    if (!(s.area > 0)) return s;
    for (int i = 0; i < s.nodes; ++i) {
        const Vec2 across = quad ? Vec2(at[(i + 1) % 4] - at[(i + 3) % 4]) : Vec2(at[(i + 1) % 3] - at[(i + 2) % 3]);
        s.b[i] = Vec2(across[1], -across[0]) / twice;
    }
    if (quad) {
        Vec2 twisted = Vec2::Zero();
        for (int i = 0; i < 4; ++i) twisted += corner[i][0] * corner[i][1] * at[i];
        for (int i = 0; i < 4; ++i) s.g[i] = 0.25 * (corner[i][0] * corner[i][1] - twisted.dot(s.b[i]));
        set_points(s, at, poisson);
    } else {
        s.point[0].area = s.area;
        for (double& share : std::span(s.share).first<3>()) share = s.area / 3;
    }
    for (int i = 0; i < s.nodes; ++i) s.F += x[i] * s.b[i].transpose(), s.q += s.g[i] * x[i];
    return s;
}

Placed place(const Shape& s, std::span<const Vec3> moved, bool large) {
    Placed at;
    at.large = large;
    const Mat32& F0 = s.F;
    const Vec3& q0 = s.q;
    Mat32 dF = Mat32::Zero();
    Vec3 dq = Vec3::Zero();
    for (int i = 0; i < s.nodes; ++i) dF += moved[i] * s.b[i].transpose(), dq += s.g[i] * moved[i];
    at.F = large ? Mat32(F0 + dF) : F0;
    at.q = large ? Vec3(q0 + dq) : q0;
    // the change alone: of places far from the origin little would be left of a difference
    const Mat2 first = F0.transpose() * dF;
    Mat2 E = 0.5 * (first + first.transpose());
    at.p = F0.transpose() * dq + dF.transpose() * q0;
    if (large) {
        E += 0.5 * (dF.transpose() * dF + (2 * q0.dot(dq) + dq.squaredNorm()) * s.H);
        at.p += dF.transpose() * dq;
    } else {
        E += q0.dot(dq) * s.H;
    }
    at.strain = {E(0, 0), E(1, 1), 2 * E(0, 1)};
    return at;
}

Mat53 strain_gradient(const Shape& s, const Placed& at, int i) {
    Mat53 B;
    const Vec3 f0 = at.F.col(0), f1 = at.F.col(1), gq = s.g[i] * at.q;
    B.row(0) = s.b[i][0] * f0, B.row(1) = s.b[i][1] * f1;
    B.row(2) = s.b[i][1] * f0 + s.b[i][0] * f1;
    B.row(0) += s.H(0, 0) * gq, B.row(1) += s.H(1, 1) * gq, B.row(2) += 2 * s.H(0, 1) * gq;
    for (int a : {0, 1}) B.row(3 + a) = s.g[i] * at.F.col(a) + s.b[i][a] * at.q;
    return B;
}

void add_forces(const Shape& s, const Placed& at, const Resultants& r, std::span<Vec3> forces) {
    const Mat2 N = (Mat2() << r.mean[0], r.mean[2], r.mean[2], r.mean[1]).finished();
    const Mat32 FN = at.F * N;
    const Vec3 of_q = (N.array() * s.H.array()).sum() * at.q + at.F * r.varying;
    for (int i = 0; i < s.nodes; ++i) forces[i] += FN * s.b[i] + s.g[i] * of_q + r.varying.dot(s.b[i]) * at.q;
}

}  // namespace hinge::panel

// The forces that a cross-section can carry at its yield stress: the exact interaction of N, Mx and My.
//
// A section flows at the plastic strain e + kx y - ky x, where it yields in tension on one side of the neutral axis and
// in compression on the other. The work of that, per length, is the support function
//
//   h(kx, ky, e) = integral of |e + kx y - ky x| over the area
//
// and its gradient is the point (Mx, My, N) of the surface whose normal is (kx, ky, e). Area and first moments on each
// side of the neutral axis are closed forms for polygons and circles, so that nothing is approximated. The domain is
// convex. It has one corner, at N alone, and no other where the outline has no thin parts of no area.
//
// Forces are normalised: N/N0, Mx/Mx0, My/My0, with N0 = fy A, Mx0 = fy Zx, My0 = fy Zy; strains are what does work on
// them. Zx and Zy are those of the neutral axis along x and along y that halves the area: moments at N = 0. Where the
// section has no symmetry, the other moment is not zero there.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "core/types.h"

namespace hinge::beam {

/// Outline of a cross-section, m. Its axes go through the centroid of the area: x and y of the member.
struct Outline {
    struct Polygon {
        std::vector<Eigen::Vector2d> corners;  ///< in either direction of rotation
        bool hole = false;
    };
    struct Circle {
        Eigen::Vector2d centre = Eigen::Vector2d::Zero();
        double radius = 0;
        bool hole = false;
    };
    std::vector<Polygon> polygons;
    std::vector<Circle> circles;

    /// Area, m^2, and its centroid, m.
    double area() const;
    Eigen::Vector2d centroid() const;
    void move(const Eigen::Vector2d& by);
};

class PlasticDomain {
public:
    /// `outline`: its centroid is the origin.
    explicit PlasticDomain(const Outline& outline);

    /// h of the strain v = (kx, ky, e); `point`: its gradient (Mx, My, N); `curvature`, unless null: its second
    /// derivatives, positive semidefinite, zero along v.
    double support(const Vec3& v, Vec3& point, Mat3* curvature = nullptr) const;

    /// The gauge of the forces q = (Mx, My, N): 1 on the surface, proportional to q. `normal`, unless null: the strain
    /// whose point is q / gauge, with h = 1. `error`, unless null: what the gauge is at most above the number returned,
    /// which it is never below, but for rounding; 0 where the point was found to 1e-12. Beside the corner at N alone
    /// the direction of a force may have too few digits for that.
    double gauge(const Vec3& q, Vec3* normal = nullptr, double* error = nullptr) const;

    /// The point of the contour at axial force n = N/N0, -1 < n < 1, for a curvature in the direction `angle` (0: about
    /// x; pi/2: about y).
    Eigen::Vector2d contour(double n, double angle) const;

    /// True only if q is inside: a polyhedron within the surface, quick to ask. For n up to 0.95 it reaches to within
    /// 1 % of the surface for 99 % of all directions, and to within 6 % for each. `normal`, unless null: about the
    /// strain whose point is near q.
    bool surely_inside(const Vec3& q, Vec3* normal = nullptr) const;

    /// An ellipsoid within the surface: its half axes (Mx, My, N).
    const Vec3& ellipsoid() const { return ellipsoid_; }

    /// Area, m^2, and fully plastic moduli about x and y, m^3.
    double area() const { return area_; }
    const Eigen::Vector2d& moduli() const { return modulus_; }

private:
    struct Sums;
    struct Polygon {
        std::vector<Eigen::Vector2d> corners;  ///< counterclockwise; clockwise: a hole
        double area;                           ///< negative: a hole
        Eigen::Vector2d moment;
    };
    struct Circle {
        Eigen::Vector2d centre;
        double radius, sign;
    };
    static void add(const Polygon& part, Sums& sums);
    static void add(const Circle& part, Sums& sums);
    void add_parts(Sums& sums) const;
    double find_gauge(const Vec3& to, Vec3& v, double& missed) const;
    void make_polyhedron();
    void make_ellipsoid();
    double farthest() const;  ///< of the outline from the centroid, m

    std::vector<Polygon> polygons_;
    std::vector<Circle> circles_;
    double area_ = 0;
    Eigen::Vector2d modulus_ = Eigen::Vector2d::Zero();
    Vec3 scale_ = Vec3::Ones();    ///< from normalised strains to 1/m, and from moments to normalised ones
    std::vector<double> inverse_;  ///< 1 over the radius, of each ray of each level
    Vec3 ellipsoid_ = Vec3::Zero();
};

/// An outline whose domain is computed when it is first asked for, and once.
class SectionOutline {
public:
    explicit SectionOutline(Outline outline) : outline_(std::move(outline)) {}
    const Outline& outline() const { return outline_; }
    std::shared_ptr<const PlasticDomain> domain() const {
        std::call_once(once_, [this] { domain_ = std::make_shared<const PlasticDomain>(outline_); });
        return domain_;
    }

private:
    Outline outline_;
    mutable std::once_flag once_;
    mutable std::shared_ptr<const PlasticDomain> domain_;
};

}  // namespace hinge::beam

// The forces that a cross-section can carry at its strength: the exact interaction of N, Mx and My, of steel and of
// reinforced concrete.
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
//
// Concrete has the stress -fc where it shortens and none where it lengthens. Its work fc max(0, -strain) is that of a
// material of the yield stress fc / 2 in tension and in compression, less fc / 2 times the strain. So is that of a bar:
// it has the mean of its two strengths, and a stress that is always there. Hence
//
//   h = (fc / 2) (integral of |strain| over the outline and, weighted, over the bars) + centre . strain
//
// The domain is that of an outline with heavier parts, moved to `centre`: symmetric about that point, not about zero.
// A bar is a disc of its area. A line without breadth would make flat faces on the surface, where the flow could not
// tell the point. The concrete that bars displace carries nothing. N0 is half of the range of N, and Mx0 and My0 are
// the moments beyond those of the centre at its N.
//
// Concrete with strains has the support function of ultimate_states.h instead. Its domain is not symmetric about the
// centre, the middle of the line between both ends of N.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "section/inner_polyhedron.h"
#include "section/ultimate_states.h"

namespace hinge::beam {

/// The convex set of forces (Mx, My, N) that a section can carry, by its support function.
class PlasticDomain {
public:
    class Walls;
    /// Walls of a doubly symmetric section that have lost a part of their strength, as shear forces make them: those
    /// along x and those along y, 0 to less than 1.
    struct Lost {
        const Walls* walls;
        double part[2];
    };

    /// `outline`: its centroid is the origin. `concrete`: null for a material of one yield stress.
    explicit PlasticDomain(const Outline& outline, const Reinforcement* concrete = nullptr);

    /// h of the strain v = (kx, ky, e); `point`: its gradient (Mx, My, N); `curvature`, unless null: its second
    /// derivatives, positive semidefinite, zero along v.
    /// `lost`: of walls, null for none; so in what follows. Forces are normalised by the whole section's.
    double support(const Vec3& v, Vec3& point, Mat3* curvature = nullptr, const Lost* lost = nullptr) const;

    /// The gauge of the forces q = (Mx, My, N): 1 on the surface, proportional to q. `normal`, unless null: the strain
    /// whose point is q / gauge, with h = 1. `error`, unless null: what the gauge is at most above the number returned,
    /// which it is never below, but for rounding; 0 where the point was found to 1e-12. Beside the corner at N alone
    /// the direction of a force may have too few digits for that.
    /// `limit`: the search ends earlier, with an error that may be larger, where the gauge is known to be above it or
    /// not.
    double gauge(const Vec3& q, Vec3* normal = nullptr, double* error = nullptr,
                 double limit = std::numeric_limits<double>::infinity(), const Lost* lost = nullptr) const;

    /// The point of the contour at axial force n = N/N0, between the least and the largest, for a curvature in the
    /// direction `angle` (0: about x; pi/2: about y).
    Eigen::Vector2d contour(double n, double angle) const;

    /// True only if q is inside: a polyhedron within the surface, quick to ask. For n up to 0.95 it reaches to within
    /// 1 % of the surface for 99 % of all directions, and to within 6 % for each. `normal`, unless null: about the
    /// strain whose point is near q.
    bool surely_inside(const Vec3& q, Vec3* normal = nullptr, const Lost* lost = nullptr) const;

    /// About the strain whose point is in the direction of the forces; quick.
    Vec3 about_normal(const Vec3& forces) const;

    /// An ellipsoid about zero within the surface: its half axes (Mx, My, N).
    const Vec3& ellipsoid() const { return ellipsoid_; }

    /// Area, m^2, and fully plastic moduli about x and y, m^3. Of concrete: with the bars by their weight.
    double area() const { return area_; }
    const Eigen::Vector2d& moduli() const { return modulus_; }

    bool concrete() const { return stress_ > 0; }
    /// Of concrete: Mx0, My0 (N m), N0 (N), by which its forces are normalised.
    Vec3 strength() const { return stress_ * Vec3(modulus_[0], modulus_[1], area_); }
    /// The point about which the domain of ideal plasticity is symmetric: (Mx, My, N), zero but for concrete.
    const Vec3& centre() const { return centre_; }

private:
    struct Sums;
    using Polygon = std::vector<Eigen::Vector2d>;  ///< counterclockwise; clockwise: a hole
    struct Circle {
        Eigen::Vector2d centre;
        double radius, weight;  ///< -1: a hole
    };
    /// All polygons as one list of corners; each ends with its first corner. An edge goes from one corner to the next.
    struct Edges {
        std::vector<double> x, y, weight;  ///< weight: 0 from one polygon to the next, else 1
        double area = 0, farthest = 0;     ///< farthest: largest distance of a corner from the origin, m
        Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    };
    static void add_polygon(Polygon corners, bool hole, Edges& to);
    static void pad(Edges& edges);
    static void add(const Edges& edges, Sums& sums);
    static void add(const Circle& part, Sums& sums);
    void add_parts(Sums& sums) const;
    double find_gauge(const Vec3& to, Vec3& v, double& missed, double limit, const Lost* lost, bool alone) const;
    void set_scale();
    void set_states(const Outline& outline, const Reinforcement& concrete);
    Vec3 about_centre(const Vec3& forces, double& side) const;
    Eigen::Vector2d slice(double n, double angle) const;
    bool doubly_symmetric() const;
    void make_polyhedron();
    void make_ellipsoid();
    void make_ellipsoid_of_concrete();
    double farthest() const;  ///< of the outline from the centroid, m

    Edges edges_;
    std::vector<Circle> circles_;
    double area_ = 0;
    Vec3 total_ = Vec3::Zero();     ///< twice the sums that are left on the positive side at pure compression
    Vec3 weighted_ = Vec3::Zero();  ///< sums over the area
    double stress_ = 0;             ///< Pa, half of the concrete's strength; 0: no concrete
    Eigen::Vector2d modulus_ = Eigen::Vector2d::Zero();
    Vec3 scale_ = Vec3::Ones();  ///< from normalised strains to 1/m, and from moments to normalised ones
    InnerPolyhedron polyhedron_;
    Vec3 ellipsoid_ = Vec3::Zero();
    Vec3 centre_ = Vec3::Zero();
    Eigen::Vector2d end_ = Eigen::Vector2d::Zero();  ///< moments beyond the centre's at pure tension
    std::shared_ptr<const UltimateStates> states_;   ///< null: the domain of ideal plasticity
    Vec3 of_states_ = Vec3::Ones();                  ///< strength of the states over that of the domain
};

/// Walls that carry shear forces, within the outline of their section: those along x, those along y.
class PlasticDomain::Walls {
public:
    using Polygons = std::array<std::vector<Outline::Polygon>, 2>;
    explicit Walls(const Polygons& walls);

private:
    friend class PlasticDomain;
    Edges edges_[2];
};

}  // namespace hinge::beam

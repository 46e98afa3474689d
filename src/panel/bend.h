// Bending of panels about a node that they share, from the places of the nodes alone.
//
// Where two sides of panels go on in one line through a node, the change of slope along it is a second derivative of
// the surface; a quadrilateral gives the mixed one, its part of xi eta. Each is a vector d = sum w_j x_j, of which the
// part along the surface's normal n counts: k = n . d. The two lines and the mixed derivative give the curvature of the
// surface at the node (finite differences of a plate), and its area around the node gives the moments their work. What
// follows are forces without resultant and without moment: k does not change where the surface moves as a rigid body.
// An edge of the floor rests without moment on what carries it, and goes on over a beam between two panels.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "core/types.h"

namespace hinge::panel {

/// Bending of a plate: elastic up to a moment per length in the directions of principal moments (Johansen's criterion).
/// Moments are positive where the side that n points away from is in tension.
struct BendingLaw {
    double stiffness = 0;  ///< D, N m; 0: does not bend
    double poisson = 0;
    double sagging = std::numeric_limits<double>::infinity(), hogging = sagging;  ///< N m/m
    bool is_elastic() const { return !std::isfinite(sagging) && !std::isfinite(hogging); }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.stiffness, s.poisson, s.sagging, s.hogging);
    }
};

/// What a plate answers to a curvature [k11, k22, 2 k12], 1/m. Kept, before and after: plastic curvature, moments.
struct BendingResponse {
    Vec3 moment = Vec3::Zero();  ///< [m11, m22, m12], N m/m
    Mat3 tangent = Mat3::Zero();
    double stored = 0, dissipated = 0;  ///< J/m^2
};
inline constexpr int bending_history = 6;
BendingResponse bend(const BendingLaw& law, const Vec3& curvature, const double* before, double* after,
                     bool with_tangent = true);

/// Panels around a node: indices of their corners in a list of places, which has the node itself in front.
struct Bend {
    std::vector<int> nodes;                     ///< of the model; the first is the one that it is about
    std::vector<std::array<double, 3>> weight;  ///< of each in the two second derivatives and the mixed one, 1/m^2
    std::vector<std::array<int, 4>> around;     ///< corners of each panel, by their places in `nodes`; -1: a triangle
    Mat3 to_frame = Mat3::Zero();               ///< curvature from those three, in the frame
    Mat3 frame = Mat3::Identity();              ///< columns: its first and second axis, the normal
    double area = 0;                            ///< m^2
    Vec3 start = Vec3::Zero();                  ///< those three where the panels are declared
    std::vector<int> panels;                    ///< of the model
};

/// A panel as the others see it.
struct Corners {
    std::span<const int> nodes;  ///< three or four
    double area;                 ///< m^2
    double poisson;
};

/// Bends at the nodes of these panels. `place`: of each node of the model, m. Throws InputError where four panels close
/// a ring around a node, and their sides do not go on in two lines there: nothing would bend.
std::vector<Bend> bends_of(std::span<const Corners> panels, std::span<const Vec3> place);

/// Where a bend is.
struct Bent {
    Vec3 normal, sum;  ///< of unit length; the sum of the panels' normals, m^2
    Vec3 d[3];         ///< the three derivatives, 1/m
    Vec3 derivative;   ///< their parts along the normal, less those at the start
};
/// `places`: of its nodes. Small displacement: `moved` from there, with the normal at the start.
Bent bent(const Bend& bend, std::span<const Vec3> places, std::span<const Vec3> moved, bool large);

/// Derivatives of the three by the places of its nodes: 3 rows, three columns a node.
using Gradient = Eigen::Matrix<double, 3, Eigen::Dynamic>;
Gradient gradient(const Bend& bend, const Bent& at, std::span<const Vec3> places, bool large);
/// The same times `moment`, work per change of the three, N m^2: forces of its nodes, N.
void add_forces(const Bend& bend, const Bent& at, std::span<const Vec3> places, bool large, const Vec3& moment,
                std::span<Vec3> forces);

}  // namespace hinge::panel

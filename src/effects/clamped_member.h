// Corrects lumped nodal loads to exact fixed-end moments.
//
// In a clamped member the nodes' parts give other end moments than the load does. So the member's two end nodes get the
// difference to the fixed-end moments of the whole Timoshenko member, with the two shear forces that keep it in
// balance. End forces are then exact, and displacements of joints as exact as the stiffness between them is: closed
// form with pairs of asi-gauss elements. A member with a broken element has no correction.
#pragma once

#include <utility>
#include <vector>

#include "beam/beam_column.h"
#include "effects/reports.h"
#include "state/configuration.h"

namespace hinge {

/// First element of each member and one past its last.
std::vector<std::pair<int, int>> elements_of_members(const Structure& structure);

/// Three points of Gauss, 0 to 1, and what they count: exact for a linear load on a cubic.
extern const double gauss_point[3], gauss_weight[3];

/// A member with both ends clamped, from its closed form and from its elements. Planes: 0 bends about x, 1 about y.
/// Ends are 0 and 1. Moments per unit of the load, in the member's axes.
class ClampedMember {
public:
    ClampedMember(const Structure& structure, int first, int end);

    /// The fixed-end moment of a force at xi (0 to 1) along y (plane 0) or x, m; of a moment there, about the same
    /// axis.
    double of_force(int end, int plane, double xi) const;
    double of_moment(int end, int plane, double xi) const;

    /// The part of a unit load on node k (0 to n), in one of six directions, that arrives at the ends' component `to`
    /// (0 to 11) through the elements.
    double arrives(int k, int direction, int to) const {
        if (k == 0) return direction == to;
        if (k == n_) return 6 + direction == to;
        return carried_(6 * (k - 1) + direction, to);
    }

private:
    int n_;
    double length_, phi_[2];
    Eigen::MatrixXd carried_;
};

/// A member's elements and the moments that its end nodes get, N m.
struct MemberEnds {
    int first, count;  ///< elements

    bool whole(const State& state) const {
        for (int i = first; i < first + count; ++i)
            if (state.broken[i]) return false;
        return true;
    }
    /// The member's axes, and the way from its first to its second end, m.
    struct Chord {
        Mat3 axes;
        Vec3 span;
    };
    Chord chord(const Structure& structure, const Pose& at) const;
    /// Its axes alone, in a third of the time: by the mean of the y axes at its ends.
    Mat3 axes(const Structure& structure, const Pose& at) const;

    /// Calls add(node, force and moment in space) for moments m at the two ends, in space.
    template <class Add>
    void pass_on(const Structure& structure, const Vec3& span, const Vec3 m[2], Add add) const {
        const Vec3 shear = span.cross(m[0] + m[1]) / span.squaredNorm();
        Vec6 f;
        f << -shear, m[0];
        add(structure.elements()[first].node[0], f);
        f << shear, m[1];
        add(structure.elements()[first + count - 1].node[1], f);
    }
    /// The moment that such moments, in the member's axes, are in a section at an end (0, 1) of an element.
    Vec3 moment_at(int element, int end, const Vec3 m[2]) const {
        const double xi = double(element - first + end) / count;
        return (1 - xi) * m[0] - xi * m[1];
    }
    /// Section forces by such moments, in the member's axes, at an end (0, 1) of an element.
    void add_section_forces(int element, int end, double length, const Vec3 m[2], SectionForces& forces) const;
};

/// Forces on a pair of elements as sums over their places x, -1 to 1 over the pair: of f x^2k, f x^(2k+1) and
/// f |x|^(2k+1). What N does with them is a series in p of PressedPair, for |p| up to 6.5 to rounding.
struct PairForces {
    static constexpr int terms = 12;
    Vec3 even[terms], odd[terms], side[terms];  ///< N
    PairForces();
    void add(const Vec3& force, double x);
};

/// |p| of PressedPair below which it is taken as none, and from which on it counts in full.
inline constexpr double counts_from = 0.02, counts_in_full = 0.04;

/// p of PressedPair as far as it counts.
template <class Real>
[[gnu::always_inline]] inline Real counted(Real p) {
    const auto c = [&](double v) { return spread(v, p); };
    p = p > c(beam::pair_most) ? c(beam::pair_most) : p;
    Real part = ((p < c(0) ? -p : p) - c(counts_from)) * c(1 / (counts_in_full - counts_from));
    part = part < c(0) ? c(0) : part;
    part = part > c(1) ? c(1) : part;
    return p * part * part * (c(3) - c(2) * part);
}

/// Changes of a pair's fixed-end moments by its axial force N (p_delta = "member"; nothing in all
/// other models). Between clamped ends the exact beam-column under a load has other end moments than the beam without
/// N. With p = -N l^2 / EI, u^2 = p and A of beam/beam_column.h (l: one element, x from the middle of the pair):
///
///   even load q                   q l^2 / 3 / A                    (3 (tan u - u) / (u^2 tan u) times q L^2 / 12)
///   load q x / l                  q l^2 (1 - A) / p                (q l^2 / 15 at p = 0)
///   force at x                    deflection there where that end rotates by one (Betti):
///       symmetric rotation        (cos u x/l - cos u) l / (u sin u)
///       antisymmetric rotation    (sin u x/l - x/l sin u) l / (u cos u - sin u)
///
///   moment at x                   the beam's rotation there, the derivative of that deflection
///
/// in tension the same with hyperbolic functions. Closed form for beams that are stiff in shear. p counts up to 6, as
/// in the law of pairs; below 0.02 it is taken as none, where the moments change by less than 0.2 %, and in full from
/// 0.04 on. The axial force does not follow from an energy with these moments in it: their work is the load's. The
/// moment in the middle of the pair has a part of the load, too (beam/pair_bow.h).
class PressedPair {
public:
    /// `force`: p of all elements; `heat`: of all elements, or empty.
    PressedPair(const Structure& structure, int first, const std::vector<Vec6>& force, const ElementHeats& heat);
    bool counts() const { return p_[0] != 0 || p_[1] != 0; }
    /// The change at an end (0, 1) about the axis of the plane (0: x, 1: y), N m: by a load per length, q[0] at the
    /// first and q[1] at the second end, N/m, linear between, along y (plane 0) or x.
    double of_spread(int end, int plane, const double (&q)[2]) const;
    /// The same at the first end by an even load, N/m; the opposite at the second.
    double of_even(int plane, double q) const;
    /// By a unit force there, m, and by a unit moment about the axis of the plane; x: -1 to 1 over the pair.
    double of_force(int end, int plane, double x) const;
    double of_couple(int end, int plane, double x) const;
    /// Difference of the moment in the middle and that at the node, with the section's sign, N m: by the mean q, N/m,
    /// of a load per length; by a unit force, m.
    double middle_of_spread(int plane, double q) const;
    double middle_of_force(int plane, double x) const;
    double middle_of_couple(int plane, double x) const;
    /// Whether the series of PairForces hold in a plane.
    bool is_mild(int plane) const { return std::abs(p_[plane]) <= 6.5; }
    /// Adds what forces do, by their components along `across`: to the ends' moments and to that in the middle.
    void add_forces(int plane, const PairForces& forces, const Vec3& across, double (&ends)[2], double& middle) const;

private:
    double l_, p_[2], more_[2];
};

/// Of an element, along its chord.
Vec3 direction_of(const Structure& structure, int element, const Pose& at);

/// The forces of a section at an end of an element balance what its node got of the load: in the element's axes.
void add_share(double side, const Vec3& force, const Vec3& moment, SectionForces& forces);

}  // namespace hinge

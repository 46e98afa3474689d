// Geometry of the contact rule `gap`: eqs 17-19 of the paper, at an instant and over a step.
//
// Symbols as in the paper: A1, A2 the ends of one element, B1, B2 those of the other; L_c, L_i their lengths; C_l the
// contact length (a factor); alpha the coplanarity tolerance. All lengths in m, f and alpha in m^3.
#pragma once

#include "contact/segments.h"
#include "core/types.h"

namespace hinge::contact {

/// End points of two bars at an instant, m.
struct BarPair {
    Vec3 a[2], b[2];
};

inline Closest closest_points(const BarPair& two) { return closest_points(two.a[0], two.a[1], two.b[0], two.b[1]); }

/// Eq 17: f = (B1 - A2) x (B2 - A2) . (A1 - A2), six times the volume of the tetrahedron of the four end points.
/// For any point p on the axis of a and q on the axis of b it equals (q - p) . (A2 - A1) x (B2 - B1).
double coplanarity(const BarPair& two);

/// Eq 18, left side: |A1B1| + |A1B2| + |A2B1| + |A2B2|.
double spread(const BarPair& two);

/// Eq 18: spread <= C_l (L_c + L_i).
bool within_contact_length(const BarPair& two, double contact_length);

/// Eq 19, |f| <= alpha. (Printed without the bars; a signed f would let half of all approaches through from any
/// distance.)
bool coplanar(const BarPair& two, double alpha, bool signed_f = false);

/// Motion of two bars over a step: their end points at its start, and the displacement of each end. Ends move in
/// straight lines, so that f is a cubic in the part tau of the step, 0 <= tau <= 1.
struct Moving {
    BarPair start, move;

    /// The end points at the part tau of the step.
    BarPair at(double tau) const;
    /// The largest distance by which any point of a and any point of b can come closer in the whole step, m.
    double closing_bound() const;
};

/// The cubic f(tau) = c[0] + c[1] tau + c[2] tau^2 + c[3] tau^3.
struct Cubic {
    double c[4];
    double operator()(double tau) const { return c[0] + tau * (c[1] + tau * (c[2] + tau * c[3])); }
    double slope(double tau) const { return c[1] + tau * (2 * c[2] + tau * 3 * c[3]); }
};
/// The cubic of f (eq 17) over a step.
Cubic coplanarity_over(const Moving& moving);

/// A closed part of a step.
struct Span {
    double from, to;
};

/// Finds the spans of [0, 1] in which lo <= p(tau) <= hi: at most three, ordered, touching ones not merged. Returns
/// their number.
int spans_between(const Cubic& p, double lo, double hi, Span out[3]);

/// Parameters of the rule `gap`.
struct RuleNumbers {
    double contact_length;    ///< C_l of eq 18; infinite: eq 18 always holds
    double alpha;             ///< eq 19, m^3
    double contact_distance;  ///< sum of the half depths, m (not used by the rule as printed)
    bool signed_f = false;    ///< f with its sign (used by the rule as printed alone)
};

/// Time and place of a contact found in a step.
struct Meeting {
    bool found = false;
    double tau = 0;                 ///< part of the step
    double s = 0, t = 0;            ///< along a and along b
    Vec3 direction = Vec3::Zero();  ///< unit vector from a to b along which they approach
};

/// Rate and direction of the approach of two bars.
struct Approach {
    double rate;     ///< as a distance per step, m; positive: they come closer
    Vec3 direction;  ///< unit vector from a to b along which it is measured
};

/// The velocity at which the bars approach, as a distance per step: minus the relative motion of the two closest points
/// along the line from a to b. If the axes nearly intersect, or have passed through each other, that line is not
/// meaningful; `normal`, the direction from a to b before, replaces it.
Approach approach(const Moving& moving, const BarPair& now, const Closest& closest, const Vec3& normal,
                  double contact_distance);

/// Finds the earliest contact in the step: eq 19 holds (or f has changed sign), eq 18 holds, the axes are within the
/// contact distance of each other, and the bars approach. `normal` is the unit direction from a to b when they last
/// were clearly apart (zero: unknown); it tells bars that come closer from bars that have already passed a little
/// through each other. `begin` are the closest points when the step begins. A graze shallower than 1 % of the contact
/// distance may go unseen.
Meeting first_meeting(const Moving& moving, const Closest& begin, const Vec3& normal, const RuleNumbers& numbers);

/// Finds a contact by eqs 17-19 as printed, tested only at the start of the step: coplanar (19), close enough (18),
/// approaching.
Meeting printed_meeting(const Moving& moving, const Closest& begin, const Vec3& normal, const RuleNumbers& numbers);

}  // namespace hinge::contact

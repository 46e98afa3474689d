// Contact law of a ground layer: springs and dashpots distributed over the contact area of a straight bar.
#pragma once

namespace hinge::contact {

/// A straight piece of a member above a ground layer. The axis is closer to the plane than the half depth h by the
/// overlap o, m, which is linear between the two ends, as is its rate o', m/s. The layer presses with p = s o + d o'
/// where o > 0 and p > 0, and not elsewhere: it never pulls.
///
///   along the side   width (1 - lean^2) p, N/m: spread over the part that touches, to the two ends in proportion
///   at an end face   A lean p, N: lean is the cosine between the axis, out of the end, and the way into the ground
///
/// (A side's true projection is the root of 1 - lean^2. The square has a finite derivative where a bar stands upright.)
///
/// The contact area is therefore that of the bar, with any number of elements: width times length for a bar that lies
/// flat, A for one that stands on its end.
struct LayerPiece {
    double stiffness = 0;          ///< s, N/m^3
    double damping = 0;            ///< d, N s/m^3
    double width = 0, length = 0;  ///< of the side, m
    /// Width at the two ends over the mean; linear between them. Where a piece's mass is more at one end, its pressed
    /// area is too: a bar that lands flat is then stopped without bending.
    double taper[2] = {1, 1};
    double end_area[2] = {0, 0};  ///< A of the faces of its two ends, m^2; 0: the member goes on there
};

/// Position and velocity of the two ends of a piece relative to the layer.
struct LayerPlace {
    double overlap[2] = {0, 0};  ///< o, m; negative: apart
    double rate[2] = {0, 0};     ///< o', m/s
    double lean[2] = {0, 0};     ///< -1 to 1; above 0 where the end points into the ground; the second is -the first
};

/// Forces of the layer on a piece, stored energy, and their derivatives.
struct LayerPress {
    double force[2] = {0, 0};    ///< on each end, out of the ground, N, of the side and of the end face
    double elastic[2] = {0, 0};  ///< the part of it that the springs would give alone; the rest dissipates
    double stored = 0;           ///< J
    /// Derivative of `stored` by `lean`, J. It rotates the bar, so that the energy stored at an end face is conserved
    /// as the bar topples.
    double leaning[2] = {0, 0};
    /// m^2: of the first end with itself, with the other, of the other with itself. The derivatives of the forces by o
    /// and o' are s and d times this.
    double area[3] = {0, 0, 0};
};

/// Computes the action of the layer on a piece. `touching`, m: an overlap above -touching counts as contact in `area`,
/// so that statics finds the ground it begins on.
LayerPress press(const LayerPiece& piece, const LayerPlace& place, double touching = 0);

}  // namespace hinge::contact

// The element's consistent mass with rotary inertia, and what becomes of it when the element breaks.
#pragma once

#include "beam/timoshenko.h"

namespace hinge::beam {

/// Rotary inertia per length of the section in local axes, kg m: about x, about y, about z (polar).
inline Vec3 rotary_inertia(const Rigidity& c) { return {c.rhoIx, c.rhoIy, c.rhoIx + c.rhoIy}; }

/// Consistent mass, 12 x 12, order [u1 t1 u2 t2], in space; `axes`: columns are the local axes. Linear shape functions;
/// not changed by the position of the integration point (paper, after eq 15).
inline Mat12 consistent_mass(const Rigidity& c, double L, const Mat3& axes) {
    const Mat3 J = axes * rotary_inertia(c).asDiagonal() * axes.transpose();
    Mat12 M = Mat12::Zero();
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            const double share = L / 6 * (i == j ? 2 : 1);
            M.block<3, 3>(6 * i, 6 * j) = share * c.rhoA * Mat3::Identity();
            M.block<3, 3>(6 * i + 3, 6 * j + 3) = share * J;
        }
    return M;
}

/// Lumped, for each of its two nodes: kg, and kg m^2 about every axis (the section's polar inertia).
inline double lumped_mass(const Rigidity& c, double L) { return 0.5 * c.rhoA * L; }
inline double lumped_rotary(const Rigidity& c, double L) { return 0.5 * (c.rhoIx + c.rhoIy) * L; }

/// The lumped mass as a matrix, 12 x 12.
inline Mat12 lumped_matrix(const Rigidity& c, double L) {
    Vec12 d;
    const double m = lumped_mass(c, L), j = lumped_rotary(c, L);
    d << m, m, m, j, j, j, m, m, m, j, j, j;
    return d.asDiagonal();
}

/// A straight rigid bar hung on a node: `span` points from the node to its free end, in the frame wanted; `axes` likewise.
struct Stub {
    double mass;
    Vec3 moment;   ///< kg m
    Mat3 inertia;  ///< about the node, kg m^2
};
inline Stub rigid_stub(const Rigidity& c, const Vec3& span, const Mat3& axes) {
    const double L = span.norm(), m = c.rhoA * L;
    const Mat3 J = L * (axes * rotary_inertia(c).asDiagonal() * axes.transpose());
    return {m, 0.5 * m * span, J + m / 3 * (span.squaredNorm() * Mat3::Identity() - span * span.transpose())};
}

/// The same of an element with lumped mass: half of it at each end. A stub that turned more easily than the element's masses did
/// would gain energy as it takes over their angular momentum.
inline Stub lumped_stub(const Rigidity& c, const Vec3& span) {
    const double L = span.norm(), m = c.rhoA * L;
    return {m, 0.5 * m * span, 2 * lumped_rotary(c, L) * Mat3::Identity() + 0.5 * m * (span.squaredNorm() * Mat3::Identity() - span * span.transpose())};
}

/// Mass of a rigid body hung on a node, 6 x 6 in space, for first moment and inertia in space.
inline Mat6 hung_mass(double mass, const Vec3& moment, const Mat3& inertia) {
    Mat6 M;
    M << mass * Mat3::Identity(), -skew(moment), skew(moment), inertia;
    return M;
}

}  // namespace hinge::beam

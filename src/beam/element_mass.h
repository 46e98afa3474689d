// Mass matrices of an element: linear as in the paper, cubic in pairs, or lumped; and the mass of its rigid remains
// after it breaks.
#pragma once

#include <cmath>

#include "beam/timoshenko.h"

namespace hinge::beam {

/// Rotary inertia per length of the section in local axes, kg m: about x, about y, about z (polar).
inline Vec3 rotary_inertia(const Rigidity& c) { return {c.rhoIx, c.rhoIy, c.rhoIx + c.rhoIy}; }

/// Mass of an element of length L, kg.
inline double element_mass(const Rigidity& c, double L) { return c.rhoA * L; }

/// Mass of an element at its two nodes and between them. Translational mass is the same in all directions; rotary
/// inertia is about the local axes.
struct Inertia {
    double own[2], across;          ///< of each node, and between the two, kg
    Vec3 rotary[2], rotary_across;  ///< likewise, kg m^2

    double weight(int end) const { return own[end] + across; }  ///< mass of a node in a translation, kg

    /// The same with the rotary inertia between the nodes moved to the nodes.
    Inertia with_rotary_at_nodes() const {
        return {{own[0], own[1]}, across, {rotary[0] + rotary_across, rotary[1] + rotary_across}, Vec3::Zero()};
    }

    /// matrix(axes) times v.
    Vec12 times(const Mat3& axes, const Vec12& v) const {
        const Vec3 spin[2] = {axes.transpose() * v.segment<3>(3), axes.transpose() * v.segment<3>(9)};
        Vec12 out;
        for (int i : {0, 1})
            out.segment<6>(6 * i) << own[i] * v.segment<3>(6 * i) + across * v.segment<3>(6 * (1 - i)),
                axes * (rotary[i].cwiseProduct(spin[i]) + rotary_across.cwiseProduct(spin[1 - i]));
        return out;
    }
    /// 12 x 12, order [u1 t1 u2 t2], in space; `axes`: columns are the local axes.
    Mat12 matrix(const Mat3& axes) const {
        const auto in_space = [&](const Vec3& J) -> Mat3 { return axes * J.asDiagonal() * axes.transpose(); };
        const Mat3 between = in_space(rotary_across);
        Mat12 M = Mat12::Zero();
        for (int i : {0, 1}) {
            M.block<3, 3>(6 * i, 6 * i).diagonal().setConstant(own[i]);
            M.block<3, 3>(6 * i, 6 * (1 - i)).diagonal().setConstant(across);
            M.block<3, 3>(6 * i + 3, 6 * i + 3) = in_space(rotary[i]);
            M.block<3, 3>(6 * i + 3, 6 * (1 - i) + 3) = between;
        }
        return M;
    }
};

/// Consistent mass of linear shape functions. It does not depend on the position of the integration point (paper, after
/// eq 15).
inline Inertia linear_inertia(const Rigidity& c, double L) {
    const double m = L / 6 * c.rhoA;
    const Vec3 J = L / 6 * rotary_inertia(c);
    return {{2 * m, 2 * m}, m, {2 * J, 2 * J}, J};
}

/// Mass of an element in a pair of asi-gauss elements that deflects as a cubic; `middle`: the element's end (0, 1) at
/// the pair's middle. The pair's stiffness is that of a cubic, but its middle node deflects by only 2 - 2/sqrt 3 = 0.85
/// of the cubic. Therefore
///   - a pair that bows has the momentum of the parabola: 2/3 of its mass at the true sag;
///   - a part of its moment of inertia belongs to the middle node, which rotates ahead of the chord
///     where the pair bends like an S: so the masses off the chord count there too.
/// Without bending, mass and moment of inertia are unchanged.
/// In parts of rho A l: 1/4 on the outer node, 1/4 + 1/sqrt 3 on the middle one, 1/4 - 1/(2 sqrt 3) between; and rho A
/// l^3/12 on the middle node about the two axes across. Translation alone couples the nodes, so it holds in any
/// position. Not in the paper.
inline Inertia cubic_inertia(const Rigidity& c, double L, int middle) {
    Inertia i = linear_inertia(c, L);
    const double m = element_mass(c, L), root = 1 / std::sqrt(3.0), tilting = m * L * L / 12;
    i.own[1 - middle] = 0.25 * m;
    i.own[middle] = (0.25 + root) * m;
    i.across = (0.25 - 0.5 * root) * m;
    i.rotary[middle] += Vec3(tilting, tilting, 0);
    return i;
}

/// Part of the lumped mass of an element at its first node; `index`: which of the `count` equal elements of its member
/// it is, from 0. The lumps of a member have its mass, its centre and its moment of inertia m L^2 / 12:
///   - a pair has 1/6, 4/6, 1/6 of its mass (Simpson's rule), so an element 1/3 at the outer node and 2/3 at the
///   middle;
///   - in members of three, five, ... elements the outer ones have 1/2 - e at their ends, e = n / (12 (n - 1)), the
///     others half and half. With three that is the 3/8 rule;
///   - a single element has half and half, and m L^2 / 4.
inline double lumped_part(int index, int count) {
    if (count % 2 == 0) return index % 2 == 0 ? 1 / 3.0 : 2 / 3.0;
    if (count == 1 || (index > 0 && index < count - 1)) return 0.5;
    const double less = count / (12.0 * (count - 1));
    return index == 0 ? 0.5 - less : 0.5 + less;
}

/// Lumped mass: `part` of it at the first node, the rest at the second (lumped_part). Each has half of the section's
/// polar rotary inertia, about every axis: so spin needs no frame.
inline Inertia lumped_inertia(const Rigidity& c, double L, double part) {
    const double m = element_mass(c, L), first = part * m;
    const Vec3 J = Vec3::Constant(0.5 * (c.rhoIx + c.rhoIy) * L);
    return {{first, m - first}, 0, {J, J}, Vec3::Zero()};
}

/// Mass left at the nodes of an element of a pair whose other element has broken off: a quarter of its mass at the
/// outer node; the rest is attached to the inner one (state/lone_elements.h). `inner`: which end that is.
inline Inertia lone_inertia(const Rigidity& c, double L, int inner) {
    Inertia m = lumped_inertia(c, L, 0.5);
    m.own[inner] = 0, m.own[1 - inner] = 0.25 * element_mass(c, L);
    return m;
}

/// Mass of a rigid bar that is attached to a node by one end.
struct RigidOffset {
    double mass;
    Vec3 moment;   ///< kg m
    Mat3 inertia;  ///< about the node, kg m^2
};
/// A straight rigid bar: `span` points from the node to its free end; both `span` and `axes` in the frame of the
/// result.
inline RigidOffset rigid_offset(const Rigidity& c, const Vec3& span, const Mat3& axes) {
    const double L = span.norm(), m = element_mass(c, L);
    const Mat3 J = L * (axes * rotary_inertia(c).asDiagonal() * axes.transpose());
    return {m, 0.5 * m * span, J + m / 3 * (span.squaredNorm() * Mat3::Identity() - span * span.transpose())};
}

/// Two masses on nodes, 6 x 6 each about its own, where the second node follows the first rigidly; `span` points to it.
/// With less rotary inertia than these the bar would gain energy when it takes over their angular momentum.
inline RigidOffset lumped_rigid_offset(const Mat6& first, const Mat6& second, const Vec3& span) {
    Mat6 follow = Mat6::Identity();
    follow.topRightCorner<3, 3>() = -skew(span);
    const Mat6 M = first + follow.transpose() * second * follow;
    const Mat3 S = M.bottomLeftCorner<3, 3>();
    return {M(0, 0), {S(2, 1), S(0, 2), S(1, 0)}, M.bottomRightCorner<3, 3>()};
}

/// Mass matrix of a rigid body attached to a node, 6 x 6 in space, from its first moment and inertia in space.
inline Mat6 offset_mass_matrix(double mass, const Vec3& moment, const Mat3& inertia) {
    Mat6 M;
    M << mass * Mat3::Identity(), -skew(moment), skew(moment), inertia;
    return M;
}

}  // namespace hinge::beam

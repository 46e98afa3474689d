// Corotational formulation for large displacement: deformation and nodal forces of an element in a frame that moves
// with it.
//
// The frame: e3 along the chord, e1 and e2 from the mean of the two nodes' y axes. The end rotations are the rotation
// vectors of the nodes relative to that frame, so a rigid motion of any size leaves no deformation. Nodal rotations are
// quaternions. The forces are the exact gradient of the deformation's work (see tangent.h for their derivative).
//
// The twist is the difference of the two rotation vectors along the chord. The rotation vectors contain the shear angle
// too. In an element that is bent in one plane and sheared in the other, this changes the strain energy by the shear
// angle times (G J - E I) times the curvature, which does not vanish with shorter elements: a right-angle cantilever
// that is bent far out of its plane converges to within 1e-6 to 6e-6 of its exact answer, and closer if G J = E I.
#pragma once

#include "core/lanes.h"

namespace hinge::beam {

/// A vector of three numbers. Kernels are templates over Real: `double` for one element, `Lanes` for a block of eight
/// (core/lanes.h).
template <class Real>
struct Triple {
    Real x, y, z;
};

template <class Real>
inline Triple<Real> operator+(const Triple<Real>& a, const Triple<Real>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
inline Triple<Real> operator-(const Triple<Real>& a, const Triple<Real>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
inline Triple<Real> operator*(const Real& s, const Triple<Real>& a) {
    return {s * a.x, s * a.y, s * a.z};
}
template <class Real>
inline Real dot(const Triple<Real>& a, const Triple<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
inline Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real>
struct Quadruple {
    Real w, x, y, z;
};  // a unit quaternion

template <class Real>
struct Triad {
    Triple<Real> x, y, z;
};  // three orthonormal columns

template <class Real>
inline Quadruple<Real> product(const Quadruple<Real>& a, const Quadruple<Real>& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// The triad of quaternion a * b: the element's axes at a node (a: the node's rotation, b: the element's axes at the
/// start).
template <class Real>
[[gnu::always_inline]] inline Triad<Real> rotated_triad(const Quadruple<Real>& a, const Quadruple<Real>& b) {
    const Real w = a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z;
    const Real x = a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y;
    const Real y = a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x;
    const Real z = a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w;
    const Real x2 = x + x, y2 = y + y, z2 = z + z;
    const Real one = spread(1.0, x);
    const Real xx = x * x2, yy = y * y2, zz = z * z2, xy = x * y2, xz = x * z2, yz = y * z2, wx = w * x2, wy = w * y2,
               wz = w * z2;
    return {
        {one - (yy + zz), xy + wz, xz - wy}, {xy - wz, one - (xx + zz), yz + wx}, {xz + wy, yz - wx, one - (xx + yy)}};
}

/// The rotation vector of R = frame^T * node, in the frame's axes, rad; unique below pi.
template <class Real>
[[gnu::always_inline]] inline Triple<Real> relative_rotation(const Triad<Real>& frame, const Triad<Real>& node) {
    const Real half = spread(0.5, frame.x.x);
    const Triple<Real> v = {half * (dot(frame.z, node.y) - dot(frame.y, node.z)),
                            half * (dot(frame.x, node.z) - dot(frame.z, node.x)),
                            half * (dot(frame.y, node.x) - dot(frame.x, node.y))};
    const Real cosine = half * (dot(frame.x, node.x) + dot(frame.y, node.y) + dot(frame.z, node.z) - spread(1.0, half));
    const Real q = dot(v, v);  // sin^2 of the angle
    // asin(sqrt q)/sqrt q by its series while the angle is below 0.2 rad, which it nearly always is
    const auto c = [&](double value) { return spread(value, q); };
    Real factor =
        c(1) +
        q * (c(1.0 / 6) +
             q * (c(3.0 / 40) +
                  q * (c(5.0 / 112) +
                       q * (c(35.0 / 1152) +
                            q * (c(63.0 / 2816) + q * (c(231.0 / 13312) +
                                                       q * (c(143.0 / 10240) + q * (c(6435.0 / 557056) +
                                                                                    q * (c(12155.0 / 1245184))))))))));
    const auto large = [&](int i) { return !(lane(q, i) < 0.04 && lane(cosine, i) > 0); };
    if (any_not_below(q, 0.04) || any_not_below(-cosine, 0))
        factor = replace_where(factor, large, [&](int i) {
            const double sine = std::sqrt(lane(q, i));
            return sine > 0 ? std::atan2(sine, lane(cosine, i)) / sine : 1.0;
        });
    return factor * v;
}

/// eta(t) = (1 - (t/2) cot(t/2)) / t^2 with t^2 = q: the second coefficient of the inverse tangent of the rotation
/// vector.
template <class Real>
inline Real inverse_tangent_coefficient(const Real& q) {
    const auto c = [&](double value) { return spread(value, q); };
    Real eta =
        c(1.0 / 12) +
        q * (c(1.0 / 720) + q * (c(1.0 / 30240) +
                                 q * (c(1.0 / 1209600) + q * (c(1.0 / 47900160) + q * (c(691.0 / 1307674368000.0) +
                                                                                       q * c(1.0 / 74724249600.0))))));
    if (!any_not_below(q, 0.09)) return eta;
    return replace_where(
        eta, [&](int i) { return !(lane(q, i) < 0.09); },
        [&](int i) {
            const double t = std::sqrt(lane(q, i));
            return (1 - 0.5 * t / std::tan(0.5 * t)) / lane(q, i);
        });
}

/// Position of an element: its frame, its chord, and the rotations of its two nodes in that frame.
template <class Real>
struct ElementFrame {
    Triad<Real> frame;        ///< e1 e2 e3 in space
    Real length;              ///< of the chord, m
    Triple<Real> theta[2];    ///< rotation vectors of the nodes in the frame, rad
    Triple<Real> y[2];        ///< the nodes' y axes, in the frame
    Real y_mean_y, y_mean_z;  ///< the mean y axis in the frame: (0, y_mean_y, y_mean_z)
};

/// Computes the frame of an element. chord: present vector from node 1 to node 2 (m); node1, node2: the nodes'
/// rotations; axes: the element's axes at the start.
template <class Real>
[[gnu::always_inline]] inline ElementFrame<Real> place(const Triple<Real>& chord, const Quadruple<Real>& node1,
                                                       const Quadruple<Real>& node2, const Quadruple<Real>& axes) {
    const Triad<Real> t1 = rotated_triad(node1, axes), t2 = rotated_triad(node2, axes);
    const Real one = spread(1.0, chord.x), half = spread(0.5, chord.x);
    ElementFrame<Real> p;
    p.length = square_root(dot(chord, chord));
    p.frame.z = (one / p.length) * chord;
    const Triple<Real> y_mean = half * (t1.y + t2.y);
    const Triple<Real> e1 = cross(y_mean, p.frame.z);
    p.frame.x = (one / square_root(dot(e1, e1))) * e1;
    p.frame.y = cross(p.frame.z, p.frame.x);
    p.theta[0] = relative_rotation(p.frame, t1);
    p.theta[1] = relative_rotation(p.frame, t2);
    p.y[0] = {dot(p.frame.x, t1.y), dot(p.frame.y, t1.y), dot(p.frame.z, t1.y)};
    p.y[1] = {dot(p.frame.x, t2.y), dot(p.frame.y, t2.y), dot(p.frame.z, t2.y)};
    p.y_mean_y = half * (p.y[0].y + p.y[1].y);
    p.y_mean_z = half * (p.y[0].z + p.y[1].z);
    return p;
}

/// Basic deformations d = [tx1 tx2 ty1 ty2 e phi] of an element (timoshenko.h), which replace the strains of eqs 7b,
/// 10b and 12b.
template <class Real>
inline void deformation(const ElementFrame<Real>& p, const Real& L, Real d[6]) {
    d[0] = p.theta[0].x;
    d[1] = p.theta[1].x;
    d[2] = p.theta[0].y;
    d[3] = p.theta[1].y;
    d[4] = p.length - L;
    d[5] = p.theta[1].z - p.theta[0].z;
}

/// Forces and moments on the two nodes of an element.
template <class Real>
struct NodalForces {
    Triple<Real> force[2], moment[2];
};

/// Nodal forces and moments in space from the basic forces p: f = (dd/du)^T p.
///
/// With m_i the moments on theta_i, mu_i = m_i + theta_i x m_i / 2 + eta theta_i x (theta_i x m_i) acts on the spin of
/// the node relative to the frame, and -(mu_1 + mu_2) acts on the frame's own spin: about e1, e2 through the chord's
/// ends, about e3 through the nodes' y axes.
template <class Real>
[[gnu::always_inline]] inline NodalForces<Real> nodal_forces(const ElementFrame<Real>& p, const Real f[6]) {
    const Real half = spread(0.5, p.length), zero = spread(0.0, p.length);
    const Triple<Real> m[2] = {{f[0], f[2], zero - f[5]}, {f[1], f[3], f[5]}};
    Triple<Real> mu[2];
    for (int i = 0; i < 2; ++i) {
        const Triple<Real>& t = p.theta[i];
        const Triple<Real> once = cross(t, m[i]);
        mu[i] = m[i] + half * once + inverse_tangent_coefficient(dot(t, t)) * cross(t, once);
    }
    const Triple<Real> sum = mu[0] + mu[1];
    const Real slope = p.y_mean_z / p.y_mean_y, share = half * sum.z / p.y_mean_y;
    const Triple<Real> end = {zero - (sum.y + slope * sum.z) / p.length, sum.x / p.length, f[4]};
    const Triple<Real> n1 = {mu[0].x, mu[0].y + share * p.y[0].z, mu[0].z - share * p.y[0].y};
    const Triple<Real> n2 = {mu[1].x, mu[1].y + share * p.y[1].z, mu[1].z - share * p.y[1].y};
    const auto to_space = [&](const Triple<Real>& a) { return a.x * p.frame.x + a.y * p.frame.y + a.z * p.frame.z; };
    NodalForces<Real> out;
    out.force[1] = to_space(end);
    out.force[0] = (zero - half - half) * out.force[1];
    out.moment[0] = to_space(n1);
    out.moment[1] = to_space(n2);
    return out;
}

/// Rates d' of the basic deformations from the velocities of an element's nodes in space, linear and angular: the
/// transpose of nodal_forces, so that p . d' is the power of the forces.
template <class Real>
[[gnu::always_inline]] inline void deformation_rates(const ElementFrame<Real>& p, const Triple<Real> (&linear)[2],
                                                     const Triple<Real> (&angular)[2], Real rate[6]) {
    const Real half = spread(0.5, p.length), zero = spread(0.0, p.length);
    const auto to_frame = [&](const Triple<Real>& a) -> Triple<Real> {
        return {dot(p.frame.x, a), dot(p.frame.y, a), dot(p.frame.z, a)};
    };
    const Triple<Real> along = to_frame(linear[1] - linear[0]), spin[2] = {to_frame(angular[0]), to_frame(angular[1])};
    const Real slope = p.y_mean_z / p.y_mean_y;
    const Real by_axes = spin[0].y * p.y[0].z - spin[0].z * p.y[0].y + spin[1].y * p.y[1].z - spin[1].z * p.y[1].y;
    const Triple<Real> of_frame = {along.y / p.length, zero - along.x / p.length,
                                   half * by_axes / p.y_mean_y - slope * along.x / p.length};
    Triple<Real> theta[2];  // rates of the rotation vectors
    for (int i = 0; i < 2; ++i) {
        const Triple<Real>& t = p.theta[i];
        const Triple<Real> relative = spin[i] + of_frame, once = cross(t, relative);
        theta[i] = relative - half * once + inverse_tangent_coefficient(dot(t, t)) * cross(t, once);
    }
    rate[0] = theta[0].x;
    rate[1] = theta[1].x;
    rate[2] = theta[0].y;
    rate[3] = theta[1].y;
    rate[4] = along.z;
    rate[5] = theta[1].z - theta[0].z;
}

}  // namespace hinge::beam

// Inertia forces of rotating elements, eight at a time: rotary inertia about the axes of each node, or about the axes
// of the element's frame.
#pragma once

#include "beam/corotation.h"

namespace hinge::beam {

/// Inertia moment J a + w x J w of a spin w with rate a, in the frame's axes, per share of mass.
inline Triple<Lanes> rotary_force(const Lanes* J, const Triple<Lanes>& w, const Triple<Lanes>& a) {
    const Triple<Lanes> h = {J[0] * w.x, J[1] * w.y, J[2] * w.z};
    return Triple<Lanes>{J[0] * a.x, J[1] * a.y, J[2] * a.z} + cross(w, h);
}

/// Spins of the two ends of an element, their rates, and the velocity of end 2 relative to end 1, in the element's
/// frame.
struct Spins {
    Triple<Lanes> w[2], rate[2], relative;
};

/// Inertia forces of rotary inertia about the axes of the element's frame, not of its nodes, in the frame's axes. J:
/// inertia per share of mass, two shares at each end and one between them; `more`: additional transverse inertia of the
/// cubic mass at each end.
///
/// With the kinetic energy T = L_1 w_1 / 2 + L_2 w_2 / 2 and the frame's spin W, Lagrange's equations give dL/dt + L x
/// w on the nodes and the sum of w x L on the frame, which is distributed to the nodes as in nodal_forces. So the
/// kinetic energy changes by the work of these forces alone. With w x J w on each node it would not, if ends rotate
/// fast relative to their frame.
inline NodalForces<Lanes> turning_inertia(const ElementFrame<Lanes>& p, unsigned wound, const Lanes (&J)[3],
                                          const Lanes* more, const Spins& of) {
    const Lanes none = {}, half = spread(0.5, p.length), two = spread(2.0, p.length);
    Triple<Lanes> y[2] = {p.y[0], p.y[1]};
    Lanes y_mean_y = p.y_mean_y, y_mean_z = p.y_mean_z;
    if (wound)  // their frame turns about the chord by the mean of its ends
        for (int i = 0; i < lane_count; ++i) {
            if (!(wound >> i & 1)) continue;
            for (int e : {0, 1}) y[e].y[i] = 1, y[e].z[i] = 0;
            y_mean_y[i] = 1, y_mean_z[i] = 0;
        }
    const Lanes slope = y_mean_z / y_mean_y, to_z = half / y_mean_y;
    const Triple<Lanes>*w = of.w, *s = of.rate;
    const Triple<Lanes> W = {-of.relative.y / p.length, of.relative.x / p.length,
                             slope * of.relative.x / p.length -
                                 to_z * (y[0].z * w[0].y - y[0].y * w[0].z + y[1].z * w[1].y - y[1].y * w[1].z)};
    const auto times = [](const Lanes& a, const Lanes& b, const Lanes& c, const Triple<Lanes>& v) {
        return Triple<Lanes>{a * v.x, b * v.y, c * v.z};
    };
    NodalForces<Lanes> out;
    Triple<Lanes> mu[2];
    for (int e : {0, 1}) {
        const Triple<Lanes> shares = two * w[e] + w[1 - e];
        Triple<Lanes> L = times(J[0], J[1], J[2], shares);
        out.moment[e] = times(J[0], J[1], J[2], two * s[e] + s[1 - e] - cross(W, shares));
        if (more) {
            L = L + times(more[e], more[e], none, w[e]);
            out.moment[e] = out.moment[e] + times(more[e], more[e], none, s[e] - cross(W, w[e]));
        }
        mu[e] = cross(L, w[e]);
        out.moment[e] = out.moment[e] + cross(W, L) + mu[e];
    }
    const Triple<Lanes> sum = mu[0] + mu[1];
    const Lanes share = sum.z * to_z;
    for (int e : {0, 1}) out.moment[e] = out.moment[e] + Triple<Lanes>{none, share * y[e].z, none - share * y[e].y};
    out.force[1] = {none - (sum.y + slope * sum.z) / p.length, sum.x / p.length, none};
    out.force[0] = Triple<Lanes>{none, none, none} - out.force[1];
    return out;
}

}  // namespace hinge::beam

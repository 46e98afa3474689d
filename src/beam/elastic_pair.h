// A pair of elements (beam_column.h) and the springs at its ends: what worn hinges have lost of their stiffness.
//
// A spring turns by c m under the moment m of its end. It is in series with the element, so that of a deformation d the
// springs have a part t, and the element d - t:
//
//   U(d) = the least over t of  (energy of the elements and of the pair at d - t) + sum of t^2 / (2 c)
//
// U depends on d alone: energy is conserved. Without springs all is as in beam_column.h, to the last bit.
#pragma once

#include "beam/beam_column.h"

namespace hinge::beam {

/// Springs at the two ends of an element, for bending about x and about y: rotation over moment, rad/(N m); 0: rigid.
struct EndSprings {
    double x[2] = {0, 0}, y[2] = {0, 0};

    bool any() const { return x[0] > 0 || x[1] > 0 || y[0] > 0 || y[1] > 0; }
    friend EndSprings operator*(double factor, EndSprings s) {
        for (int end : {0, 1}) s.x[end] *= factor, s.y[end] *= factor;
        return s;
    }
    /// In the places of p of timoshenko.h.
    Vec6 compliance() const { return (Vec6() << x[0], x[1], y[0], y[1], 0, 0).finished(); }
};

/// Stiffness of an element with such springs.
Stiffness in_series(const Stiffness& k, const EndSprings& springs);

/// d1 and d2 below: elastic deformations of the two elements with their springs. Where no t is found, the results are
/// not numbers.
struct ElasticPair {
    PairKind<double> kind;
    Stiffness of[2];  ///< k(s) of the elements, without springs
    EndSprings springs[2] = {};

    bool has_springs() const { return springs[0].any() || springs[1].any(); }
    /// Their own parts of d1 and d2, without those of the springs.
    bool take_off_springs(Vec6& d1, Vec6& d2) const;
    /// The pair where its elements with their springs have the deformations d1 and d2.
    struct At {
        Vec6 own[2];   ///< without the parts of the springs
        Vec12 beyond;  ///< forces_beyond, N and N m
        double N;      ///< axial force, N
    };
    At at(const Vec6& d1, const Vec6& d2) const;
    // What the pair has in addition to elements of stiffness `of` with the deformations d1 and d2.
    double energy_beyond(const Vec6& d1, const Vec6& d2) const;                              ///< J
    Vec12 forces_beyond(const Vec6& d1, const Vec6& d2) const { return at(d1, d2).beyond; }  ///< as pair_forces
    PairMatrix stiffness_beyond(const At& at) const;
    PairMatrix stiffness_beyond(const Vec6& d1, const Vec6& d2) const { return stiffness_beyond(at(d1, d2)); }
};

}  // namespace hinge::beam

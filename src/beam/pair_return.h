// The return of a pair of elements to its yield surfaces, and the tangent that is consistent with it.
//
// The nodes are given, and so the deformation d of both elements (12 numbers). Plastic flow x takes part of it, and the
// pair stores the elastic energy U(d - x) of beam_column.h. An implicit step of associated flow makes
//
//   F(x) = U(d - x) + D(x)
//
// least, where D(x), the dissipation, is the largest work p . x that forces p on or inside the yield surfaces can do.
// At the minimum the forces dU/dd are on the surface where x flows, and x is normal to it. F(x) <= F(0) says that 0 <=
// D(x) <= U(d) - U(d - x): flow never takes more than the elastic energy that it frees.
//
// While S and A of beam_column.h are positive, p = -N l^2 / EI below 3.5, U is convex: as the greatest over N of
// functions that are linear in the extension and convex in the bending. Then there is one minimum, and it is found in
// rounds: each element returns by itself (yield.h), from the forces that the elastic deformations of the round before
// give the pair.
//
// Beyond that U is not convex, as a strut within its own length is not stable there. A hinge may then snap from one
// equilibrium to another. The minimum that is found is one to which F falls without a rise from x = 0: each step
// replaces U by a quadratic function that lies above it, and is refused where F does not fall. What U has lost by a
// snap and the flow has not dissipated would become a vibration inside the element, and then heat. It is dissipated at
// once.
//
// The forces that are given back are dU/dd at d - x. They are a hair outside or inside of the surface where the
// iteration has ended, but no energy is made or lost by that.
#pragma once

#include "beam/beam_column.h"

namespace hinge::beam {

inline const FixedEnd no_fixed_ends[2];

/// Flow of both elements whose elastic deformations would be d[0] and d[1] (timoshenko.h) without it.
///   k          what the elements of the pair are
///   of         their stiffnesses k(s)
///   w          their yield surfaces; both ends can yield
///   fixed_end  of the two elements: what loads between the nodes add at the ends
///   tolerance  on the last change of the plastic deformation, over the elastic one, in the energy norm
/// False where the iteration has not come to that tolerance: the step is then to be taken back.
bool return_to_surface(const PairKind<double>& k, const Stiffness (&of)[2], const Vec6 (&d)[2],
                       const YieldSurface* const (&w)[2], ReturnMapResult (&flow)[2], double tolerance = 1e-4,
                       const FixedEnd* fixed_end = no_fixed_ends);

/// d(forces)/dd of a pair, 12 x 12, consistent with that return (eq 10a, of the pair).
///   elastic  what the flow has left
///   flow     null of an element that does not flow
PairMatrix pair_tangent(const PairKind<double>& k, const Stiffness (&of)[2], const Vec6 (&elastic)[2],
                        const YieldSurface* const (&w)[2], const ReturnMapResult* const (&flow)[2],
                        const FixedEnd* fixed_end = no_fixed_ends);

}  // namespace hinge::beam

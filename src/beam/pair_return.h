// Return mapping of a pair of elements to its yield surfaces, and the consistent tangent.
//
// The nodes determine the deformation d of both elements (12 numbers). A part x of it is plastic flow, and the pair
// stores the elastic energy U(d - x) of beam_column.h. An implicit step of associated flow minimises
//
//   F(x) = U(d - x) + D(x)
//
// where D(x), the dissipation, is the largest work p . x of forces p on or inside the yield surfaces. At the minimum
// the forces dU/dd are on the surface where x flows, and x is normal to it. F(x) <= F(0) says that 0 <= D(x) <= U(d) -
// U(d - x): flow never dissipates more than the elastic energy that it releases.
//
// While S and A of beam_column.h are positive, p = -N l^2 / EI below 3.5, U is convex: as the greatest over N of
// functions that are linear in the extension and convex in the bending. Then there is one minimum, and it is found in
// rounds: each element returns by itself (yield.h), from the forces that the elastic deformations of the round before
// give the pair.
//
// Beyond that U is not convex: a strut buckles within its own length there. A hinge may then snap from one equilibrium
// to another. The minimum that is found is one to which F falls without a rise from x = 0: each step replaces U by a
// quadratic function that lies above it, and is refused where F does not fall. What U has lost by a snap and the flow
// has not dissipated would become a vibration inside the element, and then heat. It is dissipated at once.
//
// The returned forces are dU/dd at d - x. They lie outside or inside the surface within the tolerance of the iteration;
// this neither creates nor loses energy.
#pragma once

#include "beam/elastic_pair.h"
#include "section/section_law.h"

namespace hinge::beam {

/// Returns both elements of a pair to their yield surfaces; d[0] and d[1]: their deformations if the step were elastic
/// (timoshenko.h).
///   pair       its elastic side
///   law        of their sections; both ends can yield
///   at         of the sections of the two elements, in this order
///   tolerance  on the last change of the plastic deformation, over the elastic one, in the energy norm
/// Returns false if the iteration did not reach that tolerance: the step must then be rolled back.
bool return_to_surface(const ElasticPair& pair, const Vec6 (&d)[2], const SectionLaw& law, ReturnMapResult (&flow)[2],
                       double tolerance = 1e-4, const SectionConditions* at = no_conditions);

/// Consistent tangent d(forces)/dd of a pair after that return, 12 x 12 (eq 10a for a pair).
///   elastic  elastic deformations after the flow
///   flow     null for an element that does not flow
PairMatrix pair_tangent(const ElasticPair& pair, const Vec6 (&elastic)[2], const SectionLaw& law,
                        const ElementFlow* const (&flow)[2], const SectionConditions* at = no_conditions);

}  // namespace hinge::beam

// Bounds that spare most elements the check of eq 16: no elastic strain takes them to a limit.
#pragma once

#include "effects/fracture_rule.h"
#include "model/structure.h"

namespace hinge {

/// True if a limit can ever be reached with this plastic deformation. Elastic curvature is a mean of the two end
/// moments over EI, and neither is above the fully plastic one. Where bending follows N (`p_delta`), S and A of
/// beam/beam_column.h at the fully plastic compression take from EI, and the chord shortens by bowing.
bool ever_within_reach(const FractureRule& rule, const Element& e, const Vec6& plastic, bool p_delta);

/// The same for a pair's element with its forces of now, which spares most elements the search for their deformation.
/// `force`, `of_partner`: forces p of the two elements. S and A fall ever faster with p' (beam/beam_column.h) and are
/// above the straight line from 1 at p' = 0 to 0.58 at p' = 2.
bool now_within_reach(const FractureRule& rule, const Element& e, const Vec6& plastic, const Vec6& force,
                      const Vec6& of_partner);

}  // namespace hinge

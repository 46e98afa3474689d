// The tangents of pairs whose bending follows their axial force (beam/beam_column.h), for statics.
#pragma once

#include "algebra/node_blocks.h"
#include "state/sweep.h"

namespace hinge {

struct PairTangents {
    std::vector<Mat6> of_element;     ///< dp/dd of each element with its partner's deformation held
    std::vector<Coupling> couplings;  ///< what each force has from the partner's deformation, in nodes
};

/// At `pose`. An element that yields takes part with its [D_p] (eq 10a). Elements whose partner is broken get none:
/// `of_element` holds zeros for them.
PairTangents pair_tangents(const Structure& structure, const State& state, const Pose& pose, const Sweep& sweep,
                           const std::vector<Yielding>& yielding);

}  // namespace hinge

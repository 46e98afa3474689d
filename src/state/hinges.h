// Hinges at the end of a step: what flowed is accumulated, and integration points go to where the hinges are.
#pragma once

#include "beam/pair_return.h"
#include "state/element_assembly.h"

namespace hinge {

/// Takes the flow of the step into `state`: plastic deformation, its work, which sections flow now and which ever have.
/// With Shift::elastic_and_plastic (the paper's letter, eqs 6 and 10) the element's point moves to the far end of its
/// hinge, its partner's to the middle, and both go back when it unloads; the forces are the same before and after. With
/// Shift::plastic the plastic strain alone is at the hinge and no point moves.
///   flowing  elements that flowed in the step before; replaced by those of this one
/// Returns the elements whose point moved.
std::vector<int> commit_flow(const Structure& structure, State& state, const std::vector<PlasticIncrement>& yielding,
                             std::vector<int>& flowing);

/// Moves the integration point of an element to s and keeps its forces: d_p takes what the compliance gives away.
void move_point(const Structure& structure, State& state, int element, double s);

/// What an element of a pair is whose bending follows its axial force. Pairs are elements 2 i and 2 i + 1.
inline beam::PairKind<double> pair_kind_of(const Element& e) { return beam::pair_kind(e.rigidity, e.length); }

/// k(s) of the element as it stands.
inline beam::Stiffness stiffness_now(const Structure& structure, const State& state, int element) {
    const Element& e = structure.elements()[element];
    return state.point[element] == e.s ? e.stiffness : beam::stiffness(e.rigidity, e.length, state.point[element]);
}

/// Whether the element is one of a pair whose bending follows its axial force, and both are whole.
inline bool in_pair(const Structure& structure, const State& state, int element) {
    return structure.p_delta() && !state.broken[element] && !state.broken[structure.elements()[element].partner];
}

/// dp/dd of such a pair, 12 x 12, `first` its first element. `flow`: of its elements, null where one does not flow.
beam::PairMatrix pair_tangent(const Structure& structure, const State& state, const Configuration& pose,
                              const ElementAssembly& assembly, int first,
                              const beam::ReturnMapResult* const (&flow)[2]);
/// The same while both are elastic. `place`: of the two elements at the pose, where that is known.
beam::PairMatrix elastic_pair_tangent(const Structure& structure, const State& state, const Configuration& pose,
                                      int first, const ElementFrame* place = nullptr);

}  // namespace hinge

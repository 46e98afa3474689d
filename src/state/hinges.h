// Hinges at the end of a step: what flowed is accumulated, and integration points go to where the hinges are.
#pragma once

#include "state/sweep.h"

namespace hinge {

/// Takes the flow of the step into `state`: plastic deformation, its work, which sections flow now and which ever have.
/// With Shift::whole (the paper's letter, eqs 6 and 10) the element's point moves to the far end of its hinge, its
/// partner's to the middle, and both go back when it unloads; the forces are the same before and after. With
/// Shift::plastic the plastic strain alone is at the hinge and no point moves.
///   flowing  elements that flowed in the step before; replaced by those of this one
/// Returns the elements whose point moved.
std::vector<int> commit_flow(const Structure& structure, State& state, const std::vector<Yielding>& yielding,
                             std::vector<int>& flowing);

/// Moves the integration point of an element to s and keeps its forces: d_p takes what the compliance gives away.
void move_point(const Structure& structure, State& state, int element, double s);

/// k(s) of the element as it stands.
inline beam::Stiffness stiffness_now(const Structure& structure, const State& state, int element) {
    const Element& e = structure.elements()[element];
    return state.point[element] == e.s ? e.stiffness : beam::stiffness(e.rigidity, e.length, state.point[element]);
}

}  // namespace hinge

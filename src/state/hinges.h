// Plastic hinges at the end of a step: plastic flow is accumulated, and integration points move to the hinges.
#pragma once

#include "beam/pair_return.h"
#include "section/softened_law.h"
#include "state/element_assembly.h"

namespace hinge {

/// Adds the plastic flow of the step to `state`: plastic deformation, its work, which sections flow now and which ever
/// have. With Shift::elastic_and_plastic (the paper's letter, eqs 6 and 10) the element's point moves to the far end of
/// its hinge, its partner's to the middle, and both go back when it unloads; the forces are the same before and after.
/// With Shift::plastic the plastic strain alone is at the hinge and no point moves.
///   dt       length of the step, s
///   flowing  elements that flowed in the step before; replaced by those of this one
/// Returns the elements whose point moved.
std::vector<int> commit_flow(const Structure& structure, State& state, const std::vector<PlasticIncrement>& yielding,
                             double dt, std::vector<int>& flowing);

/// Moves the integration point of an element to s and keeps its forces: d_p takes the change of elastic deformation.
void move_point(const Structure& structure, State& state, int element, double s);

/// History variables of the law of section r of an element; null where it has none.
inline const double* section_history(const Structure& structure, const State& state, int element, double r) {
    const beam::SectionLaw* law = structure.elements()[element].law;
    const double* all = history_of(structure, state, element);
    return all && law && law->history_size() > 0 ? all + (r > 0 ? law->history_size() : 0) : nullptr;
}

/// Slack of an element, m: part of its plastic elongation (SectionLaw::slack).
inline double slack_of(const Structure& structure, const State& state, int element) {
    const double* history = section_history(structure, state, element, -1);
    return history ? structure.elements()[element].law->slack(history) : 0;
}

/// Pair stiffness of an element whose bending follows its axial force. Pairs are elements 2 i and 2 i + 1. Where they
/// form none, it adds nothing to the element's own.
inline beam::PairKind<double> pair_kind_of(const Element& e, const ElementHeat& heat = no_heat) {
    if (!e.forms_pairs)
        return {.axial = heat.stiffness * e.rigidity.EA / e.length, .length = 0, .b = {}, .c = {}, .shear = {}};
    return heat.stiffness * beam::pair_kind(e.rigidity, e.length);
}

/// Stiffness k(s) of the element with its present integration point, of the declared material, without springs.
inline beam::Stiffness declared_stiffness(const Structure& structure, const State& state, int element) {
    const Element& e = structure.elements()[element];
    return state.point[element] == e.s ? e.stiffness : beam::stiffness(e.rigidity, e.length, state.point[element]);
}

/// Springs at the ends of an element, by what its hinges have lost of their stiffness in unloading.
beam::EndSprings springs_of(const Structure& structure, const State& state, int element,
                            const ElementHeat& heat = no_heat);

/// What an element has of the rotations of its hinges in a step as elastic ones from then on, since they have become
/// softer in unloading; its forces are the same.
struct Softening {
    Vec6 turned = Vec6::Zero();  ///< in the places of d, rad
    double stored = 0;           ///< elastic energy, part of the plastic work of the step, J
};
Softening softening_of(const Structure& structure, const State& state, const PlasticIncrement& y,
                       const ElementHeat& heat);

/// True if the element is one of a pair whose bending follows its axial force, and both are whole.
inline bool in_pair(const Structure& structure, const State& state, int element) {
    const Element& e = structure.elements()[element];
    return structure.p_delta() && !state.broken[element] && !state.broken[e.partner] && e.forms_pairs;
}

/// The same at the temperature of a trial configuration, or of the state. It has the springs at the element's ends,
/// other than of elements in a pair, whose ElasticPair has them.
inline beam::Stiffness stiffness_now(const Structure& structure, const State& state, int element,
                                     const ElementHeat& heat) {
    const beam::Stiffness k = heat.stiffness * declared_stiffness(structure, state, element);
    if (!structure.wears_stiffness() || in_pair(structure, state, element)) return k;
    return in_series(k, springs_of(structure, state, element, heat));
}
inline beam::Stiffness stiffness_now(const Structure& structure, const State& state, int element) {
    return stiffness_now(structure, state, element, heat_of(state.heat, element));
}

/// The law of an element's sections at a temperature.
inline beam::LawAt law_now(const Element& e, const ElementHeat& heat) {
    return beam::LawAt(*e.law, heat.strength, heat.temperature);
}

/// f_y of resultants q (Mx, My, N, Mz) in section r of an element, by its law where the state is; 0 without a law.
inline double yield_function_at(const Structure& structure, const State& state, int element, double r, const Vec4& q) {
    const Element& e = structure.elements()[element];
    return e.law ? law_now(e, heat_of(state.heat, element))
                       ->yield_function(q, section_history(structure, state, element, r))
                 : 0;
}

/// The elastic side of the pair whose first element is `first`.
inline beam::ElasticPair elastic_pair(const Structure& structure, const State& state, int first,
                                      const ElementHeat& heat) {
    beam::ElasticPair pair = {pair_kind_of(structure.elements()[first], heat),
                              {heat.stiffness * declared_stiffness(structure, state, first),
                               heat.stiffness * declared_stiffness(structure, state, first + 1)}};
    if (structure.wears_stiffness())
        for (int i : {0, 1}) pair.springs[i] = springs_of(structure, state, first + i, heat);
    return pair;
}

/// Tangent dp/dd of such a pair, 12 x 12. `first`: first element. `flow`: of both, null if one does not flow.
beam::PairMatrix pair_tangent(const Structure& structure, const State& state, const Configuration& pose,
                              const ElementAssembly& assembly, int first,
                              const beam::ReturnMapResult* const (&flow)[2]);
/// That tangent while both are elastic. `place`: of the two elements at the pose, where that is known.
beam::PairMatrix elastic_pair_tangent(const Structure& structure, const State& state, const Configuration& pose,
                                      int first, const ElementFrame* place = nullptr);

}  // namespace hinge

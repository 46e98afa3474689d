// The tangents of elements that flow, [D_p] of eq 10a, for statics and Newmark's method.
#pragma once

#include <Eigen/LU>

#include "algebra/effective_stiffness.h"
#include "state/hinges.h"

namespace hinge {

/// dp/dd of an element that flows by itself, [D_p] of eq 10a, consistent with the return to the yield surface.
inline Mat6 yield_tangent(const Structure& structure, const State& state, const Configuration& pose,
                          const ElementAssembly& assembly, const PlasticIncrement& y) {
    double section[2];
    const int n = assembly.sections(section);
    const ElementHeat& heat = heat_of(pose.heat, y.element);
    return law_now(structure.elements()[y.element], heat)
        ->tangent(y.flow, stiffness_now(structure, state, y.element, heat), section, n,
                  assembly.conditions(state, y.element));
}

/// What the effective stiffness takes in the place of the elastic one for those of `list` (rising) that flow, from
/// their [D_p], or whose partner does.
inline std::vector<ElementTangent> given_tangents(const Structure& structure, const State& state,
                                                  const Configuration& pose, const ElementAssembly& assembly,
                                                  const std::vector<int>& list,
                                                  const std::vector<PlasticIncrement>& yielding) {
    std::vector<ElementTangent> given;
    int done = -1;  // elements up to here have theirs
    for (std::size_t i = 0; i < yielding.size(); ++i) {
        const int element = yielding[i].element;
        if (element <= done || !std::binary_search(list.begin(), list.end(), element)) continue;
        if (!in_pair(structure, state, element)) {
            given.push_back({element, yield_tangent(structure, state, pose, assembly, yielding[i]), Mat6::Zero()});
            continue;
        }
        const int first = element & ~1;
        const beam::ReturnMapResult* flow[2] = {nullptr, nullptr};
        flow[element - first] = &yielding[i].flow;
        if (i + 1 < yielding.size() && yielding[i + 1].element == first + 1) flow[1] = &yielding[i + 1].flow;
        const beam::PairMatrix K = pair_tangent(structure, state, pose, assembly, first, flow);
        given.push_back({first, K.topLeftCorner<6, 6>(), K.topRightCorner<6, 6>()});
        given.push_back({first + 1, K.bottomRightCorner<6, 6>(), K.bottomLeftCorner<6, 6>()});
        done = first + 1;
    }
    return given;
}

/// What elements that flow resist with where their fixed-end parts change by `change`, and the nodes do not move, on
/// their nodes: an element and its fixed-end part together yield as if it were deformed by what makes that elastically.
/// `given`: their tangents. Sections have the mean of N and Mz at the two ends.
inline void add_response(const Structure& structure, const State& state, const Configuration& pose,
                         const std::vector<ElementTangent>& given, const std::vector<beam::FixedEnd>& change,
                         std::vector<Vec6>& resisting) {
    for (const ElementTangent& g : given) {
        const Vec6 own = change[g.element].at(0);
        Vec6 p = -own;
        if (in_pair(structure, state, g.element)) {
            const int first = g.element & ~1, i = g.element - first;
            Vec12 both;
            both << change[first].at(0), change[first + 1].at(0);
            const Vec12 d = elastic_pair_tangent(structure, state, pose, first).partialPivLu().solve(both);
            p += g.own * d.segment<6>(6 * i) + g.partner * d.segment<6>(6 - 6 * i);
        } else {
            p += g.own * stiffness_now(structure, state, g.element, heat_of(pose.heat, g.element)).solve(own);
        }
        const Vec12 f = nodal_forces(element_frame(structure, g.element, pose), p);
        for (int end : {0, 1}) resisting[structure.elements()[g.element].node[end]] += f.segment<6>(6 * end);
    }
}

/// What flowed at the end of a step flows on when the next one begins: its [D_p] is that of a beginning.
inline std::vector<PlasticIncrement> flowing_on(std::vector<PlasticIncrement> yielding) {
    for (PlasticIncrement& y : yielding)
        for (double& lambda : y.flow.lambda) lambda = lambda > 0 ? 1e-300 : 0;
    return yielding;
}

}  // namespace hinge

// The tangents of elements that flow, [D_p] of eq 10a, for statics and Newmark's method.
#pragma once

#include "algebra/effective_stiffness.h"
#include "state/hinges.h"

namespace hinge {

/// dp/dd of each element of `yielding`, [D_p] of eq 10a, consistent with the return to the yield surface.
inline std::vector<Mat6> yield_tangents(const Structure& structure, const State& state, const Sweep& sweep,
                                        const std::vector<Yielding>& yielding) {
    std::vector<Mat6> tangents;
    tangents.reserve(yielding.size());
    double section[2];
    const int n = sweep.sections(section);
    for (const Yielding& y : yielding) {
        const bool active[2] = {y.flow.lambda[0] > 0, y.flow.lambda[1] > 0};
        tangents.push_back(beam::plastic_tangent(y.flow.p, stiffness_now(structure, state, y.element),
                                                 structure.elements()[y.element].yield, section, y.flow.lambda, active,
                                                 n));
    }
    return tangents;
}

/// Of each element of `list` (rising), its tangent if it flows, null if it is elastic.
inline std::vector<const Mat6*> tangents_of(const std::vector<int>& list, const std::vector<Yielding>& yielding,
                                            const std::vector<Mat6>& tangents) {
    std::vector<const Mat6*> given(list.size(), nullptr);
    for (std::size_t i = 0; i < yielding.size(); ++i) {
        const auto at = std::lower_bound(list.begin(), list.end(), yielding[i].element);
        if (at != list.end() && *at == yielding[i].element) given[at - list.begin()] = &tangents[i];
    }
    return given;
}

/// What flowed at the end of a step flows on when the next one begins: its [D_p] is that of a beginning.
inline std::vector<Yielding> flowing_on(std::vector<Yielding> yielding) {
    for (Yielding& y : yielding)
        for (double& lambda : y.flow.lambda) lambda = lambda > 0 ? 1e-300 : 0;
    return yielding;
}

}  // namespace hinge

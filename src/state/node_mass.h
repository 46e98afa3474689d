// Mass of elements and offset masses at their nodes. The assembly computes eight elements at a time itself
// (assembly_stages.cpp).
#pragma once

#include "state/state.h"

namespace hinge {

/// Calls f(node, kg) for both nodes of each whole element: the element's share at the node in a uniform acceleration.
template <class F>
void for_each_weight(const Structure& structure, const State& state, F f) {
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        if (state.broken[i]) continue;
        const beam::Inertia& m = structure.inertia(int(i));
        for (int end : {0, 1}) f(structure.elements()[i].node[end], m.weight(end));
    }
}

/// Lumped masses of the whole elements at a node.
struct LumpedMass {
    double mass = 0;    ///< kg
    double rotary = 0;  ///< kg m^2, about every axis
    /// Inverse for each degree of freedom, 1/kg and 1/(kg m^2); zero where `held` or massless.
    Vec6 inverse(std::uint8_t held) const;
};
LumpedMass lumped_mass_at(const Structure& structure, const State& state, int node);

/// The mass attached to a node, 6 x 6 in space (kg, kg m, kg m^2).
Mat6 offset_mass_in_space(const OffsetMass& offset, const Quat& rotation);

}  // namespace hinge

// Mass of elements and offset masses at their nodes. The assembly computes eight elements at a time itself
// (assembly_stages.cpp).
#pragma once

#include "state/state.h"

namespace hinge {

/// The end (0, 1) of an element that is at the middle of its pair.
inline int inner_end(int index, const Element& e) { return index < e.partner ? 1 : 0; }

/// True for a whole element with lumped mass whose partner has broken off. A part of its mass is then in the offset
/// mass of its inner node (lone_elements.h); State::offset_arm has where, from that node.
inline bool is_lone(const Structure& structure, const State& state, int element) {
    return structure.lumped() && !state.offset_arm.empty() && structure.elements()[element].partner >= 0 &&
           !state.broken[element] && !state.offset_arm[element].isZero(0);
}

/// Mass of a whole element without what is in offset masses, in local axes.
inline const beam::Inertia& inertia_now(const Structure& structure, const State& state, int element) {
    return is_lone(structure, state, element) ? structure.elements()[element].lone : structure.inertia(element);
}

/// Calls f(node, kg) for both nodes of each whole element: the element's share at the node in a uniform acceleration.
template <class F>
void for_each_weight(const Structure& structure, const State& state, F f) {
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        if (state.broken[i]) continue;
        const beam::Inertia& m = inertia_now(structure, state, int(i));
        for (int end : {0, 1}) f(structure.elements()[i].node[end], m.weight(end));
    }
}

/// Calls f(node, kg) for what an element that has just broken, and a partner that is lone since, had on nodes before
/// and have no more.
template <class F>
void for_each_lost_weight(const Structure& structure, const State& state, int element, F f) {
    const Element& e = structure.elements()[element];
    const bool lumped_pair = structure.lumped() && e.partner >= 0, was_lone = lumped_pair && state.broken[e.partner];
    const beam::Inertia& m = was_lone ? e.lone : e.inertia;
    for (int end : {0, 1}) f(e.node[end], m.weight(end));
    if (!lumped_pair || was_lone) return;
    const Element& other = structure.elements()[e.partner];
    for (int end : {0, 1}) f(other.node[end], other.inertia.weight(end) - other.lone.weight(end));
}

/// Mass of a whole element that moves with a node where it hits something, kg: half of it, or its lump.
double striking_mass(const Structure& structure, const State& state, int element, int end);

/// Lumped masses of the whole elements at a node.
struct LumpedMass {
    double mass = 0;    ///< kg
    double rotary = 0;  ///< kg m^2, about every axis
    /// Inverse for each degree of freedom, 1/kg and 1/(kg m^2); zero where `held` or massless.
    Vec6 inverse(std::uint8_t held) const;
};
/// Half of each element on each node where the structure has other masses.
LumpedMass lumped_mass_at(const Structure& structure, const State& state, int node);

/// The mass attached to a node, 6 x 6 in space (kg, kg m, kg m^2).
Mat6 offset_mass_in_space(const OffsetMass& offset, const Quat& rotation);

}  // namespace hinge

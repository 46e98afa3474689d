#include "state/node_mass.h"

#include "beam/element_mass.h"

namespace hinge {

Vec6 LumpedMass::inverse(std::uint8_t held) const {
    Vec6 inverse = Vec6::Zero();
    for (int c = 0; c < 6; ++c)
        if (const double m = c < 3 ? mass : rotary; m > 0 && !(held >> c & 1)) inverse[c] = 1 / m;
    return inverse;
}

LumpedMass lumped_mass_at(const Structure& structure, const State& state, int node) {
    LumpedMass sum;
    for (int index : structure.elements_at(node)) {
        if (state.broken[index]) continue;
        const Element& element = structure.elements()[index];
        const int end = element.node[0] == node ? 0 : 1;
        const beam::Inertia lumped = structure.lumped() ? inertia_now(structure, state, index)
                                                        : beam::lumped_inertia(element.rigidity, element.length, 0.5);
        sum.mass += lumped.own[end];
        sum.rotary += lumped.rotary[end].x();
    }
    return sum;
}

double striking_mass(const Structure& structure, const State& state, int index, int end) {
    const Element& e = structure.elements()[index];
    if (!structure.lumped()) return 0.5 * e.mass();
    const double own = inertia_now(structure, state, index).own[end];
    return is_lone(structure, state, index) && end == inner_end(index, e) ? e.mass() - e.lone.own[1 - end] : own;
}

Mat6 offset_mass_in_space(const OffsetMass& h, const Quat& rotation) {
    const Mat3 R = rotation.toRotationMatrix();
    return beam::offset_mass_matrix(h.mass, R * h.moment, R * h.inertia * R.transpose());
}

}  // namespace hinge

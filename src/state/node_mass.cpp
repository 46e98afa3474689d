#include "state/node_mass.h"

#include "beam/element_mass.h"

namespace hinge {

Vec6 LumpedMass::inverse(std::uint8_t held) const {
    Vec6 inverse = Vec6::Zero();
    for (int c = 0; c < 6; ++c)
        if (mass > 0 && !(held >> c & 1)) inverse[c] = 1 / (c < 3 ? mass : rotary);
    return inverse;
}

LumpedMass lumped_mass_at(const Structure& structure, const State& state, int node) {
    LumpedMass sum;
    for (int index : structure.elements_at(node)) {
        if (state.broken[index]) continue;
        const Element& element = structure.elements()[index];
        const beam::Inertia lumped = beam::lumped_inertia(element.rigidity, element.length);
        sum.mass += lumped.own[0];
        sum.rotary += lumped.rotary[0].x();
    }
    return sum;
}

Mat6 offset_mass_in_space(const OffsetMass& h, const Quat& rotation) {
    const Mat3 R = rotation.toRotationMatrix();
    return beam::offset_mass_matrix(h.mass, R * h.moment, R * h.inertia * R.transpose());
}

}  // namespace hinge

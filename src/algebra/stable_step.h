// The longest step in which central differences stay stable.
#pragma once

#include <span>

#include "algebra/node_blocks.h"
#include "model/structure.h"

namespace hinge {

/// 2 / omega, s, for the highest frequency that any single element has with its lumped mass, which no structure of them
/// exceeds (Irons 1970); `element` is the one that has it. As the script declared it, without load: contact and initial
/// stress come on top. Damping of the elements (empty: none) takes part with the velocity that a step predicts,
/// v + dt a, and shortens it to 2 / (c + sqrt(c^2 + omega^2)), c = of_mass + of_stiffness omega^2: beyond it the
/// fastest motion changes its sign with every step and grows.
struct StableStep {
    double dt;
    int element;
};
StableStep stable_step(const Structure& structure, std::span<const ElementDamping> damping = {});

/// The part of it that a run takes of itself: room for large rotations and for what contact adds. A touch is as stiff
/// as its softer element, which takes a node's frequency up by the root of 3/2; gap elements are four springs of half
/// an element's length each, which take it up three times (Case I of the ten-storey impact holds its energy to 0.1 % at
/// 0.22 of the limit, to 0.35 % at 0.37, and not at all at 0.7).
inline double usual_step(const StableStep& limit, const Model& model) {
    double part = 0.9;
    for (const ContactRule& rule : model.contact())
        part = std::min(part, rule.settings.rule == contact::ContactRuleKind::gap ? 0.22 : 0.7);
    return part * limit.dt;
}

}  // namespace hinge

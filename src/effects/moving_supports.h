// Motions of supports, as a script declares them.
#pragma once

#include "model/history.h"
#include "model/model.h"

namespace hinge {

inline constexpr const char* moving_supports_effect = "moving supports";

/// Prescribed displacement of a support over time, relative to its position at the start of the run: m along x, y or z,
/// or rad about an axis of space, whose rate is the node's rate of rotation about that axis.
struct SupportMotion {
    int node, component;
    History displacement;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.node, s.component, s.displacement);
    }
};

/// Declares the motion and fixes what it moves.
void add_motion(Model& model, SupportMotion motion);

}  // namespace hinge

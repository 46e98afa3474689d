// Supports that settle in statics, as a script declares them.
#pragma once

#include "model/model.h"

namespace hinge {

inline constexpr const char* settlement_effect = "settlement";

/// The displacement of a supported degree of freedom at load factor 1, from the declared position: m, or rad about an
/// axis of space.
struct Settlement {
    int node = 0, component = 0;
    double by = 0;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.node, s.component, s.by);
    }
};

/// Declares the settlement and fixes what it moves.
void add_settlement(Model& model, const Settlement& settlement);

}  // namespace hinge

// Rigid diaphragms, as a script declares them.
#pragma once

#include <vector>

namespace hinge {

inline constexpr const char* diaphragm_effect = "diaphragms";

/// Nodes that keep their distances in the plane across x, y or z, and share the rotation about its normal.
struct Diaphragm {
    std::vector<int> nodes;  ///< the first one is the one that the others follow
    int normal = 2;          ///< 0 to 2: x, y, z

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.nodes, s.normal);
    }
};

}  // namespace hinge

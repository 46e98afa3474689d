// Rigid links between two nodes, as a script declares them.
#pragma once

#include <cstdint>

namespace hinge {

inline constexpr const char* rigid_link_effect = "rigid links";

/// Node `to` moves with node `from` as a rigid body.
struct RigidLink {
    int from, to;
    std::uint8_t tied = 63;  ///< six bits of `to`: all, or 7, its translations alone (a ball joint at its end)

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.from, s.to, s.tied);
    }
};

}  // namespace hinge

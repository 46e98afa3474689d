// A rigid half space that members fall on, as a script declares it.
#pragma once

#include <optional>

#include "core/types.h"

namespace hinge {

inline constexpr const char* ground_effect = "ground";

/// A plane; the solid side is the one that `normal` points away from.
struct GroundPlane {
    Vec3 point = Vec3::Zero();          ///< m
    Vec3 normal = Vec3::UnitZ();        ///< of unit length
    double friction = 0;                ///< Coulomb's coefficient
    double stiffness = 0;               ///< of each point of contact, N/m; 0: of the elements that meet there
    std::optional<double> restitution;  ///< 0 to 1; none: what comes of the springs alone
    int group = -1;                     ///< whose members meet it, -1: all

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.point, s.normal, s.friction, s.stiffness, s.restitution, s.group);
    }
};

}  // namespace hinge

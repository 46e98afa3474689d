// Point masses as a script declares them.
#pragma once

#include "core/types.h"

namespace hinge {

inline constexpr const char* point_mass_effect = "point masses";

/// Attached rigidly to a node, with which it rotates. Offset and axes are those of space before anything has moved.
struct PointMass {
    int node;
    double mass;                  ///< kg, positive
    Vec3 inertia = Vec3::Zero();  ///< about x, y, z through the mass, kg m^2
    Vec3 offset = Vec3::Zero();   ///< from the node to the mass, m

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.node, s.mass, s.inertia, s.offset);
    }
};

}  // namespace hinge

// A ground that members fall on, as a script declares it. ground_law.h has the two laws by which it presses.
#pragma once

#include <optional>

#include "core/types.h"

namespace hinge {

inline constexpr const char* ground_effect = "ground";

/// What a ground is where a script gives neither `stiffness` nor `restitution`, per area.
///
/// Stiffness: the modulus of subgrade reaction of dense sand, 64 to 128 MN/m^3 (Bowles, Foundation Analysis and Design,
/// 5th edition, 1996, table 9-1). A steel bar of 0.1 m that lies flat settles by 0.08 mm.
///
/// Damping: chosen, not measured. A steel column of a storey, 3 m, that lands on its end keeps a quarter of its speed
/// (0.65 of critical), and members that land flat keep none. The waves that a rigid plate sends into dense sand take a
/// third of it (Lysmer's analogue: density times wave speed, 1900 kg/m^3 times 390 m/s); the rest stands for rubble and
/// soil that is crushed, which has no law of its own here.
inline constexpr double layer_stiffness = 1e8, layer_damping = 2e6;  // N/m^3, N s/m^3

/// A plane; the solid side is the one that `normal` points away from.
struct GroundPlane {
    Vec3 point = Vec3::Zero();    ///< m
    Vec3 normal = Vec3::UnitZ();  ///< of unit length
    double friction = 0;          ///< Coulomb's coefficient
    /// Of each point of contact, N/m; 0: of the elements that meet there. Either of these two asks for points.
    double stiffness = 0;
    /// 0 to 1, of the normal velocity of a point; none: what comes of the springs alone, as with 1. It is the point's:
    /// an elastic bar that lands on its end comes back with 0.8 to 1 of its speed whatever this is, because all but one
    /// of its nodes never touch the ground.
    std::optional<double> restitution;
    double layer_stiffness = hinge::layer_stiffness;  ///< N/m^3, above 0
    double layer_damping = hinge::layer_damping;      ///< N s/m^3, 0 or above
    int group = -1;                                   ///< whose members meet it, -1: all

    bool is_layer() const { return stiffness == 0 && !restitution; }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.point, s.normal, s.friction, s.stiffness, s.restitution, s.layer_stiffness, s.layer_damping, s.group);
    }
};

}  // namespace hinge

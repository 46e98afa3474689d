// Pose and motion of a structure, in a state or on trial.
#pragma once

#include <vector>

#include "core/types.h"
#include "state/element_heat.h"

namespace hinge {

/// Turns of the ends of an element by its hinges (state/turned_ends.h).
struct TurnedEnds {
    double by[2][4] = {{1}, {1}};  ///< of each end's axes against its node's, at the start: quaternion w x y z
    double flowed[6] = {};         ///< the plastic deformation that `by` replaces
    Quat of(int end) const { return {by[end][0], by[end][1], by[end][2], by[end][3]}; }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.by, s.flowed);
    }
};

/// Places and rotations of the nodes, and what else the deformation of the elements follows from.
struct Pose {
    std::vector<Vec3> displacement;    ///< m
    std::vector<Quat> rotation;        ///< large displacement: since the start
    std::vector<Vec3> small_rotation;  ///< small displacement alone: rotation vector, rad
    /// Twist of an element's ends against each other, turns counted, rad; 0 up to a third of a turn (beam/winding.h);
    /// empty until one has twisted that far. On trial it is that where the step began, as `turned` is.
    std::vector<double> twist;
    std::vector<TurnedEnds> turned;  ///< empty until a hinge has turned an end far
    ElementHeats heat;               ///< empty where nothing is heated
};

/// A pose and the motion of the nodes there, in space.
struct Configuration : Pose {
    std::vector<Vec6> velocity;      ///< m/s and rad/s
    std::vector<Vec6> acceleration;  ///< m/s^2 and rad/s^2
};

}  // namespace hinge

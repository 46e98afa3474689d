// End of a bar: a point rigidly attached to a node.
#pragma once

#include <functional>

#include "core/types.h"

namespace hinge::contact {

/// A point rigidly attached to a node. `arm` is zero for a real node; a broken element ends in a virtual node, whose
/// arm rotates with the node that carries it.
struct End {
    int node = -1;
    Vec3 arm = Vec3::Zero();  ///< m, in the node's own frame: the point is position + rotation * arm

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.node, s.arm);
    }
};

/// Adds a 12x12 stiffness between two different nodes (rows and columns: translation and rotation of node a, then of
/// node b).
using AddStiffness = std::function<void(int node_a, int node_b, const Mat12&)>;

}  // namespace hinge::contact

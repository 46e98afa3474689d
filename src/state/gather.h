// Numbers of the nodes of eight elements, a lane for each: for kernels that take eight elements at once.
#pragma once

#include <vector>

#include "beam/corotation.h"
#include "core/types.h"

namespace hinge {

/// Three numbers of each of eight nodes, from the given one of its numbers on.
template <class T>
[[gnu::always_inline]] inline beam::Triple<Lanes> gather(const std::vector<T>& from, const int* node, int offset = 0) {
    Lanes v[lane_count];
    pick_rows<3>(from.data()->data() + offset, node, sizeof(T) / sizeof(double), v);
    return {v[0], v[1], v[2]};
}

[[gnu::always_inline]] inline beam::Quadruple<Lanes> gather(const std::vector<Quat>& from, const int* node) {
    Lanes v[lane_count];
    pick_rows<4>(from.data()->coeffs().data(), node, 4, v);  // x y z w
    return {v[3], v[0], v[1], v[2]};
}

/// Velocities or accelerations of eight nodes.
struct Motion {
    beam::Triple<Lanes> linear, angular;
};
[[gnu::always_inline]] inline Motion gather_motion(const std::vector<Vec6>& from, const int* node) {
    Lanes v[lane_count];
    pick_rows<6>(from.data()->data(), node, 6, v);
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

}  // namespace hinge

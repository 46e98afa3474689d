// Bodies that whole elements and links between nodes hold together, and which of them something holds.
#pragma once

#include "state/bodies.h"

namespace hinge {

/// Bodies that whole elements hold together in `state`, and links of the model (node_links), broken or not. A node
/// without elements that a link reaches is part of none.
Bodies joined_bodies(const Structure& structure, const State& state);

/// Of each body, whether something holds it: a support in any direction, or a link to the ground or to a node without
/// elements that is held.
std::vector<char> held_bodies(const Structure& structure, const State& state, const Bodies& bodies);

/// Of each body, whether it is carried against gravity g: a support holds one of its nodes in a direction in which
/// gravity acts, or a link joins it to the ground, to a held node without elements, or to a body that is carried.
std::vector<char> carried_bodies(const Structure& structure, const State& state, const Bodies& bodies, const Vec3& g);

}  // namespace hinge

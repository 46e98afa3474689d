// Sums over the effects of a run: their stiffness, and what loads between nodes do at the ends of elements.
#pragma once

#include "effects/effect_list.h"

namespace hinge {

/// Stiffness (and damping times `of_damping`) that effects add between nodes.
Blocks added_blocks(const EffectList& effects, const Pose& at, double of_damping);
void add_blocks(const EffectList& effects, const Pose& at, Blocks& to);

/// Reads which elements take part and where their integration points are, after a point has moved.
void read_active(Workspace& w);

/// Gives the element assembly the fixed-end forces of all loads between nodes, at the configuration that is tried.
/// `factor`: the load factor of statics.
void find_fixed_ends(Workspace& w, const EffectList& effects, double factor);

}  // namespace hinge

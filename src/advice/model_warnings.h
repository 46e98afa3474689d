// Warnings of likely mistakes in a model: units, and members and nodes that only seem to be joined.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "advice/warning.h"

namespace hinge {

/// Finds all likely mistakes of a model: E, density, yield stress, sections, positions and gravity in other units than
/// SI; materials that yield with sections that cannot; gravity that pulls up; nodes that no member uses; nodes within a
/// millionth of the model's size, or a thousandth of the shortest member there, of each other, and members that lie on
/// each other or pass through a node, not joined; members shorter than a fiftieth of one that they are joined to.
/// `joined`: pairs of nodes that something other than a member joins. `gravity`: m/s^2.
std::vector<Warning> warnings(const Model& model, const std::vector<std::pair<int, int>>& joined = {},
                              const std::optional<Vec3>& gravity = {});

}  // namespace hinge

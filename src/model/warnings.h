// Warnings of likely mistakes in a model: units, and members and nodes that only seem to be joined.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/model.h"

namespace hinge {

/// A likely mistake and its remedy. `more` counts further ones of the same kind.
struct Warning {
    std::string what;  ///< "member 3 ...", with the culprit's name, its value and its unit
    std::string advice;
    std::string asked_at;  ///< the script's line, "" where it is not known
    int more = 0;
    int tells_of = 1;          ///< number of equal objects that it describes
    bool of_units = false;     ///< a number that looks as if it were in another unit
    bool of_buckling = false;  ///< members near Euler's load in a linear solution
};

/// Finds all likely mistakes of a model: E, density, yield stress, sections, positions and gravity in other units than
/// SI; materials that yield with sections that cannot; gravity that pulls up; nodes that no member uses; nodes within a
/// millionth of the model's size, or a thousandth of the shortest member there, of each other, and members that lie on
/// each other or pass through a node, not joined; members shorter than a fiftieth of one that they are joined to.
/// `joined`: pairs of nodes that something other than a member joins. `gravity`: m/s^2.
std::vector<Warning> warnings(const Model& model, const std::vector<std::pair<int, int>>& joined = {},
                              const std::optional<Vec3>& gravity = {});

/// The first warning about units, if any: results from such numbers are meaningless.
std::optional<Warning> of_units(const std::vector<Warning>& list);

}  // namespace hinge

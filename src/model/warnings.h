// What in a model is allowed but a likely mistake: units, members and nodes that are not joined as they seem to be.
#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace hinge {

/// One slip, and what to do about it. More of the same kind are counted: `more`.
struct Warning {
    std::string what;  ///< "member 3 ...", with the culprit's name, its value and its unit
    std::string advice;
    std::string asked_at;  ///< the script's line, "" where it is not known
    int more = 0;
    bool of_units = false;  ///< a number that looks as if it were in another unit
};

/// All of them: E, density, yield stress, sections, positions and gravity in other units than SI; gravity that pulls
/// up; nodes that no member uses; nodes within a millionth of the model's size of each other, and members that lie on
/// each other or pass through a node, not joined; members shorter than a fiftieth of one that they are joined to.
std::vector<Warning> warnings(const Model& model);

/// Whether one of them is of units: what is computed from such numbers is not worth a word.
bool doubts_units(const std::vector<Warning>& list);

}  // namespace hinge

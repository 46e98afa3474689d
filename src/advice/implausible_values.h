// Numbers of a script that look as if they were in another unit, or along another axis: hinge check tells them.
#pragma once

#include <vector>

#include "advice/warning.h"

namespace hinge {
class Structure;
}

namespace hinge {

/// Settlements, limits of fracture and velocities that are far too large, and gravity across a structure that stands
/// along z.
std::vector<Warning> implausible_values(const Structure& structure);

}  // namespace hinge

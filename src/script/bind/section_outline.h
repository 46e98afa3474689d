// The field `outline` of a section: its parts, each a polygon or a circle, or a hole.
#pragma once

#include <memory>

#include "beam/plastic_domain.h"
#include "script/lua/lua_support.h"

namespace hinge::script {

/// Reads { { corners = { {x, y}, ... }, hole = false }, { diameter = d, centre = {x, y}, hole = true }, ... }, m. The
/// centroid becomes the origin. Null if the field is absent. Errors: fewer than three corners, a part without area, or
/// holes as large as what they are in.
std::shared_ptr<const beam::SectionOutline> read_outline(Options& section);

}  // namespace hinge::script

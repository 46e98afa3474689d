// The fields `outline` and `reinforcement` of a section: its parts, each a polygon or a circle, or a hole; and the bars
// of a section of concrete.
#pragma once

#include <memory>

#include "section/plastic_domain.h"
#include "script/lua/options.h"

namespace hinge::script {

/// Reads { { corners = { {x, y}, ... }, hole = false }, { diameter = d, centre = {x, y}, hole = true }, ... }, m. The
/// centroid becomes the origin. Null if the field is absent. Errors: fewer than three corners, a part without area, or
/// holes as large as what they are in. With the field `reinforcement` = { concrete =, bars = { { x, y, area =,
/// tension =, compression = }, ... } }, Pa and m^2, the section is of concrete. Errors: a bar that is not within the
/// outline, or is in another, or weaker than the concrete; no bars, or so few that nearly no strength is left in some
/// direction.
std::shared_ptr<const beam::SectionOutline> read_outline(Options& section);

}  // namespace hinge::script

// The fields `outline` and `reinforcement` of a section: its parts, each a polygon or a circle, or a hole; and the bars
// of a section of concrete.
#pragma once

#include <memory>

#include "section/section_outline.h"
#include "script/lua/options.h"

namespace hinge::script {

/// Reads { { corners = { {x, y}, ... }, hole = false }, { diameter = d, centre = {x, y}, hole = true }, ... }, m, and
/// `reinforcement` = { concrete =, bars = { { x, y, area =, tension =, compression = }, ... }, strains = }, Pa and m^2.
/// Null if `outline` is absent. Errors: those of make_section_outline.
std::shared_ptr<const beam::SectionOutline> read_outline(Options& section);

}  // namespace hinge::script

// When a section counts as found too strong.
#pragma once

#include <string>

namespace hinge {

/// By how much a moment may exceed what the section carries before it is told: up to that eq 14 is within the scatter
/// of yield stresses. Near N0, where both vanish, by how many parts of M0.
inline constexpr double unsafe_excess = 0.10, unsafe_moment = 0.05;
/// Parts of M0 that are no difference: of alike members the first is named on every processor.
inline constexpr double alike_moment = 1e-9;

/// Whether that is so of a moment m beside which the exact one is `exact`, both in parts of M0.
inline bool is_unsafe(double m, double exact) { return m > (1 + unsafe_excess) * exact && m > exact + unsafe_moment; }

/// "73 %"
std::string excess_text(double excess);

}  // namespace hinge

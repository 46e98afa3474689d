// Compile-time switches of effects, all on. The benchmark also compiles an engine without these effects (HINGE_BARE),
// to show that an effect costs nothing in a scene that does not use it.
#pragma once

namespace hinge::built {

#ifdef HINGE_BARE
inline constexpr bool contact = false, fracture = false, plasticity = false;
#else
inline constexpr bool contact = true, fracture = true, plasticity = true;
#endif

}  // namespace hinge::built

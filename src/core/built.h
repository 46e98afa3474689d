// Which effects are compiled in: all of them. The bench compiles an engine without, to show that an effect that a scene
// does not call for costs no more than one that is not there.
#pragma once

namespace hinge::built {

#ifdef HINGE_BARE
inline constexpr bool contact = false, fracture = false, plasticity = false;
#else
inline constexpr bool contact = true, fracture = true, plasticity = true;
#endif

}  // namespace hinge::built

// Contact between elements as others read it.
#pragma once

#include "contact/member_contacts.h"
#include "state/state.h"

namespace hinge {

inline constexpr const char* contact_effect = "contact";

/// Null in a scene without contact.
inline const contact::Contact* contact_of(const State& state) {
    return state.data.find<contact::Contact>(contact_effect);
}

}  // namespace hinge

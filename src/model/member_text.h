// Name of a member in messages.
#pragma once

#include <string>

#include "model/model.h"

namespace hinge {

/// Name of a member with its first group: "member 3 (columns)"
inline std::string member_text(const Model& model, int member) {
    const auto& groups = model.members()[member].groups;
    return "member " + std::to_string(member + 1) + (groups.empty() ? "" : " (" + model.groups()[groups[0]] + ")");
}

}  // namespace hinge

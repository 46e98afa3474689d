// Members that a script takes out of the structure at a time of the run.
#pragma once

#include <string>

#include "core/archive.h"

namespace hinge {

inline constexpr const char* removal_effect = "removal";

/// All elements of the members break at the end of the first step of dynamics that reaches the time. What they put on
/// the nodes that keep other members then acts on as a force, and falls to nothing over a time.
struct Removal {
    int member = -1, group = -1;  ///< one of the two; of a group all members that it has in the run
    double at = 0;                ///< s
    double over = 0;              ///< s; 0: it is gone at once
    std::string asked_at;         ///< line of the script

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.member, s.group, s.at, s.over);
    }
};

}  // namespace hinge

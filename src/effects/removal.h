// Members that a script takes out of the structure at a time of the run.
#pragma once

#include <string>

#include "core/archive.h"

namespace hinge {

inline constexpr const char* removal_effect = "removal";

/// All elements of the members break at the end of the first step of dynamics that reaches the time.
struct Removal {
    int member = -1, group = -1;  ///< one of the two; of a group all members that it has in the run
    double at = 0;                ///< s
    std::string asked_at;         ///< line of the script

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.member, s.group, s.at);
    }
};

}  // namespace hinge

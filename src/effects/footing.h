// The supports of a body, relative to which it is damped where they move.
#pragma once

#include <vector>

#include "core/types.h"

namespace hinge {

/// Which supports a body is damped relative to, along x, y and z each.
struct Footing {
    std::vector<int> supports[3];

    /// The mean over them of what `of` (a node, a direction) says; 0 without supports.
    template <class Of>
    Vec3 mean(Of of) const {
        Vec3 all = Vec3::Zero();
        for (int c : {0, 1, 2}) {
            for (const int node : supports[c]) all[c] += of(node, c);
            if (!supports[c].empty()) all[c] /= double(supports[c].size());
        }
        return all;
    }
};

}  // namespace hinge

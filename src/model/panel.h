// Panels as a script declares them: flat plates between three or four nodes.
#pragma once

#include <memory>
#include <vector>

#include "model/model.h"
#include "panel/sheet.h"

namespace hinge {

inline constexpr const char* panels_effect = "panels";

/// A plate in its plane between nodes, in their order around it.
struct Panel {
    std::vector<int> nodes;                     ///< three or four
    std::shared_ptr<const panel::Sheet> sheet;  ///< what it is made of
    Vec3 along = Vec3::Zero();                  ///< direction of the sheet's x axis, projected into the plane

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.nodes, *s.sheet, s.along);
    }
};

}  // namespace hinge

// Panels as a script declares them: flat plates between three or four nodes.
#pragma once

#include <algorithm>
#include <array>
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

/// Where a panel is: the declared ones have a list of these, sorted by their nodes, rising.
inline constexpr const char* panel_places = "places of panels";
struct PanelPlace {
    std::array<int, 4> nodes{-1, -1, -1, -1};
    int panel = -1;
    explicit PanelPlace(const std::vector<int>& of, int index = -1) : panel(index) {
        std::copy(of.begin(), of.end(), nodes.begin());
        std::sort(nodes.begin(), nodes.end());
    }
    bool operator<(const PanelPlace& other) const { return nodes < other.nodes; }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.panel);
    }
};

}  // namespace hinge

// Contact of panels with points of other panels and of members: its declaration, and its state in a run.
#pragma once

#include <vector>

#include "contact/pressed_point.h"
#include "state/state.h"

namespace hinge {

inline constexpr const char* panel_contact_effect = "contact of panels";

/// As a script declares it, once in a model.
struct PanelContactRule {
    double stiffness = 0;    ///< N/m, of a point; 0: by the mass at its nodes (panel_points.cpp)
    double restitution = 1;  ///< contact::least_restitution to 1: part of its speed with which a point goes back
    double friction = 0;     ///< Coulomb's coefficient
    bool members = true;     ///< points of members meet panels too
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.stiffness, s.restitution, s.friction, s.members);
    }
};

/// A point that is near a panel.
struct PanelTouch {
    int point = 0, panel = 0;  ///< places in the run's lists
    double side = 1;           ///< of the panel, along its normal, on which the point is
    bool over = false;         ///< its foot is within the panel: the one that it presses on, of a surface
    double level = 0;          ///< m: depth where it was found first. There it is at rest until it rises

    double test_at = 0;           ///< m of PanelContactNow::travelled, up to which it cannot touch
    contact::PressedPoint press;  ///< where a step begins; its depth is less the level

    bool operator<(const PanelTouch& other) const {
        return point != other.point ? point < other.point : panel < other.panel;
    }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.point, s.panel, s.side, s.over, s.level, s.test_at, s.press);
    }
};

struct PanelContactNow {
    int points = 0, panels = 0;        ///< of the structure that they belong to
    std::vector<PanelTouch> touches;   ///< by point, then by panel
    double travelled = 0, margin = 0;  ///< m, since they were listed: nothing else comes near within the margin
    bool listed = false;
    static constexpr bool in_state_hash = false;  ///< the hash of a state is that of its arrays
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.points, s.panels, s.touches, s.travelled, s.margin, s.listed);
    }
};

/// What presses on panels where a run is: the number of points, the sum of their forces, N, and the deepest, m.
struct PanelPress {
    int points = 0;
    double force = 0, depth = 0;
};
PanelPress pressing_on_panels(const Structure& structure, const State& state);

}  // namespace hinge

// What effects report of a run: lines of the plan, section forces, loads to be drawn.
#pragma once

#include <string>
#include <vector>

#include "core/types.h"

namespace hinge {

/// A line of the plan: whether an effect is simulated, and why.
struct PlanLine {
    std::string name;
    bool active;
    std::string because;   ///< why it is in the step, or not
    std::string asked_at;  ///< the script's line that declares it, "" where none does
    double seconds = 0;    ///< spent in it so far
};

/// The resultants of a section: N, N m; signs as run:forces has them.
struct SectionForces {
    double N = 0, Mx = 0, My = 0, Mz = 0, Qx = 0, Qy = 0;
};

/// A load to be drawn, as it acts where the state is: on a node, or on an element.
struct ShownLoad {
    int node = -1, element = -1;
    double at = -1;            ///< on an element: at this share of its length, 0 to 1; -1: spread over it
    Vec3 force[2], moment[2];  ///< in space; N and N m; spread: at the two ends of the part that it covers, per m
    double from = 0, to = 1;   ///< that part of the element's length
    bool is_weight = false;    ///< not drawn: what the weight of a line mass differs from an even one
    bool is_partial() const { return from > 0 || to < 1; }
};

}  // namespace hinge

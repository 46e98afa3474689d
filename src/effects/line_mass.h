// Masses along members, as a script declares them: floors, cladding, pipes. And the panels of floors.
#pragma once

#include "model/model.h"

namespace hinge {

inline constexpr const char* line_mass_effect = "masses on members";

/// Over a part of a member, linear between its ends. Its inertia is spread evenly over the whole member
/// (MemberData::line_mass), its weight acts where it is.
struct LineMass {
    int member;
    double from = 0, to = 1;        ///< parts of the member's length
    double per_length[2] = {0, 0};  ///< where it begins and where it ends, kg/m
    double mean() const { return 0.5 * (per_length[0] + per_length[1]) * (to - from); }  ///< over the member, kg/m
    bool is_even() const { return from == 0 && to == 1 && per_length[0] == per_length[1]; }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.member, s.from, s.to, s.per_length[0], s.per_length[1]);
    }
};

/// Panels of floors between members, for pictures: their loads and masses are on the members.
inline constexpr const char* floor_panels = "floors";
struct FloorPanel {
    std::vector<int> nodes;    ///< at its corners, in their order
    std::vector<int> members;  ///< along its edges
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.nodes, s.members);
    }
};

/// Declares it; one of zero is none.
void add_line_mass(Model& model, const LineMass& mass);

}  // namespace hinge

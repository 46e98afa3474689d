// Loads on members, as a script declares them.
#pragma once

#include <memory>

#include "model/model.h"

namespace hinge {

inline constexpr const char* member_loads_effect = "member loads";

/// In which axes a load on a member is given, and per which length.
enum class LoadAxes : std::uint8_t {
    global,     ///< in space, per length of the member; keeps its direction
    projected,  ///< in space, per length of the member's projection on the plane across the load, at the start
    local       ///< in the element's axes, with which it rotates
};

struct MemberLoad {
    int member;
    LoadAxes axes = LoadAxes::global;
    double at = -1;           ///< where a point load acts, 0 to 1 of the length; -1: spread over the member
    double from = 0, to = 1;  ///< the part of the length that a spread load covers
    /// Where it begins and where it ends, linear between, N/m and N m/m; of a point load the first one, N and N m.
    Vec3 force[2] = {Vec3::Zero(), Vec3::Zero()}, moment[2] = {Vec3::Zero(), Vec3::Zero()};
    bool has_history = false;
    History history = {};  ///< factor over time
    int number = 0;        ///< in the order in which they were declared
    int load_case = -1;
    bool held = false;  ///< statics: it acts in full from the start on (Model::choose)
    bool spread() const { return at < 0; }
    bool is_partial() const { return from > 0 || to < 1; }
    void times(double factor) {
        for (int end : {0, 1}) force[end] *= factor, moment[end] *= factor;
    }
    void forget_history() { has_history = false, history = {}; }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.member, s.axes, s.at, s.force[0], s.force[1], s.moment[0], s.moment[1], s.history);
        if (s.is_partial()) a(s.from, s.to);
    }
};

class Effect;
class Host;
struct Workspace;

/// The effect of weights that are given as such loads, under the name of another effect: in dynamics they act on
/// members that are whole and carried (gravity.cpp), and no picture shows them.
std::unique_ptr<Effect> make_weights_on_members(const char* name, std::vector<MemberLoad> loads, Workspace& w,
                                                Host& host);

}  // namespace hinge

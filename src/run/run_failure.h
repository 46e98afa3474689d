// What is known of a run that has failed: the failure itself, and what else was seen.
#pragma once

#include <vector>

#include "core/failure.h"

namespace hinge {

/// Something beside the failure itself.
struct Remark {
    enum class Kind : int {
        // dynamics
        halved,        ///< value: s, the shortest step that was tried
        pressed_flat,  ///< element; value: part of its length that is left
        before,        ///< the energy balance had failed before
        fastest,       ///< node; value: m/s; time: s
        went_back,     ///< the state is that of an earlier step: count, time, s; value: its energy error
        // statics: where the structure gives way
        load_control_ends,  ///< load control finds only equilibria that cannot be held
        limit_point,        ///< node, component; members with plastic hinges
        limit_or_snap,
        path_turns,       ///< the path of arc length
        not_moved,        ///< node, component: the loads do not move what is driven
        would_turn_back,  ///< node, component; value: m or rad
        of_element,       ///< an element that failed there, too
        // statics: what may help
        shorter_arc,
        drive_what_moves,
        drive_one_way,
        drive_displacement,  ///< node, component; value: m, over which it was tried
        imperfection,
        arc_length,
        follow_in_time,
    };
    Kind kind = Kind::halved;
    Failure of = {};  ///< its numbers; of `before` and `of_element` a failure
    std::vector<int> members = {};
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.kind, s.of, s.members);
    }
};

struct RunFailure {
    Failure what = {};
    std::vector<Remark> remarks = {};
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.what, s.remarks);
    }
};

}  // namespace hinge

// What is known of a run that has failed: the failure itself, what else was seen, and what may help.
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

/// Another setting of a dynamic run, which may hold where the run's own has not.
struct Remedy {
    enum class Kind : int {
        more_elements,
        more_elements_conserving,  ///< together with the energy-momentum method
        direct_solver,
        iterations,    ///< value
        step_control,  ///< value
        automatic_dt,
        dt,  ///< value, s
        energy_momentum,
        rho_infinity,  ///< value
        explicit_steps,
    };
    Kind kind = Kind::more_elements;
    double value = 0;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.kind, s.value);
    }
};

/// What a failed dynamic run advises.
struct Advice {
    enum class Kind : int {
        none,
        more_nodes,  ///< element: it yields by the loads between its nodes alone; value: times what it can carry
        untried,     ///< the first remedy, and why it was not tried
        holds,       ///< the last remedy, tried from one time to another
        in_vain,     ///< all of them
    };
    enum class Untried : int { other_model, calls_script, no_good_state, too_long };
    Kind kind = Kind::none;
    Untried why = Untried::other_model;
    int element = -1;
    double value = 0, from = 0, to = 0;  ///< from, to: s
    std::vector<Remedy> remedies = {};
    std::vector<Remedy> left = {};  ///< with in_vain: the first that could not be tried in the time
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.kind, s.why, s.element, s.value, s.from, s.to, s.remedies, s.left);
    }
};

struct RunFailure {
    Failure what = {};
    std::vector<Remark> remarks = {};
    Advice advice = {};
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.what, s.remarks, s.advice);
    }
};

}  // namespace hinge

// What a dynamic run that failed advises: the first of a few other settings that held in a short trial from the last
// good state.
#pragma once

#include <string>
#include <vector>

#include "run/dynamics.h"

namespace hinge {

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

/// The first setting that holds, the first one with why it was not tried, or those that were tried in vain.
Advice find_remedy(const Dynamics& run);

/// "; dt = 1e-05 holds: tried from ..."
std::string text_of(const Advice& advice, const Structure& structure);

/// Whether what was read from a checkpoint fits the structure.
bool makes_sense(const Advice& advice, const Structure& structure);

}  // namespace hinge

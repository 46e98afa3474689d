// Why a step of a run could not go on, as values: a cause, what it is about, and its numbers. The sentence is made
// where it is printed (run/failure_text.h). Nothing reads that back: the name of a group may stand in it.
#pragma once

namespace hinge {

/// Causes of a failure. Scripts know them by their words (run/failure_text.h), listed in lua/hinge/words.
enum class Cause : int {
    none,
    // forces
    load_not_finite,   ///< node
    force_not_finite,  ///< element, or node
    forces_unbounded,  ///< node: each force is finite, their sum is not
    // elements
    element_folded,  ///< element; `unbroken`: it yields, and no rule of fracture lets it break
    flow_not_found,  ///< element
    // linear and nonlinear equations
    not_factorised,
    not_positive_definite,  ///< node; element or other; `yields`, or value: its compression, N
    solution_not_finite,
    solver_not_converged,  ///< count: iterations
    mass_not_solved,       ///< `after_breaks`: of the velocities after elements broke
    newton_not_converged,  ///< count: iterations; value: the last correction as a part of the first
    // step control
    rotation_too_large,   ///< node; value and limit, rad
    energy_lost_in_step,  ///< value and limit: parts of the largest energy
    energy_not_finite,
    // energy monitor
    energy_error,        ///< value: part of the largest energy; tolerance
    energy_error_grown,  ///< value and limit: by how much, as parts of it, since step `count`; tolerance
    // statics
    no_equilibrium,  ///< value: the load factor; step; limit: the part of the way to which it was halved
    unstable,        ///< node and component where the structure gives way; value and limit: load factors before, beyond
};
inline constexpr int cause_count = int(Cause::unstable) + 1;

struct Failure {
    Cause cause = Cause::none;
    int node = -1, element = -1, other = -1;  ///< of the structure; other: a second node
    int component = -1;                       ///< 0..5: ux uy uz rx ry rz
    double value = 0, limit = 0, tolerance = 0;
    long count = 0;
    bool unbroken = false, yields = false, after_breaks = false;
    long step = 0;    ///< of the run, that was tried; 0: before the first one
    double time = 0;  ///< s, at its end

    explicit operator bool() const { return cause != Cause::none; }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.cause, s.node, s.element, s.other, s.component, s.value, s.limit, s.tolerance, s.count, s.unbroken,
          s.yields, s.after_breaks, s.step, s.time);
    }
};

}  // namespace hinge

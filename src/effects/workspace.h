// The data that stages and effects of a run share: the state, the trial configuration and the forces on it.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "section/fracture_limits.h"
#include "core/failure.h"
#include "core/thread_pool.h"
#include "state/breaking.h"
#include "state/elastic_rate.h"
#include "state/element_assembly.h"

namespace hinge {

/// Run properties by which effects are selected.
struct RunKind {
    bool dynamic = false;
    bool explicit_steps = false;
    bool geometric = true;    ///< the effective stiffness has the initial-stress part
    bool rest = true;         ///< bodies at rest may be left alone
    bool conserving = false;  ///< the energy-momentum method: forces count by their mean over a step
    double dt = 0;            ///< s, the script's own step; 0 in statics
    /// True if the run has effects that act in dynamics only, or in statics too.
    bool takes(bool dynamic_only) const { return dynamic || !dynamic_only; }
};

/// How accelerations become motion over a step (eq 15): v' = v + dt ((1 - gamma) a + gamma a'), u' = u + dt v +
/// dt^2 ((1/2 - beta) a + beta a'). Eq 15 takes (1 - alpha) a' + alpha a: Bossak's weighting, 0 for Newmark's method.
/// Here a stands for a value where the step begins and next for that at its end: numbers or vectors.
struct Scheme {
    double beta = 0.25, gamma = 0.5, alpha = 0;

    /// Factors of a change of the acceleration at the end: on the displacement, s^2; on the velocity, s.
    double to_displacement(double dt) const { return beta * dt * dt; }
    double to_velocity(double dt) const { return gamma * dt; }
    /// v' - v.
    template <class V>
    V velocity_change(const V& a, const V& next, double dt) const {
        return dt * ((1 - gamma) * a + gamma * next);
    }
    /// u' - u - dt v.
    template <class V>
    V displacement_beyond_velocity(const V& a, const V& next, double dt) const {
        return dt * dt * ((0.5 - beta) * a + beta * next);
    }
    /// The value of a quantity in eq 15 that changes from a to next.
    template <class V>
    V weighted(const V& a, const V& next) const {
        return (1 - alpha) * next + alpha * a;
    }
    /// The value at the end of the step, from the weighted one.
    template <class V>
    V next_of_weighted(const V& a, const V& weighted) const {
        return (weighted - alpha * a) / (1 - alpha);
    }
    /// Energy that the method with beta > gamma/2 holds back while forces of the power a . M a act, J.
    double held_back(double power, double dt) const { return 0.5 * (beta - 0.5 * gamma) * dt * dt * power; }
};

/// An element that breaks at the end of a step, at end 1 or 2.
struct Break {
    int element, end;
    beam::LimitReached cause = {};  ///< reported only; does not influence the run
};

/// A step of dynamics on its way.
struct Step {
    double begin = 0, dt = 0;   ///< s
    bool longer = false;        ///< than the script's own dt: not for impacts
    int iteration = 0;          ///< Newton iterations done; 0: stresses are recovered for the first time
    std::vector<Break> breaks;  ///< what breaks at its end, rising
    Failure failure = {};       ///< why it cannot go on
    double end() const { return begin + dt; }
};

class Constraints;

/// Part of the half depth: what is no further from the ground carries when a static run begins.
inline constexpr double just_touches = 1e-6;

/// Structure, state and helpers of a run, set at its start.
struct RunParts {
    const Structure& structure;
    State& state;  ///< where the last step that was kept ended
    ThreadPool& pool;
    ElementAssembly& assembly;
    std::unordered_map<int, Vec6>& reaction;  ///< of nodes with a degree of freedom that is held
    RunKind kind;
    Scheme scheme = {};
    /// Steps with one solution need the current offset masses: an outdated mass loses velocity at every step, by as
    /// much in a short step as in a long one.
    bool solved_at_once = false;
    Constraints* constraints = nullptr;  ///< between degrees of freedom (run/constraints.h); null where there are none
};

/// Loads: written by the effects that are loads, where a step begins, and by the load control of statics.
struct AppliedLoads {
    double factor = 0;           ///< the load factor that is tried; 1 in dynamics
    std::vector<Vec6> external;  ///< F of eq 15; in statics for a load factor of 1
    std::vector<Vec6> steady;    ///< the part of F that does not change with time: weights at nodes
    std::vector<Vec6> held;      ///< statics: loads of an earlier run, in full at any load factor; or empty
};

/// Motion on trial: written by the integrator, in statics by Newton's method.
struct TrialMotion {
    Configuration trial;                        ///< where the step is tried to end
    std::vector<Vec3> rotation_step;            ///< rotation vector of each node over the step, rad; in the
                                                ///< energy-momentum method its Cayley vector, 2 tan(angle/2) long
    std::vector<Vec6> weighted, next_weighted;  ///< where alpha is not 0: Bossak-weighted accelerations of the
                                                ///< last step and of this one
    /// The acceleration is being found where the state is: forces are those with which its last step ended.
    bool at_state = false;
};

/// Forces of the trial: written where stresses are recovered.
struct TrialForces {
    std::vector<Vec6> resisting;             ///< R of eq 15, with inertia where the trial accelerates
    std::vector<Vec6> force;                 ///< p of each element at the trial pose
    std::vector<PlasticIncrement> yielding;  ///< elements that flow on the way to the trial pose, rising
    std::vector<ElasticRate> elastic_rates;  ///< of elements that flow and are damped by them, rising
};

/// Changes between steps: written by the effects that act where a step is kept.
struct KeptChanges {
    std::vector<int> supported;  ///< nodes with a degree of freedom that is held
    std::vector<int> resting;    ///< of each node: the body at rest that it belongs to, -1; empty when there is none
    long impulses = 0;           ///< that contact and ground have given to trial velocities so far
    bool points_moved = false;   ///< integration points have moved: the assembly reads them when the step is kept
};

/// The data of a run that its stages and effects share, by what writes it. Each array means one thing; six numbers a
/// node are in space: force and moment (N, N m), or linear and angular (m/s, rad/s; m/s^2, rad/s^2).
struct Workspace : RunParts, AppliedLoads, TrialMotion, TrialForces, KeptChanges {
    /// At the state, with its forces and without loads.
    explicit Workspace(const RunParts& parts)
        : RunParts(parts), AppliedLoads{kind.dynamic ? 1.0 : 0.0, {}, {}, {}}, TrialMotion{state, {}, {}, {}} {
        force = state.force;
    }

    /// True if the node belongs to a body at rest.
    bool rests(int node) const { return !resting.empty() && resting[node] >= 0; }
    /// Calls f(from, to) for the ranges of nodes between first and end that take part in steps.
    template <class F>
    void for_awake(int first, int end, F f) const {
        if (resting.empty()) return f(first, end);
        for (int to = first; to < end;) {
            int from = to;
            while (from < end && resting[from] >= 0) ++from;
            for (to = from; to < end && resting[to] < 0;) ++to;
            if (from < to) f(from, to);
        }
    }
    /// F on a node at the trial pose.
    Vec6 load(int node) const {
        if (kind.dynamic) return external[node];
        return held.empty() ? Vec6(factor * external[node]) : Vec6(factor * external[node] + held[node]);
    }
    /// The load factor that acts where the state is: 1 in dynamics.
    double acting_factor() const { return kind.dynamic ? 1 : state.factor; }
    /// Where a kept step has ended: its time, s; in statics the load factor.
    double reached(const Step& step) const { return kind.dynamic ? step.end() : state.factor; }
    /// Whether `reached` is a load factor: in statics.
    bool goes_by_load_factor() const { return !kind.dynamic; }
    /// Whether what is done every so many steps of dynamics is due where the state is; in statics it always is.
    bool is_due_every(long steps) const { return !kind.dynamic || state.step % steps == 0; }
    /// The velocity of a node on which forces depend; none in statics, whatever velocities the state keeps.
    template <class At>
    Vec6 velocity(const At& at, int node) const {
        return kind.dynamic ? at.velocity[node] : Vec6(Vec6::Zero());
    }
    /// Distance from the ground within which a bar of such a radius carries, m: none in dynamics. Statics begins where
    /// nothing presses yet.
    double touches_within(double radius) const { return kind.dynamic ? 0 : just_touches * radius; }
    /// p of the elements whose axial force counts in their fixed-end moments: where the step began, in statics those of
    /// the last iteration.
    const std::vector<Vec6>& force_of_fixed_ends() const { return kind.dynamic ? state.force : force; }
};

}  // namespace hinge

// An effect: one thing that acts on a structure, as one object in one file.
//
// It owns its data, its part of a checkpoint, its undo and its accounts of the energy balance; it says whether a scene
// calls for it, and why. Statics, both integrators, the energy balance and the plan walk one list of them
// (all_effects.h); what a scene does not call for is not in the list. Every call has an empty default, so that an
// effect holds only what it does. README.md in src/ shows how to add one.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "algebra/node_blocks.h"
#include "core/built.h"
#include "core/thread_pool.h"
#include "state/bodies.h"
#include "state/breaking.h"
#include "state/element_assembly.h"

namespace hinge {

/// A line of the plan: whether an effect is simulated, and why.
struct PlanLine {
    std::string name;
    bool active;
    std::string because;   ///< why it is in the step, or not
    std::string asked_at;  ///< the script's line that asks for it, "" where none does
    double seconds = 0;    ///< spent in it so far
};

/// What a run is, for who decides whether it calls for an effect.
struct RunKind {
    bool dynamic = false;
    bool explicit_steps = false;
    bool geometric = true;    ///< initial-stress stiffness is asked for
    bool rest = true;         ///< bodies at rest may be left alone
    bool conserving = false;  ///< the energy-momentum method: forces count by their mean over a step
    double dt = 0;            ///< s, the script's own step; 0 in statics
};

/// How accelerations become motion over a step (eq 15): v' = v + dt ((1 - gamma) a + gamma a'), u' = u + dt v +
/// dt^2 ((1/2 - beta) a + beta a'). Eq 15 takes (1 - alpha) a' + alpha a: Bossak's weighting, 0 for Newmark's method.
struct Scheme {
    double beta = 0.25, gamma = 0.5, alpha = 0;
};

/// What the stages and effects of a run work on. Each array means one thing; six numbers a node are in space: force and
/// moment (N, N m), or linear and angular (m/s, rad/s; m/s^2, rad/s^2).
struct Workspace {
    const Structure& structure;
    State& state;  ///< where the last step that was kept ended
    ThreadPool& pool;
    ElementAssembly& assembly;
    RunKind kind;
    Scheme scheme;
    Configuration trial;                        ///< where the step is tried to end
    double factor = 0;                          ///< statics: the load factor that is tried
    std::vector<Vec3> rotation_step;            ///< rotation vector of each node over the step, rad; in the
                                                ///< energy-momentum method its Cayley vector, 2 tan(angle/2) long
    std::vector<Vec6> external;                 ///< F of eq 15
    std::vector<Vec6> resisting;                ///< R of eq 15, with inertia where the trial accelerates
    std::vector<Vec6> force;                    ///< p of each element at the trial pose
    std::vector<PlasticIncrement> yielding;     ///< elements that flow on the way to the trial pose, rising
    std::vector<int> supported;                 ///< nodes with a degree of freedom that is held
    std::unordered_map<int, Vec6>& reaction;    ///< of nodes with a degree of freedom that is held
    std::vector<Vec6> weighted, next_weighted;  ///< where alpha is not 0: Bossak-weighted accelerations of the
                                                ///< last step and of this one
    std::vector<int> resting;   ///< of each node: the body at rest that it belongs to, -1; empty when there is none
    long impulses = 0;          ///< that contact and ground have given to trial velocities so far
    bool points_moved = false;  ///< integration points have moved: the assembly takes them up when the step is kept
    /// A step is solved once, with all that it moves in what is solved for: a mass there that lags behind the one that
    /// is met loses velocity, by as much in a short step as in a long one.
    bool solved_at_once = false;
};

/// An element that breaks at the end of a step, at end 1 or 2.
struct Break {
    int element, end;
    beam::LimitReached cause = {};  ///< told to who asks why; nothing goes by it
};

/// A step of dynamics on its way.
struct Step {
    double begin = 0, dt = 0;   ///< s
    bool longer = false;        ///< than the script's own dt: not for impacts
    int iteration = 0;          ///< Newton iterations done; 0: stresses are recovered for the first time
    std::vector<Break> breaks;  ///< what breaks at its end, rising
    std::string failure;        ///< why it cannot go on, "" while it can
    double end() const { return begin + dt; }
};

/// change = M^-1 impulse, and what x times it takes: square x^2 + linear x. Supports that move add x by_supports to it.
struct ImpulseResponse {
    double square = 0, linear = 0, by_supports = 0;
    std::vector<Vec6> change;  ///< of the velocities
    /// By what the impulse is to be multiplied so that it takes `work`, J, from the motion: the root nearest to 1,
    /// where one lies between 0.5 and 1.5, else 1. In 125 runs of tests/hard 116 keep their bounds so, or if the root
    /// is always taken; 113 between 0.9 and 1.1 alone, 114 if it is never taken.
    double factor_for(double work) const;
};

/// The resultants of a section: N, N m; signs as run:forces has them.
struct SectionForces {
    double N = 0, Mx = 0, My = 0, Mz = 0, Qx = 0, Qy = 0;
};

/// A load that acts where the state is, for who shows it: on a node, or on an element.
struct ShownLoad {
    int node = -1, element = -1;
    double at = -1;            ///< on an element: at this share of its length, 0 to 1; -1: spread over it
    Vec3 force[2], moment[2];  ///< in space; N and N m; spread: at the element's two ends, N/m and N m/m
};

/// Something reached an element in this step, or broke it: a body at rest that it belongs to takes part again.
struct Reached {
    int element;
    const char* how;
};

/// What an effect may ask of the run that it is part of.
class Host {
public:
    virtual ~Host() = default;
    /// The element's stiffness is not what the effective stiffness has of it.
    virtual void stiffness_changed(int element) = 0;
    /// What effects join nodes by has changed: Effect::add_blocks is asked of all, at that place.
    virtual void blocks_changed(const ConfigurationView& at) = 0;
    /// Mass that hangs rigidly on a node, 6 x 6 in space, in the effective stiffness.
    virtual void set_offset_mass(int node, const Mat6& mass) = 0;
    /// These nodes (not negative) take no part in the solution; empty: all do.
    virtual void leave_out(const std::vector<int>& resting) = 0;
    /// A force has vanished at once: the next step begins with the acceleration found anew.
    virtual void accelerations_anew() = 0;
    /// Elements' part in M has changed.
    virtual void mass_changed(int element) = 0;
    /// What an impulse does to the nodes where the step is tried to end.
    virtual ImpulseResponse respond(const std::vector<Vec6>& impulse) = 0;
    /// F of a node changes for good: a weight is gone. All effects hear of it.
    virtual void change_steady_load(int node, const Vec3& force) = 0;
    virtual void reached(const std::vector<Reached>& elements) = 0;
    virtual void note_activation(const std::string& effect, bool awake, const std::string& why) = 0;
    /// Effect::keep_from_rest of all.
    virtual void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) = 0;
    virtual void count_break() = 0;
    virtual bool has_effective_stiffness() const = 0;
};

class Effect {
public:
    Effect(const char* name, Workspace& w, Host& host) : name_(name), w_(w), host_(host) {}
    virtual ~Effect() = default;
    Effect(const Effect&) = delete;
    const char* name() const { return name_; }

    // ---- what acts ------------------------------------------------------------------------------------------------
    /// F that does not change with time or place (weights), as the state is at the start.
    virtual void add_steady_loads(std::vector<Vec6>& external) const { (void)external; }
    /// The steady loads of all effects are summed up in the workspace.
    virtual void steady_loads_known() {}
    /// F as statics has it at load factor 1, beside the steady loads, where the nodes are.
    virtual void add_static_loads(const ConfigurationView& at, std::vector<Vec6>& external) const {
        (void)at, (void)external;
    }
    /// What statics holds in full from the start on, where it goes on from another run; not in add_static_loads, but
    /// for weights, of which it is a part.
    virtual void add_held_loads(const ConfigurationView& at, std::vector<Vec6>& external) const {
        (void)at, (void)external;
    }
    /// Whether add_static_loads depends on where the nodes are.
    virtual bool loads_follow() const { return false; }
    /// Whether the steady loads have a potential energy in an account of their own, so that they do no work.
    virtual bool has_potential() const { return false; }
    /// Adds what it resists with at the workspace's trial pose. `time`: that of the pose, s.
    virtual void add_forces(double time, std::vector<Vec6>& resisting) { (void)time, (void)resisting; }
    /// Adds the derivative of those forces.
    virtual void add_blocks(const ConfigurationView& at, Blocks& blocks) const { (void)at, (void)blocks; }
    /// Whether add_blocks has something to add just now.
    virtual bool has_blocks() const { return false; }
    /// Whether it goes with the energy-momentum method: its forces, the mean of a step's two ends, do the work that its
    /// accounts say, on displacements and Cayley vectors (Workspace::rotation_step); nothing but they changes
    /// velocities.
    virtual bool takes_mean_forces() const { return false; }
    /// Whether its blocks change with every pose: they are renewed wherever stresses are recovered.
    virtual bool blocks_follow() const { return false; }

    /// Damping in proportion to an element's own matrices, C = of_mass M + of_stiffness K (1/s, s): it goes into the
    /// element's effective stiffness. The forces are added like all others.
    virtual bool damps_elements() const { return false; }
    virtual ElementDamping element_damping(int element) const { return (void)element, ElementDamping{}; }
    /// What the section forces at an end (side -1: the first node, 1: the second) have beyond those that follow from
    /// the element's deformation: loads between its nodes.
    virtual void add_section_forces(int element, double side, SectionForces& forces) const {
        (void)element, (void)side, (void)forces;
    }

    /// The part of those that yield and fracture go by, of all elements where the nodes are: whether there is one just
    /// now, and adds it. `factor`: the load factor of statics. What an element's own forces do on its flow is less than
    /// the whole by work_on_flow, which is not work of the load: the load's account has that.
    virtual bool has_fixed_ends() const { return false; }
    virtual void add_fixed_ends(const ConfigurationView& at, double factor, std::vector<beam::FixedEnd>& all) const {
        (void)at, (void)factor, (void)all;
    }
    /// The same in the place of what `all` has.
    virtual void set_fixed_ends(const ConfigurationView& at, double factor, std::vector<beam::FixedEnd>& all) const {
        std::fill(all.begin(), all.end(), beam::FixedEnd());
        add_fixed_ends(at, factor, all);
    }

    // ---- a step of dynamics, in this order ------------------------------------------------------------------------
    /// F at the end of the step, and what is prescribed there. Functions of the script are asked.
    virtual void begin(const Step& step) { (void)step; }
    /// Whether meet and end have something to do in this scene.
    virtual bool meets() const { return false; }
    /// Finds what comes into contact in the coming step. False: the step is too long for what comes, and a shorter one
    /// is begun.
    virtual bool meet(const Step& step) { return (void)step, true; }
    /// The trial pose is predicted: what is prescribed is put in its place.
    virtual void predicted(const Step& step) { (void)step; }
    /// The trial was corrected by this change of the accelerations (explicit steps: from none).
    virtual void corrected(const Step& step, const std::vector<Vec6>& change) { (void)step, (void)change; }
    /// Whether the solution holds to the forces that it was found with; false: once more.
    virtual bool settled() { return true; }
    /// The trial is solved; `change`: the last correction.
    virtual void solved(const Step& step, const std::vector<Vec6>& change) { (void)step, (void)change; }
    /// Where the step has ended: what ends with it.
    virtual void end(const Step& step) { (void)step; }
    /// What the step would add to the accounts if it were kept.
    virtual void accumulate_energy(const Step& step, Accounts& sums) const { (void)step, (void)sums; }
    /// The name of what decide does, null where it does nothing.
    virtual const char* decides() const { return nullptr; }
    /// What breaks, and what the script is told. The last stage that may fail.
    virtual void decide(Step& step) { (void)step; }
    /// The step is kept: before the trial becomes the state, and after.
    virtual void before_commit(const Step& step) { (void)step; }
    virtual void after_commit(const Step& step) { (void)step; }
    /// An element breaks (after kept), with what its breaking asks of the nodes in `impulse`; and all have.
    virtual void breaks(const Break& b, std::vector<Vec6>& impulse) { (void)b, (void)impulse; }
    virtual void broke(const Break& b) { (void)b; }
    virtual void all_broke() {}

    // ---- undo -----------------------------------------------------------------------------------------------------
    /// A step begins that may be taken back; it is taken back; it stands.
    virtual void save_step() {}
    virtual void roll_back() {}
    virtual void release_step() {}
    virtual bool calls_script() const { return false; }  ///< so that a step may fail and must be taken back

    /// Asked once, where a run is made: the most that its forces may ever add to stiffness and damping, as far as that
    /// is known then. Explicit steps may not be longer than that allows, and dt = "auto" keeps that limit.
    virtual void add_stiffest(Blocks& most) const { (void)most; }

    /// Whether forces may vanish at once, so that M by itself is needed.
    virtual bool makes_forces_vanish() const { return false; }

    // ---- the acceleration anew: at the start, and when a force has vanished at once ---------------------------------
    virtual void loads_at(double time) { (void)time; }  ///< F at a time, without asking the script again
    virtual void restart_begins() {}
    virtual void prescribe(std::vector<Vec6>& acceleration) const { (void)acceleration; }
    virtual void restart_ends() {}
    /// The run is set up and the first acceleration is known. `out_of_balance`: F - R where the run starts.
    virtual void started(const std::vector<Vec6>& out_of_balance) { (void)out_of_balance; }

    // ---- what others want to know -----------------------------------------------------------------------------------
    /// Loads of the script that act where the state is. Weights are not among them.
    virtual void show_loads(std::vector<ShownLoad>& to) const { (void)to; }
    virtual void steady_load_changed(int node, const Vec3& force) { (void)node, (void)force; }
    virtual void reached(const std::vector<Reached>& elements) { (void)elements; }
    virtual void effective_stiffness_begins() {}
    /// An element's part of the effective stiffness, with nothing held, each time it is built.
    virtual bool watches_matrices() const { return false; }
    virtual bool watches_matrix(int element) const { return (void)element, false; }
    virtual void matrix_built(int element, const ElementPart& part) { (void)element, (void)part; }
    /// Bodies that it may move are not at rest.
    virtual void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const { (void)bodies, (void)rests; }
    /// What supports that move with `supports` do, J, on the momentum that nodes have at `velocity`.
    virtual double work_of_supports(const std::vector<Vec6>& supports, const std::vector<Vec6>& velocity) const {
        return (void)supports, (void)velocity, 0;
    }
    /// Whether steps may be longer than the shortest: nothing happens that needs those.
    virtual bool allows_long_step() const { return true; }
    /// Whether what it prescribes changes at one of these times after now, s.
    virtual bool changes_within(double now, std::span<const double> after) const {
        return (void)now, (void)after, false;
    }
    /// For effects that sleep: whether it had something to do in the step, and what.
    virtual bool sleeps() const { return false; }
    virtual bool busy() const { return false; }
    virtual std::string why_awake() const { return {}; }

    // ---- energy and checkpoint --------------------------------------------------------------------------------------
    /// What it stores in such a state, J, by account.
    virtual void add_energy(const State& state, Accounts& sums) const { (void)state, (void)sums; }
    virtual void save(Writer& to) const { (void)to; }
    virtual void restore(Reader& from) { (void)from; }
    /// After all was read: finds anew what follows from the state. False where what was read makes no sense.
    virtual bool restored(std::span<const State* const> states) { return (void)states, true; }

protected:
    /// Adds x times what an impulse does to the velocities of the trial; the supports' work is counted.
    void add_to_trial(double x, const ImpulseResponse& response);

    /// The work of a fixed-end part on what an element flows in the step, J.
    double work_on_flow(const PlasticIncrement& of, const beam::FixedEnd& part) const;

    /// save and restore of a class that tells its fields once.
    template <class Self>
    static void save_fields(const Self& self, Writer& to) {
        Self::fields(self, to);
    }

    const char* name_;
    Workspace& w_;
    Host& host_;
};

/// An effect as the engine knows it before a run.
struct EffectKind {
    const char* name;
    std::vector<AccountInfo> accounts;
    /// Its lines of the plan.
    std::vector<PlanLine> (*plan)(const Structure& structure, const RunKind& kind);
    /// The effect, or null where the scene does not call for it.
    std::unique_ptr<Effect> (*make)(Workspace& w, Host& host);
    /// Declared by Model::declare under its name, so that a run can do without it (core.leave_out).
    bool declared = false;
    /// Of each element, empty for none: what Effect::element_damping will say. It shortens explicit steps.
    std::vector<ElementDamping> (*damping)(const Structure& structure) = nullptr;
};

}  // namespace hinge

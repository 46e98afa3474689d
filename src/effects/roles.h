// The roles of effects: what an effect may do in a run, an abstract class each. An effect takes on the roles that it
// needs by inheritance; the run lists the effects of each role in the order of list.inc (effect_list.h), and each stage
// of a step walks the list that it needs.
#pragma once

#include <algorithm>
#include <span>

#include "algebra/node_blocks.h"
#include "beam/pair_bow.h"
#include "effects/reports.h"
#include "effects/host.h"
#include "effects/workspace.h"
#include "model/linear_constraint.h"

namespace hinge {

/// A load: part of F in eq 15. In statics it grows with the load factor; in dynamics it acts in full, or as its history
/// says. Effect::begin sets what is known of it before the step is solved.
class Load {
public:
    virtual ~Load() = default;
    /// Adds the part of F that changes with neither time nor place (weights at nodes), in the state of the start.
    virtual void add_steady_loads(std::vector<Vec6>& external) const { (void)external; }
    /// Statics begins.
    virtual void begin_statics() {}
    /// Statics: adds F at load factor 1, beside the steady loads, where the nodes are.
    virtual void add_static_loads(const Pose& at, std::vector<Vec6>& external) const = 0;
    /// Statics: adds what is held in full from the start on, in a run that continues another one. That is not in
    /// add_static_loads, except of weights, of which it is a part.
    virtual void add_held_loads(const Pose& at, std::vector<Vec6>& external) const = 0;
    /// Statics: whether add_static_loads depends on where the nodes are.
    virtual bool follows_nodes() const { return false; }
    /// Statics: whether the derivative of its forces by the displacements is unsymmetric.
    virtual bool is_unsymmetric() const { return follows_nodes(); }
    /// Statics: whether the load is a weight, whose potential energy has an account of its own: it does no work.
    virtual bool has_potential() const { return false; }
    /// Dynamics: sets F at a time for which functions of the script were asked before.
    virtual void act_at(double time) { (void)time; }
    /// Dynamics: subtracts from R the loads that follow the nodes of the trial configuration. Masses that such a load
    /// acts on add their inertia.
    virtual void subtract_following_loads(std::vector<Vec6>& resisting) { (void)resisting; }
    /// Lists the loads of the script as they act where the state is, and weights along members that are not even.
    virtual void show_loads(std::vector<ShownLoad>& to) const { (void)to; }
};

/// Forces that depend on where the nodes are and how they move: part of R in eq 15, with a stiffness and damping in
/// blocks of one or two nodes.
class Force {
public:
    virtual ~Force() = default;
    /// Adds the forces in the trial configuration. `time`: that of the configuration, s.
    virtual void add_forces(double time, std::vector<Vec6>& resisting) = 0;
    /// Statics begins: velocities, and forces that follow from them, do not act.
    virtual void begin_statics() {}
    /// Adds the derivative of those forces, for the effective stiffness.
    virtual void add_blocks(const Pose& at, Blocks& blocks) const { (void)at, (void)blocks; }
    /// Whether add_blocks has something to add now.
    virtual bool has_blocks() const { return false; }
    /// Stiffness times the squares of the lengths that it is found from, J: rounding is a part of it.
    virtual double scale_of_rounding(const Pose& at) const { return (void)at, 0; }
    /// True if the blocks depend on the places of the nodes: they are renewed wherever stresses are recovered.
    virtual bool blocks_follow() const { return false; }
    /// Whether those of an earlier place will do where a step takes few iterations: they are many, and inertia rules
    /// the equations then.
    virtual bool blocks_may_lag() const { return false; }
};

/// Loads between the nodes of a member: the resultants of its sections have a part that does not follow from the
/// element's deformation, the fixed-end part.
class SectionForceSource {
public:
    virtual ~SectionForceSource() = default;
    /// Adds that part at an end of an element, where the state is (side -1: the first node, 1: the second).
    virtual void add_section_forces(int element, double side, SectionForces& forces) const = 0;
    /// Whether yield and fracture have such a part now.
    virtual bool has_fixed_ends() const = 0;
    /// Adds the part that yield and fracture take, of all elements. `factor`: the load factor, 1 in dynamics. The work
    /// of an element's own forces on its flow is less than the whole by work_on_flow; the load's account has that.
    virtual void add_fixed_ends(const Pose& at, double factor, std::vector<beam::FixedEnd>& all) const = 0;
    /// Adds the loads that act at points between the ends of the pair of elements that begins with `first`, about the
    /// axis of a plane (0: x, 1: y).
    virtual void add_points(int first, int plane, const Pose& at, double factor,
                            std::vector<beam::BowPoint>& to) const {
        (void)first, (void)plane, (void)at, (void)factor, (void)to;
    }
    /// Sets it in the place of what `all` has.
    virtual void set_fixed_ends(const Pose& at, double factor, std::vector<beam::FixedEnd>& all) const {
        std::fill(all.begin(), all.end(), beam::FixedEnd());
        add_fixed_ends(at, factor, all);
    }
};

/// Motion that is prescribed: degrees of freedom whose displacement is a function of time.
class Prescriber {
public:
    virtual ~Prescriber() = default;
    /// Lists the degrees of freedom that are prescribed now.
    virtual void list_prescribed(std::vector<DegreeOfFreedom>& list) const = 0;
    /// The trial configuration is predicted: sets what is prescribed in it.
    virtual void predicted(const Step& step) = 0;
    /// The trial was corrected by this change of the accelerations (explicit steps: from none).
    virtual void corrected(const Step& step, const std::vector<Vec6>& change) = 0;
    /// R was recovered once more at the end of the step, where the solution has led.
    virtual void recovered_last() {}
    /// Keeps the prescribed part of the acceleration, which is about to be recomputed.
    virtual void keep_acceleration() = 0;
    /// Sets what is prescribed of the acceleration that is being found.
    virtual void prescribe(std::vector<Vec6>& acceleration) const = 0;
    /// Work of supports that move with `supports` on the momentum that nodes have at `velocity`, J.
    virtual double work_of_supports(const std::vector<Vec6>& supports, const std::vector<Vec6>& velocity) const = 0;
};

/// Reads an element's part of the effective stiffness, with nothing held, each time it is built.
class MatrixWatcher {
public:
    virtual ~MatrixWatcher() = default;
    virtual bool watches_matrix(int element) const = 0;
    virtual void matrix_built(int element, const ElementPart& part) = 0;
};

/// Contact: forces that begin and end within a step.
class ContactLaw {
public:
    virtual ~ContactLaw() = default;
    /// Finds what comes into contact in the coming step. False: the step is too long for what comes, and a shorter one
    /// is begun.
    virtual bool detect_contacts(const Step& step) = 0;
    /// False if the forces that the solution was found with do not agree with it: another iteration follows.
    virtual bool has_converged() = 0;
    /// Ends the contacts that are over at the end of the step, and adds the impulses that the step missed.
    virtual void end(const Step& step) { (void)step; }
};

/// Finds the elements that break at the end of a step, or calls the script's functions for its events. The last stage
/// that may fail.
class Breaker {
public:
    virtual ~Breaker() = default;
    /// The name of the stage; the stage of several has the first one's.
    virtual const char* stage_name() const = 0;
    virtual void find_breaks(Step& step) = 0;
    /// True if it breaks elements by their strains.
    virtual bool by_strain() const { return false; }
};

/// Takes part when elements break, after the commit.
class BreakListener {
public:
    virtual ~BreakListener() = default;
    /// An element breaks; adds the impulses of its break on the nodes.
    virtual void breaks(const Break& b, std::vector<Vec6>& impulse) { (void)b, (void)impulse; }
    /// It has broken; all of the step have.
    virtual void broke(const Break& b) { (void)b; }
    virtual void all_broke() {}
};

/// Limits the length of steps.
class StepLimiter {
public:
    virtual ~StepLimiter() = default;
    /// Whether steps may be longer than the shortest: nothing happens that needs those.
    virtual bool allows_long_step() const { return true; }
    /// True if a load or a support changes at one of these times after now, s.
    virtual bool changes_within(double now, std::span<const double> after) const {
        return (void)now, (void)after, false;
    }
    /// Adds the largest stiffness and damping that its forces may ever have, as far as that is known where the run is
    /// made. Explicit steps may not be longer than that allows, and dt = "auto" keeps that limit.
    virtual void add_stiffest(Blocks& most) const { (void)most; }
};

/// Sleeps while it has nothing to do: run.state_changes lists when it began and ended.
class Sleeper {
public:
    virtual ~Sleeper() = default;
    virtual bool busy() const = 0;  ///< it had something to do in the step
    virtual std::string why_awake() const = 0;
};

/// Puts bodies at rest out of the solution, and back when something reaches them.
class RestKeeper {
public:
    virtual ~RestKeeper() = default;
    virtual void reached(const std::vector<Reached>& elements) = 0;
};

/// Moves supports in statics.
class StaticPrescriber {
public:
    virtual ~StaticPrescriber() = default;
    /// Adds what supported degrees of freedom move by per unit of the load factor, of each node: m and rad.
    virtual void add_rates(std::vector<Vec6>& rates) const = 0;
};

/// Sets the temperatures of elements.
class Heater {
public:
    virtual ~Heater() = default;
    /// Statics: those of the trial configuration, at a load factor. Dynamics: Effect::begin.
    virtual void heat_at(double factor) = 0;
};

}  // namespace hinge

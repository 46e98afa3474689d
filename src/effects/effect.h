// An effect: one thing that acts on a structure, as one object in one file.
//
// It owns its data, its part of a checkpoint, its undo and its accounts of the energy balance. What it does beside that
// it takes on as roles (roles.h), by inheritance: the head of its class lists them. The run keeps a list for each role,
// and a stage walks its own. Every call here has an empty default. README.md in src/ shows how to add an effect.
#pragma once

#include <span>

#include "effects/effect_kind.h"
#include "effects/host.h"
#include "effects/workspace.h"

namespace hinge {

/// Properties of an effect that are known once it is made.
struct EffectTraits {
    /// It acts in the energy-momentum method: its forces are end-point averages, which do the work that its accounts
    /// say on displacements and Cayley vectors (Workspace::rotation_step), and it applies no impulses.
    bool mean_forces = false;
    bool calls_script = false;      ///< a step may fail in a function of the script, and is rolled back then
    bool forces_vanish = false;     ///< a force may end at once: the acceleration is recomputed with M alone
    bool strains_at_start = false;  ///< it strains elements at once where the run begins
    bool cracks = false;            ///< it holds no tension: without load it is in equilibrium in more than one place
    bool stiffens = false;          ///< it may become far stiffer by the displacements that its tangent asks for
};

/// Adds x times what an impulse does to the velocities of the trial; the supports' work is counted.
void add_to_trial(Workspace& w, double x, const ImpulseResponse& response);

class Effect {
public:
    Effect(const char* name, Workspace& w, Host& host, EffectTraits traits = {})
        : name_(name), traits_(traits), w_(w), host_(host) {}
    virtual ~Effect() = default;
    Effect(const Effect&) = delete;
    const char* name() const { return name_; }
    const EffectTraits& traits() const { return traits_; }

    // ---- a step of dynamics, in this order ------------------------------------------------------------------------
    /// F at the end of the step, and what is prescribed there. Functions of the script are called.
    virtual void begin(const Step& step) { (void)step; }
    /// The trial is solved; `change`: the last correction of the accelerations.
    virtual void solved(const Step& step, const std::vector<Vec6>& change) { (void)step, (void)change; }
    /// Adds what the step would add to the accounts if it were kept, J. In statics too.
    virtual void accumulate_energy(const Step& step, Accounts& sums) const { (void)step, (void)sums; }
    /// The step is kept: before the trial becomes the state, and after. In statics too.
    virtual void before_commit(const Step& step) { (void)step; }
    virtual void after_commit(const Step& step) { (void)step; }

    // ---- undo -----------------------------------------------------------------------------------------------------
    /// A step begins that may be rolled back; it is rolled back; it stands.
    virtual void save_step() {}
    virtual void roll_back() {}
    virtual void release_step() {}

    // ---- where a run begins, or goes on ---------------------------------------------------------------------------
    /// The acceleration where the step begins was found, at the start or because a force has vanished: the forces of
    /// now are those that the step begins with.
    virtual void acceleration_found() {}
    /// A run of dynamics begins beyond yield, and what flows on the way back to the yield surface (Workspace::yielding)
    /// is kept before its first step. Adds to the accounts.
    virtual void returned_to_yield(const Step& start) { (void)start; }
    /// The run is set up. `out_of_balance`: F - R where it starts.
    virtual void started(const std::vector<Vec6>& out_of_balance) { (void)out_of_balance; }
    /// Clears the bodies that it may move: they are not at rest.
    virtual void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const { (void)bodies, (void)rests; }
    /// Marks the bodies that lie on it where the last step ended: they may come to rest there.
    virtual void hold_up(const Bodies& bodies, std::vector<char>& held_up) const { (void)bodies, (void)held_up; }
    /// Lists bodies of which one lies on the other, or nearly: they rest together, and take part again together.
    virtual void lie_together(const Bodies& bodies, BodyPairs& pairs) const { (void)bodies, (void)pairs; }
    /// Bodies have come to rest, or take part again (Workspace::rests).
    virtual void rest_changed() {}

    // ---- energy and checkpoint ------------------------------------------------------------------------------------
    /// Adds the energy that it stores in such a state, J.
    virtual void add_energy(const State& state, Accounts& sums) const { (void)state, (void)sums; }
    virtual void save(Writer& to) const { (void)to; }
    virtual void restore(Reader& from) { (void)from; }
    /// Called after all was read: recomputes what follows from the state. False if the data make no sense.
    virtual bool restored(std::span<const State* const> states) { return (void)states, true; }

protected:
    /// The work of a fixed-end part on what an element flows in the step, J.
    double work_on_flow(const PlasticIncrement& of, const beam::FixedEnd& part) const;

    /// save and restore of a class that tells its fields once.
    template <class Self>
    static void save_fields(const Self& self, Writer& to) {
        Self::fields(self, to);
    }

    const char* name_;
    EffectTraits traits_;
    Workspace& w_;
    Host& host_;
};

}  // namespace hinge

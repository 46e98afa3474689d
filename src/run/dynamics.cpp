#include "run/dynamics.h"

#include <algorithm>
#include <cmath>

#include "algebra/stable_step.h"
#include "core/errors.h"
#include "core/text.h"
#include "effects/all_effects.h"
#include "run/central_differences.h"
#include "run/effect_forces.h"
#include "run/energy_momentum.h"
#include "run/newmark.h"
#include "state/nodes.h"

namespace hinge {
namespace {

/// Part of the largest energy that the balance may miss before a run with explicit steps is ended, whose energy swings
/// with the fastest vibrations and whose runs then hold. Implicit steps: large_error.
constexpr double may_swing = 0.1;
constexpr double much_flow = 4;        ///< times an abrupt change of the motion: of plastic work in a step
constexpr double most_rotation = 0.5;  ///< rad: of a node in a step, with step control
constexpr long quiet_steps = 100;      ///< without anything to do after which an effect is said to sleep
constexpr double most_phase = 0.9;     ///< rad: of what effects join nodes by, in a step of dt = "auto" (Newmark)

constexpr double crushed_part = 0.05;  ///< of its length, to which an element is pressed flat

RunKind kind_of(const DynamicSettings& s) {
    return {true, s.explicit_steps(), s.geometric, s.rest && !s.conserving, s.conserving, s.dt};
}

}  // namespace

Dynamics::Dynamics(std::shared_ptr<const Structure> structure, State start, DynamicSettings settings)
    : Run(std::move(structure), std::move(start), kind_of(settings), settings.threads,
          !settings.explicit_steps() && !settings.conserving),
      settings_(fitted(settings)),
      size_(settings_.dt, settings_.duration, settings_.automatic, settings_.controlled(), state_.time),
      mass_(w_),
      largest_energy_(*structure_),
      energy_monitor_(tolerance(), size_.whole() / size_.own_length()),
      control_(settings_.step_control, settings_.controlled_by_default) {
    if (explicit_steps() != structure_->lumped())
        throw InputError("dynamics: explicit steps (beta 0) go with lumped masses, and Newmark's with consistent ones");
    w_.scheme = {settings_.beta, settings_.gamma(), settings_.alpha()};
    if (settings_.conserving != structure_->at_nodes())
        throw InputError("dynamics: the energy-momentum method goes with rotary inertia at the nodes (MassKind)");
    for (const auto& e : effects_->all)
        if (settings_.conserving && !e->traits().mean_forces)
            throw InputError("model:dynamic: integrator = 'energy-momentum' does not go with " +
                             std::string(e->name()) + " yet; leave that out, or take 'newmark' or 'explicit'");
    w_.rotation_step.assign(structure_->position().size(), Vec3::Zero());
    meets_ = !effects_->contact_laws.empty();
    breaks_or_parts_ = effects_->any(&EffectTraits::forces_vanish);
    decides_ = !effects_->breakers.empty();
    if (control_.by_default()) {
        lumped_.assign(structure_->position().size(), 0);
        for (const Element& e : structure_->elements())
            for (int n : e.node) lumped_[n] += 0.5 * e.mass();
    }

    at_.loads = stages_.add("loads");
    if (meets_) at_.contact = stages_.add("contact");
    if (breaks_or_parts_) at_.restart = stages_.add("restart");
    at_.predict = stages_.add("predict");
    at_.recover = stages_.add("recover stresses");
    if (explicit_steps()) integrator_ = std::make_unique<CentralDifferences>(w_, mass_, stages_);
    else if (settings_.conserving) integrator_ = std::make_unique<EnergyMomentum>(w_, mass_, stages_, settings_);
    else integrator_ = std::make_unique<Newmark>(w_, mass_, stages_, settings_);
    at_.correct = integrator_->correct_stage();
    if (meets_) at_.ends = stages_.add("contact ends");
    if (settings_.controlled()) at_.control = stages_.add("step control");
    if (const auto& list = effects_->breakers; decides_) at_.decide = stages_.add(list.front()->stage_name());
    at_.commit = stages_.add("commit");

    assembly_.update_active(state_);
    std::vector<Vec6> out_of_balance;
    integrator_->prepare(*effects_);
    return_to_yield_surface();
    find_acceleration(out_of_balance);
    if (step_.failure) fail({step_.failure});
    integrator_->begin(*effects_);
    if (any_of(effects_->forces, &Force::has_blocks)) blocks_changed(state_);
    for (const auto& e : effects_->all) e->started(out_of_balance);
    sleepers_.resize(effects_->sleepers.size());
    if (!explicit_steps() && !breaks_or_parts_) mass_.drop();  // nothing can vanish at once
    add_inertia_to_reactions();
    energy_monitor_.begin(state_);
}

/// A step for what effects add to the elements: a chosen one is shortened, too long an explicit one refused. Elements'
/// own limit was looked at where the settings were read.
DynamicSettings Dynamics::fitted(DynamicSettings s) const {
    if (s.controlled_by_default && !s.automatic && !calls_for_control()) s.step_control = 0;
    Blocks stiffness, damping(1, false);
    for (const auto& limiter : effects_->step_limiters)
        limiter->add_stiffest(stiffness), limiter->add_stiffest(damping);
    const bool none =
        stiffness.pairs.empty() && stiffness.nodes.empty() && damping.pairs.empty() && damping.nodes.empty();
    if (none || !(s.explicit_steps() || s.automatic)) return s;
    const JoinedStep limit =
        s.explicit_steps() ? stable_step_of_joined(*structure_, state_, damping_of(*structure_), stiffness, damping)
                           : JoinedStep{most_phase / std::sqrt(fastest_of_joined(*structure_, state_, stiffness)), -1};
    if (s.chosen) {
        const double wanted = s.explicit_steps() ? usual_step({limit.dt, -1}, *structure_) : limit.dt;
        if (wanted < s.dt) s.dt = s.duration / std::ceil(s.duration / wanted);
    } else if (s.explicit_steps() && s.dt > limit.dt) {
        char text[120];
        std::snprintf(text, sizeof text, "model:dynamic: dt = %.6g s; explicit steps stay stable up to %.6g s (", s.dt,
                      limit.dt);
        throw InputError(text + std::string("with the springs and dashpots at ") + structure_->node_name(limit.node) +
                         "); give a shorter one, dt = 'auto', or integrator = 'newmark'");
    }
    return s;
}

/// The default of energy_tolerance.
double Dynamics::energy_may_miss() const {
    return structure_->model().options().shift == Shift::elastic_and_plastic ? 0
           : explicit_steps()                                                ? may_swing
                                                                             : large_error;
}

// ---- a step -------------------------------------------------------------------------------------------------------

/// Does a stage of the step, unless one before it has failed, and counts its time.
template <class F>
void Dynamics::stage(int stage, F f) {
    if (!step_.failure) stages_.timed(stage, f);
}

/// One step in the paper's order; [what a scene may not call for].
void Dynamics::take_step() {
    choose_length();
    step_ = {state_.time, size_.dt(), size_.longer(), 0, {}, {}};
    stage(at_.loads, [&] { begin_step(); });            // F at the end of the step
    if (meets_) stage(at_.contact, [&] { meet(); });    // [which elements come into contact: eqs 17 to 19]
    if (anew_) stage(at_.restart, [&] { restart(); });  // [the acceleration anew: a force has vanished]
    stage(at_.predict, [&] { predict(); });             // the motion that is known
    bool more = true;
    while (more && !step_.failure) {                        // Newton's loop; the paper goes through it once
        stage(at_.recover, [&] { recover(step_.end()); });  // R: eqs 3, 10, 13, and the return to eq 14
        if (!step_.failure) integrator_->solve(step_);      // [yield: eq 10a], effective stiffness, eq 15
        stage(at_.correct, [&] { more = correct(); });
    }
    stage(at_.recover, [&] { settle(); });                 // stresses where a long step has led
    if (meets_) stage(at_.ends, [&] { end_contacts(); });  // [ties that are due, contacts that began or ended]
    if (settings_.controlled()) stage(at_.control, [&] { control_step(); });  // [whether the step is kept]
    if (decides_) stage(at_.decide, [&] { decide(); });                       // [eq 16; the script is told]
    stage(at_.commit, [&] { commit(); });                                     // what was tried becomes the state
}

void Dynamics::begin_step() {
    for (const auto& e : effects_->all) e->begin(step_);
}

void Dynamics::predict() {
    integrator_->predict(step_);
    for (const auto& p : effects_->prescribers) p->predicted(step_);
    integrator_->prescribed(step_);
    if (constraints_) keep_constraints(true);
}

/// Dependent nodes move with those on which they depend.
void Dynamics::keep_constraints(bool moved) {
    if (moved) constraints_->place(state_, w_.rotation_step), constraints_->renew();
    constraints_->set_velocities();
    constraints_->set_accelerations(true);
}

/// A step too long for what comes is begun again as a shorter one.
void Dynamics::meet() {
    for (const auto& law : effects_->contact_laws) {
        if (law->detect_contacts(step_)) continue;
        take_steps_of(size_.own_length());
        step_.dt = size_.dt(), step_.longer = false;
        begin_step();
        return meet();
    }
}

void Dynamics::restart() {
    std::vector<Vec6> unused;
    find_acceleration(unused);
    begin_step();
}

Failure Dynamics::failure_of_elements() const {
    return assembly_.failure(!any_of(effects_->breakers, &Breaker::by_strain));
}

/// Internal and inertia forces where the nodes are now (eqs 3, 10, 13); p of each element.
void Dynamics::recover(double time) {
    for (Vec6& n : w_.resisting) n.setZero();
    assembly_.set_step(step_.dt);
    find_fixed_ends(w_, *effects_, 1);
    assembly_.run(state_, w_.trial, w_.resisting, w_.force, w_.yielding);
    integrator_->recovered(step_);
    for (const auto& load : effects_->loads) load->subtract_following_loads(w_.resisting);
    for (const auto& force : effects_->forces) force->add_forces(time, w_.resisting);
    if (any_of(effects_->forces, &Force::blocks_follow)) blocks_changed(w_.trial);
    if (constraints_) constraints_->balance([this](int n) { return w_.external[n]; });
    for (int e : assembly_.rotated()) stiffness_changed(e);
    if (step_.iteration == 0 && assembly_.folded() >= 0) step_.failure = failure_of_elements();
}

/// True: another iteration follows.
bool Dynamics::correct() {
    const bool again = integrator_->correct(step_);
    for (const auto& p : effects_->prescribers) p->corrected(step_, integrator_->change());
    if (constraints_) keep_constraints(!explicit_steps());
    if (again) return true;
    if (integrator_->may_go_on(step_))
        for (const auto& law : effects_->contact_laws)
            if (!law->has_converged()) return true;
    integrator_->solved(step_);
    for (const auto& e : effects_->all) e->solved(step_, integrator_->change());
    if (constraints_) constraints_->set_velocities();
    return false;
}

/// With the displacement predictor the stresses so far are those that the last solution started from.
void Dynamics::settle() {
    if (integrator_->recovers_last()) {
        recover(step_.end());
        integrator_->recovered_last();
        for (const auto& p : effects_->prescribers) p->recovered_last();
    }
    if (assembly_.unreturned() >= 0) step_.failure = failure_of_elements();
}

void Dynamics::end_contacts() {
    for (const auto& law : effects_->contact_laws) law->end(step_);
}

void Dynamics::decide() {
    for (const auto& breaker : effects_->breakers) breaker->find_breaks(step_);
}

/// What was tried becomes the state.
void Dynamics::commit() {
    for (const auto& e : effects_->all) e->accumulate_energy(step_, state_.accumulated);
    state_.accumulated["numerical"] += integrator_->dissipated(step_);
    for (const auto& e : effects_->all) e->before_commit(step_);
    integrator_->before_commit();
    std::swap(static_cast<Configuration&>(state_), w_.trial);
    state_.force.swap(w_.force);
    for (int e : assembly_.save_turns(state_, w_.trial)) stiffness_changed(e);
    integrator_->after_commit();
    if (constraints_) constraints_->commit();
    for (const auto& e : effects_->all) e->after_commit(step_);
    call_watches(step_);
    if (constraints_due_) rebuild_constraints();
    if (unseen_) control_.not_looked_at(size_);
    if (built::fracture && !step_.breaks.empty()) break_elements();
    if (w_.points_moved) assembly_.update_active(state_), w_.points_moved = false;
    if (control_.on() && !control_.by_default() && anew_) control_.start_from(energy().error);
    watch_effects();
    ++state_.step;
    size_.count_step();
    if (control_.by_default()) motions_.insert(motions_.begin(), motion_), motions_.resize(2, motion_);
    if (settings_.automatic || (control_.on() && !control_.by_default())) state_.time = size_.end();
    else state_.time += step_.dt;
}

/// Elements break: each becomes an offset mass, and what that asks of the nodes is passed on to all velocities.
void Dynamics::break_elements() {
    const bool watched = control_.by_default();
    const double error = watched ? energy().error : 0;
    std::vector<Reached> broken;
    for (const Break& b : step_.breaks) broken.push_back({b.element, "broken"});
    reached(broken);
    std::vector<Vec6> impulse(w_.resisting.size(), Vec6::Zero());
    for (const Break& b : step_.breaks) {
        for (const auto& listener : effects_->break_listeners) listener->breaks(b, impulse);
        integrator_->removed(b.element);
        for (const auto& listener : effects_->break_listeners) listener->broke(b);
        assembly_.deactivate(b.element);
    }
    if (w_.points_moved) assembly_.update_active(state_), w_.points_moved = false;
    if (constraints_) rebuild_constraints();
    Mass& mass = mass_.renewed(state_);
    const double before = work_of_supports(state_.velocity, state_.velocity);
    if (std::isnan(pass_on(state_, mass, impulse))) fail({{.cause = Cause::mass_not_solved, .after_breaks = true}});
    state_.accumulated["work"] += work_of_supports(state_.velocity, state_.velocity) - before;
    for (const auto& listener : effects_->break_listeners) listener->all_broke();
    if (watched) control_.leave_behind(energy().error - error);
    anew_ = true;
}

/// Those of nodes that are left; a node that is no longer joined has its own mass again.
void Dynamics::rebuild_constraints() {
    constraints_due_ = false;
    for (const std::vector<int>& group : constraints_->reduction().groups())
        for (const int n : group)
            for (const int e : structure_->elements_at(n)) mass_.changed(e);
    constraints_->rebuild();
    if (EffectiveStiffness* effective = integrator_->effective()) effective->set_held(state_.held);
}

// ---- what the steps stand on ----------------------------------------------------------------------------------------

/// M a = F - R: at the start, and again whenever a force has vanished at once. With the acceleration of before, half a
/// step of a force that is no longer there would go into the velocities.
void Dynamics::find_acceleration(std::vector<Vec6>& out_of_balance) {
    const auto prescribe = [&] {
        for (const auto& p : effects_->prescribers) p->prescribe(state_.acceleration);
    };
    for (const auto& p : effects_->prescribers) p->keep_acceleration();
    for (const auto& load : effects_->loads) load->act_at(state_.time);
    for (Vec6& a : state_.acceleration) a.setZero();
    prescribe();
    w_.trial = state_;
    if (constraints_) constraints_->renew(), constraints_->set_accelerations(false);
    const std::vector<Vec6> towards_centre = w_.trial.acceleration;
    step_.iteration = 0;
    w_.at_state = true;
    recover(state_.time);
    w_.at_state = false;
    integrator_->start_from_forces();
    Mass& mass = mass_.renewed(w_.trial);
    out_of_balance.resize(w_.resisting.size());
    for (std::size_t i = 0; i < out_of_balance.size(); ++i) out_of_balance[i] = w_.external[i] - w_.resisting[i];
    for (int n : w_.supported) {
        Vec6& r = reaction_[n];
        r.setZero();
        for (int c = 0; c < 6; ++c)
            if (state_.held[n] >> c & 1) r[c] = 0 - out_of_balance[n][c], out_of_balance[n][c] = 0;
    }
    must_be_solved(mass.solve(out_of_balance, state_.acceleration, state_, 1e-12));
    if (constraints_)
        for (const std::vector<int>& group : constraints_->reduction().groups())
            for (const int n : group) state_.acceleration[n] += towards_centre[n];
    w_.yielding.clear();
    anew_ = false;
    for (const auto& e : effects_->all) e->acceleration_found();
    prescribe();
    if (w_.scheme.alpha != 0) w_.weighted = state_.acceleration;
}

/// What strains elements at once where a run begins (heat, prestress) may put them beyond yield. They begin with the
/// forces on the yield surface, at the deformation that they have. So does a bar between fixed ends that is heated
/// slowly: initial energy is what it stores then and its plastic work, not what it would store without yield. Loads
/// between nodes that act at once may bring other elements beyond yield, by work that nothing supplies: these stay.
void Dynamics::return_to_yield_surface() {
    if (!effects_->any(&EffectTraits::strains_at_start) || !structure_->can_yield()) return;
    for (const auto& load : effects_->loads) load->act_at(state_.time);
    w_.trial = state_;
    if (constraints_) constraints_->renew();
    step_ = {state_.time, 0, false, 1, {}, {}};  // with 0 long steps take the hinges of their last step
    w_.at_state = true;
    recover(state_.time);
    w_.at_state = false;
    const auto strained = [&](int e) { return !heat_of(state_.heat, e).deformation().isZero(0); };
    std::erase_if(w_.yielding, [&](const PlasticIncrement& y) { return !strained(y.element); });
    if (!w_.yielding.empty() && !step_.failure && assembly_.unreturned() < 0) {
        const double before = state_.accumulated["plastic"];
        const int first = w_.yielding.front().element;
        const std::size_t count = w_.yielding.size();
        for (std::size_t i = 0; i < state_.force.size(); ++i)
            if (strained(int(i))) state_.force[i] = w_.force[i];
        for (const auto& e : effects_->all) e->returned_to_yield(step_);
        if (w_.points_moved) assembly_.update_active(state_), w_.points_moved = false;
        initial_ -= energy_of(state_).error;
        const double work = state_.accumulated["plastic"] - before;
        if (work > 0)
            note({.kind = Notice::Kind::starts_beyond_yield, .element = first, .count = long(count), .value = work});
    }
    w_.yielding.clear();
    step_ = {};
}

/// Reactions where the run begins: what holds the supports' share of the mass of elements that accelerate at once. In
/// explicit steps a support has no such share. Effects have found what they need in them without it.
void Dynamics::add_inertia_to_reactions() {
    const auto moves = [](const Vec6& a) { return !a.isZero(0); };
    if (explicit_steps() || std::none_of(state_.acceleration.begin(), state_.acceleration.end(), moves)) return;
    ElementAssembly assembly(*structure_, pool_, true);
    assembly.update_active(state_);
    Configuration pose = state_;
    std::vector<Vec6> with(pose.displacement.size(), Vec6::Zero()), without = with, force = state_.force;
    std::vector<PlasticIncrement> yielding;
    assembly.run(state_, pose, with, force, yielding);
    for (Vec6& a : pose.acceleration) a.setZero();
    assembly.run(state_, pose, without, force, yielding);
    if (constraints_) constraints_->reduction().reduce(with), constraints_->reduction().reduce(without);
    for (int n : w_.supported)
        for (int c = 0; c < 6; ++c)
            if (state_.held[n] >> c & 1) reaction_[n][c] += with[n][c] - without[n][c];
}

/// A solution with M without an answer: the step fails. A right side that is not finite is named where it comes from.
void Dynamics::must_be_solved(const SolveReport& report) {
    const bool not_finite = !report.indefinite && report.iterations == 0;
    if (!report.converged && !not_finite && !step_.failure) step_.failure = {.cause = Cause::mass_not_solved};
}

ImpulseResponse Dynamics::respond(const std::vector<Vec6>& impulse) {
    ImpulseResponse out;
    for (std::size_t i = 0; i < impulse.size(); ++i) {
        out.linear += impulse[i].dot(w_.trial.velocity[i]);
        for (int c = 0; c < 6; ++c)
            if (state_.held[i] >> c & 1) out.by_supports -= impulse[i][c] * w_.trial.velocity[i][c];
    }
    must_be_solved(mass_.renewed(w_.trial).solve(impulse, out.change, state_, 1e-10));  // nothing where it is held
    for (std::size_t i = 0; i < impulse.size(); ++i) out.square += 0.5 * impulse[i].dot(out.change[i]);
    out.by_supports += work_of_supports(w_.trial.velocity, out.change);
    return out;
}

double Dynamics::work_of_supports(const std::vector<Vec6>& supports, const std::vector<Vec6>& velocity) const {
    double work = 0;
    for (const auto& p : effects_->prescribers) work += p->work_of_supports(supports, velocity);
    return work;
}

void Dynamics::blocks_changed(const Pose& at) {
    if (EffectiveStiffness* effective = integrator_->effective())
        effective->set_blocks(added_blocks(*effects_, at, w_.scheme.gamma / (w_.scheme.beta * size_.dt())));
}

void Dynamics::set_offset_mass(int node, const Mat6& mass) {
    if (EffectiveStiffness* effective = integrator_->effective()) effective->set_offset_mass(node, mass);
}

void Dynamics::leave_out(const std::vector<int>& resting) {
    if (EffectiveStiffness* effective = integrator_->effective()) effective->leave_out(resting);
}

/// Called once a step: effects that sleep wake when they have something to do.
void Dynamics::watch_effects() {
    auto sleeper = sleepers_.begin();
    for (const auto& e : effects_->sleepers) {
        Sleep& s = *sleeper++;
        if (e->busy()) {
            if (!s.awake) note_activation(e.effect->name(), true, e->why_awake());
            s.awake = true;
            s.quiet = 0;
        } else if (s.awake && ++s.quiet >= quiet_steps) {
            s.awake = false;
            note_activation(e.effect->name(), false, "nothing to do for " + std::to_string(quiet_steps) + " steps");
        }
    }
}

// ---- the run --------------------------------------------------------------------------------------------------------

bool Dynamics::advance() {
    if (verdict_ != Verdict::running) return false;
    if (size_.over()) {
        verdict_ = Verdict::completed;
        return false;
    }
    save_step();
    try {
        do {
            rejected_ = false;
            take_step();
            if (!step_.failure) break;
            step_.failure.step = state_.step + 1, step_.failure.time = state_.time + step_.dt;
            // no shorter step helps against a load that is not finite
            rejected_ =
                settings_.controlled() && !(control_.by_default() && step_.failure.cause == Cause::load_not_finite);
            if (!rejected_) roll_back(), fail({step_.failure});
        } while (rejected_ && again_shorter());
        for (const auto& e : effects_->all) e->release_step();
    } catch (const HookError& e) {
        roll_back();
        char at[100];
        std::snprintf(at, sizeof at, " at step %ld, t = %.6g s; the step was taken back to t = %.6g s", state_.step + 1,
                      state_.time + size_.dt(), state_.time);
        throw HookError(e.what() + std::string(at));
    } catch (...) {
        roll_back();
        throw;
    }
    if (verdict_ == Verdict::running && size_.over()) verdict_ = Verdict::completed;
    if (settings_.controlled() && !unseen_ && verdict_ != Verdict::failed)
        energy_monitor_.take(control_.kept_share(), state_.time);
    check_energy();
    end_step();
    return verdict_ != Verdict::failed;
}

void Dynamics::choose_length() {
    if (!size_.varies()) return;
    const auto calm = [&] {
        const auto& list = effects_->step_limiters;
        return !anew_ && std::all_of(list.begin(), list.end(), [](const auto& l) { return l->allows_long_step(); });
    };
    const auto changes = [&] {
        double after[StepSize::long_step];
        for (long i = 0; i < StepSize::long_step; ++i) after[i] = double(i + 1) * size_.own();
        const auto& list = effects_->step_limiters;
        return std::any_of(list.begin(), list.end(),
                           [&](const auto& l) { return l->changes_within(state_.time, after); });
    };
    take_steps_of(size_.next(settings_.automatic && calm(), integrator_->jump(), changes));
}

void Dynamics::take_steps_of(long length) {
    if (length == size_.length()) return;
    const long own = size_.own_length();
    if (std::max(length, size_.length()) > own)
        note_activation("long steps", length > own,
                        length > own ? "nothing yields, breaks or touches" : "back to the shortest");
    else if (length == own) note_activation("short steps", false, "back to dt");
    set_length(length);
}

void Dynamics::set_length(long length) {
    if (!size_.set_length(length)) return;
    integrator_->dt_changed(size_.dt());
    if (any_of(effects_->forces, &Force::has_blocks)) blocks_changed(state_);
}

// ---- steps that are taken back --------------------------------------------------------------------------------------

/// Whatever a step changes before it commits, beside what is tried. Each step is saved: functions of the script are
/// not all that may throw in one.
void Dynamics::save_step() {
    for (const auto& e : effects_->all) e->save_step();
    before_.accumulated = state_.accumulated;
    before_.size = size_;
    before_.anew = anew_;
    before_.fastest = integrator_->fastest;
}

/// A rule of the script failed, or step control takes the step back: all as it was before.
void Dynamics::roll_back() {
    set_length(before_.size->length());
    state_.accumulated = before_.accumulated;
    size_ = *before_.size;
    anew_ = before_.anew;
    integrator_->fastest = before_.fastest;
    step_.breaks.clear();
    for (const auto& e : effects_->all) e->roll_back();
}

/// The step is taken back and halved; false when it is the finest already: the run ends.
bool Dynamics::again_shorter() {
    const Failure why = step_.failure;
    const long tried = size_.length();
    roll_back();
    if (tried > 1) {
        const long next = size_.halved(tried);
        if (tried == size_.own_length()) note_activation("short steps", true, text_of(RunFailure{why}, *structure_));
        set_length(next);
        save_step();
        return true;
    }
    RunFailure failure{why, {{Remark::Kind::halved, {.value = size_.dt()}}}};
    if (const Failure flat = crushed(); flat.element >= 0)
        failure.remarks.push_back({Remark::Kind::pressed_flat, flat});
    fail(std::move(failure));
    return false;
}

/// An element that is pressed flat: it has no length left that steps could be short against.
Failure Dynamics::crushed() const {
    Failure flat{.value = crushed_part};
    for (int i = 0; structure_->large() && i < int(structure_->elements().size()); ++i) {
        const Element& e = structure_->elements()[i];
        const double part = chord_of(e, state_.displacement).norm() / e.length;
        if (!state_.broken[i] && part < flat.value) flat.value = part, flat.element = i;
    }
    return flat;
}

/// The energy balance of what is tried; the state is as before afterwards.
Energy Dynamics::energy_of_trial() {
    const Accounts accumulated = state_.accumulated;
    std::vector<Vec6> plastic;
    for (const auto& e : effects_->all) e->accumulate_energy(step_, state_.accumulated);
    state_.accumulated["numerical"] += integrator_->dissipated(step_);
    for (const PlasticIncrement& y : w_.yielding) {
        plastic.push_back(state_.plastic[y.element]);
        state_.plastic[y.element] += y.flow.plastic;
    }
    std::swap(static_cast<Configuration&>(state_), w_.trial);
    Energy energy = energy_of(state_);
    std::swap(static_cast<Configuration&>(state_), w_.trial);
    for (std::size_t i = 0; i < w_.yielding.size(); ++i) state_.plastic[w_.yielding[i].element] = plastic[i];
    state_.accumulated = accumulated;
    return energy;
}

/// Whether step control acts in this scene by default, whatever its dt.
bool Dynamics::calls_for_control() const {
    return (built::plasticity && structure_->can_yield()) || effects_->any(&EffectTraits::forces_vanish);
}

/// The kinetic energy of the nodes where the step is tried to end, with half of each element's mass on either node: it
/// costs next to nothing, and is near enough to see a jump.
double Dynamics::motion_of_trial() const {
    const double* mass = lumped_.data();
    const Vec6* v = w_.trial.velocity.data();
    return w_.pool.sum(int(lumped_.size()), some_nodes, [mass, v](int first, int end) {
        double sum = 0;
        for (int i = first; i < end; ++i) sum += 0.5 * mass[i] * v[i].head<3>().squaredNorm();
        return sum;
    });
}

/// Whether the motion changes so much in the step that is tried that it may hide a loss: its kinetic energy differs
/// from what the two steps before lead to, or much flows in hinges.
bool Dynamics::is_abrupt() {
    motion_ = motion_of_trial();
    const double limit = control_.abrupt() * largest_energy_.most();
    const double expected = motions_.size() < 2 ? motion_ : 2 * motions_[0] - motions_[1];
    double flow = 0;
    for (const PlasticIncrement& y : w_.yielding) flow += std::abs(y.flow.dissipation);
    return !(std::abs(motion_ - expected) <= limit && flow <= much_flow * limit);
}

/// Step control: whether the step is kept.
void Dynamics::control_step() {
    if (structure_->large())
        for (std::size_t i = 0; i < w_.rotation_step.size(); ++i)
            if (const double angle = w_.rotation_step[i].norm(); !(angle <= most_rotation)) {
                step_.failure = {
                    .cause = Cause::rotation_too_large, .node = int(i), .value = angle, .limit = most_rotation};
                return;
            }
    unseen_ = !control_.due(control_.by_default() && is_abrupt(), size_);
    if (unseen_) return;
    step_.failure = control_.refuse(energy_of_trial(), accounts_, largest_energy_, size_, [this] {
        const double error = energy().error;  // of a state that is kept, seen only now
        if (largest_energy_.most() > 0) energy_monitor_.take(error / largest_energy_.most(), state_.time);
        return error;
    });
}

double Dynamics::energy_error_share() const {
    LargestEnergy largest = largest_energy_;  // it grows at the checks of the energy monitor alone
    return largest.share(energy(), accounts_);
}

/// The largest error of explicit steps is that of a few steps, which the energy monitor may miss between two checks.
void Dynamics::look_between() {
    const double most = std::max(largest_energy_.most(), initial_);
    if (verdict_ != Verdict::running || !energy_monitor_.may_miss(integrator_->swing(), most)) return;
    LargestEnergy largest = largest_energy_;  // it grows at the checks of the energy monitor alone
    const double share = largest.share(energy(), accounts_);
    if (largest.most() <= 2 * most) energy_monitor_.take(share, state_.time);
}

/// After a step that went well, or one that failed: whether the energy balance still closes.
void Dynamics::check_energy() {
    const bool running = verdict_ == Verdict::running, failed = verdict_ == Verdict::failed;
    const bool due = energy_monitor_.due(state_, running);
    if (!due && !failed) return look_between();
    Failure lost;
    if (due)
        lost = energy_monitor_.look(state_, energy(), accounts_, largest_energy_, running,
                                    EnergyMonitor::may_grow(tolerance()));
    if (!lost && !failed) return;
    if (!lost && (assembly_.folded() >= 0 || failure_.what.cause == Cause::load_not_finite)) return;
    RunFailure failure = failed ? failure_ : RunFailure{lost};
    if (lost && failed) failure.remarks.push_back({Remark::Kind::before, lost});
    if (const Fastest& fast = fastest(); lost && fast.node >= 0)
        failure.remarks.push_back({Remark::Kind::fastest, {.node = fast.node, .value = fast.speed, .time = fast.time}});
    if (lost && energy_monitor_.lost()->went_back)
        failure.remarks.push_back(
            {Remark::Kind::went_back,
             {.value = energy_monitor_.lost()->good_share, .count = state_.step, .time = state_.time}});
    fail(std::move(failure));
}

}  // namespace hinge

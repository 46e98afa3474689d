#include "run/dynamics.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "core/text.h"
#include "effects/all_effects.h"
#include "run/central_differences.h"
#include "run/effect_forces.h"
#include "run/energy_momentum.h"
#include "run/newmark.h"

namespace hinge {
namespace {

RunKind kind_of(const DynamicSettings& s) {
    return {true, s.explicit_steps(), s.geometric, s.rest && !s.conserving, s.conserving, s.dt};
}

}  // namespace

Dynamics::Dynamics(std::shared_ptr<const Structure> structure, State start, DynamicSettings settings)
    : Run(std::move(structure), std::move(start), kind_of(settings), settings.threads,
          !settings.explicit_steps() && !settings.conserving),
      settings_(fitted_to_effects(settings, w_, *effects_)),
      length_(settings_, w_),
      energy_check_(*structure_, settings_.energy_tolerance.value_or(default_energy_tolerance(*structure_, settings_)),
                    own_steps()),
      mass_(w_),
      forces_(w_, *effects_, mass_, integrator_, *this, step_, times_),
      element_breaks_(w_, *effects_, mass_, integrator_, forces_, *this),
      sleepers_(*effects_),
      has_contacts_(!effects_->contact_laws.empty()),
      forces_may_vanish_(effects_->any(&EffectTraits::forces_vanish)),
      has_breakers_(!effects_->breakers.empty()) {
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
    add_stages();
    assembly_.update_active(state_);
    std::vector<Vec6> out_of_balance;
    integrator_->prepare(*effects_);
    if (const auto yields = forces_.return_to_yield_surface()) {
        initial_ -= energy_of(state_).error;
        if (yields->value > 0) note(*yields);
    }
    forces_.find_acceleration(out_of_balance);
    if (step_.failure) fail({step_.failure});
    integrator_->begin(*effects_);
    if (any_of(effects_->forces, &Force::has_blocks)) blocks_changed(state_);
    for (const auto& e : effects_->all) e->started(out_of_balance);
    if (!explicit_steps() && !forces_may_vanish_) mass_.drop();  // nothing can vanish at once
    forces_.add_inertia_to_reactions();
    energy_check_.begin(state_, own_steps());
}

/// The stages of a step, and the integrator with its own.
void Dynamics::add_stages() {
    at_ = {};
    at_.loads = stages_.add("loads");
    if (has_contacts_) at_.contact = stages_.add("contact");
    if (forces_may_vanish_) at_.restart = stages_.add("restart");
    at_.predict = stages_.add("predict");
    at_.recover = stages_.add("recover stresses");
    if (explicit_steps()) integrator_ = std::make_unique<CentralDifferences>(w_, mass_, stages_);
    else if (settings_.conserving) integrator_ = std::make_unique<EnergyMomentum>(w_, mass_, stages_, settings_);
    else integrator_ = std::make_unique<Newmark>(w_, mass_, stages_, settings_);
    at_.correct = integrator_->correct_stage();
    if (has_contacts_) at_.ends = stages_.add("contact ends");
    if (length_.controls()) at_.control = stages_.add("step control");
    if (const auto& list = effects_->breakers; has_breakers_) at_.decide = stages_.add(list.front()->stage_name());
    at_.commit = stages_.add("commit");
}

// ---- a step -------------------------------------------------------------------------------------------------------

/// Does a stage of the step, unless one before it has failed, and counts its time.
template <class F>
void Dynamics::stage(int stage, F f) {
    if (!step_.failure) stages_.timed(stage, f);
}

/// One step in the paper's order; [what a scene may not call for].
void Dynamics::take_step() {
    times_.begin_step(state_.step, planned_steps());
    choose_length();
    step_ = {state_.time, dt(), length_.size().longer(), 0, {}, {}};
    stage(at_.loads, [&] { begin_step(); });                            // F at the end of the step
    if (has_contacts_) stage(at_.contact, [&] { detect_contacts(); });  // [elements that come into contact: eqs 17-19]
    if (forces_.acceleration_due) stage(at_.restart, [&] { restart(); });  // [acceleration anew: a force has vanished]
    stage(at_.predict, [&] { predict(); });                                // the motion that is known
    bool more = true;
    while (more && !step_.failure) {                                // Newton's loop; the paper goes through it once
        stage(at_.recover, [&] { forces_.recover(step_.end()); });  // R: eqs 3, 10, 13, and the return to eq 14
        if (!step_.failure) integrator_->solve(step_);              // [yield: eq 10a], effective stiffness, eq 15
        stage(at_.correct, [&] { more = correct(); });
    }
    stage(at_.recover, [&] { recover_last(); });                  // stresses where a long step has led
    if (has_contacts_) stage(at_.ends, [&] { end_contacts(); });  // [ties that are due, contacts that began or ended]
    if (length_.controls()) stage(at_.control, [&] { control_step(); });  // [whether the step is kept]
    if (has_breakers_) stage(at_.decide, [&] { decide_breaks(); });       // [eq 16; the script is told]
    stage(at_.commit, [&] { commit(); });                                 // what was tried becomes the state
}

void Dynamics::choose_length() {
    take_steps_of(length_.next(*effects_, !forces_.acceleration_due, integrator_->jump()));
}

void Dynamics::begin_step() {
    forces_.begin_step();
    times_.each(effects_->all, [this](Effect& e) { e.begin(step_); });
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
void Dynamics::detect_contacts() {
    bool short_enough = true;
    times_.each(effects_->contact_laws,
                [&](ContactLaw& law) { short_enough = short_enough && law.detect_contacts(step_); });
    if (short_enough) return;
    take_steps_of(length_.size().own_length());
    step_.dt = dt(), step_.longer = false;
    begin_step();
    detect_contacts();
}

void Dynamics::restart() {
    std::vector<Vec6> unused;
    forces_.find_acceleration(unused);
    begin_step();
}

/// True: another iteration follows.
bool Dynamics::correct() {
    const bool again = integrator_->correct(step_);
    for (const auto& p : effects_->prescribers) p->corrected(step_, integrator_->change());
    if (constraints_) keep_constraints(!explicit_steps());
    if (again) return true;
    if (integrator_->may_go_on(step_)) {
        bool converged = true;
        times_.each(effects_->contact_laws, [&](ContactLaw& law) { converged = converged && law.has_converged(); });
        if (!converged) return true;
    }
    integrator_->solved(step_);
    times_.each(effects_->all, [this](Effect& e) { e.solved(step_, integrator_->change()); });
    if (constraints_) constraints_->set_velocities();
    return false;
}

/// With the displacement predictor the stresses so far are those that the last solution started from.
void Dynamics::recover_last() {
    if (integrator_->recovers_last()) {
        forces_.recover(step_.end());
        integrator_->recovered_last();
        for (const auto& p : effects_->prescribers) p->recovered_last();
    }
    if (assembly_.unreturned() >= 0) step_.failure = forces_.failure_of_elements();
}

void Dynamics::end_contacts() {
    times_.each(effects_->contact_laws, [this](ContactLaw& law) { law.end(step_); });
}

void Dynamics::decide_breaks() {
    times_.each(effects_->breakers, [this](Breaker& breaker) { breaker.find_breaks(step_); });
}

/// What was tried becomes the state.
void Dynamics::commit() {
    times_.each(effects_->all, [this](Effect& e) { e.accumulate_energy(step_, state_.accumulated); });
    state_.accumulated["numerical"] += integrator_->dissipated(step_);
    times_.each(effects_->all, [this](Effect& e) { e.before_commit(step_); });
    integrator_->before_commit();
    std::swap(static_cast<Configuration&>(state_), w_.trial);
    state_.force.swap(w_.force);
    for (int e : assembly_.save_turns(state_, w_.trial)) stiffness_changed(e);
    integrator_->after_commit();
    if (constraints_) constraints_->commit();
    times_.each(effects_->all, [this](Effect& e) { e.after_commit(step_); });
    call_watches(step_);
    if (element_breaks_.constraints_due) element_breaks_.rebuild_constraints();
    length_.note_skipped();
    if (built::fracture && !step_.breaks.empty()) break_elements();
    if (w_.points_moved) read_active(w_);
    const StepControl& control = length_.control();
    if (control.on() && !control.by_default() && forces_.acceleration_due) length_.start_from(energy().error);
    sleepers_.update(*this);
    ++state_.step;
    state_.time = length_.commit(state_.time, step_.dt);
}

void Dynamics::break_elements() {
    const bool watched = length_.control().by_default();
    const double error = watched ? energy().error : 0;
    if (!element_breaks_.apply(step_.breaks)) fail({{.cause = Cause::mass_not_solved, .after_breaks = true}});
    if (watched) length_.leave_behind(energy().error - error);
    forces_.acceleration_due = true;
}

void Dynamics::blocks_changed(const Pose& at) {
    EffectiveStiffness* effective = integrator_->effective();
    if (!effective) return;
    blocks_.begin(w_.scheme.gamma / (w_.scheme.beta * dt()));
    add_blocks(*effects_, at, blocks_);
    effective->exchange_blocks(blocks_);
}

void Dynamics::set_offset_mass(int node, const Mat6& mass) {
    if (EffectiveStiffness* effective = integrator_->effective()) effective->set_offset_mass(node, mass);
}

/// What rests is left as it is in both, the state and the trial, which take turns.
void Dynamics::rest_changed() {
    const auto copy = [](const auto& from, auto& to, std::size_t i) {
        if (i < from.size() && i < to.size()) to[i] = from[i];
    };
    for (std::size_t n = 0; n < w_.resting.size(); ++n) {
        if (w_.resting[n] < 0) continue;
        copy(state_.displacement, w_.trial.displacement, n), copy(state_.rotation, w_.trial.rotation, n);
        copy(state_.small_rotation, w_.trial.small_rotation, n);
        copy(state_.velocity, w_.trial.velocity, n), copy(state_.acceleration, w_.trial.acceleration, n);
        w_.resisting[n].setZero(), w_.rotation_step[n].setZero();
    }
    const std::vector<Element>& elements = structure_->elements();
    for (std::size_t e = 0; e < elements.size(); ++e)
        if (w_.rests(elements[e].node[0])) {
            w_.force[e] = state_.force[e];
            copy(state_.twist, w_.trial.twist, e), copy(state_.turned, w_.trial.turned, e);
        }
    if (EffectiveStiffness* effective = integrator_->effective()) effective->leave_out(w_.resting);
    Run::rest_changed();
}

// ---- the run --------------------------------------------------------------------------------------------------------

bool Dynamics::advance() {
    if (verdict_ != Verdict::running) return false;
    if (length_.size().over()) {
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
            rejected_ = length_.controls() &&
                        !(length_.control().by_default() && step_.failure.cause == Cause::load_not_finite);
            if (!rejected_) roll_back(), fail({step_.failure});
        } while (rejected_ && try_shorter());
        for (const auto& e : effects_->all) e->release_step();
    } catch (const HookError& e) {
        roll_back();
        char at[100];
        std::snprintf(at, sizeof at, " at step %ld, t = %.6g s; the step was taken back to t = %.6g s", state_.step + 1,
                      state_.time + dt(), state_.time);
        throw HookError(e.what() + std::string(at));
    } catch (...) {
        roll_back();
        throw;
    }
    if (verdict_ == Verdict::running && length_.size().over()) verdict_ = Verdict::completed;
    if (length_.controls() && !length_.is_skipped() && verdict_ != Verdict::failed)
        energy_check_.note_error(length_.control().kept_share(), state_.time);
    if (auto failure = energy_check_.check(*this, state_, *integrator_, initial_)) fail(std::move(*failure));
    end_step();
    return verdict_ != Verdict::failed;
}

void Dynamics::take_steps_of(long length) {
    const StepSize& size = length_.size();
    if (length == size.length()) return;
    const long own = size.own_length();
    if (std::max(length, size.length()) > own)
        note_activation("long steps", length > own,
                        length > own ? "nothing yields, breaks or touches" : "back to the shortest");
    else if (length == own) note_activation("short steps", false, "back to dt");
    set_length(length);
}

void Dynamics::set_length(long length) {
    if (!length_.set(length)) return;
    integrator_->dt_changed(dt());
    if (any_of(effects_->forces, &Force::has_blocks)) blocks_changed(state_);
}

// ---- steps that are taken back --------------------------------------------------------------------------------------

/// Whatever a step changes before it commits, beside what is tried. Each step is saved: functions of the script are
/// not all that may throw in one.
void Dynamics::save_step() {
    for (const auto& e : effects_->all) e->save_step();
    before_.accumulated = state_.accumulated;
    before_.size = length_.size();
    before_.acceleration_due = forces_.acceleration_due;
    before_.fastest = integrator_->fastest;
}

/// A rule of the script failed, or step control takes the step back: all as it was before.
void Dynamics::roll_back() {
    set_length(before_.size->length());
    state_.accumulated = before_.accumulated;
    length_.restore(*before_.size);
    forces_.acceleration_due = before_.acceleration_due;
    integrator_->fastest = before_.fastest;
    step_.breaks.clear();
    for (const auto& e : effects_->all) e->roll_back();
}

/// The step is taken back and halved; false when it is the finest already: the run ends.
bool Dynamics::try_shorter() {
    const Failure why = step_.failure;
    const long tried = length_.size().length();
    roll_back();
    if (tried > 1) {
        const long next = length_.halved(tried);
        if (tried == length_.size().own_length())
            note_activation("short steps", true, text_of(RunFailure{why}, *structure_));
        set_length(next);
        save_step();
        return true;
    }
    RunFailure failure{why, {{Remark::Kind::halved, {.value = dt()}}}};
    if (const Failure flat = find_crushed(*structure_, state_); flat.element >= 0)
        failure.remarks.push_back({Remark::Kind::pressed_flat, flat});
    fail(std::move(failure));
    return false;
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

/// Whether one of the effects whose forces may vanish has something to do, or may have.
bool Dynamics::effects_act() const {
    const auto acts = [&](const std::unique_ptr<Effect>& e) {
        if (!e->traits().forces_vanish || sleepers_.asleep(*e)) return false;
        const auto breaks_by_strain = [&](const InRole<Breaker>& b) { return b.effect == e.get() && b->by_strain(); };
        return breaks() > 0 || std::none_of(effects_->breakers.begin(), effects_->breakers.end(), breaks_by_strain);
    };
    return std::any_of(effects_->all.begin(), effects_->all.end(), acts);
}

/// Step control: whether the step is kept.
void Dynamics::control_step() {
    const auto error_before = [&] {  // of a state that is kept, seen only now
        const double error = energy().error, most = energy_check_.largest().most();
        if (most > 0) energy_check_.note_error(error / most, state_.time);
        return error;
    };
    length_.begin_control([this] { return effects_act(); }, [this] { return energy().error; });
    step_.failure =
        length_.refuse([this] { return energy_of_trial(); }, accounts_, energy_check_.largest(), error_before);
}

}  // namespace hinge

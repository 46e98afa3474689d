#include "run/statics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/text.h"
#include "effects/all_effects.h"

namespace hinge {
namespace {

/// Part of the load factor to which steps of load are shortened before the structure is said to be unstable.
constexpr double instability_bracket = 1e-3;

/// Where one mechanism takes over from another, so many times the substep that has failed is tried first.
constexpr double longer_exchange = 16;

}  // namespace

Statics::Statics(std::shared_ptr<const Structure> structure, State start, StaticSettings settings)
    : Run(std::move(structure), std::move(start), RunKind{}, 1, false),
      problem_(w_, *effects_, std::move(settings)),
      forces_(problem_, stages_),
      tangent_(problem_, forces_, stages_),
      newton_(problem_, forces_, tangent_),
      stability_(problem_, tangent_, newton_),
      path_(make_path()),
      load_to_target_(this->settings().steps),
      halving_(path_->step_rule()) {
    w_.rotation_step.assign(structure_->position().size(), Vec3::Zero());
    state_.factor = w_.factor = 0;
    assembly_.stop_at_unreturned();
    assembly_.update_active(state_);
    forces_.recover();
    forces_.find_reactions(0);
    factor_at_start_ = forces_.factor_at_start();
    if (constraints_) constraints_->reduction().refuse_held(problem_.held);
    refuse_mechanism();
    const bool unsymmetric = structure_->large() && forces_.are_unsymmetric();
    stability_.begin(unsymmetric);
    if (unsymmetric) tangent_.keep_unsymmetric();
}

/// A step of the run, in as many substeps as it takes.
bool Statics::advance() {
    if (verdict_ != Verdict::running) return false;
    if (is_over()) {
        verdict_ = Verdict::completed;
        return false;
    }
    const long substeps_before = substeps_;
    halving_.begin_step(1 - part_done());
    while (halving_.left() > 0 && verdict_ == Verdict::running) take_substep();
    const bool moved = substeps_ != substeps_before;
    if (moved) ++state_.step;
    if (moved && verdict_ == Verdict::running && is_over()) verdict_ = Verdict::completed;
    end_step();
    return moved;
}

/// From one equilibrium to the next.
void Statics::take_substep() {
    std::optional<Substep> substep = find_equilibrium();
    if (!substep) return;
    if (path_->reaches_target(state_.factor, w_.factor)) substep = step_to_target(*substep);
    stability_.accept_branching(*path_);
    if (stability_.has_more_modes() && !pass_instability(*substep)) return;
    if (path_->kind() == Control::load)
        if (const auto snap = stability_.find_snap(substep->increment)) note(*snap);
    branches_left_ = 0;
    commit(*substep);
}

/// The substep that comes next, or half of it, and half of that; none where the run ends there. An equilibrium that
/// cannot be held may be that of another branch, to which Newton's method has leapt. It is the structure's own where it
/// lies as far from the state as its tangent says, or where no shorter step finds another.
std::optional<Statics::Substep> Statics::find_equilibrium() {
    const double whole = halving_.next();
    double increment = whole;
    for (;;) {
        const Found found = try_step(*path_, increment);
        if (found != Found::nothing && is_on_path(increment)) break;
        if (halving_.halve(increment)) continue;
        if (const auto unheld = reach_unheld()) return Substep{path_.get(), *unheld};
        if (const auto exchanged = exchange_mechanisms(whole)) {
            halving_.go_on_with(*exchanged);
            return Substep{path_.get(), *exchanged};
        }
        end_at_limit(
            {.cause = Cause::no_equilibrium, .value = state_.factor, .limit = increment, .step = steps_done() + 1});
        return {};
    }
    return Substep{path_.get(), increment};
}

/// Whether the equilibrium that has been tried counts as the next one of the path.
bool Statics::is_on_path(double increment) const {
    if (increment / 2 < StepHalving::smallest) return true;
    if (path_->kind() != Control::load) return !stability_.has_left_path(*path_);
    if (instability()) return true;
    // A step may end at a stable equilibrium beyond a snap. Where its own tangent does not lead there, shorter ones
    // show whether the path does.
    constexpr double shortest = 1.0 / 8;  // of a step that was asked for
    if (!stability_.has_more_modes())
        return settings().past_unstable ||
               !(std::abs(increment) * settings().steps > shortest * std::abs(settings().target) &&
                 stability_.may_have_leapt(increment));
    return increment <= instability_bracket * std::abs(w_.factor) || stability_.follows_tangent(increment);
}

Found Statics::try_step(PathControl& control, double increment, double hinge_stiffness) {
    if (on_try_) on_try_();
    stability_.begin_try();
    if (!newton_.find(control, increment, hinge_stiffness, start_of(control, increment))) return Found::nothing;
    const Found found = stability_.judge(control, increment, hinge_stiffness);
    if (found == Found::unstable && &control == path_.get()) note_unheld();
    return found;
}

/// Where a step begins, as displacements from the state: at the state itself, but for the first step onto a branch, and
/// for the step to an equilibrium that is known.
std::vector<Vec6> Statics::start_of(const PathControl& control, double increment) const {
    std::vector<Vec6> start;
    if (to_unheld_ > 0 && increment == to_unheld_) return way_to(*unheld_);
    if (substeps_ > 0 || settings().branch.empty()) return start;
    start = settings().branch;
    const double by = control.along(start, increment);
    for (Vec6& v : start) v *= by;
    return start;
}

/// Where one mechanism takes over from another, a new hinge lets many others unload at once. Newton's method then
/// swings between two sets of hinges, however short the step. A tangent in which hinges keep more of the elastic
/// stiffness comes to the new set, slowly; the step must reach beyond the exchange. Returns the increment that does.
/// So do members that are slack in one iteration and taut in the next. Steps of load alone are left out: where they
/// find no equilibrium they mostly are at a limit load. Heat and moving supports drive a structure like a displacement.
/// Substeps that are short by now may need it one after another, at a hundred times the cost of others: it is tried
/// with longer ones first.
std::optional<double> Statics::exchange_mechanisms(double increment) {
    const auto& members = structure_->model().members();
    const bool may_be_slack =
        std::any_of(members.begin(), members.end(), [](const MemberData& m) { return m.carries != Carries::both; });
    const bool driven = forces_.are_heated() || !forces_.support_rates().empty();
    if (!may_be_slack && ((path_->kind() == Control::load && !driven) || newton_.hinges().empty())) return {};
    const double longest = std::min(halving_.left(), longer_exchange * increment);
    for (double part = longest; part >= increment / 100 && part >= StepHalving::smallest; part /= 4)
        for (const double hinge_stiffness : {1e-3, 1e-2, 1e-1})
            if (try_step(*path_, part, hinge_stiffness) != Found::nothing && !stability_.has_left_path(*path_))
                return part;
    return {};
}

/// A step along the arc has passed the load factor at which the path ends: a step of load ends there, or a part of it
/// comes near. Where none is found, the path goes on, and may come by once more.
Statics::Substep Statics::step_to_target(const Substep& passing) {
    const double rest = settings().target - state_.factor;
    for (double part = rest; std::abs(part) >= StepHalving::smallest; part /= 2)
        if (try_step(load_to_target_, part) != Found::nothing) return {&load_to_target_, part};
    try_step(*passing.control, passing.increment);
    return passing;
}

/// The structure becomes unstable on the way to the trial. False where the run ends there, at the last equilibrium that
/// can be held, or goes on from there, since the trial lies on another branch of equilibria.
bool Statics::pass_instability(const Substep& substep) {
    const int modes = stability_.modes();
    const auto try_part = [&](double part) { return try_step(*substep.control, part); };
    double stable = substep.increment;
    if (!instability()) {
        stable = stability_.locate_instability(*substep.control, substep.increment, try_part);
        if (stability_.are_driven()) {
            stability_.accept_driven();
            stability_.forget_instability();
            return false;
        }
        if (goes_on_before_leap(stable) && try_part(stable) == Found::stable) {
            ++branches_left_;
            stability_.forget_instability();
            commit({substep.control, stable});
            return false;
        }
        if (path_->kind() == Control::load && leans_on_slack_members()) return false;
        if (settings().past_unstable) try_part(substep.increment);
    }
    stability_.accept_modes(modes);
    if (path_->kind() == Control::load && !settings().past_unstable) {
        if (stable > 0 && try_part(stable) == Found::stable) commit_state();
        const Instability& at = *instability();
        end_at_limit({.cause = Cause::unstable,
                      .node = at.node,
                      .component = at.component,
                      .value = at.factor,
                      .limit = at.beyond});
        return false;
    }
    stability_.count_ways(modes);
    return true;
}

void Statics::commit(const Substep& substep) {
    commit_state();
    const double target = settings().target;
    const bool at_target = substep.control == &load_to_target_ &&
                           std::abs(state_.factor - target) <= 1e-12 * std::max(1.0, std::abs(target));
    path_->commit(substep.increment, newton_.result().displacements, at_target);
    halving_.commit(substep.increment, newton_.result().iterations);
}

/// The trial becomes the state.
void Statics::commit_state() {
    const Step step{state_.time, 0, false, 0, {}, {}};
    forces_.add_work(substeps_ == 0 ? factor_at_start_ : state_.factor, state_.accumulated["work"]);
    forces_.find_reactions(w_.factor);
    for (const auto& e : effects_->all) e->accumulate_energy(step, state_.accumulated);
    for (const auto& e : effects_->all) e->before_commit(step);
    static_cast<Pose&>(state_) = w_.trial;  // the velocities stay
    state_.force = w_.force;
    assembly_.save_turns(state_, w_.trial);
    state_.factor = w_.factor;
    newton_.commit();
    stability_.commit();
    to_unheld_ = 0;
    if (constraints_) constraints_->commit();
    for (const auto& e : effects_->all) e->after_commit(step);
    call_watches(step);
    tangent_.commit(w_.points_moved);
    if (w_.points_moved) assembly_.update_active(state_), w_.points_moved = false;
    ++substeps_;
}

std::vector<PlanLine> Statics::effects() const {
    std::vector<PlanLine> list = plan_of(*structure_, w_.kind);
    stages_.add_to(list);
    return list;
}

}  // namespace hinge

#include "run/dynamic_forces.h"

#include <algorithm>

#include "effects/all_effects.h"
#include "run/effect_forces.h"
#include "state/element_heat.h"

namespace hinge {

namespace {
constexpr int few = 5;  ///< iterations of a step that inertia rules
}

Failure DynamicForces::failure_of_elements() const {
    return w_.assembly.failure(!any_of(effects_.breakers, &Breaker::by_strain));
}

void DynamicForces::recover(double time) {
    w_.for_awake(0, int(w_.resisting.size()), [&](int from, int to) {
        std::fill(w_.resisting.begin() + from, w_.resisting.begin() + to, Vec6::Zero());
    });
    w_.assembly.set_step(step_.dt);
    find_fixed_ends(w_, effects_, 1);
    w_.assembly.run(w_.state, w_.trial, w_.resisting, w_.force, w_.yielding);
    integrator_->recovered(step_);
    times_.each(effects_.loads, [&](Load& load) { load.subtract_following_loads(w_.resisting); });
    times_.each(effects_.forces, [&](Force& force) { force.add_forces(time, w_.resisting); });
    renew_blocks();
    if (w_.constraints) w_.constraints->balance([this](int n) { return w_.external[n]; });
    for (int e : w_.assembly.rotated()) host_.stiffness_changed(e);
    if (step_.iteration == 0 && w_.assembly.folded() >= 0) step_.failure = failure_of_elements();
}

void DynamicForces::begin_step() {
    may_lag_ = iterations_ > 1 && iterations_ <= few;
    iterations_ = 0;
}

/// A method that solves once a step corrects its error in the next one, with blocks that are renewed.
void DynamicForces::renew_blocks() {
    ++iterations_;
    const bool lag = may_lag_ && iterations_ <= few;
    if (std::any_of(effects_.forces.begin(), effects_.forces.end(),
                    [&](const auto& f) { return f->blocks_follow() && !(lag && f->blocks_may_lag()); }))
        host_.blocks_changed(w_.trial);
}

void DynamicForces::find_acceleration(std::vector<Vec6>& out_of_balance) {
    const auto prescribe = [&] {
        for (const auto& p : effects_.prescribers) p->prescribe(w_.state.acceleration);
    };
    for (const auto& p : effects_.prescribers) p->keep_acceleration();
    for (const auto& load : effects_.loads) load->act_at(w_.state.time);
    for (Vec6& a : w_.state.acceleration) a.setZero();
    prescribe();
    w_.trial = w_.state;
    if (w_.constraints) w_.constraints->renew(), w_.constraints->set_accelerations(false);
    const std::vector<Vec6> towards_centre = w_.trial.acceleration;
    step_.iteration = 0;
    w_.at_state = true;
    recover(w_.state.time);
    w_.at_state = false;
    integrator_->start_from_forces();
    Mass& mass = mass_.renewed(w_.trial);
    out_of_balance.resize(w_.resisting.size());
    for (std::size_t i = 0; i < out_of_balance.size(); ++i) out_of_balance[i] = w_.external[i] - w_.resisting[i];
    for (int n : w_.supported) {
        Vec6& r = w_.reaction[n];
        r.setZero();
        for (int c = 0; c < 6; ++c)
            if (w_.state.held[n] >> c & 1) r[c] = 0 - out_of_balance[n][c], out_of_balance[n][c] = 0;
    }
    require_solved(mass.solve(out_of_balance, w_.state.acceleration, w_.state, 1e-12));
    if (w_.constraints)
        for (const std::vector<int>& group : w_.constraints->reduction().groups())
            for (const int n : group) w_.state.acceleration[n] += towards_centre[n];
    w_.yielding.clear();
    acceleration_due = false;
    for (const auto& e : effects_.all) e->acceleration_found();
    prescribe();
    if (w_.scheme.alpha != 0) w_.weighted = w_.state.acceleration;
}

std::optional<Notice> DynamicForces::return_to_yield_surface() {
    if (!effects_.any(&EffectTraits::strains_at_start) || !w_.structure.can_yield()) return {};
    for (const auto& load : effects_.loads) load->act_at(w_.state.time);
    w_.trial = w_.state;
    if (w_.constraints) w_.constraints->renew();
    step_ = {w_.state.time, 0, false, 1, {}, {}};  // with 0 long steps take the hinges of their last step
    w_.at_state = true;
    recover(w_.state.time);
    w_.at_state = false;
    std::optional<Notice> found;
    const auto strained = [&](int e) { return !heat_of(w_.state.heat, e).deformation().isZero(0); };
    std::erase_if(w_.yielding, [&](const PlasticIncrement& y) { return !strained(y.element); });
    if (!w_.yielding.empty() && !step_.failure && w_.assembly.unreturned() < 0) {
        const double before = w_.state.accumulated["plastic"];
        const int first = w_.yielding.front().element;
        const std::size_t count = w_.yielding.size();
        for (std::size_t i = 0; i < w_.state.force.size(); ++i)
            if (strained(int(i))) w_.state.force[i] = w_.force[i];
        for (const auto& e : effects_.all) e->returned_to_yield(step_);
        if (w_.points_moved) read_active(w_);
        found = Notice{.kind = Notice::Kind::starts_beyond_yield,
                       .element = first,
                       .count = long(count),
                       .value = w_.state.accumulated["plastic"] - before};
    }
    w_.yielding.clear();
    step_ = {};
    return found;
}

void DynamicForces::add_inertia_to_reactions() {
    const auto moves = [](const Vec6& a) { return !a.isZero(0); };
    if (w_.kind.explicit_steps || std::none_of(w_.state.acceleration.begin(), w_.state.acceleration.end(), moves))
        return;
    ElementAssembly assembly(w_.structure, w_.pool, true);
    assembly.update_active(w_.state);
    Configuration pose = w_.state;
    std::vector<Vec6> with(pose.displacement.size(), Vec6::Zero()), without = with, force = w_.state.force;
    std::vector<PlasticIncrement> yielding;
    assembly.run(w_.state, pose, with, force, yielding);
    for (Vec6& a : pose.acceleration) a.setZero();
    assembly.run(w_.state, pose, without, force, yielding);
    if (w_.constraints) w_.constraints->reduction().reduce(with), w_.constraints->reduction().reduce(without);
    for (int n : w_.supported)
        for (int c = 0; c < 6; ++c)
            if (w_.state.held[n] >> c & 1) w_.reaction[n][c] += with[n][c] - without[n][c];
}

/// A solution with M without an answer: the step fails. A right side that is not finite is named where it comes from.
void DynamicForces::require_solved(const SolveReport& report) {
    const bool not_finite = !report.indefinite && report.iterations == 0;
    if (!report.converged && !not_finite && !step_.failure) step_.failure = {.cause = Cause::mass_not_solved};
}

ImpulseResponse DynamicForces::respond(const std::vector<Vec6>& impulse) {
    ImpulseResponse out;
    for (std::size_t i = 0; i < impulse.size(); ++i) {
        out.linear += impulse[i].dot(w_.trial.velocity[i]);
        for (int c = 0; c < 6; ++c)
            if (w_.state.held[i] >> c & 1) out.by_supports -= impulse[i][c] * w_.trial.velocity[i][c];
    }
    require_solved(mass_.renewed(w_.trial).solve(impulse, out.change, w_.state, 1e-10));  // nothing where it is held
    for (std::size_t i = 0; i < impulse.size(); ++i) out.square += 0.5 * impulse[i].dot(out.change[i]);
    out.by_supports += work_of_supports(w_.trial.velocity, out.change);
    return out;
}

double DynamicForces::work_of_supports(const std::vector<Vec6>& supports, const std::vector<Vec6>& velocity) const {
    double work = 0;
    for (const auto& p : effects_.prescribers) work += p->work_of_supports(supports, velocity);
    return work;
}

}  // namespace hinge

// What a run that failed advises: the first of a few other settings that held in a short trial from the last good
// state.
#include <algorithm>
#include <cmath>

#include "algebra/massless.h"
#include "algebra/stable_step.h"
#include "effects/all_effects.h"
#include "run/dynamics.h"
#include "state/hinges.h"

namespace hinge {
namespace {

constexpr double far_bent = 0.5;  ///< rad: of an element, elastically; no setting of the run helps then
/// Element recoveries that all trials of a run may take together: 1 to 3 s. Counted in place of time, so that the same
/// run says the same on every machine.
constexpr long most_updates = 1'500'000;
constexpr int most_iterations = 30;
constexpr double steps_beyond = 20;  ///< of the run, that a trial goes on after the moment of failure
constexpr double trial_part = 0.5;   ///< of energy_tolerance: it must hold for the whole run, not for a trial alone

/// By how much the element that is bent most is bent elastically, rad.
double most_bent(const Structure& structure, const State& state) {
    double most = 0;
    for (std::size_t i = 0; structure.large() && i < structure.elements().size(); ++i) {
        if (state.broken[i]) continue;
        const Vec6 d = element_deformation(structure, int(i), state) - state.plastic[i];
        most = std::max({most, std::abs(d[1] - d[0]), std::abs(d[3] - d[2])});
    }
    return most;
}

/// f_y beyond which loads between nodes have come at once. Where they grow, the return to the yield surface keeps f_y
/// at 1, and a step adds what the load grows by in it: 5 % of the forces would be a load that is there in 20 steps.
/// Loads at once that end a run, of 2 to 8 elements a member, bring 1.07 to 30 times what a section carries.
constexpr double beyond_at_once = 1.05 * 1.05;

/// Whether the loads between an element's nodes have come at once: where the nodes are in the state, whose forces are
/// on the yield surface or within it, the fixed-end forces of the step that failed put the section far beyond it. How
/// large these forces are by themselves does not say that. A clamped member carries more than they are at first yield:
/// 4/3 of it under an even load (16 Mp / l^2 in the place of 12), 2 b / l under a force at a < b from its ends, and as
/// a tie any load; and where they grew slowly, a run may fail for any other reason.
bool come_at_once(const Structure& structure, const State& state, const ElementAssembly& assembly, int element,
                  double end) {
    if (structure.laws_call_script()) return true;
    const Vec6 forces = state.force[std::size_t(element)] + assembly.fixed_end(element).at(end);
    const double of_history = structure.conventional() ? 0 : end;
    return yield_function_at(structure, state, element, of_history, beam::resultants(forces, end)) > beyond_at_once;
}

/// Advice where an element yields by fixed-end forces alone that have come at once: its sections yield in no time,
/// before the nodes move. What is lost by that does not depend on dt.
Advice loads_between_nodes(const Structure& structure, const State& state, const ElementAssembly& assembly) {
    double most = 1;
    int worst = -1;
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        if (state.broken[i] || !e.law) continue;
        for (const double end : {-1.0, 1.0}) {
            const double f = beam::yield_function(assembly.fixed_end(int(i)).at(end), end, e.yield);
            if (f > most && come_at_once(structure, state, assembly, int(i), end)) most = f, worst = int(i);
        }
    }
    if (worst < 0) return {};
    return {.kind = Advice::Kind::more_nodes, .element = worst, .value = std::sqrt(most)};
}

}  // namespace

/// Settings that may hold where these have not, in the order in which they are tried: those that cost least first.
std::vector<Dynamics::Trial> Dynamics::trials() const {
    using Kind = Remedy::Kind;
    const bool newmark = !explicit_steps() && !settings_.conserving, large = structure_->large();
    const bool closes = structure_->model().options().shift != Shift::elastic_and_plastic;
    const bool may_conserve =
        newmark && large && closes &&
        std::all_of(effects_->all.begin(), effects_->all.end(), [](const auto& e) { return e->traits().mean_forces; });
    std::vector<Trial> list;
    const auto add = [&](Remedy remedy, auto change) {
        DynamicSettings s = settings_;
        change(s);
        list.push_back({remedy, s});
    };
    // far bent, shorter steps do not hold either, nor does the energy-momentum method with so few elements
    if (most_bent(*structure_, state_) > far_bent) {
        if (may_conserve) return {{{Kind::more_elements_conserving}, {}}};
        list.push_back({{Kind::more_elements}, {}});
    }
    const Cause cause = failure_.what.cause;
    if (cause == Cause::not_positive_definite || cause == Cause::solver_not_converged)
        add({Kind::direct_solver}, [](DynamicSettings& s) { s.solver.direct = true; });
    if (cause == Cause::newton_not_converged && settings_.iterations > 1 && settings_.iterations < most_iterations)
        add({Kind::iterations, most_iterations}, [](DynamicSettings& s) { s.iterations = most_iterations; });
    if (control_.on() && !control_.by_default()) {
        const double larger = std::min(0.5, std::max(0.01, 10 * settings_.step_control));
        add({Kind::step_control, larger}, [&](DynamicSettings& s) { s.control(larger); });
    }
    if (!control_.on() && closes) add({Kind::step_control, 0.01}, [](DynamicSettings& s) { s.control(0.01); });
    const double shortest = shortest_step(*structure_, settings_.duration);
    if (newmark && !settings_.chosen && shortest < settings_.dt)
        add({Kind::automatic_dt}, [&](DynamicSettings& s) {
            s.dt = shortest, s.automatic = s.chosen = true;
            if (closes) s.step_control = DynamicSettings::default_control, s.controlled_by_default = true;
        });
    for (const int part : {4, 16})
        add({Kind::dt, settings_.dt / part},
            [&](DynamicSettings& s) { s.dt = settings_.dt / part, s.automatic = false; });
    if (may_conserve && !may_be_massless(*structure_))
        add({Kind::energy_momentum}, [](DynamicSettings& s) {
            s.conserving = true, s.automatic = s.chosen = false;
            s.beta = 0.25, s.rho_infinity = 1, s.iterations = 0, s.predictor = Predictor::by_step,
            s.single_precision = true;
            s.tolerance = 1e-8, s.rebuild_angle = 0.002, s.control(0.01);
        });
    if (newmark && settings_.alpha() == 0)
        add({Kind::rho_infinity, 0.8},
            [](DynamicSettings& s) { s.rho_infinity = 0.8, s.beta = DynamicSettings::beta_of(0.8); });
    if (newmark && !structure_->cubic() && !may_be_massless(*structure_))
        add({Kind::explicit_steps}, [](DynamicSettings& s) {
            s.beta = 0, s.rho_infinity = 1, s.automatic = false, s.chosen = true, s.control(0);
        });
    return list;
}

/// Whether a run with these settings gets from the state, which is at `from`, to some steps beyond the moment of
/// failure. Nothing is said where the trial would take too long.
std::optional<bool> Dynamics::holds(const Trial& of, double from, double beyond, long& budget) const {
    DynamicSettings s = *of.settings;
    s.trial = true;
    if (tolerance() > 0) s.energy_tolerance = trial_part * tolerance();
    try {
        auto structure = structure_;
        if (explicit_steps() != s.explicit_steps() || settings_.conserving != s.conserving)
            structure =
                std::make_shared<const Structure>(structure_->share_model(), s.explicit_steps() ? MassKind::lumped
                                                                             : s.conserving     ? MassKind::at_nodes
                                                                                                : MassKind::consistent);
        if (s.explicit_steps() && !explicit_steps())
            s.dt = usual_step(stable_step(*structure, damping_of(*structure)), *structure);
        const double steps = std::ceil((beyond - from) / s.dt);
        if (!(steps >= 1 && steps * double(structure->elements().size()) <= double(budget))) return {};
        s.duration = steps * s.dt;
        s.step_control *= std::min(1.0, s.duration / settings_.duration);  // its share of the run
        State start = state_;
        start.step = 0;
        Dynamics trial(structure, std::move(start), s);
        while (trial.advance())
            if (trial.element_updates() > budget) return budget = 0, std::nullopt;
        budget -= trial.element_updates();
        return trial.verdict() == Verdict::completed;
    } catch (const std::exception&) { return false; }
}

/// The first setting that holds, the first one with why it was not tried, or those that were tried in vain.
Advice Dynamics::advice() const {
    using Kind = Advice::Kind;
    using Untried = Advice::Untried;
    // what holds in a short trial then is no remedy: the work of these loads on the flow is not resolved
    if (const Advice more = loads_between_nodes(*structure_, state_, assembly_); more.kind != Kind::none) return more;
    const std::vector<Trial> list = trials();
    const auto untried = [&](Untried why) {
        return list.empty() ? Advice{} : Advice{.kind = Kind::untried, .why = why, .remedies = {list.front().remedy}};
    };
    if (list.empty() || !list.front().settings) return untried(Untried::other_model);
    if (effects_->any(&EffectTraits::calls_script)) return untried(Untried::calls_script);
    const std::optional<LostBalance>& lost = energy_monitor_.lost();
    if (lost && !lost->went_back) return untried(Untried::no_good_state);
    const double from = state_.time, failed = lost ? lost->time : state_.time + size_.own();
    const double beyond = failed + steps_beyond * size_.own();
    long budget = most_updates;
    std::vector<Remedy> in_vain, left;
    for (const Trial& t : list) {
        const std::optional<bool> held = t.settings ? holds(t, from, beyond, budget) : std::nullopt;
        if (held && *held) return {.kind = Kind::holds, .from = from, .to = beyond, .remedies = {t.remedy}};
        if (held) in_vain.push_back(t.remedy);
        else if (left.empty()) left.push_back(t.remedy);
    }
    if (in_vain.empty()) return untried(Untried::too_long);
    return {.kind = Kind::in_vain, .from = from, .remedies = std::move(in_vain), .left = std::move(left)};
}

}  // namespace hinge

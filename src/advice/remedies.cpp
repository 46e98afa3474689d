#include "advice/remedies.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "advice/adviser.h"
#include "algebra/massless.h"
#include "algebra/stable_step.h"
#include "core/text.h"
#include "effects/all_effects.h"
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

struct Trial {
    Remedy remedy;
    std::optional<DynamicSettings> settings;  ///< to be tried; none where the model would be another one
};

/// Settings that may hold where those of the run have not, in the order in which they are tried: those that cost least
/// first.
std::vector<Trial> trials_of(const Dynamics& run) {
    using Kind = Remedy::Kind;
    const DynamicSettings& settings = run.settings();
    const Structure& structure = run.structure();
    const StepControl& control = run.step_control();
    const auto& effects = run.effect_list().all;
    const bool newmark = !run.explicit_steps() && !settings.conserving, large = structure.large();
    const bool closes = structure.model().options().shift != Shift::elastic_and_plastic;
    const bool may_conserve =
        newmark && large && closes &&
        std::all_of(effects.begin(), effects.end(), [](const auto& e) { return e->traits().mean_forces; });
    std::vector<Trial> list;
    const auto add = [&](Remedy remedy, auto change) {
        DynamicSettings s = settings;
        change(s);
        list.push_back({remedy, s});
    };
    // far bent, shorter steps do not hold either, nor does the energy-momentum method with so few elements
    if (most_bent(structure, run.state()) > far_bent) {
        if (may_conserve) return {{{Kind::more_elements_conserving}, {}}};
        list.push_back({{Kind::more_elements}, {}});
    }
    const Cause cause = run.failure()->what.cause;
    if (cause == Cause::not_positive_definite || cause == Cause::solver_not_converged)
        add({Kind::direct_solver}, [](DynamicSettings& s) { s.solver.direct = true; });
    if (cause == Cause::newton_not_converged && settings.iterations > 1 && settings.iterations < most_iterations)
        add({Kind::iterations, most_iterations}, [](DynamicSettings& s) { s.iterations = most_iterations; });
    if (control.on() && !control.by_default()) {
        const double larger = std::min(0.5, std::max(0.01, 10 * settings.step_control));
        add({Kind::step_control, larger}, [&](DynamicSettings& s) { s.control(larger); });
    }
    if (!control.on() && closes) add({Kind::step_control, 0.01}, [](DynamicSettings& s) { s.control(0.01); });
    const double shortest = shortest_step(structure, settings.duration);
    if (newmark && !settings.chosen && shortest < settings.dt)
        add({Kind::automatic_dt}, [&](DynamicSettings& s) {
            s.dt = shortest, s.automatic = s.chosen = true;
            if (closes) s.step_control = DynamicSettings::default_control, s.controlled_by_default = true;
        });
    for (const int part : {4, 16})
        add({Kind::dt, settings.dt / part},
            [&](DynamicSettings& s) { s.dt = settings.dt / part, s.automatic = false; });
    if (may_conserve && !may_be_massless(structure))
        add({Kind::energy_momentum}, [](DynamicSettings& s) {
            s.conserving = true, s.automatic = s.chosen = false;
            s.beta = 0.25, s.rho_infinity = 1, s.iterations = 0, s.predictor = Predictor::by_step,
            s.single_precision = true;
            s.tolerance = 1e-8, s.rebuild_angle = 0.002, s.control(0.01);
        });
    if (newmark && settings.alpha() == 0)
        add({Kind::rho_infinity, 0.8},
            [](DynamicSettings& s) { s.rho_infinity = 0.8, s.beta = DynamicSettings::beta_of(0.8); });
    if (newmark && !structure.cubic() && !may_be_massless(structure))
        add({Kind::explicit_steps}, [](DynamicSettings& s) {
            s.beta = 0, s.rho_infinity = 1, s.automatic = false, s.chosen = true, s.control(0);
        });
    return list;
}

/// Whether a run with these settings gets from the state of the one that failed, which is at `from`, to some steps
/// beyond the moment of failure. Nothing is said where the trial would take too long.
std::optional<bool> holds(const Dynamics& run, const DynamicSettings& settings, double from, double beyond,
                          long& budget) {
    DynamicSettings s = settings;
    if (run.tolerance() > 0) s.energy_tolerance = trial_part * run.tolerance();
    try {
        auto structure = run.share_structure();
        if (run.explicit_steps() != s.explicit_steps() || run.settings().conserving != s.conserving)
            structure =
                std::make_shared<const Structure>(structure->share_model(), s.explicit_steps() ? MassKind::lumped
                                                                            : s.conserving     ? MassKind::at_nodes
                                                                                               : MassKind::consistent);
        if (s.explicit_steps() && !run.explicit_steps())
            s.dt = usual_step(stable_step(*structure, damping_of(*structure)), *structure);
        const double steps = std::ceil((beyond - from) / s.dt);
        if (!(steps >= 1 && steps * double(structure->elements().size()) <= double(budget))) return {};
        s.duration = steps * s.dt;
        s.step_control *= std::min(1.0, s.duration / run.settings().duration);  // its share of the run
        State start = run.state();
        start.step = 0;
        Dynamics trial(structure, std::move(start), s);
        while (trial.advance())
            if (trial.element_updates() > budget) return budget = 0, std::nullopt;
        budget -= trial.element_updates();
        return trial.verdict() == Verdict::completed;
    } catch (const std::exception&) { return false; }
}

/// Advice is looked for where the run fails, and kept.
class FailureAdvice : public Adviser {
public:
    void finish(const Run& run) override {
        const auto& dynamics = static_cast<const Dynamics&>(run);
        if (run.verdict() != Verdict::failed) return;
        // a fold has advice of its own (failure_text.cpp); no step helps against a load that is not finite
        const bool hopeless =
            run.workspace().assembly.folded() >= 0 || run.failure()->what.cause == Cause::load_not_finite;
        if (dynamics.lost() || !hopeless) advice_ = find_remedy(dynamics);
    }
    std::string remedy(const Run& run) const override {
        return run.verdict() == Verdict::failed ? text_of(advice_, run.structure()) : "";
    }
    void save(Writer& to) const override { to(advice_); }
    void restore(Reader& from) override { from(advice_); }
    bool fits(const Run& run) const override { return makes_sense(advice_, run.structure()); }

private:
    Advice advice_;
};

}  // namespace

Advice find_remedy(const Dynamics& run) {
    using Kind = Advice::Kind;
    using Untried = Advice::Untried;
    // what holds in a short trial then is no remedy: the work of these loads on the flow is not resolved
    const Advice more = loads_between_nodes(run.structure(), run.state(), run.workspace().assembly);
    if (more.kind != Kind::none) return more;
    const std::vector<Trial> list = trials_of(run);
    const auto untried = [&](Untried why) {
        return list.empty() ? Advice{} : Advice{.kind = Kind::untried, .why = why, .remedies = {list.front().remedy}};
    };
    if (list.empty() || !list.front().settings) return untried(Untried::other_model);
    if (run.effect_list().any(&EffectTraits::calls_script)) return untried(Untried::calls_script);
    const LostBalance* lost = run.lost();
    if (lost && !lost->went_back) return untried(Untried::no_good_state);
    const double from = run.state().time, failed = lost ? lost->time : run.state().time + run.shortest();
    const double beyond = failed + steps_beyond * run.shortest();
    long budget = most_updates;
    std::vector<Remedy> in_vain, left;
    for (const Trial& t : list) {
        const std::optional<bool> held = t.settings ? holds(run, *t.settings, from, beyond, budget) : std::nullopt;
        if (held && *held) return {.kind = Kind::holds, .from = from, .to = beyond, .remedies = {t.remedy}};
        if (held) in_vain.push_back(t.remedy);
        else if (left.empty()) left.push_back(t.remedy);
    }
    if (in_vain.empty()) return untried(Untried::too_long);
    return {.kind = Kind::in_vain, .from = from, .remedies = std::move(in_vain), .left = std::move(left)};
}

namespace {

std::string text_of(const Remedy& r) {
    switch (r.kind) {
        case Remedy::Kind::more_elements: return "more elements a member";
        case Remedy::Kind::more_elements_conserving:
            return "more elements a member together with integrator = 'energy-momentum'";
        case Remedy::Kind::direct_solver: return "solver = 'direct'";
        case Remedy::Kind::iterations: return "iterations = " + number_text(r.value, 3);
        case Remedy::Kind::step_control: return "step_control = " + number_text(r.value, 3);
        case Remedy::Kind::automatic_dt: return "dt = 'auto'";
        case Remedy::Kind::dt: return "dt = " + number_text(r.value, 3);
        case Remedy::Kind::energy_momentum: return "integrator = 'energy-momentum'";
        case Remedy::Kind::rho_infinity: return "rho_infinity = " + number_text(r.value, 3);
        default: return "integrator = 'explicit' with dt = 'auto'";
    }
}

}  // namespace

std::string text_of(const Advice& a, const Structure& s) {
    static constexpr const char* untried[] = {"it needs another model", "it would call functions of the script",
                                              "no good state is kept", "a trial would take too long"};
    std::string remedies;
    for (const Remedy& r : a.remedies) remedies += (remedies.empty() ? "" : ", ") + text_of(r);
    switch (a.kind) {
        case Advice::Kind::none: return {};
        case Advice::Kind::more_nodes:
            return "; " + s.element_name(a.element) + " yields by the loads between its nodes alone: their fixed-end " +
                   "forces are " + number_text(a.value, 3) +
                   " times what it can carry. Where they act at once no shorter step helps; give the member more "
                   "elements, with a node where a point load acts, or let the load grow over a time (history)";
        case Advice::Kind::untried: return "; " + remedies + " may hold (not tried: " + untried[int(a.why)] + ")";
        case Advice::Kind::holds:
            return "; " + remedies + " holds: tried from t = " + number_text(a.from, 4) + " s to " +
                   number_text(a.to, 4) + " s";
        default: {
            std::string text = "; tried in vain from t = " + number_text(a.from, 4) + " s: " + remedies;
            for (const Remedy& r : a.left)
                text += "; " + text_of(r) + " may hold (not tried: a trial would take too long)";
            return text;
        }
    }
}

bool makes_sense(const Advice& a, const Structure& s) {
    const auto within = [](auto kind, auto last) { return int(kind) >= 0 && int(kind) <= int(last); };
    const auto known = [&](const Remedy& r) { return within(r.kind, Remedy::Kind::explicit_steps); };
    return within(a.kind, Advice::Kind::in_vain) && within(a.why, Advice::Untried::too_long) &&
           a.element >= (a.kind == Advice::Kind::more_nodes ? 0 : -1) && a.element < int(s.elements().size()) &&
           std::ranges::all_of(a.remedies, known) && std::ranges::all_of(a.left, known);
}

std::unique_ptr<Adviser> advise_of_failure(const Run& run, WarningLog&) {
    if (!run.workspace().kind.dynamic) return nullptr;
    return std::make_unique<FailureAdvice>();
}

}  // namespace hinge

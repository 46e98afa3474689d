// What a run that failed advises: the first of a few other settings that held in a short trial from the last good
// state.
#include <algorithm>
#include <cmath>

#include "algebra/stable_step.h"
#include "core/text.h"
#include "effects/all_effects.h"
#include "run/dynamics.h"
#include "state/hinges.h"

namespace hinge {
namespace {

constexpr double far_bent = 0.5;  ///< rad: of an element, elastically; no setting of the run helps then
/// Element recoveries that all trials of a run may take together: 1 to 3 s. Counted in place of time, so that the same
/// run says the same on every machine.
constexpr long most_updates = 1'500'000;
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

/// Names the element that yields by fixed-end forces alone, with the remedy. Where such loads act at once its sections
/// yield in no time, before the nodes move: what is lost by that does not depend on dt.
std::string loads_between_nodes(const Structure& structure, const State& state, const ElementAssembly& assembly) {
    double most = 1;
    int worst = -1;
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        if (state.broken[i] || !e.law) continue;
        for (const double end : {-1.0, 1.0})
            if (const double f = beam::yield_function(assembly.fixed_end(int(i)).at(end), end, e.yield); f > most)
                most = f, worst = int(i);
    }
    if (worst < 0) return {};
    return "; " + structure.element_name(worst) + " yields by the loads between its nodes alone: their fixed-end " +
           "forces are " + number_text(std::sqrt(most), 3) +
           " times what it can carry. Where they act at once no shorter step helps; give the member more elements, " +
           "with a node where a point load acts, or let the load grow over a time (history)";
}

}  // namespace

/// Settings that may hold where these have not, in the order in which they are tried: those that cost least first.
std::vector<Dynamics::Remedy> Dynamics::remedies() const {
    const bool newmark = !explicit_steps() && !settings_.conserving, large = structure_->large();
    const bool closes = structure_->model().options().shift != Shift::elastic_and_plastic;
    const bool may_conserve =
        newmark && large && closes &&
        std::all_of(effects_->all.begin(), effects_->all.end(), [](const auto& e) { return e->traits().mean_forces; });
    std::vector<Remedy> list;
    const auto add = [&](std::string words, auto change) {
        DynamicSettings s = settings_;
        change(s);
        list.push_back({std::move(words), s});
    };
    // far bent, shorter steps do not hold either, nor does the energy-momentum method with so few elements
    if (most_bent(*structure_, state_) > far_bent) {
        if (may_conserve) return {{"more elements a member together with integrator = 'energy-momentum'", {}}};
        list.push_back({"more elements a member", {}});
    }
    const std::string of_solver = integrator_->remedy ? integrator_->remedy : "";
    if (of_solver.find("direct") != std::string::npos)
        add("solver = 'direct'", [](DynamicSettings& s) { s.solver.direct = true; });
    if (of_solver.find("more iterations") != std::string::npos && settings_.iterations > 1 && settings_.iterations < 30)
        add("iterations = 30", [](DynamicSettings& s) { s.iterations = 30; });
    if (control_.on() && !control_.by_default()) {
        const double larger = std::min(0.5, std::max(0.01, 10 * settings_.step_control));
        add("step_control = " + number_text(larger, 3), [&](DynamicSettings& s) { s.control(larger); });
    }
    if (!control_.on() && closes) add("step_control = 0.01", [](DynamicSettings& s) { s.control(0.01); });
    const double shortest = shortest_step(*structure_, settings_.duration);
    if (newmark && !settings_.chosen && shortest < settings_.dt)
        add("dt = 'auto'", [&](DynamicSettings& s) {
            s.dt = shortest, s.automatic = s.chosen = true;
            if (closes) s.step_control = DynamicSettings::default_control, s.controlled_by_default = true;
        });
    for (const int part : {4, 16})
        add("dt = " + number_text(settings_.dt / part, 3),
            [&](DynamicSettings& s) { s.dt = settings_.dt / part, s.automatic = false; });
    if (may_conserve)
        add("integrator = 'energy-momentum'", [](DynamicSettings& s) {
            s.conserving = true, s.automatic = s.chosen = false;
            s.beta = 0.25, s.rho_infinity = 1, s.iterations = 0, s.predictor = Predictor::by_step,
            s.single_precision = true;
            s.tolerance = 1e-8, s.rebuild_angle = 0.002, s.control(0.01);
        });
    if (newmark && settings_.alpha() == 0)
        add("rho_infinity = 0.8",
            [](DynamicSettings& s) { s.rho_infinity = 0.8, s.beta = DynamicSettings::beta_of(0.8); });
    if (newmark && !structure_->cubic())
        add("integrator = 'explicit' with dt = 'auto'", [](DynamicSettings& s) {
            s.beta = 0, s.rho_infinity = 1, s.automatic = false, s.chosen = true, s.control(0);
        });
    return list;
}

/// Whether a run with these settings gets from the state, which is at `from`, to some steps beyond the moment of
/// failure. Nothing is said where the trial would take too long.
std::optional<bool> Dynamics::holds(const Remedy& remedy, double from, double beyond, long& budget) const {
    DynamicSettings s = *remedy.settings;
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

/// "; ... holds", "; ... may hold" with why it was not tried, or what was tried in vain.
std::string Dynamics::advice() const {
    // what holds in a short trial then is no remedy: the work of these loads on the flow is not resolved
    if (std::string cause = loads_between_nodes(*structure_, state_, assembly_); !cause.empty()) return cause;
    const std::vector<Remedy> list = remedies();
    const auto untried = [&](const std::string& why) {
        return list.empty() ? std::string() : "; " + list.front().words + " may hold (not tried: " + why + ")";
    };
    if (list.empty() || !list.front().settings) return untried("it needs another model");
    if (effects_->any(&EffectTraits::calls_script)) return untried("it would call functions of the script");
    const std::optional<LostBalance>& lost = energy_monitor_.lost();
    if (lost && !lost->went_back) return untried("no good state is kept");
    const double from = state_.time, failed = lost ? lost->time : state_.time + size_.own();
    const double beyond = failed + steps_beyond * size_.own();
    long budget = most_updates;
    std::string in_vain, not_tried;
    for (const Remedy& r : list) {
        const std::optional<bool> held = r.settings ? holds(r, from, beyond, budget) : std::nullopt;
        if (held && *held)
            return "; " + r.words + " holds: tried from t = " + number_text(from, 4) + " s to " +
                   number_text(beyond, 4) + " s";
        if (held) in_vain += (in_vain.empty() ? "" : ", ") + r.words;
        else if (not_tried.empty()) not_tried = r.words;
    }
    if (in_vain.empty()) return untried("a trial would take too long");
    const std::string left =
        not_tried.empty() ? "" : "; " + not_tried + " may hold (not tried: a trial would take too long)";
    return "; tried in vain from t = " + number_text(from, 4) + " s: " + in_vain + left;
}

}  // namespace hinge

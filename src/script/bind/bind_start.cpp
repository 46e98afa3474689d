// model:static{} and model:dynamic{}: the settings of a run, and the run made from them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "model/member_ends.h"
#include "model/section_laws.h"
#include "script/bind/changed_runs.h"
#include "script/bind/dynamic_settings.h"
#include "script/bind/static_settings.h"
#include "advice/load_warnings.h"
#include "effects/all_effects.h"
#include "effects/contact.h"
#include "effects/declared.h"
#include "effects/ground.h"
#include "effects/removal.h"
#include "run/checkpoint.h"
#include "run/dynamics.h"
#include "advice/adviser.h"
#include "run/go_on.h"
#include "run/element_count.h"
#include "advice/size_notice.h"
#include "record/told_warnings.h"
#include "core/text.h"
#include "run/statics.h"
#include "script/bind/model_methods.h"
#include "script/bind/run_box.h"
#include "script/bind/bind_checkpoint.h"
#include "script/bind/chain.h"

namespace hinge::script {
namespace {

/// The run in field 'from', null where there is none.
const ScriptRun* run_before(Options& o, const std::shared_ptr<ScriptModel>& model) {
    lua_State* L = o.L();
    const ScriptRun* record = nullptr;
    if (o.push_field("from") != LUA_TNIL) {
        if (!find<RunBox>(L, -1)) o.complain("from", show(L, -1), "must be a run, whose state this one goes on from");
        record = run_argument(L, -1, o.function() + ": field 'from'").get();
        if (record->model != model) o.complain("from", "a run of another model", "must be a run of this one");
        if (record->stepping && record->mid_step)
            o.complain("from", "a run in the middle of a step", "make this run when the step is done");
        const Run& run = *record->run;
        const bool is_static = run.is_static();
        if (run.verdict() == Verdict::running && !context(L)->mode.planning && (is_static || run.steps_done() == 0))
            o.complain("from",
                       "a " + std::string(run.kind()) + " run that has done " + std::to_string(run.steps_done()) +
                           " of " + std::to_string(run.planned_steps()) + " steps (made at " + record->asked_at + ")",
                       "finish it first with run:finish(), or end it with run:stop() to go on from there");
    }
    lua_pop(L, 1);
    return record;
}

/// The run's own copy of a model, with the loads that it takes, without the effect that is left out just now
/// (core.leave_out), and with what core.change_runs changes. Numbers of elements are decided with all loads; the model
/// takes them from the run, once there is one, or before they are changed.
std::shared_ptr<const Model> copy_of(lua_State* L, Model& m, const LoadChoice& choice) {
    auto copy = std::make_shared<Model>(m);
    copy->lock(false);  // a run may be made inside a step of another
    context(L)->running = L;
    decide_elements(*copy);
    tell_size(*context(L), *copy);
    copy->choose(choice);
    if (const std::string& effect = context(L)->mode.left_out; !effect.empty()) {
        hinge::leave_out(effect, *copy);
        leave_out_law(effect, *copy);
    }
    if (models_change(L)) m.take_elements(*copy), change_model(L, *copy);
    look_over(*context(L), *copy);
    return copy;
}

/// The state in which a run begins; `before`: the run that it goes on from, or null.
State start_state(Options& o, const Structure& structure, const ScriptRun* before) {
    if (!before) return initial_state(structure);
    if (const auto refusal = refusal_to_go_on(*before->run, structure))
        o.complain("from", refusal->what.empty() ? "the run made at " + before->asked_at : refusal->what,
                   refusal->advice);
    try {
        return state_to_go_on(*before->run, structure);
    } catch (const InputError& e) { throw InputError(o.function() + ": " + e.what()); }
}

void refuse_lost_loads(const Model& m, const Structure& structure, const State& start, const char* function) {
    for (const DeclaredLoad& l : declared_loads(m))
        if (!l.motion && l.node >= 0 && structure.has_panels_alone(l.node) && !l.moment.isZero(0))
            throw InputError(std::string(function) + ": a moment acts on " + structure.node_name(l.node) +
                             ", which panels alone join: it has no rotation of its own; give forces");
    for (const DeclaredLoad& l : declared_loads(m))
        if (!l.motion && l.node >= 0 && start.gone[l.node] &&
            !(structure.is_alone(l.node) && has_member_at(m, l.node)))  // a support takes it
            throw InputError(std::string(function) + ": a load acts on " + structure.node_name(l.node) +
                             (structure.is_alone(l.node)
                                  ? ", which belongs to no member; put the load on the node that a rigid link, a "
                                    "diaphragm or a connector joins it to, with the moment that it has there"
                                  : ", which has no element left"));
}

bool is_weightless(const Structure& structure) {
    return added_masses(structure.model()).empty() &&
           std::none_of(structure.elements().begin(), structure.elements().end(),
                        [](const Element& e) { return e.rigidity.rhoA > 0; });
}

/// All loads wait for dynamics.
void refuse_no_loads(const Model& m, int aside) {
    const std::vector<DeclaredLoad> list = declared_loads(m);
    const long all = std::count_if(list.begin(), list.end(), [](const DeclaredLoad& l) { return !l.motion; });
    if (aside == 0 || aside < all || declared_gravity(m)) return;
    throw InputError(
        "model:static: nothing acts: all loads have a history, which is for dynamics; leave the history out, or put "
        "them into a load case and name it, loads = { name = 1 }, which takes them in full");
}

/// Steps between rows of history.csv; 0 for record = false.
int record_every(Options& o, int usual) {
    const bool none = o.push_field("record") == LUA_TBOOLEAN && !lua_toboolean(o.L(), -1);
    lua_pop(o.L(), 1);
    return none ? 0 : o.integer("record", 1, usual);
}

void refuse_static_start(const Model& declared, const Structure& structure, const State& start, bool goes_on) {
    if (structure.is_empty())
        throw InputError("model:static: the model has no members; add at least one with model:member");
    const Model& model = structure.model();
    refuse_lost_loads(model, structure, start, "model:static");
    for (const DeclaredLoad& l : declared_loads(model))
        if (l.follows_state)
            throw InputError("model:static: a load on " + structure.node_name(l.node) +
                             " is a function of time and the run, which acts in dynamics only; make the static run "
                             "before it is declared, or put it into a load case that this run does not take");
    if (!goes_on) refuse_no_loads(declared, model.set_aside());
    if (const auto g = declared_gravity(model); g && !g->isZero(0) && is_weightless(structure))
        throw InputError(
            "model:static: the model has gravity, and nothing in it has mass: all densities are 0 kg/m^3; give "
            "hinge.material a density, or leave gravity out");
}

}  // namespace

int static_run(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:static").value;
    change_options(L, "static");
    Options o(L, 2, "model:static", true);
    o.expect({"steps", "iterations", "tolerance", "control", "unstable", "to_limit", "fixed_group", "record", "from",
              "allow_failed", "loads", "branch"});
    const ScriptRun* before = run_before(o, m);
    Chain chain(o, before);
    const LoadChoice choice = read_choice(o, *m, before, true);
    const auto structure = std::make_shared<const Structure>(copy_of(L, *m, choice));
    const StaticSettings s = read_static_settings(o, m, *structure, before != nullptr);
    const int every = record_every(o, 1);
    State start = start_state(o, *structure, before);
    refuse_static_start(*m, *structure, start, before != nullptr);
    context(L)->running = L;
    if (!context(L)->mode.planning) tell_notice(*context(L), static_notice(*structure, s.steps));
    try {
        std::vector<Warning> likely_mistakes = empty_cases(*m, m->gravity_case.value_or(-1), choice, where(L));
        for (Warning& w : floors_twice(*structure)) likely_mistakes.push_back(std::move(w));
        for (Warning& w : loads_beside_hinges(*structure)) likely_mistakes.push_back(std::move(w));
        for (Warning& w : heated_without_curve(*structure)) likely_mistakes.push_back(std::move(w));
        auto run = std::make_shared<Statics>(structure, std::move(start), s);
        advise(*run);
        make_run(L, std::move(run), m, every, std::move(likely_mistakes));
        return chain.keep(L);
    } catch (const InputError& e) { throw InputError(std::string("model:static: ") + e.what()); }
}

namespace {

void require_density(const Structure& structure) {
    if (structure.is_empty())
        throw InputError("model:dynamic: the model has no members; add at least one with model:member");
    if (is_weightless(structure))
        throw InputError(
            "model:dynamic: nothing has mass: all densities are 0 kg/m^3, and no node has a mass; give hinge.material "
            "a density, or nodes a mass with model:mass");
}

/// A panel has no resistance across itself: its nodes are held by members, by supports, or by their inertia.
void refuse_massless_panels(const Structure& structure) {
    std::vector<double> mass(structure.position().size(), 0);
    for (const AddedMass& added : added_masses(structure.model())) mass[std::size_t(added.node)] += added.mass.mass;
    for (std::size_t n = 0; n < mass.size(); ++n)
        if (structure.has_panels_alone(int(n)) && !(mass[n] > 0) && (structure.fixed()[n] & 7) != 7)
            throw InputError("model:dynamic: " + structure.node_name(int(n)) +
                             " has no mass, and panels alone join it; give its panels a density or a mass (kg/m^2), "
                             "or the node one with model:mass");
}

/// What members without mass do not go with. Nodes without mass are in balance in Newmark's method.
void refuse_massless(const Structure& structure, IntegratorKind integrator) {
    refuse_massless_panels(structure);
    const auto& elements = structure.elements();
    const auto at =
        std::find_if(elements.begin(), elements.end(), [](const Element& e) { return !(e.rigidity.rhoA > 0); });
    if (at == elements.end()) return;
    const Model& m = structure.model();
    const std::string name = "member " + std::to_string(at->member + 1) + " has density 0 kg/m^3";
    if (integrator != IntegratorKind::newmark) {
        double mass = 0, volume = 0, wave = std::numeric_limits<double>::infinity();
        for (const AddedMass& added : added_masses(m)) mass += added.mass.mass;
        for (const Element& e : elements) mass += e.mass();
        for (const Element& e : elements) {
            const MemberData& member = m.members()[e.member];
            if (e.mass() > 0) continue;
            volume += member.section->area * e.length;
            wave = std::min(wave, e.length / std::sqrt(member.material->E));
        }
        const double density = 1e-3 * mass / volume;
        const std::string explicit_steps =
            integrator == IntegratorKind::explicit_steps
                ? ", with which explicit steps are at most about " + show(wave * std::sqrt(density)) + " s"
                : "";
        throw InputError("model:dynamic: " + name + "; integrator = '" +
                         (integrator == IntegratorKind::explicit_steps ? "explicit" : "energy-momentum") +
                         "' needs a mass at each node. Take 'newmark', in which nodes without mass are in balance, or "
                         "give such members " +
                         show(density) + " kg/m^3, a thousandth of the whole mass" + explicit_steps);
    }
    for (const char* effect : {contact_effect, ground_effect})
        if (m.declarations().count(effect))
            throw InputError("model:dynamic: " + name +
                             "; what meets others or a ground is stopped by its mass: give all members a density");
    Model without_removal = m;
    without_removal.undeclare(removal_effect);
    for (const Element& e : elements)
        if (!(e.mass() > 0) && may_break(without_removal, {.dynamic = true}, e.member))
            throw InputError("model:dynamic: member " + std::to_string(e.member + 1) +
                             " has density 0 kg/m^3 and can break; what breaks off flies by its mass: give it a "
                             "density, or a group without fracture (model:remove takes out members without mass)");
}

MassKind mass_kind(IntegratorKind integrator) {
    switch (integrator) {
        case IntegratorKind::explicit_steps: return MassKind::lumped;
        case IntegratorKind::energy_momentum: return MassKind::at_nodes;
        default: return MassKind::consistent;
    }
}

void expect_dynamic_fields(Options& o) {
    o.expect({"dt", "duration", "beta", "from", "iterations", "tolerance", "solver", "internals", "record",
              "integrator", "precision", "threads", "rest", "energy_tolerance", "step_control", "rho_infinity",
              "checkpoint", "allow_failed", "loads"});
}

/// Likely mistakes in what the model has where a dynamic run begins. `before`: the run that it goes on from, or null.
std::vector<Warning> mistakes_in_dynamics(lua_State* L, const Structure& structure, const State& start,
                                          const ScriptRun* before, const DynamicSettings& s) {
    const Model* model_before = before ? &before->run->structure().model() : nullptr;
    std::vector<Warning> all;
    const auto add = [&](std::vector<Warning> more) {
        for (Warning& w : more) all.push_back(std::move(w));
    };
    add(idle_histories(structure.model(), model_before, start.time, s.duration, s.chosen ? 0 : s.dt));
    add(massless_loads(structure, where(L)));
    add(floors_twice(structure));
    add(loads_beside_hinges(structure));
    add(heated_without_curve(structure));
    if (before) add(late_gravity(structure, *before, where(L)));
    add(overlapping_bars(structure, start));
    add(damped_free_bodies(structure, start));
    add(lone_velocities(structure, start, model_before, where(L)));
    return all;
}

}  // namespace

int dynamic_run(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:dynamic").value;
    change_options(L, "dynamic");
    Options o(L, 2, "model:dynamic");
    expect_dynamic_fields(o);
    const IntegratorKind integrator = read_integrator(o);
    const ScriptRun* before = run_before(o, m);
    Chain chain(o, before);
    const LoadChoice choice = read_choice(o, *m, before, false);
    const auto structure = std::make_shared<const Structure>(copy_of(L, *m, choice), mass_kind(integrator));
    if (integrator == IntegratorKind::explicit_steps && m->options().mass == MassShape::cubic)
        throw InputError(
            "model:dynamic: integrator = 'explicit' lumps masses on the nodes; a model with mass = 'cubic' takes "
            "'newmark'");
    require_density(*structure);
    refuse_massless(*structure, integrator);
    DynamicSettings s = read_dynamic_settings(o, *m, *structure, integrator);
    change_steps(L, s);
    State start = start_state(o, *structure, before);
    refuse_lost_loads(structure->model(), *structure, start, "model:dynamic");
    try {
        refuse_idle_velocities(*structure, start);
    } catch (const InputError& e) { throw InputError(std::string("model:dynamic: ") + e.what()); }
    context(L)->running = L;
    std::vector<Warning> likely_mistakes = empty_cases(*m, m->gravity_case.value_or(-1), choice, where(L));
    for (Warning& w : mistakes_in_dynamics(L, *structure, start, before, s)) likely_mistakes.push_back(std::move(w));
    if (!context(L)->mode.planning) tell_notice(*context(L), dynamic_notice(*structure));
    const Dynamics* goes_on = before ? std::as_const(*before->run).dynamics() : nullptr;
    if (goes_on && start.velocity != goes_on->state().velocity) goes_on = nullptr;  // some were given since
    auto run = std::make_shared<Dynamics>(structure, std::move(start), s);
    advise(*run);
    if (goes_on) go_on(*run, *goes_on);
    const long planned = std::llround(s.duration / run->settings().dt);
    const int every = record_every(o, int(std::max(1L, planned / 500)));
    auto plan = read_checkpoint_plan(o, *m);
    make_run(L, std::move(run), m, every, std::move(likely_mistakes));
    find<RunBox>(L, -1)->value->checkpoint = std::move(plan);
    return chain.keep(L);
}

}  // namespace hinge::script

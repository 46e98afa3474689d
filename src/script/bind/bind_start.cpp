// model:static{} and model:dynamic{}: the settings of a run, and the run made from them.
#include <algorithm>
#include <cmath>

#include "script/checks/chain.h"
#include "script/checks/check.h"
#include "script/files/run_checkpoint.h"
#include "script/checks/load_warnings.h"
#include "effects/all_effects.h"
#include "effects/member_loads.h"
#include "effects/point_mass.h"
#include "run/dynamics.h"
#include "algebra/stable_step.h"
#include "script/checks/element_count.h"
#include "script/checks/size_notice.h"
#include "core/text.h"
#include "run/statics.h"

namespace hinge::script {
namespace {

/// The run in field 'from', null where there is none.
const RunRecord* run_before(Options& o, const std::shared_ptr<ScriptModel>& model) {
    lua_State* L = o.L();
    const RunRecord* record = nullptr;
    if (o.push_field("from") != LUA_TNIL) {
        if (!find<RunBox>(L, -1)) o.complain("from", show(L, -1), "must be a run, whose state this one goes on from");
        record = run_argument(L, -1, o.function() + ": field 'from'").get();
        if (record->model != model) o.complain("from", "a run of another model", "must be a run of this one");
        if (record->stepping && record->mid_step)
            o.complain("from", "a run in the middle of a step", "make this run when the step is done");
        const Run& run = *record->run;
        const bool is_static = std::string_view(run.kind()) == "static";
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
/// (core.leave_out). Numbers of elements are decided with all loads; the model takes them from the run, once there is
/// one.
std::shared_ptr<const Model> copy_of(lua_State* L, const Model& m, const LoadChoice& choice) {
    auto copy = std::make_shared<Model>(m);
    context(L)->running = L;
    decide_elements(*copy);
    tell_size(*context(L), *copy);
    copy->choose(choice);
    if (const std::string& effect = context(L)->mode.left_out; !effect.empty()) copy->leave_out(effect);
    look_over(*context(L), *copy);
    return copy;
}

/// Velocities that were given since the run before was made: of the target where it is now, and of the nodes inside the
/// members there as Structure::initial_velocity has them.
void take_velocities(State& state, const Structure& structure, const Model& before, const std::string& function) {
    const Model& m = structure.model();
    std::vector<Vec6> velocity = state.velocity;
    std::vector<char> anew(velocity.size(), 0);
    for (std::size_t n = 0; n < m.nodes().size(); ++n) {
        const int given = m.velocity_given()[n];
        if (given == before.velocity_given()[n]) continue;
        const GivenVelocity& v = m.given_velocities()[given];
        const auto place = [&](int node) { return Vec3(structure.position()[node] + state.displacement[node]); };
        Vec3 centre = Vec3::Zero();
        for (int node : v.nodes) {
            if (state.gone[node] && !structure.elements_at(node).empty())
                throw InputError(function + ": a velocity was given to " + structure.node_name(node) +
                                 ", which has no element left in the run that this one goes on from");
            centre += place(node) / double(v.nodes.size());
        }
        velocity[n] << v.linear + v.angular.cross(place(int(n)) - centre), v.angular;
        anew[n] = 1;
    }
    std::size_t inner = m.nodes().size();
    for (const MemberData& member : m.members())
        for (int i = 1; i < member.elements; ++i, ++inner) {
            const double t = double(i) / member.elements;
            anew[inner] = anew[member.node[0]] && anew[member.node[1]];
            if (anew[inner]) velocity[inner] = (1 - t) * velocity[member.node[0]] + t * velocity[member.node[1]];
        }
    for (std::size_t n = 0; n < velocity.size(); ++n)
        for (int c = 0; c < 6 && anew[n]; ++c) state.velocity[n][c] = state.held[n] >> c & 1 ? 0 : velocity[n][c];
}

State start_state(Options& o, const std::shared_ptr<const Structure>& structure, const RunRecord* before) {
    State state = initial_state(*structure);
    if (!before) return state;
    const State& from = before->run->state();
    const Model &there = before->run->structure().model(), &here = structure->model();
    const bool same = there.nodes().size() == here.nodes().size() && there.members().size() == here.members().size();
    if (!same || from.displacement.size() != state.displacement.size() || from.broken.size() != state.broken.size())
        o.complain("from",
                   "a run of a structure with " + std::to_string(from.displacement.size()) + " nodes and " +
                       std::to_string(from.broken.size()) + " elements",
                   "this model has " + std::to_string(state.displacement.size()) + " and " +
                       std::to_string(state.broken.size()) + "; add nothing between the runs");
    state = from;
    state.step = 0;
    for (std::size_t n = 0; n < here.nodes().size(); ++n)
        if (here.nodes()[n].fixed & ~there.nodes()[n].fixed)
            o.complain("from", "the run made at " + before->asked_at,
                       structure->node_name(int(n)) +
                           " has been fixed since, and what goes on has it free; fix it before that run is made");
    take_velocities(state, *structure, there, o.function());
    return state;
}

/// A velocity that no node can have.
void refuse_idle_velocities(const Structure& structure, const State& start) {
    const Model& m = structure.model();
    for (std::size_t n = 0; n < m.nodes().size(); ++n) {
        const int given = m.velocity_given()[n];
        if (given < 0 || m.given_velocities()[given].nodes.size() > 1) continue;
        const GivenVelocity& v = m.given_velocities()[given];
        Vec6 wanted;
        wanted << v.linear, v.angular;
        bool moves = wanted.isZero(0) || (start.gone[n] && !structure.elements_at(int(n)).empty());
        for (int c = 0; c < 6; ++c) moves = moves || (wanted[c] != 0 && !(start.held[n] >> c & 1));
        if (!moves)
            throw InputError("model:dynamic: a velocity was given to " + structure.node_name(int(n)) +
                             (structure.elements_at(int(n)).empty() ? ", which belongs to no member"
                                                                    : ", which supports hold in its directions"));
    }
}

void refuse_lost_loads(const Model& m, const Structure& structure, const State& start, const char* function) {
    for (const NodalLoad& l : m.loads())
        if (start.gone[l.node])
            throw InputError(std::string(function) + ": a load acts on " + structure.node_name(l.node) +
                             ", which has no element left");
}

bool is_weightless(const Structure& structure) {
    return structure.model().declared<PointMass>(point_mass_effect).empty() &&
           std::none_of(structure.elements().begin(), structure.elements().end(),
                        [](const Element& e) { return e.rigidity.rhoA > 0; });
}

/// All loads wait for dynamics.
void refuse_no_loads(const Model& m, int aside) {
    const std::size_t all = m.loads().size() + m.declared<MemberLoad>(member_loads_effect).size();
    if (aside == 0 || std::size_t(aside) < all || m.gravity()) return;
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

/// What leads the way of a static run; `before`: the run that it goes on from, or null.
void read_control(lua_State* L, Options& o, const std::shared_ptr<ScriptModel>& m, const RunRecord* before,
                  StaticSettings& s) {
    const char* allowed = "must be 'load', 'arc', { 'arc', to = } or { node =, \"ux\", to = }";
    const int type = o.push_field("control");
    if (type == LUA_TSTRING) {
        const std::string word = lua_tostring(L, -1);
        if (word == "arc") s.control = Control::arc;
        else if (word != "load") o.complain("control", "'" + word + "'", allowed + did_you_mean(word, {"load", "arc"}));
    } else if (type == LUA_TTABLE) {
        Options c(L, -1, "model:static, control");
        c.push_item(1);
        const std::string component = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
        if (component == "arc") {
            s.control = Control::arc;
            s.target = c.number("to", "", Range::any);
            if (s.target == 0) c.complain("to", "0", "must differ from 0, the load factor where the run begins");
            c.finish(1);
            return lua_pop(L, 2);
        }
        s.control = Control::displacement;
        c.push_field("node");
        s.node = node_argument(L, -1, "model:static, control: field 'node'", m.get()).index;
        static const std::vector<std::string> names = {"ux", "uy", "uz", "rx", "ry", "rz"};
        const auto at = std::find(names.begin(), names.end(), component);
        if (at == names.end())
            throw InputError("model:static, control: component is " + show(L, -2) +
                             "; must be one of 'ux', 'uy', 'uz', 'rx', 'ry', 'rz'" + did_you_mean(component, names));
        lua_pop(L, 2);
        s.component = int(at - names.begin());
        s.target = c.number("to", s.component < 3 ? "m" : "rad", Range::any);
        if (s.target == 0 && !before) c.complain("to", "0", "must differ from 0");
        c.finish(1);
        if (m->nodes()[s.node].fixed >> s.component & 1)
            throw InputError("model:static, control: '" + component + "' of node " + std::to_string(s.node + 1) +
                             " is fixed by a support and cannot be driven");
    } else if (type != LUA_TNIL) {
        o.complain("control", show(L, -1), allowed);
    }
    lua_pop(L, 1);
}

}  // namespace

int static_run(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:static").value;
    Options o(L, 2, "model:static", true);
    o.former_name("fixed_group", "hold");
    o.expect({"steps", "iterations", "tolerance", "control", "unstable", "to_limit", "fixed_group", "record", "from",
              "allow_failed", "loads"});
    const RunRecord* before = run_before(o, m);
    Chain chain(o, before);
    const LoadChoice choice = read_choice(o, *m, before, true);
    const auto structure = std::make_shared<const Structure>(copy_of(L, *m, choice));
    StaticSettings s;
    s.steps = o.integer("steps", 1, 10);
    s.iterations = o.integer("iterations", 2, s.iterations);
    s.tolerance = o.number("tolerance", "", Range::positive, s.tolerance);
    read_control(L, o, m, before, s);
    s.past_unstable = o.word("unstable", {"fail", "continue"}, "fail") == "continue";
    s.to_limit = o.flag("to_limit", false);
    if (s.control != Control::load)
        for (const char* field : {"unstable", "to_limit"})
            if (o.has(field))
                throw InputError(std::string("model:static: field '") + field +
                                 "' has no meaning with control by displacement or arc length, which goes on past a "
                                 "limit load; leave it out");
    if (s.past_unstable && s.to_limit)
        throw InputError(
            "model:static: to_limit = true ends where the structure becomes unstable, unstable = 'continue' goes on; "
            "leave one out");
    if (o.push_field("fixed_group") != LUA_TNIL) {
        s.held.assign(structure->position().size(), 0);
        const int g = group_argument(L, -1, "model:static: field 'fixed_group'", *m);
        for (std::size_t e = 0; e < structure->elements().size(); ++e)
            if (structure->in_group(int(e), g))
                for (int n : structure->elements()[e].node) s.held[n] = 63;
    }
    lua_pop(L, 1);
    const int every = record_every(o, 1);
    State start = start_state(o, structure, before);
    if (structure->elements().empty())
        throw InputError("model:static: the model has no members; add at least one with model:member");
    refuse_lost_loads(structure->model(), *structure, start, "model:static");
    for (const NodalLoad& l : structure->model().loads())
        if (l.follows_state())
            throw InputError("model:static: a load on " + structure->node_name(l.node) +
                             " is a function of time and the run, which acts in dynamics only; make the static run "
                             "before it is declared, or put it into a load case that this run does not take");
    if (!before) refuse_no_loads(*m, structure->model().set_aside());
    if (const auto& g = structure->model().gravity(); g && !g->isZero(0) && is_weightless(*structure))
        throw InputError(
            "model:static: the model has gravity, and nothing in it has mass: all densities are 0 kg/m^3; give "
            "hinge.material a density, or leave gravity out");
    context(L)->running = L;
    weigh_static(*context(L), *structure, s.steps);
    try {
        std::vector<Warning> likely_mistakes = empty_cases(*m, choice, where(L));
        for (Warning& w : floors_twice(*structure)) likely_mistakes.push_back(std::move(w));
        make_run(L, std::make_shared<Statics>(structure, std::move(start), s), m, every, std::move(likely_mistakes));
        return chain.keep(L);
    } catch (const InputError& e) { throw InputError(std::string("model:static: ") + e.what()); }
}

namespace {

void require_density(const Structure& structure) {
    if (structure.elements().empty())
        throw InputError("model:dynamic: the model has no members; add at least one with model:member");
    for (const Element& e : structure.elements())
        if (!(e.rigidity.rhoA > 0))
            throw InputError("model:dynamic: " + structure.element_name(int(&e - structure.elements().data())) +
                             " has density 0 kg/m^3; dynamics needs a density above 0");
}

/// The field dt. Explicit steps may not be longer than stability allows, and can be left to it: dt = "auto".
double step_of(Options& o, const Structure& structure, bool in_explicit_steps, double duration, bool& automatic) {
    const std::string word = o.push_field("dt") == LUA_TSTRING ? lua_tostring(o.L(), -1) : "";
    lua_pop(o.L(), 1);
    automatic = word == "auto";
    if (!word.empty() && !automatic)
        o.complain("dt", "'" + word + "'", "must be a number in s, or 'auto'" + did_you_mean(word, {"auto"}));
    if (!in_explicit_steps)
        return automatic ? shortest_step(structure, duration) : o.number("dt", "s", Range::positive);
    const std::vector<ElementDamping> damping = damping_of(structure);
    const StableStep limit = stable_step(structure, damping);
    if (automatic) return duration / std::ceil(duration / usual_step(limit, structure));
    const double dt = o.number("dt", "s", Range::positive);
    if (dt > limit.dt)
        o.complain("dt", show(dt) + " s",
                   "explicit steps stay stable up to " + show(limit.dt) + " s here (" +
                       structure.element_name(limit.element) + " has the highest frequency" +
                       (damping.empty() ? "" : ", and damping shortens it") + "); give a shorter one, or dt = 'auto'");
    return dt;
}

/// Of Newton, of the first correction of a step, in the norm of the energy.
constexpr double tolerance_of_conserving = 1e-8;

/// rad. With that tolerance the right-angle cantilever of tests/script/energy_momentum_test.lua takes 2451 iterations
/// with 10,400 elements rebuilt at 0.01, 2141 with 12,700 at 0.005, 1938 with 14,100 at 0.002, 1929 with 14,400 at
/// 0.001, 1905 with 34,000 where each iteration rebuilds all.
constexpr double rebuild_angle_of_conserving = 0.002;

/// What the energy-momentum method does not go with, effects aside.
void refuse_what_cannot_be_conserved(Options& o, const Model& model) {
    const std::string with = "model:dynamic: integrator = 'energy-momentum' ";
    for (const char* field : {"beta", "rho_infinity", "predictor", "precision"})
        if (o.has(field))
            throw InputError("model:dynamic: field '" + std::string(field) +
                             "' has no meaning with integrator = 'energy-momentum'; leave it out");
    if (model.options().displacement == Displacement::small)
        throw InputError(with +
                         "is for large rotations; a model with displacement = 'small' takes 'newmark', which "
                         "conserves as much there");
    if (model.options().shift == Shift::elastic_and_plastic)
        throw InputError(with +
                         "needs an energy balance that closes, and that of a model with shift = 'elastic_and_plastic' "
                         "cannot; take 'newmark'");
}

}  // namespace

int dynamic_run(lua_State* L) {
    auto& m = self<ModelBox>(L, "model:dynamic").value;
    Options o(L, 2, "model:dynamic");
    o.expect({"dt",
              "duration",
              "beta",
              "from",
              "iterations",
              "tolerance",
              "predictor",
              "geometric",
              "rebuild_angle",
              "solver",
              "solver_tolerance",
              "solver_iterations",
              "record",
              "integrator",
              "precision",
              "threads",
              "rest",
              "energy_tolerance",
              "step_control",
              "rho_infinity",
              "checkpoint",
              "allow_failed",
              "loads"});
    const std::string integrator = o.word("integrator", {"newmark", "energy-momentum", "explicit"}, "newmark");
    const bool in_explicit_steps = integrator == "explicit", conserving = integrator == "energy-momentum";
    const RunRecord* before = run_before(o, m);
    Chain chain(o, before);
    const LoadChoice choice = read_choice(o, *m, before, false);
    const auto structure =
        std::make_shared<const Structure>(copy_of(L, *m, choice), in_explicit_steps ? MassKind::lumped
                                                                  : conserving      ? MassKind::at_nodes
                                                                                    : MassKind::consistent);
    if (in_explicit_steps && m->options().mass == MassShape::cubic)
        throw InputError(
            "model:dynamic: integrator = 'explicit' lumps masses on the nodes; a model with mass = 'cubic' takes "
            "'newmark'");
    require_density(*structure);
    DynamicSettings s;
    s.conserving = conserving;
    if (conserving) refuse_what_cannot_be_conserved(o, *m);
    s.duration = o.number("duration", "s", Range::positive);
    bool automatic = false;
    s.dt = step_of(o, *structure, in_explicit_steps, s.duration, automatic);
    s.automatic = automatic && !in_explicit_steps;
    if (conserving && automatic)
        o.complain(
            "dt", "'auto'",
            "integrator = 'energy-momentum' needs a number in s; step_control halves steps that do not converge");
    s.chosen = automatic;
    if (s.duration < 0.5 * s.dt)
        o.complain("duration", show(s.duration) + " s", "must be at least one step, dt = " + show(s.dt) + " s");
    if (s.duration / s.dt > 1e12)
        o.complain("dt", show(s.dt) + " s", "would take more than 1e12 steps to duration = " + show(s.duration) + " s");
    s.beta = in_explicit_steps ? 0 : o.number("beta", "", Range::positive, s.beta);
    if (s.beta > 1)
        o.complain(
            "beta", show(s.beta),
            "Newmark's beta must be between 0 and 1 (0.25: average acceleration; the paper uses 0.4 with contact)");
    s.rho_infinity = o.number("rho_infinity", "", Range::not_negative, 1);
    if (s.rho_infinity > 1)
        o.complain("rho_infinity", show(s.rho_infinity),
                   "must be between 0 and 1: what a step leaves of the highest frequencies' amplitude (1: all, "
                   "Newmark's method)");
    if (s.rho_infinity < 1) {
        if (o.has("beta"))
            throw InputError("model:dynamic: beta and rho_infinity are both given; rho_infinity sets beta = " +
                             show(DynamicSettings::beta_of(s.rho_infinity)) + ": leave one out");
        s.beta = DynamicSettings::beta_of(s.rho_infinity);
    }
    s.controlled_by_default =
        !in_explicit_steps && !conserving && !o.has("step_control") && m->options().shift != Shift::elastic_and_plastic;
    s.step_control = o.number("step_control", "", Range::not_negative,
                              conserving                ? 0.01
                              : s.controlled_by_default ? DynamicSettings::default_control
                                                        : 0);
    if (s.step_control > 0 && m->options().shift == Shift::elastic_and_plastic)
        throw InputError(
            "model:dynamic: field 'step_control' needs an energy balance that closes, and that of a model with shift = "
            "'elastic_and_plastic' cannot; leave it out");
    if (s.step_control >= 1)
        o.complain("step_control", show(s.step_control),
                   "must be below 1: the part of the largest energy that the run may lose, such as 0.01");
    s.iterations = o.integer("iterations", 0, 0);
    s.tolerance = o.number("tolerance", "", Range::positive, conserving ? tolerance_of_conserving : s.tolerance);
    const std::string predictor = o.word("predictor", {"auto", "acceleration", "displacement"}, "auto");
    s.predictor = predictor == "acceleration"   ? Predictor::acceleration
                  : predictor == "displacement" ? Predictor::displacement
                                                : Predictor::by_step;
    s.geometric = o.flag("geometric", s.geometric);
    s.rebuild_angle =
        o.number("rebuild_angle", "rad", Range::positive, conserving ? rebuild_angle_of_conserving : s.rebuild_angle);
    s.single_precision = o.word("precision", {"single", "double"}, "single") == "single";
    s.rest = o.flag("rest", s.rest);
    if (o.has("energy_tolerance")) s.energy_tolerance = o.number("energy_tolerance", "", Range::not_negative);
    s.threads = o.integer("threads", 1, 1);
    if (s.threads > 256) o.complain("threads", std::to_string(s.threads), "must be at most 256");
    if (in_explicit_steps)
        for (const char* field : {"beta", "rho_infinity", "iterations", "tolerance", "predictor", "geometric",
                                  "rebuild_angle", "solver", "solver_tolerance", "solver_iterations", "precision"})
            if (o.has(field))
                throw InputError(std::string("model:dynamic: field '") + field +
                                 "' has no meaning with integrator = 'explicit', which solves nothing; leave it out");
    if (conserving && o.has("rest") && s.rest)
        o.complain("rest", "true", "integrator = 'energy-momentum' leaves no body at rest; leave it out");
    if (!in_explicit_steps && !conserving && s.iterations == 1 && o.has("tolerance"))
        o.complain("tolerance", show(s.tolerance),
                   "is that of Newton's method, and iterations = 1 is one solution; leave one of them out");
    s.solver.direct = o.word("solver", {"cg", "direct"}, "cg") == "direct";
    s.solver.tolerance = o.number("solver_tolerance", "", Range::positive, s.solver.tolerance);
    s.solver.max_iterations = o.integer("solver_iterations", 1, s.solver.max_iterations);
    for (const char* field : {"solver_tolerance", "solver_iterations"})
        if (s.solver.direct && o.has(field))
            throw InputError(std::string("model:dynamic: field '") + field +
                             "' has no meaning with solver = 'direct'; leave it out");
    State start = start_state(o, structure, before);
    refuse_lost_loads(structure->model(), *structure, start, "model:dynamic");
    refuse_idle_velocities(*structure, start);
    context(L)->running = L;
    std::vector<Warning> likely_mistakes = empty_cases(*m, choice, where(L));
    for (Warning& w : idle_histories(structure->model(), before ? &before->run->structure().model() : nullptr,
                                     start.time, s.duration, automatic ? 0 : s.dt))
        likely_mistakes.push_back(std::move(w));
    for (Warning& w : massless_loads(*structure, where(L))) likely_mistakes.push_back(std::move(w));
    for (Warning& w : floors_twice(*structure)) likely_mistakes.push_back(std::move(w));
    if (before)
        for (Warning& w : late_gravity(*structure, *before, where(L))) likely_mistakes.push_back(std::move(w));
    for (Warning& w : overlapping_bars(*structure, start)) likely_mistakes.push_back(std::move(w));
    for (Warning& w : damped_free_bodies(*structure, start)) likely_mistakes.push_back(std::move(w));
    for (Warning& w :
         lone_velocities(*structure, start, before ? &before->run->structure().model() : nullptr, where(L)))
        likely_mistakes.push_back(std::move(w));
    weigh_dynamic(*context(L), *structure);
    auto run = std::make_shared<Dynamics>(structure, std::move(start), s);
    const long planned = std::llround(s.duration / run->settings().dt);
    const int every = record_every(o, int(std::max(1L, planned / 500)));
    auto plan = read_checkpoint_plan(o, *m);
    make_run(L, std::move(run), m, every, std::move(likely_mistakes));
    find<RunBox>(L, -1)->value->checkpoint = std::move(plan);
    return chain.keep(L);
}

}  // namespace hinge::script

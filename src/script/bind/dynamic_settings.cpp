#include "script/bind/dynamic_settings.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "core/text.h"
#include "model/panel.h"
#include "effects/all_effects.h"
#include "run/automatic_step.h"

namespace hinge::script {
namespace {

/// Of Newton's method in energy-momentum steps: relative to the first correction of a step, in the norm of the energy.
constexpr double tolerance_of_conserving = 1e-8;

/// rad. With that tolerance the right-angle cantilever of tests/script/run/integrators_test.lua takes 2451
/// iterations with 10,400 elements rebuilt at 0.01, 2141 with 12,700 at 0.005, 1938 with 14,100 at 0.002, 1929 with
/// 14,400 at 0.001, 1905 with 34,000 where each iteration rebuilds all.
constexpr double rebuild_angle_of_conserving = 0.002;

/// Reads the fields in groups; each group refuses what is out of range or has no meaning beside others.
class Reading {
public:
    Reading(Options& o, const Model& model, const Structure& structure, IntegratorKind kind)
        : o_(o),
          model_(model),
          structure_(structure),
          explicit_(kind == IntegratorKind::explicit_steps),
          conserving_(kind == IntegratorKind::energy_momentum) {}

    DynamicSettings read() {
        s_.conserving = conserving_;
        if (conserving_) refuse_what_cannot_be_conserved();
        read_time_step();
        read_scheme();
        read_step_control();
        read_newton();
        read_rest();
        refuse_idle_fields();
        s_.solver.direct = o_.word("solver", {"cg", "direct"}, "cg") == "direct";
        read_internals();
        return s_;
    }

private:
    void refuse_what_cannot_be_conserved() const;
    double time_step(bool& automatic);
    void read_time_step();
    void read_scheme();
    void read_step_control();
    void read_newton();
    void read_rest();
    void read_threads();
    void refuse_idle_fields();
    void read_internals();

    Options& o_;
    const Model& model_;
    const Structure& structure_;
    const bool explicit_, conserving_;
    DynamicSettings s_;
};

/// What the energy-momentum method does not go with, effects aside.
void Reading::refuse_what_cannot_be_conserved() const {
    const std::string with = "model:dynamic: integrator = 'energy-momentum' ";
    for (const char* field : {"beta", "rho_infinity", "precision"})
        if (o_.has(field))
            throw InputError("model:dynamic: field '" + std::string(field) +
                             "' has no meaning with integrator = 'energy-momentum'; leave it out");
    if (model_.options().displacement == Displacement::small)
        throw InputError(with +
                         "is for large rotations; a model with displacement = 'small' takes 'newmark', which "
                         "conserves as much there");
    if (model_.options().shift == Shift::elastic_and_plastic)
        throw InputError(with +
                         "needs an energy balance that closes, and that of a model with shift = 'elastic_and_plastic' "
                         "cannot; take 'newmark'");
}

/// The field dt. Explicit steps may not be longer than stability allows, and can be left to it: dt = "auto".
double Reading::time_step(bool& automatic) {
    const std::string word = o_.push_field("dt") == LUA_TSTRING ? lua_tostring(o_.L(), -1) : "";
    lua_pop(o_.L(), 1);
    automatic = word == "auto";
    const auto& elements = structure_.elements();
    if (automatic && std::none_of(elements.begin(), elements.end(), [](const Element& e) { return e.mass() > 0; })) {
        if (explicit_ && !model_.declared<Panel>(panels_effect).empty())
            return s_.duration;  // what effects join to the nodes shortens it (fitted_to_effects, run/step_length.h)
        o_.complain("dt", "'auto'",
                    "follows waves along members, and no member has a density; give a number in s, such as a fiftieth "
                    "of the shortest period that counts (run:modes)");
    }
    if (!word.empty() && !automatic)
        o_.complain("dt", "'" + word + "'", "must be a number in s, or 'auto'" + did_you_mean(word, {"auto"}));
    if (!explicit_) return automatic ? shortest_step(structure_, s_.duration) : o_.number("dt", "s", Range::positive);
    const bool breaks = may_break(model_, {.dynamic = true, .explicit_steps = true});
    if (automatic) return explicit_step(structure_, s_.duration, breaks);
    const double dt = o_.number("dt", "s", Range::positive);
    if (const StableStep limit = explicit_limit(structure_, breaks); dt > limit.dt)
        o_.complain("dt", show(dt) + " s",
                    "explicit steps stay stable up to " + show(limit.dt) + " s here (" +
                        structure_.element_name(limit.element) + " has the highest frequency" +
                        (damping_of(structure_).empty() ? "" : ", and damping shortens it") +
                        "); give a shorter one, or dt = 'auto'");
    return dt;
}

void Reading::read_time_step() {
    s_.duration = o_.number("duration", "s", Range::positive);
    bool automatic = false;
    s_.dt = time_step(automatic);
    s_.automatic = automatic && !explicit_;
    if (conserving_ && automatic)
        o_.complain(
            "dt", "'auto'",
            "integrator = 'energy-momentum' needs a number in s; step_control halves steps that do not converge");
    s_.chosen = automatic;
    const std::string dt = show(s_.dt) + " s", duration = show(s_.duration) + " s";
    if (s_.duration < 0.5 * s_.dt) o_.complain("duration", duration, "must be at least one step, dt = " + dt);
    if (s_.duration / s_.dt > 1e12) o_.complain("dt", dt, "would take more than 1e12 steps to duration = " + duration);
}

/// Newmark's beta, or that of the numerical damping that is asked for.
void Reading::read_scheme() {
    s_.beta = explicit_ ? 0 : o_.number("beta", "", Range::positive, s_.beta);
    if (s_.beta > 1)
        o_.complain(
            "beta", show(s_.beta),
            "Newmark's beta must be between 0 and 1 (0.25: average acceleration; the paper uses 0.4 with contact)");
    s_.rho_infinity = o_.number("rho_infinity", "", Range::not_negative, 1);
    if (s_.rho_infinity > 1)
        o_.complain("rho_infinity", show(s_.rho_infinity),
                    "must be between 0 and 1: what a step leaves of the highest frequencies' amplitude (1: all, "
                    "Newmark's method)");
    if (!(s_.rho_infinity < 1)) return;
    const double beta = DynamicSettings::beta_of(s_.rho_infinity);
    if (o_.has("beta"))
        throw InputError("model:dynamic: beta and rho_infinity are both given; rho_infinity sets beta = " + show(beta) +
                         ": leave one out");
    s_.beta = beta;
}

void Reading::read_step_control() {
    const bool whole_shift = model_.options().shift == Shift::elastic_and_plastic;
    s_.controlled_by_default = !explicit_ && !conserving_ && !o_.has("step_control") && !whole_shift;
    const double usual = conserving_ ? 0.01 : s_.controlled_by_default ? DynamicSettings::default_control : 0;
    s_.step_control = o_.number("step_control", "", Range::not_negative, usual);
    if (s_.step_control > 0 && whole_shift)
        throw InputError(
            "model:dynamic: field 'step_control' needs an energy balance that closes, and that of a model with shift = "
            "'elastic_and_plastic' cannot; leave it out");
    if (s_.step_control >= 1)
        o_.complain("step_control", show(s_.step_control),
                    "must be below 1: the part of the largest energy that the run may lose, such as 0.01");
}

void Reading::read_newton() {
    s_.iterations = o_.integer("iterations", 0, 0);
    s_.tolerance = o_.number("tolerance", "", Range::positive, conserving_ ? tolerance_of_conserving : s_.tolerance);
}

void Reading::read_rest() {
    s_.single_precision = o_.word("precision", {"single", "double"}, "single") == "single";
    s_.rest = o_.flag("rest", s_.rest);
    if (o_.has("energy_tolerance")) s_.energy_tolerance = o_.number("energy_tolerance", "", Range::not_negative);
    read_threads();
}

void Reading::read_threads() {
    const std::string word = o_.push_field("threads") == LUA_TSTRING ? lua_tostring(o_.L(), -1) : "";
    lua_pop(o_.L(), 1);
    if (!o_.has("threads")) return;
    if (word.empty()) {
        s_.threads = o_.integer("threads", 1, 1);
        if (s_.threads > 256) o_.complain("threads", std::to_string(s_.threads), "must be at most 256");
    } else if (word != "auto") {
        o_.complain("threads", "'" + word + "'",
                    "must be a whole number, 1 or above, or 'auto'" + did_you_mean(word, {"auto"}));
    }
}

void Reading::refuse_idle_fields() {
    if (explicit_)
        for (const char* field :
             {"beta", "rho_infinity", "iterations", "tolerance", "solver", "precision", "internals"})
            if (o_.has(field))
                throw InputError(std::string("model:dynamic: field '") + field +
                                 "' has no meaning with integrator = 'explicit', which solves nothing; leave it out");
    if (conserving_ && o_.has("rest") && s_.rest)
        o_.complain("rest", "true", "integrator = 'energy-momentum' leaves no body at rest; leave it out");
    if (!explicit_ && !conserving_ && s_.iterations == 1 && o_.has("tolerance"))
        o_.complain("tolerance", show(s_.tolerance),
                    "is that of Newton's method, and iterations = 1 is one solution; leave one of them out");
}

/// The field `internals`, for tests: what tests/README.md says of it.
void Reading::read_internals() {
    if (conserving_) s_.rebuild_angle = rebuild_angle_of_conserving;
    if (!o_.has("internals")) return;
    if (o_.push_field("internals") != LUA_TTABLE) o_.complain("internals", show(o_.L(), -1), "must be a table");
    Options in(o_.L(), lua_gettop(o_.L()), "model:dynamic: field 'internals'");
    in.expect({"predictor", "geometric", "rebuild_angle", "solver_tolerance", "solver_iterations"});
    const auto refuse = [&](const char* field, const char* beside) {
        if (in.has(field))
            throw InputError(in.function() + ": field '" + field + "' has no meaning with " + beside +
                             "; leave it out");
    };
    if (conserving_) refuse("predictor", "integrator = 'energy-momentum'");
    for (const char* field : {"solver_tolerance", "solver_iterations"})
        if (s_.solver.direct) refuse(field, "solver = 'direct'");
    const std::string predictor = in.word("predictor", {"auto", "acceleration", "displacement"}, "auto");
    s_.predictor = predictor == "acceleration"   ? Predictor::acceleration
                   : predictor == "displacement" ? Predictor::displacement
                                                 : Predictor::by_step;
    s_.geometric = in.flag("geometric", s_.geometric);
    s_.rebuild_angle = in.number("rebuild_angle", "rad", Range::positive, s_.rebuild_angle);
    s_.solver.tolerance = in.number("solver_tolerance", "", Range::positive, s_.solver.tolerance);
    s_.solver.max_iterations = in.integer("solver_iterations", 1, s_.solver.max_iterations);
    lua_pop(o_.L(), 1);
}

}  // namespace

IntegratorKind read_integrator(Options& o) {
    const std::string word = o.word("integrator", {"newmark", "energy-momentum", "explicit"}, "newmark");
    return word == "explicit"          ? IntegratorKind::explicit_steps
           : word == "energy-momentum" ? IntegratorKind::energy_momentum
                                       : IntegratorKind::newmark;
}

DynamicSettings read_dynamic_settings(Options& o, const Model& model, const Structure& structure, IntegratorKind kind) {
    return Reading(o, model, structure, kind).read();
}

}  // namespace hinge::script

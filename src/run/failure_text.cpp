#include "run/failure_text.h"

#include <algorithm>
#include <cstdio>

#include "core/text.h"
#include "run/static_settings.h"

namespace hinge {
namespace {

constexpr std::size_t most_named = 3;  ///< members

std::string percent(double part, int digits = 3) { return number_text(100 * part, digits) + " %"; }

std::string last_correction(const Failure& f) {
    return "Newton did not converge in " + std::to_string(f.count) + " iterations (last correction " +
           number_text(f.value, 2) + " of the first)";
}

/// Where the effective stiffness is not positive definite, and what makes it so there.
std::string weakest_part(const Failure& f, const Structure& s) {
    if (f.node < 0) return {};
    const std::string at = " at " + s.node_name(f.node) + ": ";
    if (f.element < 0)
        return at + "what effects add to the stiffness " +
               (f.other < 0 ? std::string("there") : "between it and " + s.node_name(f.other)) +
               " is negative for the motion that is solved for";
    std::string why;
    if (f.yields) why = ", which yields,";
    else if (f.value > 0) why = ", under a compression of " + number_text(f.value, 3) + " N,";
    return at + s.element_name(f.element) + why + " has a negative stiffness for the motion that is solved for";
}

std::string text_of_equations(const Failure& f, const Structure& s) {
    switch (f.cause) {
        case Cause::not_factorised: return "the effective stiffness could not be factorised";
        case Cause::not_positive_definite:
            return "the effective stiffness is not positive definite" + weakest_part(f, s);
        case Cause::solution_not_finite: return "the solution for the accelerations is not finite";
        case Cause::solver_not_converged:
            return "conjugate gradients did not converge in " + count_text(f.count, "iteration");
        case Cause::mass_not_solved:
            return std::string("conjugate gradients found no solution with the mass matrix alone") +
                   (f.after_breaks ? ", after elements broke" : "");
        default: return last_correction(f);
    }
}

std::string text_of_energy(const Failure& f, const Structure& s) {
    switch (f.cause) {
        case Cause::rotation_too_large:
            return s.node_name(f.node) + " would rotate by " + number_text(f.value, 3) + " rad in a step, more than " +
                   number_text(f.limit, 2);
        case Cause::energy_lost_in_step:
            return "the step would lose " + percent(f.value) + " of the largest energy, its share of step_control is " +
                   percent(f.limit);
        case Cause::energy_not_finite: return "its energy would no longer be finite";
        case Cause::energy_error:
            return "the energy balance no longer closes, its error is " + percent(f.value) +
                   " of the largest energy (energy_tolerance " + percent(f.tolerance) + ")";
        default:
            return "the error of the energy balance has grown by " + percent(f.value) +
                   " of the largest energy since step " + std::to_string(f.count) + ", more than " + percent(f.limit) +
                   " (energy_tolerance " + percent(f.tolerance) + ")";
    }
}

/// The sentence of the cause, without step and time.
std::string sentence_of(const Failure& f, const Structure& s) {
    switch (f.cause) {
        case Cause::none: return {};
        case Cause::load_not_finite: return "the load on " + s.node_name(f.node) + " is not finite";
        case Cause::force_not_finite:
            return f.element >= 0 ? "the forces of " + s.element_name(f.element) + " are not finite"
                                  : "the forces at " + s.node_name(f.node) + " are not finite";
        case Cause::forces_unbounded: return "the forces at " + s.node_name(f.node) + " grow without bound";
        case Cause::element_folded:
            return "an end of " + s.element_name(f.element) +
                   " has folded back against the element itself, by 177 degrees or more";
        case Cause::flow_not_found:
            return "the plastic flow of " + s.element_name(f.element) +
                   " was not found: its forces are too far beyond the yield surface for one step";
        case Cause::no_equilibrium:
            return "no equilibrium found beyond load factor " + number_text(f.value) + " (step " +
                   std::to_string(f.step) + " halved down to " + number_text(f.limit, 1) + " of the way)";
        case Cause::unstable:
            return "the structure becomes unstable between load factors " + number_text(f.value) + " and " +
                   number_text(f.limit);
        case Cause::rotation_too_large:
        case Cause::energy_lost_in_step:
        case Cause::energy_not_finite:
        case Cause::energy_error:
        case Cause::energy_error_grown: return text_of_energy(f, s);
        default: return text_of_equations(f, s);
    }
}

/// What the failure of an element advises: a hinge that turns so far would have broken; what is elastic bends less in
/// shorter elements.
std::string advice_of(const Failure& f) {
    if (f.cause != Cause::element_folded) return {};
    return f.unbroken ? "; a rule of fracture (model:fracture) may help" : "; more elements a member may help";
}

std::string limit_point(const Remark& r, const Structure& s) {
    std::string text =
        ": a limit load, where " + s.node_name(r.of.node) + " gives way, " + component_name(r.of.component);
    for (std::size_t i = 0; i < std::min(r.members.size(), most_named); ++i)
        text += (i > 0                   ? ", "
                 : r.members.size() == 1 ? ", with plastic hinges in member "
                                         : ", with plastic hinges in members ") +
                std::to_string(r.members[i] + 1);
    if (r.members.size() > most_named) text += " and " + std::to_string(r.members.size() - most_named) + " more";
    return text;
}

bool is_brief(Remark::Kind kind) {
    return kind >= Remark::Kind::load_control_ends && kind <= Remark::Kind::would_turn_back;
}

std::string text_of_dynamics(const Remark& r, const Structure& s) {
    const Failure& of = r.of;
    char text[100] = "";
    switch (r.kind) {
        case Remark::Kind::halved:
            return "; dt was halved down to " + number_text(of.value, 3) + " s, and no shorter step is tried";
        case Remark::Kind::pressed_flat:
            return "; " + s.element_name(of.element) + " is pressed to " + percent(of.value, 2) + " of its length";
        case Remark::Kind::before: return "; before it, " + text_of(of, s);
        case Remark::Kind::fastest:
            std::snprintf(text, sizeof text, " with %.3g m/s at t = %.6g s", of.value, of.time);
            return "; fastest was " + s.node_name(of.node) + text;
        default:
            std::snprintf(text, sizeof text, ". The state is that of step %ld, t = %.6g s, where it was %.3g %%",
                          of.count, of.time, 100 * of.value);
            return text;
    }
}

std::string text_of(const Remark& r, const Structure& s) {
    using Kind = Remark::Kind;
    const auto what = [&] { return component_name(r.of.component) + (" of " + s.node_name(r.of.node)); };
    switch (r.kind) {
        case Kind::load_control_ends: return ". Beyond it load control finds equilibria that cannot be held";
        case Kind::limit_point: return limit_point(r, s);
        case Kind::limit_or_snap: return ": a limit load, a mechanism or a snap";
        case Kind::path_turns: return ": the path turns too sharply or ends there";
        case Kind::not_moved: return ": the loads do not move " + what() + ", which is to be driven";
        case Kind::would_turn_back:
            return ", where " + what() + " is " + number_text(r.of.value) + (r.of.component < 3 ? " m" : " rad") +
                   ": it would have to turn back there, or the structure comes apart in another way";
        case Kind::of_element: return "; " + text_of(r.of, s) + advice_of(r.of);
        case Kind::shorter_arc: return "; more steps make a shorter arc";
        case Kind::drive_what_moves: return "; drive what they move";
        case Kind::drive_one_way: return "; drive what goes on moving one way, or control by arc length";
        case Kind::drive_displacement:
            return "; control by " + what() + " goes on past it: tried over " + number_text(1e3 * r.of.value, 2) +
                   " mm";
        case Kind::imperfection:
            return "; a small load that moves it that way, as an imperfection, shows how it gives way";
        case Kind::arc_length: return "; control by arc length goes on past it: tried";
        case Kind::follow_in_time:
            return "; model:dynamic with from = and allow_failed = true follows what comes after it in time";
        default: return text_of_dynamics(r, s);
    }
}

}  // namespace

const char* word(Cause cause) {
    static constexpr const char* words[] = {"",
                                            "load_not_finite",
                                            "force_not_finite",
                                            "forces_unbounded",
                                            "element_folded",
                                            "flow_not_found",
                                            "not_factorised",
                                            "not_positive_definite",
                                            "solution_not_finite",
                                            "solver_not_converged",
                                            "mass_not_solved",
                                            "newton_not_converged",
                                            "rotation_too_large",
                                            "energy_lost_in_step",
                                            "energy_not_finite",
                                            "energy_error",
                                            "energy_error_grown",
                                            "no_equilibrium",
                                            "unstable"};
    static_assert(sizeof words / sizeof *words == cause_count);
    return words[int(cause)];
}

std::string text_of(const Failure& f, const Structure& s) {
    const bool in_time = f.cause != Cause::no_equilibrium && f.cause != Cause::unstable,
               of_energy = f.cause == Cause::energy_error || f.cause == Cause::energy_error_grown;
    char at[64] = "";
    if (in_time && (f.step > 0 || of_energy)) std::snprintf(at, sizeof at, "step %ld, t = %.6g s: ", f.step, f.time);
    return at + sentence_of(f, s);
}

std::string text_of(const RunFailure& failure, const Structure& structure) {
    return text_of(failure.what, structure) + text_of_rest(failure, structure, false);
}

std::string text_of_rest(const RunFailure& failure, const Structure& structure, bool brief) {
    std::string text;
    if (!brief) text += advice_of(failure.what);
    for (const Remark& r : failure.remarks)
        if (!brief || is_brief(r.kind)) text += text_of(r, structure);
    return text;
}

}  // namespace hinge

#include "advice/check.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/errors.h"
#include "core/text.h"
#include "advice/adviser.h"
#include "advice/curvature_limits.h"
#include "advice/damping_check.h"
#include "advice/implausible_values.h"
#include "advice/load_warnings.h"
#include "advice/plan.h"
#include "effects/all_effects.h"
#include "effects/declared.h"
#include "run/dynamics.h"
#include "run/statics.h"
#include "state/bodies.h"
#include "algebra/modes.h"

namespace hinge {
namespace {

constexpr int periods_told = 3, bodies_told = 5;
constexpr int most_nodes = 20000;  // of a body whose periods are looked for: some ten seconds
constexpr double few_steps = 5;    // in the longest period

std::string count(std::size_t n, const std::string& what) { return count_text(long(n), what); }

struct Piece {
    std::vector<int> nodes, supports;
    int members = 0;
    double mass = 0;
    bool held_by_effects = false;  ///< an effect adds stiffness to it
};

/// Bodies that elements hold together, or what effects add or tie between their nodes.
Bodies joined_bodies(const Structure& structure, const AddedToModes& added) {
    Bodies found = find_bodies(structure, initial_state(structure));
    const auto join = [&](int a, int b) {
        const int keep = found.of_node[a], gone = found.of_node[b];
        if (keep == gone || keep < 0 || gone < 0) return;
        for (int& body : found.of_node)
            if (body == gone) body = keep;
    };
    for (const Coupling& c : added.stiffness.pairs) join(c.a, c.b);
    for (const LinearConstraint& c : added.constraints)
        for (const LinearConstraint::Term& term : c.terms) join(term.of.node, c.dependent.node);
    std::vector<int> number(found.count, -1);
    found.count = 0;
    for (int& body : found.of_node)
        if (body >= 0) {
            if (number[body] < 0) number[body] = found.count++;
            body = number[body];
        }
    return found;
}

/// In statics nothing is damped, but the ratios of the model are those that its dynamics would have: point masses have
/// the mean alpha of the elements at their nodes.
void damp_masses(const Structure& s, AddedToModes& added) {
    for (const Blocks::Node& mass : added.mass) {
        const std::span<const int> at = s.elements_at(mass.node);
        double alpha = 0;
        for (const int e : at) alpha += added.damping[std::size_t(e)].of_mass / double(at.size());
        added.more_damping.nodes.push_back({mass.node, alpha * mass.K});
    }
}

AddedToModes added_by_effects(const Run& run) {
    AddedToModes added{run.added_stiffness(), {}, {}, damping_of(run.structure()), run.added_damping()};
    if (run.constraints()) added.constraints = run.constraints()->list_at(run.state());
    const State& s = run.state();
    for (std::size_t n = 0; n < s.offset_mass.size(); ++n)
        if (s.offset_mass[n].mass > 0)
            added.mass.push_back({int(n), offset_mass_in_space(s.offset_mass[n], s.rotation[n])});
    if (!added.damping.empty() && !run.dynamics()) damp_masses(run.structure(), added);
    return added;
}

std::vector<Piece> bodies_of(const Structure& structure, const AddedToModes& added) {
    const Bodies found = joined_bodies(structure, added);
    std::vector<Piece> bodies(found.count);
    for (int n = 0; n < int(found.of_node.size()); ++n) {
        if (found.of_node[n] < 0) continue;
        Piece& body = bodies[found.of_node[n]];
        body.nodes.push_back(n);
        if (structure.fixed()[n]) body.supports.push_back(n);
    }
    for (int m = 0; m < int(structure.model().members().size()); ++m)
        ++bodies[found.of_node[structure.end_node(m, 0)]].members;
    for (const Element& e : structure.elements()) {
        Piece& body = bodies[found.of_node[e.node[0]]];
        body.mass += e.mass();
    }
    for (const Blocks::Node& n : added.mass)
        if (const int b = found.of_node[n.node]; b >= 0) bodies[b].mass += n.K(0, 0);
    for (const Coupling& c : added.stiffness.pairs)
        if (const int b = found.of_node[c.a]; b >= 0) bodies[b].held_by_effects = true;
    for (const Blocks::Node& n : added.stiffness.nodes)
        if (const int b = found.of_node[n.node]; b >= 0) bodies[b].held_by_effects = true;
    for (const LinearConstraint& c : added.constraints)
        if (const int b = found.of_node[c.dependent.node]; b >= 0) bodies[b].held_by_effects = true;
    std::stable_sort(bodies.begin(), bodies.end(),
                     [](const Piece& a, const Piece& b) { return a.members > b.members; });
    return bodies;
}

/// What an axial wave takes through an element, and through all of its member, s: the shortest times.
struct Waves {
    double element = std::numeric_limits<double>::infinity(), member = element;
    int in_element = -1, in_member = -1;  ///< elements
};
Waves shortest_waves(const Structure& structure) {
    Waves least;
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        const double t = e.length * std::sqrt(e.rigidity.rhoA / e.rigidity.EA),
                     whole = t * structure.model().members()[e.member].elements;
        if (t > 0 && t < least.element) least.element = t, least.in_element = int(i);
        if (t > 0 && whole < least.member) least.member = whole, least.in_member = int(i);
    }
    return least;
}

struct Periods {
    std::string text;
    std::vector<DampedMode> modes;  ///< rising
};
Periods periods(const Structure& structure, const Piece& body, int rigid, const AddedToModes& added) {
    if (!(body.mass > 0)) return {"no periods without a mass", {}};
    if (int(body.nodes.size()) > most_nodes)
        return {"periods are not looked for beyond " + std::to_string(most_nodes) + " nodes", {}};
    Periods found;
    try {
        found.modes = damped_modes(structure, body.nodes, rigid, periods_told, added);
    } catch (const Interrupted&) { throw; } catch (const std::runtime_error& e) {
        return {std::string("no periods: ") + e.what(), {}};
    }
    for (const DampedMode& m : found.modes)
        found.text += (found.text.empty() ? "" : ", ") + digits(2 * 3.14159265358979323846 / m.frequency);
    found.text = found.text.empty() ? "nothing that vibrates" : "natural periods " + found.text + " s";
    return found;
}

/// Of the loads that are declared; none where the model is large. Bodies without supports are held.
LinearSolution linear_solution(const AdvisedRun& of, int most) {
    const Structure& declared = of.run->structure();
    if (int(declared.position().size()) > most) return {};
    const auto* held = of.run->held();
    return solve_linearly(declared.model(), held ? *held : std::vector<std::uint8_t>{});
}

/// The longest natural period of a body that supports hold, s; 0 where nobody knows. Not looked for where few_steps
/// of dt are shorter than an axial wave's way through the longest member and back: no period of a frame is so short.
double longest_period(const Structure& s, const std::vector<Piece>& bodies, const AddedToModes& added, double dt,
                      int most) {
    double longest = 0, wave = 0;
    for (const Element& e : s.elements())
        wave = std::max(wave,
                        s.model().members()[e.member].elements * e.length * std::sqrt(e.rigidity.rhoA / e.rigidity.EA));
    if (few_steps * dt < 2 * wave) return 0;
    for (std::size_t i = 0; i < bodies.size() && i < bodies_told; ++i) {
        const Piece& body = bodies[i];
        if (body.supports.empty()) continue;
        if (!(body.mass > 0) || int(body.nodes.size()) > most) return 0;
        if (!free_motions(s, body.nodes).empty()) return 0;  // it may move as slowly as it likes
        try {
            for (double w : natural_frequencies(s, body.nodes, 0, 1, added))
                longest = std::max(longest, 2 * 3.14159265358979323846 / w);
        } catch (const std::runtime_error&) { return 0; }  // not found, which is no reason to stop a run
    }
    return bodies.size() > bodies_told ? 0 : longest;
}

/// Steps that follow no vibration; where asked for, also those that spread an impact.
std::optional<Warning> long_steps(const AdvisedRun& of, const std::vector<Piece>& bodies, const AddedToModes& added,
                                  double dt, int most, bool impacts) {
    const Structure& s = of.run->structure();
    if (const double longest = longest_period(s, bodies, added, dt, most); longest > 0 && dt * few_steps > longest)
        return Warning{
            Warning::Kind::time_step,
            "dt is " + digits(dt) + " s, and the longest natural period " + digits(longest) + " s",
            "steps longer than a fifth of it follow no vibration; give dt = " + digits(longest / 50, 1) + " or less",
            of.asked_at};
    const Waves waves = shortest_waves(s);
    if (!impacts || waves.in_element < 0 || !(dt > waves.member)) return {};
    return Warning{Warning::Kind::time_step,
                   "dt is " + digits(dt) + " s, and an axial wave runs through member " +
                       std::to_string(s.elements()[waves.in_member].member + 1) + " in " + digits(waves.member) + " s",
                   "an impact is then spread over more than one member; give dt = 'auto', or less, where that matters",
                   of.asked_at};
}

}  // namespace

std::vector<std::pair<int, int>> linked_nodes(const Model& model) {
    std::vector<std::pair<int, int>> pairs;
    for (const NodeLink& link : node_links(model))
        if (link.a >= 0 && link.b >= 0) pairs.emplace_back(link.a, link.b);
    return pairs;
}

std::vector<Warning> warnings_of_run(const AdvisedRun& of, int most_solved, bool all, bool loads) {
    const Structure& s = of.run->structure();
    const bool impact = !s.model().asked_at("contact").empty() || !s.model().asked_at("ground").empty();
    std::vector<Warning> list = of.likely_mistakes;
    const AddedToModes added = added_by_effects(*of.run);
    const std::vector<Piece> bodies = bodies_of(s, added);
    for (const Piece& body : bodies) {
        const auto motions = free_motions(s, body.nodes);
        if (!motions.empty() && !body.supports.empty() && !body.held_by_effects)
            list.push_back(
                {Warning::Kind::support,
                 "mechanism: the body of " + count(body.members, "member") + " held at " +
                     s.node_name(body.supports[0]) +
                     (body.supports.size() > 1 ? " and " + count(body.supports.size() - 1, "more node") : "") +
                     " can " + ways_to_move(s, body.supports, motions) + " without resistance",
                 "fix what it may not do with model:fix",
                 s.model().asked_at("support " + std::to_string(body.supports[0] + 1))});
    }
    if (const auto* d = std::as_const(*of.run).dynamics(); d && !d->explicit_steps() && !d->settings().automatic)
        if (auto w = long_steps(of, bodies, added, d->settings().dt, most_solved, all || impact)) list.push_back(*w);
    const LinearSolution solution = linear_solution(of, most_solved);
    if (loads)
        for (Warning& w : huge_loads(of, solution)) list.push_back(std::move(w));
    for (Warning& w : near_euler(of, solution)) list.push_back(std::move(w));
    if (all)
        for (Warning& w : implausible_values(s)) list.push_back(std::move(w));
    if (all)
        for (Warning& w : unsafe_eq14(of, solution)) list.push_back(std::move(w));
    return list;
}

std::string checked_run(const AdvisedRun& of) {
    const Structure& s = of.run->structure();
    double mass = 0;
    for (const Element& e : s.elements()) mass += e.mass();
    for (const Blocks::Node& n : added_by_effects(*of.run).mass) mass += n.K(0, 0);
    return std::string(of.run->kind()) + " run" + (of.asked_at.empty() ? "" : ", " + of.asked_at) + ": " +
           count(s.model().members().size(), "member") + ", " + count(s.elements().size(), "element") + ", " +
           count(s.position().size(), "node") + ", " + std::to_string(s.free_dofs()) +
           (s.free_dofs() == 1 ? " degree" : " degrees") + " of freedom" + ", " + digits(mass, 6) + " kg\n" +
           kinetic_at_start(*of.run);
}

std::string checked_model(const AdvisedRun& of) {
    const Structure& s = of.run->structure();
    const AddedToModes added = added_by_effects(*of.run);
    const std::vector<Piece> bodies = bodies_of(s, added);
    std::string text;
    std::vector<Warning> list = warnings(s.model(), linked_nodes(s.model()), declared_gravity(s.model()));
    for (std::size_t i = 0; i < bodies.size() && i < bodies_told; ++i) {
        const Piece& body = bodies[i];
        const std::string name = body.supports.empty() ? "free body of " + count(body.members, "member")
                                                       : count(body.members, "member") + " on " +
                                                             count(body.supports.size(), "supported node");
        const Periods found = periods(s, body, int(free_motions(s, body.nodes).size()), added);
        text += "  " + name + ", " + digits(body.mass, 6) + " kg: " + found.text + damping_ratios(found.modes) + "\n";
        if (auto w = damped_otherwise(s, body.nodes, found.modes, name)) list.push_back(std::move(*w));
    }
    if (bodies.size() > bodies_told)
        text += "  and " + std::to_string(bodies.size() - bodies_told) +
                (bodies.size() == bodies_told + 1 ? " smaller body\n" : " smaller bodies\n");
    text += weight_by_source(s);
    if (const Waves waves = shortest_waves(s); waves.in_element >= 0)
        text +=
            "  shortest wave time " + digits(waves.element) + " s, through " + s.element_name(waves.in_element) + "\n";
    for (Warning& d : warnings_of_run(of, most_nodes, true, !of_units(list))) list.push_back(std::move(d));
    std::vector<Warning> notes;
    if (std::as_const(*of.run).dynamics()) name_curvature_limits(s, nullptr, notes);
    for (const Warning& n : notes) text += "  note: " + n.what + "; " + n.advice + "\n";
    for (const Warning& d : list) text += "  warning: " + warning_text(d) + "\n";
    return text + (list.empty() ? "  no warnings\n" : "");
}

}  // namespace hinge

#include "script/check.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "model/warnings.h"
#include "script/linear_solution.h"
#include "state/bodies.h"
#include "algebra/modes.h"

namespace hinge::script {
namespace {

constexpr int periods_told = 3, bodies_told = 5, buckling_told = 10;
constexpr double near_buckling = 0.5;  // of Euler's load
constexpr int most_nodes = 20000;      // of a body whose periods are looked for: some ten seconds

std::string digits(double v, int n = 4) { return number_text(v, n); }
std::string count(std::size_t n, const std::string& what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}
std::string triple(const Vec3& v) {
    return vector_text(v.unaryExpr([](double x) { return std::abs(x) < 1e-9 ? 0 : x; }), 4);
}

struct Piece {
    std::vector<int> nodes, supports;
    int members = 0;
    double mass = 0;
    bool heavy = true;             ///< all its elements have mass
    bool held_by_effects = false;  ///< an effect adds stiffness to it
};

/// Bodies that elements hold together, or what effects add between their nodes.
Bodies joined_bodies(const Structure& structure, const AddedToModes& added) {
    Bodies found = find_bodies(structure, initial_state(structure));
    for (const Coupling& c : added.stiffness.pairs) {
        const int keep = found.of_node[c.a], gone = found.of_node[c.b];
        if (keep == gone || keep < 0 || gone < 0) continue;
        for (int& body : found.of_node)
            if (body == gone) body = keep;
    }
    std::vector<int> number(found.count, -1);
    found.count = 0;
    for (int& body : found.of_node)
        if (body >= 0) {
            if (number[body] < 0) number[body] = found.count++;
            body = number[body];
        }
    return found;
}

AddedToModes added_by_effects(const Run& run) {
    AddedToModes added{run.added_stiffness(), {}};
    const State& s = run.state();
    for (std::size_t n = 0; n < s.offset_mass.size(); ++n)
        if (s.offset_mass[n].mass > 0)
            added.mass.push_back({int(n), offset_mass_in_space(s.offset_mass[n], s.rotation[n])});
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
    for (const MemberData& m : structure.model().members()) ++bodies[found.of_node[m.node[0]]].members;
    for (const Element& e : structure.elements()) {
        Piece& body = bodies[found.of_node[e.node[0]]];
        body.mass += e.mass();
        body.heavy &= e.rigidity.rhoA > 0;
    }
    for (const Blocks::Node& n : added.mass)
        if (const int b = found.of_node[n.node]; b >= 0) bodies[b].mass += n.K(0, 0);
    for (const Coupling& c : added.stiffness.pairs)
        if (const int b = found.of_node[c.a]; b >= 0) bodies[b].held_by_effects = true;
    for (const Blocks::Node& n : added.stiffness.nodes)
        if (const int b = found.of_node[n.node]; b >= 0) bodies[b].held_by_effects = true;
    return bodies;
}

bool moves_a_support(const Structure& structure, const Piece& body, const RigidMotion& m) {
    for (int n : body.supports) {
        Vec6 motion;
        motion << m.v + m.w.cross(structure.position()[n] - m.centre), m.w;
        for (int c = 0; c < 6; ++c)
            if (structure.fixed()[n] >> c & 1 && std::abs(motion[c]) > 1e-9) return true;
    }
    return false;
}

/// How a body moves against which its supports do nothing: along or about an axis of space where it can, else about its
/// own line.
std::string ways(const Structure& structure, const Piece& body, const std::vector<RigidMotion>& motions) {
    const int support = body.supports[0];
    std::string text;
    for (int c = 0; c < 6; ++c) {
        RigidMotion m{structure.position()[support], Vec3::Zero(), Vec3::Zero()};
        (c < 3 ? m.v : m.w)[c % 3] = 1;
        if (!moves_a_support(structure, body, m))
            text += (text.empty() ? "" : ", ") + std::string(c < 3 ? "move along " : "rotate about ") + "xyz"[c % 3];
    }
    if (!text.empty()) return text + (text.find("rotate") == std::string::npos ? "" : " through that node");
    const RigidMotion& m = motions[0];
    if (m.w.norm() < 1e-9 * m.v.norm()) return "move along " + triple(m.v.normalized());
    return "rotate about the line through " + triple(m.centre + m.w.cross(m.v) / m.w.squaredNorm()) + " m along " +
           triple(m.w.normalized());
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

std::string told(const Warning& d) {
    std::string where = d.asked_at;
    if (d.more > 0)
        where += (where.empty() ? "" : ", ") + std::string("and ") + std::to_string(d.more) + " more like it";
    return "  warning: " + d.what + (where.empty() ? "" : " (" + where + ")") + "; " + d.advice + "\n";
}

std::string periods(const Structure& structure, const Piece& body, int rigid, const AddedToModes& added) {
    if (!body.heavy) return "no periods without a density";
    if (int(body.nodes.size()) > most_nodes)
        return "periods are not looked for beyond " + std::to_string(most_nodes) + " nodes";
    std::string text;
    for (double w : natural_frequencies(structure, body.nodes, rigid, periods_told, added))
        text += (text.empty() ? "" : ", ") + digits(2 * 3.14159265358979323846 / w);
    return text.empty() ? "nothing that vibrates" : "natural periods " + text + " s";
}

/// Members whose compression is beyond half of Euler's load, the worst first, by one linear solution of the loads that
/// are declared. Bodies without supports are held; where there is no such solution nothing is said.
std::vector<Warning> near_euler(const RunRecord& record) {
    const Structure& declared = record.run->structure();
    if (int(declared.position().size()) > most_nodes) return {};
    const auto* statics = dynamic_cast<const Statics*>(record.run.get());
    const LinearSolution solution =
        solve_linearly(declared.model(), statics ? statics->held() : std::vector<std::uint8_t>{});
    if (!solution.run) return {};
    const Structure& structure = solution.run->structure();
    const Model& model = structure.model();

    struct Member {
        double part = 0, force = 0, euler = 0;  ///< force over Euler's load, N, N
        int member = 0;
    };
    std::vector<Member> found;
    const auto& elements = structure.elements();
    for (int i = 0; i < int(elements.size()); ++i) {
        const int member = elements[i].member;
        const auto& ends = model.members()[member].node;
        const double euler = euler_load(elements[i].rigidity,
                                        (model.nodes()[ends[1]].position - model.nodes()[ends[0]].position).norm());
        for (double side : {-1.0, 1.0}) {
            const double force = -solution.run->section_forces(i, side).N;
            if (!(force > near_buckling * euler)) continue;
            if (found.empty() || found.back().member != member) found.push_back({0, 0, euler, member});
            found.back().force = std::max(found.back().force, force);
            found.back().part = found.back().force / euler;
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const Member& a, const Member& b) { return a.part > b.part; });
    std::vector<Warning> list;
    for (const Member& m : found) {
        if (int(list.size()) == buckling_told) {
            list.back().more = int(found.size()) - buckling_told;
            break;
        }
        const auto& groups = model.members()[m.member].groups;
        list.push_back(
            {"member " + std::to_string(m.member + 1) + (groups.empty() ? "" : " (" + model.groups()[groups[0]] + ")") +
                 " carries " + digits(m.force) + " N in compression in a linear solution of the loads, " +
                 digits(m.part, 3) + " times Euler's load " + digits(m.euler) +
                 " N, pi^2 E I_min / L^2 between its nodes with effective length 1.0",
             declared.p_delta() ? "it may buckle: that shows with a small imperfection"
                                : "it may buckle: that shows in large displacement with p_delta = \"member\", its "
                                  "default, or eight elements a member, and a small imperfection",
             model.asked_at("member " + std::to_string(m.member + 1))});
    }
    return list;
}

}  // namespace

std::string checked_run(const RunRecord& record) {
    const Structure& s = record.run->structure();
    double mass = 0;
    for (const Element& e : s.elements()) mass += e.mass();
    for (const Blocks::Node& n : added_by_effects(*record.run).mass) mass += n.K(0, 0);
    return std::string(record.run->kind()) + " run" + (record.asked_at.empty() ? "" : ", " + record.asked_at) + ": " +
           count(s.model().members().size(), "member") + ", " + count(s.elements().size(), "element") + ", " +
           count(s.position().size(), "node") + ", " + std::to_string(s.free_dofs()) +
           (s.free_dofs() == 1 ? " degree" : " degrees") + " of freedom" + ", " + digits(mass, 6) + " kg\n";
}

std::string checked_model(const RunRecord& record) {
    const Structure& s = record.run->structure();
    std::vector<Warning> list = warnings(s.model());
    std::string text;
    const AddedToModes added = added_by_effects(*record.run);
    std::vector<Piece> bodies = bodies_of(s, added);
    std::stable_sort(bodies.begin(), bodies.end(),
                     [](const Piece& a, const Piece& b) { return a.members > b.members; });
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Piece& body = bodies[i];
        const auto motions = free_motions(s, body.nodes);
        if (!motions.empty() && !body.supports.empty() && !body.held_by_effects)
            list.push_back(
                {"mechanism: the body of " + count(body.members, "member") + " held at " +
                     s.node_name(body.supports[0]) +
                     (body.supports.size() > 1 ? " and " + count(body.supports.size() - 1, "more node") : "") +
                     " can " + ways(s, body, motions) + " without resistance",
                 "fix what it may not do with model:fix",
                 s.model().asked_at("support " + std::to_string(body.supports[0] + 1))});
        if (i < bodies_told)
            text += "  " +
                    (body.supports.empty()
                         ? "free body of " + count(body.members, "member")
                         : count(body.members, "member") + " on " + count(body.supports.size(), "supported node")) +
                    ", " + digits(body.mass, 6) + " kg: " + periods(s, body, int(motions.size()), added) + "\n";
    }
    if (bodies.size() > bodies_told)
        text += "  and " + std::to_string(bodies.size() - bodies_told) + " smaller bodies\n";
    if (const Waves waves = shortest_waves(s); waves.in_element >= 0) {
        text +=
            "  shortest wave time " + digits(waves.element) + " s, through " + s.element_name(waves.in_element) + "\n";
        const auto* d = dynamic_cast<const Dynamics*>(record.run.get());
        if (d && !d->explicit_steps() && !d->settings().automatic && d->settings().dt > waves.member)
            list.push_back(
                {"dt is " + digits(d->settings().dt) + " s, and an axial wave runs through member " +
                     std::to_string(s.elements()[waves.in_member].member + 1) + " in " + digits(waves.member) + " s",
                 "an impact is then spread over more than one member; give dt = 'auto', or less, where that matters",
                 record.asked_at});
    }
    for (Warning& d : near_euler(record)) list.push_back(std::move(d));
    for (const Warning& d : list) text += told(d);
    return text + (list.empty() ? "  no warnings\n" : "");
}

}  // namespace hinge::script

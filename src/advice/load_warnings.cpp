#include "advice/load_warnings.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.h"
#include "effects/damping.h"
#include "effects/declared.h"
#include "effects/joined_bodies.h"
#include "run/statics.h"
#include "state/breaking.h"

namespace hinge {
namespace {

constexpr int buckling_told = 10;      // lines
constexpr double near_buckling = 0.5;  // of Euler's load

// ---- loads too large ------------------------------------------------------------------------------------------------

/// The size of what acts, as a script gives it: its largest load on a node, else gravity.
std::string largest_load(const Model& model) {
    DeclaredLoad largest;
    const auto size = [](const DeclaredLoad& l) { return std::max(l.force.norm(), l.moment.norm()); };
    for (const DeclaredLoad& l : declared_loads(model))
        if (l.node >= 0 && size(l) > size(largest)) largest = l;
    if (size(largest) > 0) {
        const bool force = largest.force.norm() >= largest.moment.norm();
        return std::string("the largest of them is ") + digits(size(largest), 3) + (force ? " N" : " N m") +
               ", on node " + std::to_string(largest.node + 1);
    }
    const std::optional<Vec3> gravity = declared_gravity(model);
    return gravity ? "gravity is " + digits(gravity->norm(), 3) + " m/s^2" : "they act on members";
}

/// Strains, by a linear solution, that no building material follows elastically, and that plastic hinges would not see
/// but far beyond a limit load: in statics, and where what acts may end again soon.
constexpr double much_strain = 0.05, much_strain_in_dynamics = 0.5;

/// Times its plastic resultants that a linear solution asks of a section, where statics is to carry the loads in full:
/// hinges spread them over a frame, but not so much.
constexpr double much_yield = 5;

/// Of the kinetic energy of a node that is given a velocity alone, by the mass of the elements there.
constexpr double much_of_elements = 0.1;

struct Worst {
    double value = 0;
    int element = -1;
    void take(double v, int i) {
        if (v > value) value = v, element = i;
    }
};

// ---- compression ----------------------------------------------------------------------------------------------------

struct Compressed {
    double part = 0, force = 0, euler = 0;  ///< force over Euler's load, N, N
    int member = 0;
    bool stands_free = false;  ///< at one end
};

/// Nodes of one member alone, which nothing else holds.
std::vector<char> free_ends(const Model& model, const std::vector<std::uint8_t>& held) {
    std::vector<int> joined(model.nodes().size(), 0);
    for (const MemberData& m : model.members())
        for (int n : m.node) ++joined[n];
    for (const NodeLink& link : node_links(model))
        for (int n : {link.a, link.b})
            if (n >= 0) ++joined[n];
    for (const DeclaredLoad& l : declared_loads(model))
        if (l.motion) ++joined[l.node];
    std::vector<char> free(joined.size(), 0);
    for (std::size_t n = 0; n < free.size(); ++n)
        free[n] = joined[n] == 1 && model.nodes()[n].fixed == 0 && (n >= held.size() || held[n] == 0);
    return free;
}

std::vector<Compressed> compressed_members(const AdvisedRun& of, const LinearSolution& solution) {
    const Structure& structure = solution.run->structure();
    const Model& model = structure.model();
    const std::vector<char> is_free = free_ends(of.run->structure().model(), *solution.run->held());
    std::vector<Compressed> found;
    const auto& elements = structure.elements();
    for (int i = 0; i < int(elements.size()); ++i) {
        const int member = elements[i].member;
        if (model.members()[member].carries == Carries::tension) continue;  // a linear solution compresses it
        const auto& ends = model.members()[member].node;
        const bool stands_free = is_free[ends[0]] != is_free[ends[1]];
        const double length = (model.nodes()[ends[1]].position - model.nodes()[ends[0]].position).norm(),
                     euler = euler_load(elements[i].rigidity, stands_free ? 2 * length : length);
        for (double side : {-1.0, 1.0}) {
            const double force = -solution.run->section_forces(i, side).N;
            if (!(force > near_buckling * euler)) continue;
            if (found.empty() || found.back().member != member) found.push_back({0, 0, euler, member, stands_free});
            found.back().force = std::max(found.back().force, force);
            found.back().part = found.back().force / euler;
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Compressed& a, const Compressed& b) { return a.part > b.part; });
    return found;
}

/// "3-7, 9"
std::string ranges(std::vector<int> numbers) {
    std::sort(numbers.begin(), numbers.end());
    std::string text;
    for (std::size_t i = 0, j; i < numbers.size(); i = j) {
        for (j = i + 1; j < numbers.size() && numbers[j] == numbers[j - 1] + 1;) ++j;
        text += (text.empty() ? "" : ", ") + std::to_string(numbers[i] + 1);
        if (j > i + 1) text += (j > i + 2 ? "-" : ", ") + std::to_string(numbers[j - 1] + 1);
    }
    return text;
}

/// What is told in one line: members of one group, or, where they have none, of the same Euler's load.
struct Alike {
    std::string label;
    std::vector<Compressed> members;  ///< the worst first
};

std::string text_of(const Alike& group) {
    const Compressed& worst = group.members[0];
    std::vector<int> numbers;
    for (const Compressed& m : group.members) numbers.push_back(m.member);
    const bool one = numbers.size() == 1;
    return (one ? "member " : "members ") + ranges(numbers) + group.label + (one ? " carries " : " carry up to ") +
           digits(worst.force) + " N in compression in a linear solution of the loads, " +
           (one ? "" : "worst member " + std::to_string(worst.member + 1) + " with ") + digits(worst.part, 3) +
           " times Euler's load " + digits(worst.euler) + " N, " +
           (worst.stands_free ? "pi^2 E I_min / (2 L)^2, for " + std::string(one ? "it stands" : "they stand") +
                                    " free at one end: effective length 2.0"
                              : "pi^2 E I_min / L^2 between its nodes with effective length 1.0");
}

// ---- histories ------------------------------------------------------------------------------------------------------

struct UsedHistory {
    const History* history;
    std::string of, line;  ///< "the load on node 2"
};

/// What has a history given as points, and acts in this run for the first time; of those that share one the first.
std::vector<UsedHistory> histories_of(const Model& m, const Model* before) {
    const std::vector<DeclaredLoad> there = before ? declared_loads(*before) : std::vector<DeclaredLoad>();
    std::vector<UsedHistory> list;
    std::set<const History::Points*> seen;
    for (const DeclaredLoad& l : declared_loads(m)) {
        const bool is_new = std::none_of(there.begin(), there.end(),
                                         [&](const DeclaredLoad& b) { return b.asked == l.asked && b.what == l.what; });
        if (is_new && l.history && l.history->points() && seen.insert(l.history->points()).second)
            list.push_back({l.history, l.what, m.asked_at(l.asked)});
    }
    return list;
}

constexpr double little = 0.05;     ///< of the range of a history
constexpr int few_points = 2;       ///< within a run: more of them are a record, of which the first part may be quiet
constexpr double fewest_steps = 2;  ///< that follow a pulse

std::optional<Warning> doubt(const UsedHistory& told, double begin, double duration, double dt) {
    const History::Points& points = *told.history->points();
    const double end = begin + duration, nowhere = std::numeric_limits<double>::infinity();
    double first = nowhere, last = -nowhere;  // times between which it changes
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].second != points[i - 1].second)
            first = std::min(first, points[i - 1].first), last = points[i].first;
    if (!(first <= last)) return {};
    const std::string its = "the history of " + told.of + " ",
                      times = "from " + digits(first) + " to " + digits(last) + " s";
    if (begin > 0 && last <= begin)
        return Warning{
            Warning::Kind::loads,
            its + "changes " + times + ", and this run begins at " + digits(begin) +
                " s, where the run that it goes on from ended: all along it is " + digits(points.back().second),
            "times go on through runs; add " + digits(begin) + " s to them for it to begin with this run", told.line};
    double least = nowhere, most = -nowhere, from = nowhere, to = -nowhere;
    int inside = 0;
    const auto within = [&](double v) { from = std::min(from, v), to = std::max(to, v); };
    within(told.history->from(begin)), within((*told.history)(end));
    for (const auto& [t, v] : points) {
        least = std::min(least, v), most = std::max(most, v);
        if (t > begin && t < end) ++inside, within(v);
    }
    if (last > end && inside <= few_points && to - from < little * (most - least))
        return Warning{
            Warning::Kind::loads,
            its + "changes " + times + ", and this run ends at " + digits(end) + " s: in it " +
                (to > from ? digits(100 * (to - from) / (most - least), 2) + " % of the change" : "nothing of that") +
                " is seen",
            last > 50 * end ? "are its times in ms? they are in s"
                            : "times are in s; give a longer duration, or earlier times",
            told.line};
    const bool pulse = points.back().second == 0 && (points.front().second == 0 || first <= begin);
    if (pulse && last > first && last - first < fewest_steps * dt)
        return Warning{Warning::Kind::loads,
                       its + "is over within " + digits(last - first) + " s, and dt is " + digits(dt) + " s",
                       "times are in s; a shorter dt follows it, this one keeps its impulse alone", told.line};
    return {};
}

}  // namespace

std::vector<Warning> huge_loads(const AdvisedRun& of, const LinearSolution& solution) {
    if (!solution.run) return {};
    const Structure& structure = solution.run->structure();
    const Structure& declared = of.run->structure();
    const Model& model = declared.model();
    Worst strained, yielded;
    for (int i = 0; i < int(structure.elements().size()); ++i) {
        const Element& e = structure.elements()[i];
        const Section& s = *model.members()[e.member].section;
        const beam::YieldSurface& w = declared.elements()[i].yield;
        const double half = 0.5 * std::max({s.width, s.depth, std::sqrt(s.area)});
        for (double side : {-1.0, 1.0}) {
            const SectionForces f = solution.run->section_forces(i, side);
            strained.take(std::abs(f.N) / e.rigidity.EA +
                              half * (std::abs(f.Mx) / e.rigidity.EIx + std::abs(f.My) / e.rigidity.EIy),
                          i);
            yielded.take(std::sqrt(w.x * f.Mx * f.Mx + w.y * f.My * f.My + w.n * f.N * f.N + w.z * f.Mz * f.Mz), i);
        }
    }
    const auto* statics = of.run->statics();
    const auto member = [&](const Worst& w) { return std::to_string(structure.elements()[w.element].member + 1); };
    Warning w{.kind = Warning::Kind::units, .asked_at = model.asked_at("loads")};
    if (strained.value > (statics ? much_strain : much_strain_in_dynamics)) {
        const auto percent = [](double part) {
            return (part > 0.1 ? number_text(std::round(100 * part), 9) : digits(100 * part, 2)) + " %";
        };
        w.what = "the loads would strain member " + member(strained) + " by " + percent(strained.value) +
                 " in a linear solution of them; " + largest_load(model);
        w.advice = "are the loads in N and N m, E in Pa, lengths in m? A thousandth of the loads would strain it by " +
                   percent(strained.value / 1000) + "; steel yields at about 0.1 %";
        return {w};
    }
    const bool to_carry = statics && statics->settings().control == Control::load && !statics->settings().to_limit;
    if (!to_carry || !declared.can_yield() || !(yielded.value > much_yield)) return {};
    w.what = "the loads ask of member " + member(yielded) + " " + digits(yielded.value, 2) +
             " times what yields it, in a linear solution of them; " + largest_load(model);
    w.advice =
        "are the loads in N and N m, lengths in m, the yield stress in Pa? to_limit = true says how much of "
        "them it carries";
    return {w};
}

std::vector<Warning> near_euler(const AdvisedRun& of, const LinearSolution& solution) {
    if (!solution.run) return {};
    const Model& model = solution.run->structure().model();
    std::vector<Alike> groups;
    std::map<std::string, std::size_t> place;
    for (const Compressed& m : compressed_members(of, solution)) {
        const auto& named = model.members()[m.member].groups;
        const std::string label = named.empty() ? "" : " (" + model.groups()[named[0]] + ")",
                          key = (named.empty() ? digits(m.euler) : label) + (m.stands_free ? ", free" : "");
        const auto [known, fresh] = place.try_emplace(key, groups.size());
        if (fresh) groups.push_back({label, {}});
        groups[known->second].members.push_back(m);
    }
    std::vector<Warning> list;
    for (const Alike& group : groups) {
        if (int(list.size()) == buckling_told) {
            list.back().more += int(group.members.size());
            continue;
        }
        const std::string shows = of.run->structure().p_delta()
                                      ? "that shows with a small imperfection; beyond Euler's load between its nodes, "
                                        "which clamped ends allow, it takes four elements"
                                      : "that shows in large displacement with p_delta = \"member\", its default, or "
                                        "eight elements a member, and a small imperfection";
        list.push_back({Warning::Kind::buckling, text_of(group),
                        "it may buckle, and a frame that sways buckles earlier than its members alone: " + shows,
                        model.asked_at("member " + std::to_string(group.members[0].member + 1))});
        list.back().tells_of = int(group.members.size());
    }
    return list;
}

std::vector<Warning> idle_histories(const Model& model, const Model* before, double begin, double duration, double dt) {
    std::vector<Warning> list;
    for (const UsedHistory& told : histories_of(model, before))
        if (const auto w = doubt(told, begin, duration, dt)) list.push_back(*w);
    return list;
}

std::vector<Warning> lone_velocities(const Structure& s, const State& start, const Model* before,
                                     const std::string& line) {
    const Model& model = s.model();
    const auto given = [&](int node) {
        const int now = model.velocity_given()[node];
        return now >= 0 && (!before || now != before->velocity_given()[node]);
    };
    std::vector<char> alone(model.nodes().size(), 0);
    for (std::size_t n = 0; n < alone.size(); ++n) alone[n] = given(int(n)) && !start.velocity[n].isZero(0);
    for (const MemberData& m : model.members())
        if (given(m.node[0]) && given(m.node[1])) alone[m.node[0]] = alone[m.node[1]] = 0;
    std::vector<double> masses(alone.size(), 0);  // J
    for (const AddedMass& m : added_masses(model))
        masses[m.node] += 0.5 * m.mass.mass * start.velocity[m.node].head<3>().squaredNorm();
    std::vector<Warning> list;
    State only;
    for (std::size_t n = 0; n < alone.size(); ++n) {
        if (!alone[n]) continue;
        if (only.velocity.empty()) {
            only = start;
            for (Vec6& v : only.velocity) v.setZero();
        }
        only.velocity[n] = start.velocity[n];
        double elements = 0;
        for (const int e : s.elements_at(int(n)))
            if (!start.broken[e]) elements += kinetic_energy(s, only, e, axes_of(element_frame(s, e, only)));
        only.velocity[n].setZero();
        if (!(elements > much_of_elements * (elements + masses[n]))) continue;
        if (!list.empty()) {
            ++list[0].more;
            continue;
        }
        list.push_back({Warning::Kind::value,
                        "the velocity of " + s.node_name(int(n)) + " is given to that node alone and brings " +
                            digits(elements + masses[n], 3) + " J, " + digits(elements, 3) +
                            " J of them by the part of its elements' mass that is at the node, which depends on how "
                            "short the elements are",
                        "give the velocity to a member or a group to move members as a whole, or give the node the "
                        "mass that strikes (model:mass)",
                        line});
    }
    return list;
}

std::vector<Warning> damped_free_bodies(const Structure& s, const State& start) {
    const std::vector<Damping>& declared = s.model().declared<Damping>(damping_effect);
    if (std::none_of(declared.begin(), declared.end(), [](const Damping& d) { return d.alpha > 0; })) return {};
    const Bodies bodies = joined_bodies(s, start);
    const std::vector<char> held = held_bodies(s, start, bodies);
    std::vector<int> by(s.elements().size(), -1);  // the declaration that an element is damped by
    // A group of free bodies alone was named on purpose, such as debris that is to stop rolling.
    std::vector<char> meant(declared.size());
    for (std::size_t d = 0; d < declared.size(); ++d) meant[d] = declared[d].group >= 0;
    for (std::size_t i = 0; i < by.size(); ++i) {
        for (std::size_t d = 0; d < declared.size(); ++d)
            if (declared[d].group < 0 || s.in_group(int(i), declared[d].group)) by[i] = int(d);
        const int body = bodies.of_node[s.elements()[i].node[0]];
        if (by[i] >= 0 && body >= 0 && held[body]) meant[by[i]] = 0;
    }
    std::vector<Warning> list;
    std::vector<char> told(bodies.count, 0);
    for (std::size_t i = 0; i < by.size(); ++i) {
        const int body = bodies.of_node[s.elements()[i].node[0]];
        if (by[i] < 0 || meant[by[i]] || start.broken[i] || body < 0 || held[body] || told[body]) continue;
        const double alpha = declared[by[i]].alpha;
        if (!(alpha > 0)) continue;
        told[body] = 1;
        if (!list.empty()) {
            ++list[0].more;
            continue;
        }
        const int member = s.elements()[i].member;
        const auto& groups = s.model().members()[member].groups;
        list.push_back({Warning::Kind::damping,
                        "the body of member " + std::to_string(member + 1) +
                            (groups.empty() ? "" : " (" + s.model().groups()[groups[0]] + ")") +
                            " is held by no support, and alpha = " + digits(alpha, 3) +
                            " 1/s of model:damping slows it down in flight, by " +
                            digits(100 * (1 - std::exp(-0.1 * alpha)), 2) + " % in 0.1 s",
                        "damp only the groups that supports hold (group =), or give its group alpha = 0",
                        s.model().asked_at(damping_effect)});
    }
    return list;
}

std::vector<Warning> empty_cases(const Model& m, int gravity_case, const LoadChoice& choice, const std::string& line) {
    std::vector<char> holds(m.cases().size(), 0);
    const auto note = [&](int load_case) {
        if (load_case >= 0) holds[load_case] = 1;
    };
    for (const DeclaredLoad& l : declared_loads(m)) note(l.load_case);
    for (const int load_case : declared_cases(m)) note(load_case);
    note(gravity_case);
    std::vector<Warning> list;
    for (std::size_t i = 0; i < holds.size(); ++i)
        if (!holds[i] && choice.named[i] && choice.factor[i] != 0)
            list.push_back({Warning::Kind::loads,
                            "load case '" + m.cases()[i] + "', which this run takes, has no load and no gravity",
                            "give loads case = \"" + m.cases()[i] + "\", before the run is made", line});
    return list;
}

}  // namespace hinge

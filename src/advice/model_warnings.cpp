#include "advice/model_warnings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "contact/broad_phase.h"
#include "core/text.h"
#include "model/inner_nodes.h"
#include "model/member_text.h"
#include "model/panel.h"

namespace hinge {
namespace {

/// Nodes nearer to each other than this part of the shortest member there look as if they were meant to be one: 3 mm
/// of 3 m.
constexpr double part_of_members = 1e-3;

std::string number(double v) { return number_text(v); }
std::string at(const Vec3& x) { return vector_text(x) + " m"; }

/// Tolerances of one place, and the boxes of members and nodes by which neighbours are found.
struct Vicinity {
    double close = 0;                          ///< m: points nearer than this are in one place
    std::vector<double> near;                  ///< of each node, m: another node nearer than this is likely the same
    std::vector<std::vector<int>> members_at;  ///< of each node
    std::vector<int> used;                     ///< nodes that have members, rising
    int members = 0;                           ///< boxes of members, before those of the used nodes
    std::vector<contact::Box> boxes;
};

struct Finder {
    const Model& model;
    std::set<std::pair<int, int>> joined;  ///< nodes, the smaller number first
    std::vector<Warning> found;
    std::map<std::string, std::size_t> place;
    std::vector<std::pair<int, int>> connected = {};  ///< nodes that connectors join
    std::vector<int> joint_of = {};                   ///< of each node another one of its joint, or itself

    /// The first of a kind is told, the others are counted.
    void tell(const std::string& kind, const std::string& what, const std::string& advice,
              const std::string& asked_at) {
        const auto [known, fresh] = place.try_emplace(kind, found.size());
        static const std::set<std::string> units = {"E",       "yield strain", "yield stress", "density",
                                                    "section", "span",         "gravity"};
        const Warning::Kind of = units.count(kind) > 0          ? Warning::Kind::units
                                 : kind == "upward"             ? Warning::Kind::loads
                                 : kind == "no plastic modulus" ? Warning::Kind::strength
                                                                : Warning::Kind::geometry;
        if (fresh) found.push_back({of, what, advice, asked_at});
        else ++found[known->second].more;
    }
    const Vec3& position(int node) const { return model.nodes()[node].position; }
    const Vec3& end(int member, int side) const { return position(model.members()[member].node[side]); }
    double length(int member) const { return (end(member, 1) - end(member, 0)).norm(); }
    std::string name(int member) const { return member_text(model, member); }
    std::string member_line(int member) const { return model.asked_at("member " + std::to_string(member + 1)); }
    std::string node_line(int node) const { return model.asked_at("node " + std::to_string(node + 1)); }

    void materials();
    void sections();
    void never_yields();
    void spans();
    void gravity(const Vec3& g);
    void lone_nodes();
    void tiny_members();
    void unjoined();
    Vicinity vicinity() const;
    double shared_length(int i, int j, double close) const;
    void unjoined_nodes(const Vicinity& v, int other, int n);
    void passed_node(const Vicinity& v, int member, int n, const std::set<std::pair<int, int>>& overlaps);
    void find_joints(const std::vector<double>& near);
    int joint(int node) {
        while (joint_of[node] != node) node = joint_of[node] = joint_of[joint_of[node]];
        return node;
    }
    bool are_joined(int a, int b) { return joined.count(std::minmax(a, b)) > 0 || joint(a) == joint(b); }
};

void Finder::materials() {
    std::set<const Material*> seen;
    for (int i = 0; i < int(model.members().size()); ++i) {
        const Material& m = *model.members()[i].material;
        if (!seen.insert(&m).second) continue;
        const std::string whose = " (the material of " + name(i) + ")";
        // concrete and metals weigh more than 2000 kg/m^3; where nobody says, steel's number in kN/m^2 is told by
        // itself
        const double weighs = m.density < 25 ? 1000 * m.density : m.density;
        const bool in_kilo = m.E < 1e9 && (weighs > 2000 || (m.density == 0 && m.E > 1.9e8 && m.E < 2.2e8));
        if (in_kilo && m.E >= 1e7)
            tell("E", "E is " + number(m.E) + " Pa" + whose, "in kN/m^2? in Pa that would be " + number(1000 * m.E),
                 m.asked_at);
        else if (m.E < 1e7)
            tell("E", "E is " + number(m.E) + " Pa" + whose,
                 m.E < 2000 ? "in GPa? " + number(m.E) + " GPa is " + number(m.E) + "e9"
                            : "in MPa? " + number(m.E) + " MPa is " + number(m.E) + "e6",
                 m.asked_at);
        else if (m.E > 2e12)
            tell("E", "E is " + number(m.E) + " Pa, more than diamond's" + whose, "it is in Pa: steel has 206e9",
                 m.asked_at);
        else if (m.yield_stress > 0.1 * m.E && std::isfinite(m.yield_stress))
            tell("yield strain",
                 "the yield stress " + number(m.yield_stress) + " Pa is more than a tenth of E, " + number(m.E) +
                     " Pa" + whose,
                 "both are in Pa", m.asked_at);
        if (m.density > 0 && m.density < 25)
            tell("density", "the density is " + number(m.density) + " kg/m^3" + whose,
                 m.density > 1e-3 ? "in g/cm^3? " + number(m.density) + " g/cm^3 is " + number(1000 * m.density)
                                  : "in t/mm^3? " + number(m.density) + " t/mm^3 is " + number(1e12 * m.density),
                 m.asked_at);
        if (m.yield_stress < 1e5)
            tell("yield stress", "the yield stress is " + number(m.yield_stress) + " Pa" + whose,
                 "in MPa? " + number(m.yield_stress) + " MPa is " + number(m.yield_stress) + "e6", m.asked_at);
    }
}

void Finder::sections() {
    std::map<const Section*, double> longest;
    for (int i = 0; i < int(model.members().size()); ++i) {
        double& l = longest[model.members()[i].section.get()];
        l = std::max(l, length(i));
    }
    std::set<const Section*> seen;
    for (int i = 0; i < int(model.members().size()); ++i) {
        const Section& s = *model.members()[i].section;
        const double size =
            std::max({s.width, s.depth, std::sqrt(s.area), 2 * std::sqrt(std::max(s.Ix, s.Iy) / s.area)});
        if (seen.insert(&s).second && size > 2 && (size > longest[&s] || size > 20))
            tell("section",
                 "the section (" + s.kind + ") of " + name(i) + " measures " + number(size) +
                     " m across, and the longest member that has it " + number(longest[&s]) + " m",
                 "in mm? sizes are in m, areas in m^2, moments of area in m^4", s.asked_at);
    }
}

/// A yield stress without a plastic modulus or a plastic force to go with it.
void Finder::never_yields() {
    if (!model.options().plasticity) return;
    std::set<const Section*> seen;
    for (int i = 0; i < int(model.members().size()); ++i) {
        const Section& s = *model.members()[i].section;
        const Material& m = *model.members()[i].material;
        const bool yields = s.given.N0 || s.given.Mx0 || s.given.My0 || s.given.Mz0 || s.plastic_area > 0 || s.Zx > 0 ||
                            s.Zy > 0 || s.Zz > 0;
        if (std::isfinite(m.yield_stress) && !yields && seen.insert(&s).second)
            tell("no plastic modulus",
                 "the section (" + s.kind + ") of " + name(i) + " has no plastic moduli, so that it never yields at " +
                     "its material's yield stress " + number(m.yield_stress) + " Pa",
                 "give hinge.section.general plastic = { A =, Zx =, Zy =, Zz = } or N0, Mx0, My0, Mz0; or leave the "
                 "yield stress out",
                 s.asked_at);
    }
}

/// A member longer than any building's, and far more slender than a cable of that length.
void Finder::spans() {
    for (int i = 0; i < int(model.members().size()); ++i) {
        const Section& s = *model.members()[i].section;
        const double slender = length(i) / std::sqrt(std::max(s.Ix, s.Iy) / s.area);
        if (length(i) > 300 && slender > 2000)
            tell("span",
                 name(i) + " is " + number(length(i)) + " m long, " + number_text(std::round(slender), 9) +
                     " times its section's radius of gyration",
                 "nodes in mm? positions are in m", member_line(i));
    }
}

void Finder::gravity(const Vec3& g) {
    const std::string what = "gravity is " + vector_text(g) + " m/s^2";
    if (g.norm() > 100) tell("gravity", what, "in mm/s^2? the earth's is 9.80665 m/s^2", model.asked_at("gravity"));
    if (g.z() > 0 && g.z() >= g.cwiseAbs().maxCoeff())
        tell("upward", what + ", which pulls up", "write { 0, 0, -9.80665 } where z points up",
             model.asked_at("gravity"));
}

void Finder::lone_nodes() {
    std::vector<char> used(model.nodes().size(), 0);
    for (const MemberData& m : model.members()) used[m.node[0]] = used[m.node[1]] = 1;
    for (const InnerNode& inner : model.declared<InnerNode>(inner_nodes)) used[inner.node] = 1;
    for (const Panel& panel : model.declared<Panel>(panels_effect))
        for (const int n : panel.nodes) used[n] = 1;
    for (int n = 0; n < int(used.size()); ++n)
        if (!used[n])
            tell("lone", "node " + std::to_string(n + 1) + " at " + at(position(n)) + " belongs to no member",
                 "join it with model:member, or leave it out", node_line(n));
}

void Finder::tiny_members() {
    std::vector<double> longest(model.nodes().size(), 0);  // of the members at each node
    for (int i = 0; i < int(model.members().size()); ++i)
        for (int n : model.members()[i].node) longest[n] = std::max(longest[n], length(i));
    for (int i = 0; i < int(model.members().size()); ++i) {
        const double neighbour = std::max(longest[model.members()[i].node[0]], longest[model.members()[i].node[1]]);
        if (50 * length(i) < neighbour)
            tell("tiny",
                 name(i) + " is " + number(length(i)) + " m long, one that it is joined to " + number(neighbour) + " m",
                 "the shortest element sets the shortest wave time; is it meant to be there?", member_line(i));
    }
}

/// The tolerances of one place, and boxes around all members and nodes.
Vicinity Finder::vicinity() const {
    Vicinity v;
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    v.members_at.resize(model.nodes().size());
    v.members = int(model.members().size());
    for (int i = 0; i < v.members; ++i)
        for (int side : {0, 1}) {
            low = low.cwiseMin(end(i, side)), high = high.cwiseMax(end(i, side));
            v.members_at[model.members()[i].node[side]].push_back(i);
        }
    v.close = 1e-6 * (high - low).norm();
    const Vec3 room = Vec3::Constant(0.5 * v.close);
    v.near.assign(model.nodes().size(), std::numeric_limits<double>::infinity());
    for (int i = 0; i < v.members; ++i)
        for (int n : model.members()[i].node) v.near[n] = std::min(v.near[n], part_of_members * length(i));
    for (int i = 0; i < v.members; ++i)
        v.boxes.push_back({end(i, 0).cwiseMin(end(i, 1)) - room, end(i, 0).cwiseMax(end(i, 1)) + room});
    for (int n = 0; n < int(model.nodes().size()); ++n)
        if (!v.members_at[n].empty()) {
            v.near[n] = std::max(v.near[n], v.close);
            const Vec3 around = Vec3::Constant(0.5 * v.near[n]);
            v.used.push_back(n), v.boxes.push_back({position(n) - around, position(n) + around});
        }
    return v;
}

/// Nodes in one place that connectors join, directly or by way of a third: beams that are pinned to one column.
void Finder::find_joints(const std::vector<double>& near) {
    for (int n = 0; n < int(near.size()); ++n) joint_of.push_back(n);
    for (const auto& [a, b] : connected)
        if ((position(a) - position(b)).norm() <= std::min(near[a], near[b])) joint_of[joint(a)] = joint(b);
}

/// Length over which member j lies on member i, m; 0 where it does not.
double Finder::shared_length(int i, int j, double close) const {
    const Vec3 along = (end(i, 1) - end(i, 0)).normalized();
    const auto offset = [&](int side) {
        const Vec3 d = end(j, side) - end(i, 0);
        return (d - d.dot(along) * along).norm();
    };
    if (offset(0) > close || offset(1) > close) return 0;
    const double a = (end(j, 0) - end(i, 0)).dot(along), b = (end(j, 1) - end(i, 0)).dot(along);
    const double stretch = std::min(length(i), std::max(a, b)) - std::max(0.0, std::min(a, b));
    return stretch <= 10 * close ? 0 : stretch;
}

/// Two nodes that are close to each other without being joined.
void Finder::unjoined_nodes(const Vicinity& v, int other, int n) {
    const double apart = (position(n) - position(other)).norm();
    if (apart > std::min(v.near[n], v.near[other]) || are_joined(n, other)) return;
    const std::string both = "nodes " + std::to_string(other + 1) + " and " + std::to_string(n + 1) + " are ";
    if (apart <= v.close)
        tell("coincide", both + "both at " + at(position(n)) + ", but not joined",
             "use one node for both where their members meet", node_line(n));
    else
        tell("nearly coincide", both + number_text(apart, 3) + " m apart at " + at(position(n)) + ", but not joined",
             "use one node for both if their members meet there", node_line(n));
}

/// A member that passes through a node without being joined to it. `overlaps`: pairs of members that lie on each other.
void Finder::passed_node(const Vicinity& v, int member, int n, const std::set<std::pair<int, int>>& overlaps) {
    const Vec3 span = end(member, 1) - end(member, 0), d = position(n) - end(member, 0);
    const double share = d.dot(span) / span.squaredNorm(), margin = 10 * v.close / span.norm();
    const auto lies_on = [&](int other) { return overlaps.count({member, other}) > 0; };
    if (share < margin || share > 1 - margin || (d - share * span).norm() > v.close ||
        std::any_of(v.members_at[n].begin(), v.members_at[n].end(), lies_on))
        return;
    tell("through",
         name(member) + " passes through node " + std::to_string(n + 1) + " at " + at(position(n)) +
             ", but is not joined to it",
         "let two members meet there, or move the node", member_line(member));
}

/// Nodes and members that are in one place without being joined.
void Finder::unjoined() {
    const Vicinity v = vicinity();
    find_joints(v.near);
    const auto pairs = contact::overlapping(v.boxes, [&](int i, int j) {
        if (i >= v.members || j < v.members) return true;
        const auto& ends = model.members()[i].node;
        return ends[0] != v.used[j - v.members] && ends[1] != v.used[j - v.members];
    });
    std::set<std::pair<int, int>> overlaps;
    for (const auto& [i, j] : pairs) {
        if (j >= v.members) continue;
        const double stretch = shared_length(i, j, v.close);
        if (stretch == 0) continue;
        overlaps.insert({i, j}), overlaps.insert({j, i});
        tell("overlap", name(j) + " lies on " + name(i) + " over " + number(stretch) + " m",
             "leave one out, or let both end where they meet", member_line(j));
    }
    for (const auto& [i, j] : pairs) {
        if (j < v.members) continue;
        const int n = v.used[j - v.members];
        if (i >= v.members) unjoined_nodes(v, v.used[i - v.members], n);
        else passed_node(v, i, n, overlaps);
    }
}

}  // namespace

std::vector<Warning> warnings(const Model& model, const std::vector<std::pair<int, int>>& joined,
                              const std::optional<Vec3>& gravity) {
    Finder finder{model, {}, {}, {}};
    finder.connected = joined;
    for (const auto& [a, b] : joined) finder.joined.insert(std::minmax(a, b));
    for (const MemberData& m : model.members()) finder.joined.insert(std::minmax(m.node[0], m.node[1]));
    finder.materials();
    finder.sections();
    finder.never_yields();
    finder.spans();
    if (gravity) finder.gravity(*gravity);
    finder.lone_nodes();
    finder.tiny_members();
    finder.unjoined();
    return std::move(finder.found);
}

}  // namespace hinge

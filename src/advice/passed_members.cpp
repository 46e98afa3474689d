// Members that passed through each other because no contact rule is for them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "advice/adviser.h"
#include "contact/segments.h"
#include "core/built.h"
#include "core/text.h"
#include "effects/contact.h"
#include "effects/declared.h"
#include "model/member_text.h"

namespace hinge {
namespace {

constexpr int steps_between = 16;       ///< steps between looks at the nodes
constexpr double part_of_element = 8;   ///< of the shortest element: a motion after which bars are compared
constexpr double deep = 0.5;            ///< of the sum of half depths: bars that come so near have met
constexpr double between_places = 0.2;  ///< of the same sum: the way between two places that are compared
constexpr int most_places = 400;
constexpr std::size_t most_meetings = 10000;  ///< that are counted

bool share_node(const MemberData& a, const MemberData& b) {
    for (const int i : a.node)
        for (const int j : b.node)
            if (i == j) return true;
    return false;
}

std::string place_text(const Vec3& at) {
    return "{" + number_text(at.x(), 3) + ", " + number_text(at.y(), 3) + ", " + number_text(at.z(), 3) + "} m";
}

/// Finds pairs of members whose axes came nearer than half the sum of their half depths although they were apart where
/// the run began, and for which no rule of model:contact holds. In statics no rule does: there is no contact.
///
/// Not found are pairs that share a node or are joined by a link, members that overlapped from the start, and elements
/// that are broken. Nodes are looked at every few steps, in statics after each; only where one of them has moved by a
/// part of an element are bars compared, over the straight way of their nodes since the last time. It reads the state
/// and changes nothing.
class PassedMembers : public Adviser {
public:
    explicit PassedMembers(const Workspace& w);
    void after_commit(const Run& run, const Step& step) override;
    /// One warning, of the first pair, with the others counted.
    void list_findings(const Run& run, std::vector<Warning>& list) const override;
    void save(Writer& to) const override { to(since_, start_, last_, found_); }
    void restore(Reader& from) override { from(since_, start_, last_, found_); }
    bool fits(const Run& run) const override;

private:
    /// Where a pair of members met.
    struct Meeting {
        double time = 0;  ///< s
        Vec3 at = Vec3::Zero();
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.time, s.at);
        }
    };
    using Found = std::map<std::pair<int, int>, Meeting>;  ///< by members, the smaller index first
    struct Bar {
        int element;
        Vec3 low, high;  ///< of the box around its way, m
        double moved;    ///< m, at most
    };
    double moved_since_last() const;
    Vec3 place(int node, const std::vector<Vec3>& displacement) const;
    void list_bars(std::vector<Bar>& bars) const;
    void compare(double time, Found& found) const;
    void compare(const Bar& a, const Bar& b, double time, Found& found) const;
    bool may_meet(int member_a, int member_b) const;

    const Workspace& w_;
    double enough_ = 0;                        ///< m of motion, after which bars are compared
    double thinnest_ = 0;                      ///< m, the smallest half depth
    std::vector<std::pair<int, int>> linked_;  ///< members that a link joins, sorted
    int since_ = 0;                            ///< steps since nodes were looked at
    std::vector<Vec3> start_, last_;  ///< m, displacements where the run began, and where bars were last compared
    Found found_;
};

/// Whether there is a pair without a rule.
bool has_pair_without_rule(const Structure& structure, bool dynamic) {
    if (structure.model().members().size() < 2) return false;
    if (!dynamic) return structure.large();
    const auto& rules = contact_rules(structure.model());
    return std::none_of(rules.begin(), rules.end(), [](const ContactRule& r) { return r.groups.empty(); });
}

PassedMembers::PassedMembers(const Workspace& w) : w_(w), start_(w.state.displacement), last_(start_) {
    double shortest = std::numeric_limits<double>::infinity();
    thinnest_ = shortest;
    for (const Element& e : w.structure.elements()) {
        shortest = std::min(shortest, e.length);
        thinnest_ = std::min(thinnest_, e.radius);
    }
    enough_ = std::max(shortest / part_of_element, thinnest_);
    const auto& members = w.structure.model().members();
    std::map<int, std::vector<int>> at;  // members at each linked node
    const std::vector<NodeLink> links = node_links(w.structure.model());
    for (const NodeLink& link : links) at[link.a], at[link.b];
    if (links.empty()) return;
    for (std::size_t m = 0; m < members.size(); ++m)
        for (const int node : members[m].node)
            if (const auto here = at.find(node); here != at.end()) here->second.push_back(int(m));
    for (const NodeLink& link : links)
        for (const int a : at[link.a])
            for (const int b : at[link.b]) linked_.emplace_back(std::min(a, b), std::max(a, b));
    std::sort(linked_.begin(), linked_.end());
}

Vec3 PassedMembers::place(int node, const std::vector<Vec3>& displacement) const {
    return w_.structure.position()[node] + displacement[node];
}

double PassedMembers::moved_since_last() const {
    double most = 0;
    for (std::size_t n = 0; n < last_.size(); ++n) {
        const double moved = (w_.state.displacement[n] - last_[n]).squaredNorm();
        if (moved > most) most = moved;
    }
    return std::sqrt(most);
}

void PassedMembers::after_commit(const Run&, const Step& step) {
    if (++since_ < steps_between && w_.kind.dynamic) return;
    since_ = 0;
    if (!(moved_since_last() > enough_)) return;
    compare(w_.reached(step), found_);
    last_ = w_.state.displacement;
}

void PassedMembers::list_bars(std::vector<Bar>& bars) const {
    const auto& elements = w_.structure.elements();
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (w_.state.broken[i]) continue;
        const Element& e = elements[i];
        Bar bar{int(i), Vec3::Constant(std::numeric_limits<double>::infinity()), {}, 0};
        bar.high = -bar.low;
        for (const int n : e.node) {
            for (const Vec3& x : {place(n, last_), place(n, w_.state.displacement)})
                bar.low = bar.low.cwiseMin(x), bar.high = bar.high.cwiseMax(x);
            bar.moved = std::max(bar.moved, (w_.state.displacement[n] - last_[n]).norm());
        }
        bar.low.array() -= e.radius, bar.high.array() += e.radius;
        bars.push_back(bar);
    }
}

/// Sorts the boxes along the longest side of the scene and compares those that overlap.
void PassedMembers::compare(double time, Found& found) const {
    std::vector<Bar> bars;
    list_bars(bars);
    if (bars.empty()) return;
    Vec3 low = bars[0].low, high = bars[0].high;
    for (const Bar& b : bars) low = low.cwiseMin(b.low), high = high.cwiseMax(b.high);
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    std::sort(bars.begin(), bars.end(), [&](const Bar& a, const Bar& b) { return a.low[axis] < b.low[axis]; });
    for (std::size_t i = 0; i < bars.size(); ++i)
        for (std::size_t j = i + 1; j < bars.size() && bars[j].low[axis] <= bars[i].high[axis]; ++j) {
            const Bar &a = bars[i], &b = bars[j];
            if (!(a.moved + b.moved > 0) || (a.low.array() > b.high.array()).any() ||
                (b.low.array() > a.high.array()).any())
                continue;
            compare(a, b, time, found);
        }
}

/// Compares two bars at places along the straight way of their nodes since the last time.
void PassedMembers::compare(const Bar& bar_a, const Bar& bar_b, double time, Found& found) const {
    const Element &a = w_.structure.elements()[bar_a.element], &b = w_.structure.elements()[bar_b.element];
    const std::pair<int, int> pair = std::minmax(a.member, b.member);
    if (pair.first == pair.second || found.size() >= most_meetings || found.count(pair) > 0 ||
        !may_meet(pair.first, pair.second))
        return;
    const double sum = a.radius + b.radius;
    const auto at = [&](int node, double part) {
        return Vec3((1 - part) * place(node, last_) + part * place(node, w_.state.displacement));
    };
    const auto begins_apart = contact::distance(place(a.node[0], start_), place(a.node[1], start_),
                                                place(b.node[0], start_), place(b.node[1], start_));
    if (!(begins_apart > sum)) return;
    const int places =
        int(std::clamp(std::ceil((bar_a.moved + bar_b.moved) / (between_places * sum)), 1.0, double(most_places)));
    for (int i = 1; i <= places; ++i) {
        const double part = double(i) / places;
        const Vec3 a0 = at(a.node[0], part), a1 = at(a.node[1], part);
        const contact::Closest closest = contact::closest_points(a0, a1, at(b.node[0], part), at(b.node[1], part));
        if (!(closest.distance < deep * sum)) continue;
        found[pair] = {time, a0 + closest.s * (a1 - a0)};
        return;
    }
}

/// Whether these members can be in each other's way, and no rule holds them apart.
bool PassedMembers::may_meet(int member_a, int member_b) const {
    const auto& members = w_.structure.model().members();
    const MemberData &a = members[member_a], &b = members[member_b];
    const bool held_apart = w_.kind.dynamic && contact_rule(contact_rules(w_.structure.model()), a, b) >= 0;
    return !share_node(a, b) && !held_apart &&
           !std::binary_search(linked_.begin(), linked_.end(), std::pair(member_a, member_b));
}

void PassedMembers::list_findings(const Run&, std::vector<Warning>& list) const {
    Found all = found_;
    // what has moved since the last look, unless it is less than any two bars need to meet
    if (moved_since_last() > between_places * thinnest_)
        compare(w_.kind.dynamic ? w_.state.time : w_.state.factor, all);
    if (all.empty()) return;
    const auto first = std::min_element(all.begin(), all.end(),
                                        [](const auto& a, const auto& b) { return a.second.time < b.second.time; });
    const Model& model = w_.structure.model();
    const auto [a, b] = first->first;
    const long others = long(all.size()) - 1;
    const auto group = [&](int m) {
        const auto& groups = model.members()[m].groups;
        return groups.empty() ? std::string() : "'" + model.groups()[groups[0]] + "'";
    };
    const bool named = !group(a).empty() && !group(b).empty();
    if (w_.goes_by_load_factor()) {
        list.push_back(
            {Warning::Kind::contact,
             member_text(model, a) + " and " + member_text(model, b) + " passed through each other by load factor " +
                 number_text(first->second.time, 4) + " near " + place_text(first->second.at) +
                 (others > 0 ? ", and " + count_text(others, "more pair") + " of members later" : "") +
                 ": contact acts in dynamics alone",
             "a slow dynamic run with model:contact has them in each other's way", line_of_member(model, a)});
        return;
    }
    const std::string rule = !named ? "model:contact {}"
                             : group(a) == group(b)
                                 ? "model:contact { groups = { " + group(a) + " } }"
                                 : "model:contact { between = { " + group(a) + ", " + group(b) + " } }";
    list.push_back(
        {Warning::Kind::contact,
         member_text(model, a) + " and " + member_text(model, b) + " passed through each other by t = " +
             number_text(first->second.time, 4) + " s near " + place_text(first->second.at) +
             (others > 0 ? ", and " + count_text(others, "more pair") + " of members later" : "") + ": " +
             (contact_rules(model).empty() ? "the model has no contact" : "no rule of model:contact is for them"),
         "declare " + rule + ", or model:contact {} for all members", line_of_member(model, a)});
}

bool PassedMembers::fits(const Run&) const {
    const std::size_t nodes = w_.structure.position().size();
    const int members = int(w_.structure.model().members().size());
    return start_.size() == nodes && last_.size() == nodes &&
           std::all_of(found_.begin(), found_.end(), [&](const auto& f) {
               return f.first.first >= 0 && f.first.first < f.first.second && f.first.second < members;
           });
}

}  // namespace

std::unique_ptr<Adviser> advise_of_passed_members(const Run& run, WarningLog&) {
    if (!built::contact || !has_pair_without_rule(run.structure(), run.workspace().kind.dynamic)) return nullptr;
    return std::make_unique<PassedMembers>(run.workspace());
}

}  // namespace hinge

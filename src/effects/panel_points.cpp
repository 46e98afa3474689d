#include "effects/panel_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "contact/broad_phase.h"
#include "effects/declared.h"

namespace hinge {
namespace {

/// Frequency of a point's mass on its spring, rad/s. Chosen, not measured: a contact takes 8 ms, so that steps of 1 ms
/// show it; what rests on a panel sinks by 0.06 mm, a slab that has fallen by 3 m goes 19 mm deep.
constexpr double frequency = 400;
/// A spring is no stiffer than this part of E t of the panel, which is that of a point without mass.
constexpr double most_stiffness = 0.1;
constexpr int most_divisions = 16;  ///< of what is longer than the smallest panel is wide

PanelContactRule rule_of(const Model& model) {
    const auto& rules = model.declared<PanelContactRule>(panel_contact_effect);
    return rules.empty() ? PanelContactRule{} : rules.front();
}

}  // namespace

PanelPoints::PanelPoints(const Structure& s)
    : structure_(s),
      rule_(rule_of(s.model())),
      damping_(contact::damping_for(rule_.restitution)),
      panels_(s.model().declared<Panel>(panels_effect)) {
    const std::size_t nodes = s.position().size();
    std::vector<double> radius(nodes, -1);
    smallest_ = std::numeric_limits<double>::infinity();
    for (const Panel& p : panels_) {
        half_.push_back(0.5 * p.sheet->thickness());
        for (const int n : p.nodes) radius[std::size_t(n)] = std::max(radius[std::size_t(n)], half_.back());
        for (std::size_t k = 0; k < p.nodes.size(); ++k)
            smallest_ = std::min(smallest_, (at(p, k + 1) - at(p, k)).norm());
    }
    for (const Element& e : s.elements())
        for (const int n : e.node) {
            double& r = radius[std::size_t(n)];
            if (rule_.members || r >= 0) r = std::max(r, e.radius);
        }
    for (std::size_t n = 0; n < nodes; ++n)
        if (radius[n] >= 0) points_.push_back({{int(n)}, {1.0}, radius[n]});
    for (std::size_t p = 0; p < panels_.size(); ++p) add_points_of(int(p));
    for (std::size_t e = 0; rule_.members && e < s.elements().size(); ++e) add_points_of(s.elements()[e], int(e));
    find_masses();
    near_.resize(nodes);
    const auto join = [&](int a, int b) { near_[std::size_t(a)].push_back(b); };
    for (const Panel& p : panels_)
        for (const int a : p.nodes)
            for (const int b : p.nodes) join(a, b);
    const auto own = [&](int n) { return s.declared_node(n) >= 0 ? s.declared_node(n) : n; };  // of an end at a joint
    for (const Element& e : s.elements())
        for (const int a : e.node)
            for (const int b : e.node) join(a, own(b)), join(own(a), own(b));
    for (auto& list : near_) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
}

void PanelPoints::find_masses() {
    mass_.resize(structure_.position().size(), 0);
    for (const AddedMass& added : added_masses(structure_.model())) mass_[std::size_t(added.node)] += added.mass.mass;
    for (const Element& e : structure_.elements())
        for (const int n : e.node) mass_[std::size_t(n)] += 0.5 * e.mass();
    std::vector<char> takes_part(mass_.size(), 0);
    for (PanelPoint& p : points_)
        for (std::size_t k = 0; k < p.node.size(); ++k)
            p.mass += p.part[k] * mass_[std::size_t(p.node[k])], takes_part[std::size_t(p.node[k])] = 1;
    for (const Panel& p : panels_) {
        panel_mass_.push_back(0);
        for (const int n : p.nodes) panel_mass_.back() += mass_[std::size_t(n)] / double(p.nodes.size());
    }
    for (std::size_t n = 0; n < mass_.size(); ++n)
        if (!takes_part[n]) mass_[n] = -1;
}

contact::PressLaw PanelPoints::law(int point, int panel) const {
    const PanelPoint& p = points_[std::size_t(point)];
    double k = rule_.stiffness;
    if (k == 0) {
        // of the lighter one; what has no mass leaves it to the other
        const double other = panel_mass_[std::size_t(panel)];
        const double mass = p.mass > 0 && other > 0 ? std::min(p.mass, other) : std::max(p.mass, other);
        const double most = most_stiffness * panels_[std::size_t(panel)].sheet->stiffness();
        k = mass > 0 ? std::min(most, mass * frequency * frequency) : most;
    }
    return {p.softer * k, damping_, rule_.friction};
}

double PanelPoints::stiffest(int node) const {
    const double k = rule_.stiffness > 0 ? rule_.stiffness : mass_[std::size_t(node)] * frequency * frequency;
    return contact::PressLaw{k, damping_}.steepest();
}

bool PanelPoints::belongs(int point, int panel) const {
    const auto& own = panels_[std::size_t(panel)].nodes;
    for (const int n : points_[std::size_t(point)].node)
        for (const int m : own)
            if (n == m || std::binary_search(near_[std::size_t(n)].begin(), near_[std::size_t(n)].end(), m))
                return true;
    return false;
}

std::vector<PanelTouch> PanelPoints::near(const State& s, const std::vector<Vec3>* before, double margin) const {
    struct Earlier {
        const std::vector<Vec3>& displacement;
    };
    std::vector<contact::Box> boxes;
    std::vector<int> of;  // the panel, or -1 - the point
    const auto add = [&](auto list_places, double by, int what) {
        Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
        const auto take = [&](const Vec3& x) { low = low.cwiseMin(x), high = high.cwiseMax(x); };
        list_places(s, take);
        if (before) list_places(Earlier{*before}, take);
        boxes.emplace_back(low - Vec3::Constant(by), high + Vec3::Constant(by)), of.push_back(what);
    };
    for (int p = 0; p < int(panels_.size()); ++p) {
        if (torn(s, p)) continue;
        const auto corners_at = [&](const auto& pose, auto take) {
            for (const int n : panels_[std::size_t(p)].nodes) take(place(pose, n));
        };
        add(corners_at, half(p) + margin, p);
    }
    for (int i = 0; i < int(points_.size()); ++i) {
        const PanelPoint& p = points_[std::size_t(i)];
        if (is_there(s, p)) add([&](const auto& pose, auto take) { take(place(pose, p)); }, p.radius, -1 - i);
    }
    const auto low = [&](int a, int b) { return -1 - std::min(of[std::size_t(a)], of[std::size_t(b)]); };
    const auto high = [&](int a, int b) { return std::max(of[std::size_t(a)], of[std::size_t(b)]); };
    std::vector<PanelTouch> list;
    for (const auto& [a, b] : contact::overlapping(boxes, [&](int i, int j) {
             return low(i, j) >= 0 && high(i, j) >= 0 && !belongs(low(i, j), high(i, j));
         })) {
        list.emplace_back();
        list.back().point = low(a, b), list.back().panel = high(a, b);
    }
    std::sort(list.begin(), list.end());
    return list;
}

std::vector<int> PanelPoints::surfaces(const State& s) const {
    std::vector<int> first(structure_.position().size());
    std::iota(first.begin(), first.end(), 0);
    const auto root = [&](int n) {
        while (first[std::size_t(n)] != n) n = first[std::size_t(n)] = first[std::size_t(first[std::size_t(n)])];
        return n;
    };
    for (std::size_t p = 0; p < panels_.size(); ++p)
        if (!torn(s, int(p)))
            for (const int n : panels_[p].nodes) first[std::size_t(root(n))] = root(panels_[p].nodes[0]);
    std::vector<int> surface;
    for (const Panel& p : panels_) surface.push_back(root(p.nodes[0]));
    return surface;
}

int PanelPoints::divisions(double length) const {
    return std::clamp(int(std::ceil(length / smallest_ - 1e-6)), 1, most_divisions);
}
void PanelPoints::add_points_of(int index) {
    const Panel& p = panels_[std::size_t(index)];
    double longest = 0;
    for (std::size_t k = 0; k < p.nodes.size(); ++k) longest = std::max(longest, (at(p, k + 1) - at(p, k)).norm());
    const int n = divisions(longest);
    const bool quad = p.nodes.size() == 4;
    const double softer = 1.0 / (n * n);
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= (quad ? n : n - i); ++j) {
            const double s = double(i) / n, t = double(j) / n;
            std::vector<double> part =
                quad ? std::vector{(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t} : std::vector{1 - s - t, s, t};
            if (*std::max_element(part.begin(), part.end()) > 1 - 1e-9) continue;  // a corner
            points_.push_back({p.nodes, part, half_[std::size_t(index)], softer, -1, index});
        }
}
void PanelPoints::add_points_of(const Element& e, int index) {
    const int n = divisions(e.length);
    for (int i = 1; i < n; ++i) {
        const double t = double(i) / n;
        points_.push_back({{e.node[0], e.node[1]}, {1 - t, t}, e.radius, 1.0 / n, index, -1});
    }
}

PanelPress pressing_on_panels(const Structure& structure, const State& state) {
    const PanelPoints parts(structure);
    PanelPress sum;
    for (const PanelTouch& t : state.data.find<PanelContactNow>(panel_contact_effect)->touches) {
        if (!t.over) continue;
        const double depth = parts.depth(t, parts.foot(state, t));
        if (!(depth > 0)) continue;
        ++sum.points, sum.force += contact::pressed(parts.law(t.point, t.panel), t.press, depth, 0).press.force,
            sum.depth = std::max(sum.depth, depth);
    }
    return sum;
}

}  // namespace hinge

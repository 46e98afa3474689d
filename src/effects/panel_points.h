// Points that may press on panels: where they are, how thick, how stiff; and where they stand over a panel.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "contact/point_on_panel.h"
#include "effects/panel_contact.h"
#include "effects/panels.h"
#include "model/structure.h"

namespace hinge {

/// A point between nodes.
struct PanelPoint {
    std::vector<int> node;
    std::vector<double> part;
    double radius = 0;             ///< half of its thickness, m
    double softer = 1;             ///< of the stiffness, where a panel has several points for a node
    int element = -1, panel = -1;  ///< inside of it; a node has neither
    double mass = 0;               ///< kg, at its nodes
};

/// What of a structure may touch panels. Nothing of it changes in a run.
class PanelPoints {
public:
    explicit PanelPoints(const Structure& structure);

    const PanelContactRule& rule() const { return rule_; }
    const std::vector<Panel>& panels() const { return panels_; }
    const std::vector<PanelPoint>& points() const { return points_; }
    double smallest() const { return smallest_; }
    double half(int panel) const { return half_[std::size_t(panel)]; }
    /// The distance at which a point touches a panel, m.
    double reach(int point, int panel) const { return points_[std::size_t(point)].radius + half(panel); }
    /// Of a point on a panel.
    contact::PressLaw law(int point, int panel) const;
    /// Whether a point or a panel has the node, and the largest stiffness of its contacts, N/m.
    bool may_press(int node) const { return mass_[std::size_t(node)] >= 0; }
    double stiffest(int node) const;
    /// Whether a node of the panel belongs to the point, or is joined to one that does.
    bool belongs(int point, int panel) const;
    /// Points and panels whose boxes come within `margin`, m, of each other, also on the straight way from `before`,
    /// the displacements of an earlier time. By point, then by panel.
    std::vector<PanelTouch> near(const State& s, const std::vector<Vec3>* before, double margin) const;
    /// A number for each panel: panels that share nodes are one surface, and have the same.
    std::vector<int> surfaces(const State& s) const;
    /// Whether what a point belongs to is whole.
    bool is_there(const State& s, const PanelPoint& p) const {
        if (p.element >= 0) return !s.broken[p.element];
        if (p.panel >= 0) return !torn(s, p.panel);
        return !s.gone[p.node[0]];
    }
    bool torn(const State& s, int panel) const {
        return is_torn(*panels_now(s), panels_[std::size_t(panel)], std::size_t(panel));
    }
    /// Whether it is of this structure: a run may go on from one that had other panels.
    bool fits(const PanelContactNow& n) const {
        return n.points == int(points_.size()) && n.panels == int(panels_.size()) &&
               std::all_of(n.touches.begin(), n.touches.end(), [&](const PanelTouch& t) {
                   return t.point >= 0 && t.point < n.points && t.panel >= 0 && t.panel < n.panels;
               });
    }
    int torn_panels(const State& s) const {
        const PanelsNow& now = *panels_now(s);
        int torn = 0;
        for (std::size_t p = 0; p < panels_.size(); ++p) torn += is_torn(now, panels_[p], p);
        return torn;
    }
    template <class At>
    Vec3 place(const At& pose, int node) const {
        return structure_.position()[node] + pose.displacement[node];
    }
    template <class At>
    Vec3 place(const At& pose, const PanelPoint& p) const {
        Vec3 x = Vec3::Zero();
        for (std::size_t i = 0; i < p.node.size(); ++i) x += p.part[i] * place(pose, p.node[i]);
        return x;
    }
    template <class At>
    std::array<Vec3, 4> corners(const At& pose, int panel) const {
        std::array<Vec3, 4> list;
        const auto& nodes = panels_[std::size_t(panel)].nodes;
        for (std::size_t k = 0; k < nodes.size(); ++k) list[k] = place(pose, nodes[k]);
        return list;
    }
    std::span<const Vec3> span(const std::array<Vec3, 4>& corners, int panel) const {
        return {corners.data(), panels_[std::size_t(panel)].nodes.size()};
    }
    template <class At>
    contact::Foot foot(const At& pose, const PanelTouch& t) const {
        const auto all = corners(pose, t.panel);
        return contact::foot_of(span(all, t.panel), place(pose, points_[std::size_t(t.point)]));
    }
    double depth(const PanelTouch& t, const contact::Foot& foot) const {
        return reach(t.point, t.panel) - t.side * foot.height - t.level;
    }

private:
    Vec3 at(const Panel& p, std::size_t k) const { return structure_.position()[p.nodes[k % p.nodes.size()]]; }
    int divisions(double length) const;
    void add_points_of(int panel);
    void add_points_of(const Element& e, int index);
    void find_masses();

    const Structure& structure_;
    PanelContactRule rule_;  ///< as a script declares it, or the default one
    double damping_;         ///< contact::damping_for its restitution
    const std::vector<Panel>& panels_;
    std::vector<PanelPoint> points_;
    std::vector<double> mass_;            ///< kg, of each node; -1: neither a panel nor a point has it
    std::vector<double> panel_mass_;      ///< kg, the mean of each panel's nodes
    std::vector<double> half_;            ///< m, of the thickness of each panel
    std::vector<std::vector<int>> near_;  ///< of each node, those that a member or a panel joins to it, rising
    double smallest_;
};

}  // namespace hinge

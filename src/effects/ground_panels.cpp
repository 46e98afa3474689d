// Panels on the ground: their nodes are points on springs, which give a part of their energy back
// (contact/press_law.h). A plane that is a layer has a spring of its stiffness times the area that belongs to the node,
// and gives back what its damping would leave of the node's mass on it. Friction is that of all points
// (contact/ground_friction.h).
#include <algorithm>
#include <cmath>

#include "effects/ground_law.h"
#include "effects/panels.h"

namespace hinge {
namespace {

using contact::PressedEnd;
using contact::PressLaw;

/// Speed that a mass comes back with from a layer, over the one with which it came: that of a damped swing.
double restitution_of(const GroundPlane& plane, double area, double mass) {
    const double damping = 0.5 * plane.layer_damping * std::sqrt(area / (plane.layer_stiffness * mass));
    return damping < 1 ? std::exp(-M_PI * damping / std::sqrt(1 - damping * damping)) : 0;
}

class GroundPanels : public GroundLaw {
public:
    GroundPanels(Workspace& w, Host& host) : GroundLaw(w), host_(host) {}

    void list(GroundData& to) const override {
        const Model& model = w_.structure.model();
        std::vector<double> area(w_.structure.position().size(), 0), half(area), mass(area);
        for (const Panel& p : model.declared<Panel>(panels_effect)) {
            const panel::Shape shape = shape_of_panel(model, p);
            for (std::size_t k = 0; k < p.nodes.size(); ++k) {
                const std::size_t n = std::size_t(p.nodes[k]);
                area[n] += shape.share[k], half[n] = std::max(half[n], 0.5 * p.sheet->thickness());
            }
        }
        for (const AddedMass& added : added_masses(model)) mass[std::size_t(added.node)] += added.mass.mass;
        for (int i = 0; i < int(planes_.size()); ++i)
            for (std::size_t n = 0; n < area.size(); ++n) {
                if (area[n] == 0 || planes_[i].group >= 0 || w_.state.gone[n]) continue;
                const GroundPlane& plane = planes_[i];
                GroundPanelPoint p;
                p.plane = i, p.end.node = int(n), p.end.radius = half[n];
                p.stiffness = plane.stiffness > 0 ? plane.stiffness : plane.layer_stiffness * area[n];
                const double restitution = !plane.is_layer() ? plane.restitution.value_or(1)
                                           : mass[n] > 0     ? restitution_of(plane, area[n], mass[n])
                                                             : 1;
                p.damping = contact::damping_for(std::max(restitution, contact::least_restitution));
                p.press.depth = begin_at(p.end, plane) - p.end.level;
                to.panels.push_back(p);
            }
    }

    void begin(const Step& step) override { dt_ = step.dt; }
    void add_forces(std::vector<Vec6>& resisting) override {
        pressed.begin();
        ends_.resize(points().size());
        for (std::size_t i = 0; i < points().size(); ++i) {
            const GroundPanelPoint& p = points()[i];
            const PressedEnd& e = ends_[i] = w_.rests(p.end.node) ? PressedEnd() : end_at(p);
            if (!e.touches()) continue;
            pressed.add(i);
            resisting[p.end.node].head<3>() += -e.press.force * plane(p).normal + law(p).along() * e.slip;
        }
    }
    void add_blocks(Blocks& blocks) const override {
        for (std::size_t i = 0; i < ends_.size(); ++i)
            if (ends_[i].touches()) add_slope(points()[i], ends_[i].press.slope, !ends_[i].slides, blocks);
    }
    void add_stiffest(Blocks& most) const override {
        for (const GroundPanelPoint& p : points())
            if (!is_held(p.end.node)) add_slope(p, law(p).steepest(), true, most);
    }
    bool has_converged() const override {
        for (std::size_t i = 0; i < ends_.size(); ++i)
            if (!w_.rests(points()[i].end.node) && !ends_[i].agrees(law(points()[i]), end_at(points()[i])))
                return false;
        return true;
    }
    bool touches_within(const Step& step) const override {
        return std::any_of(points().begin(), points().end(),
                           [&](const GroundPanelPoint& p) { return GroundLaw::touches_within(p.end, plane(p), step); });
    }

    void end(const Step& step) override {
        lost_ = 0;
        double work = 0;
        bool any = false;
        for (std::size_t i = 0; i < ends_.size(); ++i) {
            const GroundPanelPoint& p = points()[i];
            if (w_.rests(p.end.node)) continue;
            ends_[i] = end_at(p);
            const contact::PressedStep done = contact::end_of_step(law(p), p.press, ends_[i], step.dt);
            lost_ += done.lost;
            if (done.missed.impulse == 0) continue;
            if (!any) impulse_.assign(w_.trial.velocity.size(), Vec6::Zero()), any = true;
            impulse_[p.end.node].head<3>() += done.missed.impulse * plane(p).normal;
            work += done.missed.work;
        }
        if (!any) return;
        const ImpulseResponse k = host_.respond(impulse_);
        if (k.square > 0) add_to_trial(w_, k.factor_for(work), k);
    }
    double lost() const override {
        double heat = 0;
        for (const PressedEnd& e : ends_) heat += e.heat;
        return w_.kind.dynamic ? lost_ : heat;
    }
    void before_commit() override {
        for (std::size_t i = 0; i < ends_.size(); ++i) {
            GroundPanelPoint& p = points()[i];
            if (w_.rests(p.end.node)) continue;
            contact::keep(ends_[i], p.press, p.end.level);
            const double inside = p.end.radius - place_at(p, w_.trial);
            if (p.end.left_out && !w_.state.gone[p.end.node] && inside < 0)  // it has left the ground
                p.end.left_out = false, p.end.level = 0, p.press = {.depth = inside};
        }
        lost_ = 0;
    }
    void roll_back() override { lost_ = 0; }
    double broke(const Break&) override {
        double lost = 0;
        for (GroundPanelPoint& p : points()) {
            if (!w_.state.gone[p.end.node] || p.end.left_out) continue;
            lost += p.press.stored(law(p), p.press.depth);
            p.end.left_out = true, p.press = {.depth = -p.end.radius};
        }
        return lost;
    }
    void hold_up(const Bodies& bodies, std::vector<char>& held_up) const override {
        for (const GroundPanelPoint& p : points())
            if (const int body = bodies.of_node[p.end.node]; body >= 0 && !is_out(p) && p.press.depth > 0)
                held_up[body] = 1;
    }
    void rest_changed() override {
        for (GroundPanelPoint& p : points())
            if (w_.rests(p.end.node)) p.press.rate = 0;
    }
    double stored(const State& state) const override {
        double sum = 0;
        for (const GroundPanelPoint& p : state.data.find<GroundData>(ground_effect)->panels)
            if (!is_out(p)) sum += p.press.stored(law(p), p.end.radius - p.end.level - place_at(p, state));
        return sum;
    }
    std::string name_of_first() const override { return w_.structure.node_name(points()[pressed.first].end.node); }
    void restored() override { ends_.clear(); }

private:
    std::vector<GroundPanelPoint>& points() const { return data().panels; }
    const GroundPlane& plane(const GroundPanelPoint& p) const { return planes_[p.plane]; }
    PressLaw law(const GroundPanelPoint& p) const { return {p.stiffness, p.damping, plane(p).friction}; }
    bool is_out(const GroundPanelPoint& p) const {
        return p.end.left_out || is_held(p.end.node) || w_.state.gone[p.end.node];
    }
    /// Height above the plane, m.
    template <class At>
    double place_at(const GroundPanelPoint& p, const At& at) const {
        return plane(p).normal.dot(w_.structure.position()[p.end.node] + at.displacement[p.end.node] - plane(p).point);
    }
    /// At the trial.
    PressedEnd end_at(const GroundPanelPoint& p) const {
        PressedEnd e;
        if (is_out(p)) return e.depth = -p.end.radius, e;
        e = contact::pressed(law(p), p.press, p.end.radius - p.end.level - place_at(p, w_.trial),
                             w_.at_state ? 0 : dt_);
        if (!contact::rubs(law(p), p.press, e)) return e;
        const Vec3 moved = w_.trial.displacement[p.end.node] - w_.state.displacement[p.end.node];
        const Vec3& n = plane(p).normal;
        contact::rub(law(p), p.press, p.press.slip, moved - moved.dot(n) * n, e);
        return e;
    }
    void add_slope(const GroundPanelPoint& p, double slope, bool sticks, Blocks& blocks) const {
        Mat6 K = Mat6::Zero();
        K.topLeftCorner<3, 3>() = contact::slope_of(law(p), plane(p).normal, slope, sticks);
        blocks.stiffness(p.end.node, K);
    }

    Host& host_;
    std::vector<PressedEnd> ends_;  ///< of each point, where forces were found last
    std::vector<Vec6> impulse_;
    double dt_ = 0;    ///< s, of the step
    double lost_ = 0;  ///< J, in the step that ends
};

}  // namespace

std::unique_ptr<GroundLaw> ground_panels(Workspace& w, Host& host) { return std::make_unique<GroundPanels>(w, host); }

}  // namespace hinge

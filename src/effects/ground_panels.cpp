// Panels on the ground: their nodes are points on springs, which give a part of their energy back
// (contact/press_law.h). A plane that is a layer has a spring of its stiffness times the area that belongs to the node,
// and gives back what its damping would leave of the node's mass on it. Friction is that of all points
// (contact/ground_friction.h).
#include <algorithm>
#include <cmath>

#include "contact/ground_friction.h"
#include "contact/press_law.h"
#include "effects/ground_law.h"
#include "effects/panels.h"

namespace hinge {
namespace {

using contact::Press;

/// A point at a pose.
struct PressedPoint {
    double depth = 0;  ///< m, less the level; negative: apart
    Press press;
    Vec3 slip = Vec3::Zero();
    bool slides = false;
    double rate = 0;  ///< m/s, at which it goes deeper
    double heat = 0;  ///< J
};

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
                p.end.stiffness = contact::tangential_part * p.stiffness;
                p.depth = begin_at(p.end, plane) - p.end.level;
                to.panels.push_back(p);
            }
    }

    void begin(const Step& step) override { dt_ = step.dt; }
    void add_forces(std::vector<Vec6>& resisting) override {
        pressed.begin();
        touches_.resize(points().size());
        for (std::size_t i = 0; i < points().size(); ++i) {
            const GroundPanelPoint& p = points()[i];
            const PressedPoint& t = touches_[i] = touch(p, w_.trial);
            if (!(t.depth > 0)) continue;
            pressed.add(i);
            resisting[p.end.node].head<3>() += -t.press.force * plane(p).normal + p.end.stiffness * t.slip;
        }
    }
    void add_blocks(Blocks& blocks) const override {
        for (std::size_t i = 0; i < touches_.size(); ++i)
            if (touches_[i].depth > 0) add_slope(points()[i], touches_[i].press.slope, !touches_[i].slides, blocks);
    }
    void add_stiffest(Blocks& most) const override {
        for (const GroundPanelPoint& p : points())
            if (!is_held(p.end.node)) add_slope(p, p.stiffness * (1 + p.damping), true, most);
    }
    bool has_converged() const override {
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const GroundPanelPoint& p = points()[i];
            const PressedPoint now = touch(p, w_.trial);
            if ((now.depth > 0) != (touches_[i].depth > 0)) return false;
            if (!touches_[i].press.foretells(now.press, now.depth - touches_[i].depth)) return false;
            const double most = plane(p).friction * now.press.force;
            if (most > 0 && p.end.stiffness * (now.slip - touches_[i].slip).norm() > contact::same_friction * most)
                return false;
        }
        return true;
    }
    bool touches_within(const Step& step) const override {
        return std::any_of(points().begin(), points().end(),
                           [&](const GroundPanelPoint& p) { return GroundLaw::touches_within(p.end, plane(p), step); });
    }

    /// What the step has missed of the energy stored and lost, as an impulse (effects/panel_contact.cpp).
    void end(const Step& step) override {
        lost_ = 0;
        double work = 0;
        bool any = false;
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const GroundPanelPoint& p = points()[i];
            const PressedPoint& t = touches_[i] = touch(p, w_.trial);
            const Press before = contact::press(p.stiffness, p.damping, p.depth, p.rate, p.fastest, 0);
            lost_ += Press::lost(before, t.press, t.depth - p.depth) + t.heat;
            const contact::Missed m = contact::missed(before, p.depth, t.press, t.depth, step.dt);
            if (m.impulse == 0) continue;
            if (!any) impulse_.assign(w_.trial.velocity.size(), Vec6::Zero()), any = true;
            impulse_[p.end.node].head<3>() += m.impulse * plane(p).normal;
            work += m.work;
        }
        if (!any) return;
        const ImpulseResponse k = host_.respond(impulse_);
        if (k.square > 0) add_to_trial(w_, k.factor_for(work), k);
    }
    double lost() const override { return lost_; }
    void before_commit() override {
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            GroundPanelPoint& p = points()[i];
            const PressedPoint& t = touches_[i];
            p.depth = t.depth, p.rate = t.rate, p.fastest = t.press.fastest, p.end.slip = t.slip;
            if (!(p.depth < 0)) continue;
            const double less = std::min(p.end.level, -p.depth);
            p.end.level -= less, p.depth += less;
            if (p.end.left_out && p.depth < 0) p.end.left_out = false;
        }
        lost_ = 0;
    }
    void roll_back() override { lost_ = 0; }
    double broke(const Break&) override {
        double lost = 0;
        for (GroundPanelPoint& p : points()) {
            if (!w_.state.gone[p.end.node] || p.end.left_out) continue;
            lost += stored_by(p, p.depth, p.end.slip);
            p.end.left_out = true, p.depth = -p.end.radius, p.rate = p.fastest = 0, p.end.slip.setZero();
        }
        return lost;
    }
    double stored(const State& state) const override {
        double sum = 0;
        for (const GroundPanelPoint& p : state.data.find<GroundData>(ground_effect)->panels) {
            const Vec3 place = w_.structure.position()[p.end.node] + state.displacement[p.end.node];
            if (!is_held(p.end.node) && !state.gone[p.end.node])
                sum += stored_by(p, overlap_of(p.end, plane(p), place), p.end.slip);
        }
        return sum;
    }
    std::string name_of_first() const override { return w_.structure.node_name(points()[pressed.first].end.node); }
    void restored() override { touches_.clear(); }

private:
    std::vector<GroundPanelPoint>& points() const { return data().panels; }
    const GroundPlane& plane(const GroundPanelPoint& p) const { return planes_[p.plane]; }
    static double stored_by(const GroundPanelPoint& p, double depth, const Vec3& slip) {
        return contact::press(p.stiffness, p.damping, depth, 0, 0, 0).stored +
               0.5 * p.end.stiffness * slip.squaredNorm();
    }
    template <class At>
    PressedPoint touch(const GroundPanelPoint& p, const At& at) const {
        PressedPoint t;
        t.depth = -p.end.radius;
        if (is_held(p.end.node) || w_.state.gone[p.end.node]) return t;
        const Vec3& n = plane(p).normal;
        const Vec3 place = w_.structure.position()[p.end.node] + at.displacement[p.end.node];
        t.depth = overlap_of(p.end, plane(p), place);
        t.rate = w_.at_state ? p.rate : dt_ > 0 ? (t.depth - p.depth) / dt_ : 0;
        t.press = contact::press(p.stiffness, p.damping, t.depth, t.rate, p.fastest, dt_);
        if (plane(p).friction == 0 || (!(t.depth > 0) && p.end.slip.isZero(0))) return t;
        Vec3 moved = at.displacement[p.end.node] - w_.state.displacement[p.end.node];
        moved -= moved.dot(n) * n;
        const double part = p.depth > 0 || !(t.depth > 0) ? 1 : t.depth / (t.depth - p.depth);
        const contact::Friction f =
            contact::friction(p.end.slip, moved, part, p.end.stiffness, plane(p).friction * t.press.force);
        t.slip = f.slip, t.slides = f.slides, t.heat = f.heat;
        return t;
    }
    void add_slope(const GroundPanelPoint& p, double slope, bool sticks, Blocks& blocks) const {
        const Vec3& n = plane(p).normal;
        Mat6 K = Mat6::Zero();
        K.topLeftCorner<3, 3>() = slope * n * n.transpose();
        if (plane(p).friction > 0 && sticks)
            K.topLeftCorner<3, 3>() += p.end.stiffness * (Mat3::Identity() - n * n.transpose());
        blocks.stiffness(p.end.node, K);
    }

    Host& host_;
    std::vector<PressedPoint> touches_;
    std::vector<Vec6> impulse_;
    double dt_ = 0;    ///< s, of the step
    double lost_ = 0;  ///< J, in the step that ends
};

}  // namespace

std::unique_ptr<GroundLaw> ground_panels(Workspace& w, Host& host) { return std::make_unique<GroundPanels>(w, host); }

}  // namespace hinge

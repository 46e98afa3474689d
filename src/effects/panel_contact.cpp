// Contact of panels: points of other panels and of members press on them (model:panel_contact).
//
// Points are the nodes of panels and of members, and more between these where they are farther apart than the smallest
// panel is wide. A point that comes closer to the middle surface of a panel than the half thicknesses of both is pushed
// back along the surface's normal, on the side from which it came, however deep it is (contact/press_law.h). The force
// and its counterpart, in the parts of the foot's place at the corners, have the same line: momentum is kept, linear
// and angular. Friction's spring stretches between the point and the place of the panel's own points that it touched
// when the step began; its forces are the gradient of that length.
//
// Of panels that share nodes, which are one surface, a point presses on the one that it stands over. Panels that have a
// node of the point's own members or panels do not meet it.
#include "effects/panel_contact.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "effects/kinds.h"
#include "effects/panel_points.h"

namespace hinge {
namespace {

using contact::Foot;
using contact::PressedEnd;

/// A point that presses on a panel stays on it until its foot is that far outside, as long as it is over no other.
constexpr double held_beyond = 0.02;
/// Of the gap over which a point cannot touch: panels that are warped may be nearer than the height over them says.
constexpr double part_of_gap = 0.5;
constexpr double steps_of_list = 50;   ///< the list of what is near holds for about so many
constexpr double lies_within = 0.002;  ///< of a point's reach: what is no further apart lies on each other

/// A touch at the end of a step, as far as it has been solved.
struct Touched : PressedEnd {
    Foot foot, before;  ///< before: where its foot was when the step began, on the panel as it is now
    double arm = 0;     ///< height of the point over the place that it touched, where the step began, m
};

class PanelContact : public Effect,
                     public Force,
                     public ContactLaw,
                     public BreakListener,
                     public StepLimiter,
                     public Sleeper {
public:
    PanelContact(Workspace& w, Host& host)
        : Effect(panel_contact_effect, w, host, {.forces_vanish = true}), parts_(w.structure) {
        const auto* there = w.state.data.find<PanelContactNow>(panel_contact_effect);
        if (there && parts_.fits(*there)) drop_what_is_gone();
        else w.state.data.set(panel_contact_effect, empty());
    }

    // ---- before a step --------------------------------------------------------------------------------------------
    bool detect_contacts(const Step& step) override {
        dt_ = step.dt;
        PanelContactNow& n = now();
        double fastest = 0;
        for (std::size_t i = 0; i < w_.state.velocity.size(); ++i)
            fastest = std::max(
                fastest, (w_.state.velocity[i] + 0.5 * step.dt * w_.state.acceleration[i]).head<3>().squaredNorm());
        const double way = 2 * std::sqrt(fastest) * step.dt;
        if (!n.listed || !(n.travelled + way < n.margin)) list(way);
        n.travelled += way;
        bool near = look(way);
        for (auto reached = reached_at_rest(step); !reached.empty(); reached = reached_at_rest(step))
            host_.reached(reached), near |= look(way);
        return !(step.longer && near);
    }

    // ---- what acts ------------------------------------------------------------------------------------------------
    void add_forces(double, std::vector<Vec6>& resisting) override {
        const PanelContactNow& n = now();
        touched_.resize(n.touches.size());
        pressed_before_ = presses_, presses_ = 0;
        for (std::size_t i = 0; !all_rest_ && i < n.touches.size(); ++i) {
            const PanelTouch& t = n.touches[i];
            if (!acts(i)) continue;
            const Touched& at = touched_[i] = touch(i);
            if (!at.touches()) continue;
            ++presses_;
            const Vec3 push = -at.press.force * t.side * at.foot.normal, drag = law(t).along() * at.slip;
            const PanelPoint& p = parts_.points()[std::size_t(t.point)];
            for (std::size_t k = 0; k < p.node.size() && !w_.rests(p.node[k]); ++k)
                resisting[p.node[k]].head<3>() += p.part[k] * (push + drag);
            const auto& nodes = parts_.panels()[std::size_t(t.panel)].nodes;
            for (std::size_t k = 0; k < nodes.size() && !w_.rests(nodes[k]); ++k)
                resisting[nodes[k]].head<3>() -= at.foot.share[k] * push + at.before.share[k] * drag +
                                                 at.arm * contact::slope_of_normal(at.before, drag, k);
        }
    }
    /// Also where the last point has just left: its stiffness is to go.
    bool has_blocks() const override { return presses_ > 0 || pressed_before_ > 0; }
    bool blocks_follow() const override { return has_blocks(); }
    /// Left out: how the normal rotates, and the slope of a friction that slides.
    void add_blocks(const Pose&, Blocks& blocks) const override {
        for (std::size_t i = 0; i < touched_.size(); ++i) {
            const PanelTouch& t = now().touches[i];
            const Touched& at = touched_[i];
            if (!acts(i) || !at.touches()) continue;
            const Mat3 K = contact::slope_of(law(t), at.foot.normal, at.press.slope, !at.slides);
            add_slope(t, at, K, blocks);
        }
    }
    void add_stiffest(Blocks& most) const override {
        for (int n = 0; n < int(w_.structure.position().size()); ++n) {
            if (!parts_.may_press(n)) continue;
            Mat6 K = Mat6::Zero();  // as a point, and as a corner
            K.topLeftCorner<3, 3>() = 2 * parts_.stiffest(n) * Mat3::Identity();
            most.stiffness(n, K);
        }
    }
    bool has_converged() override {
        for (std::size_t i = 0; i < touched_.size(); ++i)
            if (acts(i) && !touched_[i].agrees(law(now().touches[i]), touch(i))) return false;
        return true;
    }

    // ---- the end of a step ----------------------------------------------------------------------------------------
    /// Also adds the impulses that the step has missed (contact/press_law.h).
    void end(const Step& step) override {
        const PanelContactNow& n = now();
        lost_ = 0;
        double work = 0;
        bool any = false;
        for (std::size_t i = 0; i < touched_.size(); ++i) {
            if (!acts(i)) continue;
            const PanelTouch& t = n.touches[i];
            if (!w_.kind.explicit_steps) touched_[i] = touch(i);  // else nothing has moved since
            const contact::PressedStep done = contact::end_of_step(law(t), t.press, touched_[i], step.dt);
            lost_ += done.lost;
            if (done.missed.impulse == 0) continue;
            if (!any) impulse_.assign(w_.trial.velocity.size(), Vec6::Zero()), any = true;
            add_impulse(t, touched_[i], done.missed.impulse);
            work += done.missed.work;
        }
        if (!any) return;
        const ImpulseResponse k = host_.respond(impulse_);
        if (k.square > 0) add_to_trial(w_, k.factor_for(work), k);
    }
    void accumulate_energy(const Step&, Accounts& sums) const override { sums["panel_contact_lost"] += lost_; }
    void before_commit(const Step&) override {
        PanelContactNow& n = now();
        for (std::size_t i = 0; i < touched_.size(); ++i)
            if (acts(i)) contact::keep(touched_[i], n.touches[i].press, n.touches[i].level);
        lost_ = 0;
    }
    void after_commit(const Step&) override {
        feet_.clear();
        if (const int torn = parts_.torn_panels(w_.state); torn != torn_) torn_ = torn, surface_.clear(), all_broke();
    }
    void all_broke() override {
        if (drop_what_is_gone()) host_.accelerations_anew(), host_.blocks_changed(w_.state);
    }

    void save_step() override {
        if (!all_rest_ || !is_saved_) saved_ = now(), is_saved_ = all_rest_;
    }
    void roll_back() override { now() = saved_, lost_ = 0; }

    void lie_together(const Bodies& bodies, BodyPairs& pairs) const override {
        for (const PanelTouch& t : now().touches)
            if (t.over && t.press.depth > -apart_on(t))
                pairs.emplace_back(bodies.of_node[of_point(t)], bodies.of_node[of_panel(t)]);
    }
    /// What presses on what as both rest is kept, but for the rate. Those that take part again are to be looked at.
    void rest_changed() override {
        for (PanelTouch& t : now().touches)
            if (point_rests(t) && panel_rests(t)) t.press.rate = 0;
        feet_.clear(), awake_.clear();
        const auto rests = [this](const PanelPoint& p) { return w_.rests(p.node[0]); };
        all_rest_ = std::all_of(parts_.points().begin(), parts_.points().end(), rests);
        is_saved_ = false;
    }
    bool busy() const override { return presses_ > 0; }
    bool allows_long_step() const override { return !busy(); }
    std::string why_awake() const override { return std::to_string(presses_) + " points on panels"; }

    // ---- energy and checkpoint ------------------------------------------------------------------------------------
    void add_energy(const State& state, Accounts& sums) const override {
        double stored = 0;
        for (const PanelTouch& t : state.data.find<PanelContactNow>(panel_contact_effect)->touches)
            if (t.over) stored += stored_by(t, parts_.foot(state, t));
        sums["panel_contact_stored"] += stored;
    }
    void save(Writer& to) const override { to(presses_, pressed_before_); }
    void restore(Reader& from) override {
        from(presses_, pressed_before_), touched_.clear(), feet_.clear(), awake_.clear(), surface_.clear();
    }
    bool restored(std::span<const State* const> states) override {
        return std::all_of(states.begin(), states.end(), [this](const State* s) {
            const auto* there = s->data.find<PanelContactNow>(panel_contact_effect);
            return there && parts_.fits(*there);
        });
    }

private:
    PanelContactNow& now() const { return *w_.state.data.find<PanelContactNow>(panel_contact_effect); }
    /// Whether a touch may press in this step.
    bool acts(std::size_t i) const {
        const PanelTouch& t = now().touches[i];
        return t.over && (awake_.empty() ? !(point_rests(t) && panel_rests(t)) : awake_[i] != 0);
    }
    int of_point(const PanelTouch& t) const { return parts_.points()[std::size_t(t.point)].node[0]; }
    int of_panel(const PanelTouch& t) const { return parts_.panels()[std::size_t(t.panel)].nodes[0]; }
    bool point_rests(const PanelTouch& t) const { return w_.rests(of_point(t)); }
    bool panel_rests(const PanelTouch& t) const { return w_.rests(of_panel(t)); }
    double apart_on(const PanelTouch& t) const { return lies_within * parts_.reach(t.point, t.panel); }
    contact::PressLaw law(const PanelTouch& t) const { return parts_.law(t.point, t.panel); }
    PanelContactNow empty() const { return {int(parts_.points().size()), int(parts_.panels().size()), {}}; }
    double stored_by(const PanelTouch& t, const Foot& foot) const {
        return t.press.stored(law(t), parts_.depth(t, foot));
    }

    /// At the trial, on the way from where the step began.
    Touched touch(std::size_t i) const {
        const PanelTouch& t = now().touches[i];
        Touched at;
        at.foot = at.before = parts_.foot(w_.trial, t);
        static_cast<PressedEnd&>(at) =
            contact::pressed(law(t), t.press, parts_.depth(t, at.foot), w_.at_state ? 0 : dt_);
        if (!contact::rubs(law(t), t.press, at)) return at;
        const Foot begun = i < feet_.size() ? feet_[i] : parts_.foot(w_.state, t);
        const auto corners = parts_.corners(w_.trial, t.panel);
        at.before = contact::surface_at(parts_.span(corners, t.panel), begun.at), at.arm = begun.height;
        Vec3 moved = parts_.place(w_.trial, parts_.points()[std::size_t(t.point)]) - begun.height * at.before.normal;
        for (std::size_t k = 0; k < parts_.panels()[std::size_t(t.panel)].nodes.size(); ++k)
            moved -= at.before.share[k] * corners[k];
        const auto along = [&](const Vec3& v) { return Vec3(v - v.dot(at.foot.normal) * at.foot.normal); };
        contact::rub(law(t), t.press, along(contact::carried(t.press.slip, begun, at.before)), along(moved), at);
        return at;
    }

    /// Calls f(node, factor) for the nodes that a touch joins, but for those at rest: a unit force on the point, and
    /// its counterpart.
    template <class F>
    void each_node(const PanelTouch& t, const Foot& foot, F f) const {
        const PanelPoint& p = parts_.points()[std::size_t(t.point)];
        for (std::size_t k = 0; k < p.node.size() && !w_.rests(p.node[k]); ++k) f(p.node[k], p.part[k]);
        const auto& nodes = parts_.panels()[std::size_t(t.panel)].nodes;
        for (std::size_t k = 0; k < nodes.size() && !w_.rests(nodes[k]); ++k) f(nodes[k], -foot.share[k]);
    }
    void add_impulse(const PanelTouch& t, const Touched& at, double size) {
        each_node(t, at.foot, [&](int node, double part) {
            impulse_[std::size_t(node)].head<3>() += part * size * t.side * at.foot.normal;
        });
    }
    void add_slope(const PanelTouch& t, const Touched& at, const Mat3& K, Blocks& blocks) const {
        each_node(t, at.foot, [&](int a, double part_a) {
            Mat6 own = Mat6::Zero();
            own.topLeftCorner<3, 3>() = part_a * part_a * K;
            blocks.stiffness(a, own);
            each_node(t, at.foot, [&](int b, double part_b) {
                if (a >= b) return;
                Mat12 both = Mat12::Zero();
                both.block<3, 3>(0, 6) = both.block<3, 3>(6, 0) = part_a * part_b * K;
                blocks.stiffness(a, b, both);
            });
        });
    }

    // ---- what is near ---------------------------------------------------------------------------------------------
    /// Finds the panels that points stand over, but for those at rest on each other. Whether one may touch within the
    /// way, m.
    bool look(double way) {
        if (all_rest_) return false;
        PanelContactNow& n = now();
        bool near = false;
        double lost = 0;
        feet_.resize(n.touches.size()), awake_.assign(n.touches.size(), 0);
        for (std::size_t from = 0, to = 0; from < n.touches.size(); from = to) {
            double test_at = std::numeric_limits<double>::infinity();
            bool awake = !point_rests(n.touches[from]);
            for (; to < n.touches.size() && n.touches[to].point == n.touches[from].point; ++to)
                test_at = std::min(test_at, n.touches[to].test_at), awake = awake || !panel_rests(n.touches[to]);
            if (!awake || n.travelled < test_at) continue;
            lost += choose(from, to);
            for (std::size_t i = from; i < to; ++i) {
                PanelTouch& t = n.touches[i];
                awake_[i] = !(point_rests(t) && panel_rests(t));
                near |= t.over && awake_[i] && t.press.depth + way > 0;
                // over a panel: from the side on which it is, however deep
                const double above = t.over ? t.side * feet_[i].height : std::abs(feet_[i].height);
                const double apart = above - parts_.reach(t.point, t.panel);
                t.test_at = n.travelled + part_of_gap * std::max(0.0, apart) - way;
            }
        }
        w_.state.accumulated["panel_contact_lost"] += lost;
        return near;
    }
    /// Nodes of bodies at rest that something comes to touch in the step.
    std::vector<Reached> reached_at_rest(const Step& step) const {
        std::vector<Reached> reached;
        for (std::size_t i = 0; !all_rest_ && !w_.resting.empty() && i < now().touches.size(); ++i) {
            const PanelTouch& t = now().touches[i];
            if (!acts(i) || point_rests(t) == panel_rests(t)) continue;
            double deeper = 0;
            each_node(t, feet_[i], [&](int node, double part) {
                const Vec6 v = w_.state.velocity[node] + (0.5 * step.dt) * w_.state.acceleration[node];
                deeper -= part * step.dt * t.side * feet_[i].normal.dot(v.head<3>());
            });
            if (t.press.depth + deeper > -apart_on(t))
                reached.push_back({-1, "reached", point_rests(t) ? of_point(t) : of_panel(t)});
        }
        return reached;
    }
    void list(double way) {
        PanelContactNow& n = now();
        const State& s = w_.state;
        double thickest = 0;
        for (std::size_t p = 0; p < parts_.panels().size(); ++p) thickest = std::max(thickest, parts_.half(int(p)));
        n.margin = std::clamp(steps_of_list * way, thickest + 0.02 * parts_.smallest(), parts_.smallest());
        n.margin = std::max(n.margin, 2 * way);
        std::vector<PanelTouch> list = parts_.near(s, nullptr, n.margin);
        for (PanelTouch& t : list) {
            const auto known = std::lower_bound(n.touches.begin(), n.touches.end(), t);
            if (known != n.touches.end() && !(t < *known)) {
                t = *known;
                continue;
            }
            const Foot foot = parts_.foot(s, t);
            t.side = foot.height < 0 ? -1 : 1;
        }
        std::vector<PanelTouch> deep;  // what presses stays, however deep
        std::copy_if(n.touches.begin(), n.touches.end(), std::back_inserter(deep), [&](const PanelTouch& t) {
            return t.over && t.press.depth > 0 && !std::binary_search(list.begin(), list.end(), t);
        });
        list.insert(list.end(), deep.begin(), deep.end()), std::sort(list.begin(), list.end());
        n.touches = std::move(list);
        for (PanelTouch& t : n.touches) t.test_at = 0;
        n.travelled = 0, n.listed = true, is_saved_ = false;
        surface_ = parts_.surfaces(s);
    }
    /// Of a point's panels, those that it stands over: one of a surface. Returns what is lost where it changes, J.
    double choose(std::size_t from, std::size_t to) {
        if (surface_.empty()) surface_ = parts_.surfaces(w_.state);
        double lost = 0;
        const std::span of_point = std::span(now().touches).subspan(from, to - from);
        const std::span feet = std::span(feet_).subspan(from, to - from);
        for (std::size_t i = 0; i < feet.size(); ++i) feet[i] = parts_.foot(w_.state, of_point[i]);
        for (std::size_t i = 0; i < of_point.size(); ++i) {
            const int surface = surface_[std::size_t(of_point[i].panel)];
            const auto same = [&](std::size_t k) { return surface_[std::size_t(of_point[k].panel)] == surface; };
            bool first = true;
            for (std::size_t k = 0; k < i; ++k) first = first && !same(k);
            if (!first) continue;
            std::size_t best = i, old = of_point.size();
            for (std::size_t k = i; k < of_point.size(); ++k) {
                if (!same(k)) continue;
                if (feet[k].beyond < feet[best].beyond) best = k;
                if (of_point[k].over) old = k;
            }
            const bool had = old < of_point.size();
            if (had && (feet[old].beyond <= 0 || (feet[best].beyond > 0 && feet[old].beyond < held_beyond))) best = old;
            const bool over = feet[best].beyond <= 0 || best == old;
            if (had && (!over || best != old))
                lost += leave(of_point[old], feet[old], over ? &of_point[best] : nullptr, feet[best]);
            for (std::size_t k = i; k < of_point.size(); ++k)
                if (same(k) && !(over && k == best)) of_point[k].side = feet[k].height < 0 ? -1 : 1;
            if (!over) continue;
            PanelTouch& t = of_point[best];
            if (!t.over && !had) t.level = std::max(0.0, parts_.depth(t, feet[best]));
            t.over = true;
            if (!had || best != old || !(t.press.depth > 0)) t.press.depth = parts_.depth(t, feet[best]);
        }
        return lost;
    }
    /// A point goes from one panel to the next, or off the rim. Returns the energy that goes with it.
    double leave(PanelTouch& old, const Foot& from, PanelTouch* next, const Foot& to) {
        double lost = stored_by(old, from);
        if (next) {
            next->side = from.normal.dot(to.normal) < 0 ? -old.side : old.side;
            next->press = old.press;
            // where panels fold towards the point it is deeper in the next one: no energy comes from that
            next->level = old.level;
            next->level += std::max(0.0, parts_.depth(*next, to) - parts_.depth(old, from));
            next->over = true;
            lost -= stored_by(*next, to);
        } else if (old.press.depth > 0) {
            host_.accelerations_anew();
        }
        old.over = false, old.level = 0, old.press = {};
        return lost;
    }
    /// Torn panels, and points of what has broken, press no longer; what they stored is lost. True where one pressed.
    bool drop_what_is_gone() {
        PanelContactNow& n = now();
        bool any = false;
        double lost = 0;
        std::erase_if(n.touches, [&](const PanelTouch& t) {
            if (!parts_.torn(w_.state, t.panel) && parts_.is_there(w_.state, parts_.points()[std::size_t(t.point)]))
                return false;
            if (t.over && t.press.depth > 0) lost += stored_by(t, parts_.foot(w_.state, t)), any = true;
            touched_.clear(), awake_.clear(), is_saved_ = false;
            return true;
        });
        w_.state.accumulated["panel_contact_lost"] += lost;
        return any;
    }

    PanelPoints parts_;
    std::vector<int> surface_;              ///< of each panel; empty: to be found
    std::vector<Foot> feet_;                ///< of each touch that is awake, where the step begins; empty: to be found
    std::vector<char> awake_;               ///< of each touch: may touch in the step; empty: all may
    std::vector<Touched> touched_;          ///< of each touch, where forces were found last
    int torn_ = 0;                          ///< panels
    bool all_rest_ = false;                 ///< all points
    int presses_ = 0, pressed_before_ = 0;  ///< points there, and where forces were found before
    double dt_ = 0;                         ///< s, of the step
    double lost_ = 0;                       ///< J, in the step that ends
    std::vector<Vec6> impulse_;
    PanelContactNow saved_;
    bool is_saved_ = false;  ///< all rest, and nothing has changed since
};

bool is_asked(const Structure& s) {
    return !s.model().declared<PanelContactRule>(panel_contact_effect).empty() &&
           !s.model().declared<Panel>(panels_effect).empty();
}

std::vector<PlanLine> panel_contact_plan(const Structure& s, const RunKind&) {
    if (s.model().declared<Panel>(panels_effect).empty()) return {};
    const bool on = is_asked(s);
    return {{panel_contact_effect, on, on ? "model:panel_contact" : "not declared",
             on ? s.model().asked_at(panel_contact_effect) : ""}};
}

}  // namespace

EffectKind panel_contact_kind() {
    return {.name = panel_contact_effect,
            .accounts = {{"panel_contact", 63, "stored where points press on panels now, and lost there"},
                         {"panel_contact_stored", 64, "stored now where points press on panels", "panel_contact"},
                         {"panel_contact_lost", 65,
                          "by restitution and friction on panels, and where points leave them or come to rest",
                          "panel_contact"}},
            .plan = panel_contact_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (!is_asked(w.structure)) {
                    w.state.data.erase(panel_contact_effect);
                    return nullptr;
                }
                return std::make_unique<PanelContact>(w, host);
            },
            .dynamic_only = true,
            .leave_out = leave_out_declared<panel_contact_effect>};
}

}  // namespace hinge

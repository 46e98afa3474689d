// Points on springs: the law of planes that are given a stiffness or a restitution. Where a node, or the free end of a
// broken element, comes closer to the plane than the half depth h of its members, it is pushed back:
//
//   U = k/2 o^2 where o > 0, else 0:   o = h - n . (x - point)
//
// Friction (Coulomb) is a spring e along the plane between the point of the surface that touches and the ground,
// |k_t e| <= mu k o; where it would be more, the point slides and what is missing is heat.
//
// Restitution: a point that has come out of the ground has its normal velocity reduced to that part of itself by an
// impulse, whatever the length of the step. Points of one body that come out at nearly the same time get their impulses
// together: a point that was reduced alone would be pulled up again by the rest of its body, which is still fast, and
// short steps tell apart what comes out together in long ones. So a point waits for the others of its body that touch,
// at most as long as a contact of its own takes, pi sqrt(m / k), or until it touches again. The impulses share their
// sizes as the points' masses and velocities do, and one factor makes the sum of them right.
#include <algorithm>
#include <cmath>

#include "contact/ground_friction.h"
#include "effects/ground_law.h"
#include "state/bodies.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

/// k of a point: this part of EA / L of each element that meets there. It goes with the mass there, so that a bar that
/// falls flat stays straight, and raises the square of the highest frequency by a fifth at most: explicit steps of 0.9
/// of what stability allows stay stable.
constexpr double normal_part = 0.4;
/// Restitution waits for other points of the body by this part of the time that a contact of the point alone takes.
constexpr double most_wait = 1;

/// Contact of a point at a pose.
struct Touch {
    double overlap = 0;        ///< o, m
    Vec3 arm = Vec3::Zero();   ///< from the node to the point, m
    Vec3 slip = Vec3::Zero();  ///< e, m
    bool slides = false;
    double heat = 0;  ///< J, by sliding since the step began
};

class GroundPoints : public GroundLaw {
public:
    GroundPoints(Workspace& w, Host& host) : GroundLaw(w), host_(host) {}

    void list(GroundData& to) const override {
        const Structure& s = w_.structure;
        for (int i = 0; i < int(planes_.size()); ++i) {
            if (planes_[i].is_layer()) continue;
            for (int n = 0; n < int(s.position().size()); ++n) {
                GroundPoint p;
                p.plane = i, p.end.node = n;
                for (int element : s.elements_at(n)) {
                    if (!presses_on(i, element)) continue;
                    const Element& e = s.elements()[element];
                    p.end.radius = std::max(p.end.radius, e.radius);
                    const double mass = striking_mass(s, w_.state, element, e.node[0] == n ? 0 : 1);
                    p.stiffness += normal_part * e.rigidity.EA / e.length * (mass / (0.5 * e.mass()));
                    p.mass += mass;
                }
                if (p.stiffness != 0 && !w_.state.gone[n]) to.points.push_back(started(p));
            }
            for (int e = 0; e < int(s.elements().size()); ++e)
                if (w_.state.broken[e] && presses_on(i, e)) to.points.push_back(free_end(i, e));
        }
    }

    void add_forces(std::vector<Vec6>& resisting) override {
        pressed.begin();
        touches_.resize(points().size());
        for (std::size_t i = 0; i < points().size(); ++i) {
            const GroundPoint& p = points()[i];
            const Touch& t = touches_[i] = touch(p, w_.trial);
            if (carries(p, t)) pressed.add(i);
            if (!(t.overlap > 0)) continue;
            const Vec3 push = -p.stiffness * t.overlap * plane(p).normal;
            add_force(p.end, plane(p), t.arm, push, t.slip, resisting);
        }
    }
    /// Left out: the slope of a friction that slides, which has no symmetry, and how the arms rotate.
    void add_blocks(Blocks& blocks) const override {
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const GroundPoint& p = points()[i];
            const Touch& t = touches_[i];
            if (!carries(p, t)) continue;
            blocks.stiffness(p.end.node, slope(p, t.arm, plane(p).friction > 0 && !t.slides));
        }
    }

    /// A stiffness of its own, everywhere at once. That of the elements' own is within what steps leave free.
    void add_stiffest(Blocks& most) const override {
        for (const GroundPoint& p : points()) {
            if (plane(p).stiffness == 0 || is_held(p.end.node)) continue;
            most.stiffness(p.end.node, slope(p, arm_of(p.end, w_.state), plane(p).friction > 0));
        }
    }

    /// Another solution is needed where a point has come to touch, or no longer does, or friction has become another.
    bool has_converged() const override {
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const GroundPoint& p = points()[i];
            const Touch now = touch(p, w_.trial), &before = touches_[i];
            if ((now.overlap > 0) != (before.overlap > 0)) return false;
            const double most = plane(p).friction * p.stiffness * now.overlap;
            if (most > 0 && p.end.stiffness * (now.slip - before.slip).norm() > contact::same_friction * most)
                return false;
        }
        return true;
    }
    bool touches_within(const Step& step) const override {
        return std::any_of(points().begin(), points().end(),
                           [&](const GroundPoint& p) { return GroundLaw::touches_within(p.end, plane(p), step); });
    }

    /// Friction's heat, what the step has missed where a point began or ceased to touch, and restitution.
    void end(const Step& step) override {
        lost_ = gives_back_ = 0;
        waits_.clear();
        bool begins_or_ends = false, waits = false;
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const GroundPoint& p = points()[i];
            const Touch& t = touches_[i] = touch(p, w_.trial);
            lost_ += t.heat;
            begins_or_ends |= (t.overlap > 0) != (p.overlap > 0);
            waits |= p.waits > 0 || comes_out(p, t);
        }
        if (!begins_or_ends && !waits) return;
        taken_.assign(touches_.size(), 0);
        if (begins_or_ends) add_missed(step.dt);
        if (waits && find_due(step.dt)) restitute();
        take_from_friction();
    }
    double lost() const override {
        double heat = 0;
        for (const Touch& t : touches_) heat += t.heat;
        return w_.kind.dynamic ? lost_ : heat;
    }
    void before_commit() override {
        for (std::size_t i = 0; i < points().size(); ++i) {
            GroundPoint& p = points()[i];
            const Touch t = touch(p, w_.trial);
            if (!waits_.empty()) {
                if (comes_out(p, t)) p.dragged = friction_part(p, p.overlap, p.end.slip);
                p.waits = waits_[i];
            }
            if (!(p.overlap > 0) && t.overlap > 0 && p.waits == 0) p.rubbed = 0;  // it begins to touch
            p.rubbed += t.heat;
            if (gives_back_ > 0 && taken_[i] != 0) p.rubbed *= 1 - gives_back_;
            keep(p, t);
        }
        lost_ = gives_back_ = 0;
        waits_.clear();
    }

    /// The free end of what breaks is where it is, at rest; a node that is gone presses no longer. What it stored where
    /// the step ended is lost: touch() finds nothing at a node that is gone.
    double broke(const Break& b) override {
        double lost = 0;
        for (GroundPoint& p : points()) {
            if (!w_.state.gone[p.end.node] || p.end.left_out) continue;
            lost += energy(p, p.overlap, p.end.slip);
            p.end.left_out = true, p.overlap = -p.end.radius, p.end.slip.setZero(), p.waits = 0;
        }
        for (int i = 0; i < int(planes_.size()); ++i)
            if (!planes_[i].is_layer() && presses_on(i, b.element)) points().push_back(free_end(i, b.element));
        return lost;
    }

    void roll_back() override { lost_ = gives_back_ = 0, waits_.clear(); }
    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        for (const GroundPoint& p : points())
            if (const int body = bodies.of_node[p.end.node];
                body >= 0 && (p.waits > 0 || touch(p, w_.state).overlap > 0))
                rests[body] = 0;
    }
    bool waits() const override {
        return std::any_of(points().begin(), points().end(), [](const GroundPoint& p) { return p.waits > 0; });
    }
    double stored(const State& state) const override {
        double sum = 0;
        for (const GroundPoint& p : state.data.find<GroundData>(ground_effect)->points) {
            const Touch t = touch(p, state);
            sum += energy(p, t.overlap, t.slip);
        }
        return sum;
    }
    std::string name_of_first() const override { return w_.structure.node_name(points()[pressed.first].end.node); }
    void restored() override { touches_.clear(); }

private:
    std::vector<GroundPoint>& points() const { return data().points; }
    const GroundPlane& plane(const GroundPoint& p) const { return planes_[p.plane]; }
    Mat6 slope(const GroundPoint& p, const Vec3& arm, bool sticks) const {
        const Vec6 row = row_of(plane(p).normal, arm);
        Mat6 K = p.stiffness * row * row.transpose();
        if (sticks) add_slope_of_friction(p.end, plane(p), arm, K);
        return K;
    }
    /// Whether it counts in the tangent.
    bool carries(const GroundPoint& p, const Touch& t) const { return t.overlap > (-w_.touches_within(p.end.radius)); }

    /// Contact of a point at a pose, on the way from where the step began.
    template <class At>
    Touch touch(const GroundPoint& p, const At& at) const {
        Touch t;
        if (p.end.left_out || is_held(p.end.node)) return t.overlap = -p.end.radius, t;
        t.arm = arm_of(p.end, at);
        const Vec3 place = place_of(p.end, at, t.arm);
        t.overlap = overlap_of(p.end, plane(p), place);
        if (w_.rests(p.end.node)) return t.overlap = std::min(0.0, t.overlap), t;
        const double mu = plane(p).friction;
        if (mu == 0) return t;
        const Vec3 moved = moved_along(p.end, plane(p), place - p.place, p.rotation, at.rotation[p.end.node]);
        // of a step in which it comes to touch, the part that is left then
        const double part = p.overlap > 0 ? 1 : t.overlap > 0 ? t.overlap / (t.overlap - p.overlap) : 0;
        const contact::Friction f =
            contact::friction(p.end.slip, moved, part, p.end.stiffness, mu * p.stiffness * std::max(0.0, t.overlap));
        t.slip = f.slip, t.slides = f.slides, t.heat = f.heat;
        return t;
    }
    static double energy(const GroundPoint& p, double overlap, const Vec3& slip) {
        const double o = std::max(0.0, overlap);
        return 0.5 * (p.stiffness * o * o + p.end.stiffness * slip.squaredNorm());
    }
    /// Where the next step begins.
    void keep(GroundPoint& p, const Touch& t) const {
        GroundEnd& end = p.end;
        if ((end.left_out || end.level > 0) && !w_.state.gone[end.node]) {
            const Vec3 place = place_of(end, w_.trial, arm_of(end, w_.trial));
            if (overlap_of(end, plane(p), place) + end.level <= 0) end.left_out = false, end.level = 0;
        }
        p.overlap = t.overlap;
        end.slip = t.slip;
        if (plane(p).friction == 0) return;
        p.place = place_of(end, w_.trial, t.arm);
        p.rotation = w_.trial.rotation[end.node];
    }

    /// A point where the run begins, or where its element has broken.
    GroundPoint started(GroundPoint p) const {
        if (plane(p).stiffness > 0) p.stiffness = plane(p).stiffness;
        p.end.stiffness = contact::tangential_part * p.stiffness;
        p.overlap = begin_at(p.end, plane(p)) - p.end.level;
        p.place = place_of(p.end, w_.state, arm_of(p.end, w_.state));
        p.rotation = w_.state.rotation[p.end.node];
        return p;
    }
    GroundPoint free_end(int plane, int element) const {
        const Element& e = w_.structure.elements()[element];
        GroundPoint p;
        p.plane = plane, p.element = element;
        p.end.node = e.node[w_.state.broken[element] == 2 ? 0 : 1];
        p.end.arm = w_.state.offset_arm[element];
        p.end.radius = e.radius;
        p.stiffness = normal_part * e.rigidity.EA / e.length;
        p.mass = 0.5 * e.mass();
        return started(p);
    }

    void add_impulse(const GroundPoint& p, const Touch& t, double size) {
        const Vec3 f = size * plane(p).normal;
        impulse_[p.end.node].head<3>() += f;
        impulse_[p.end.node].tail<3>() += t.arm.cross(f);
    }
    /// A step takes the mean of the forces at its two ends. Where o changes its sign that is not the force that does
    /// the work -(U1 - U0) (contact/surface_contact.h): what is missing of it, times dt, is an impulse, scaled so that
    /// it does the work that was missed.
    void add_missed(double dt) {
        impulse_.assign(w_.trial.velocity.size(), Vec6::Zero());
        double work = 0;
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const double before = points()[i].overlap, now = touches_[i].overlap;
            if ((before > 0) == (now > 0)) continue;
            const double most = std::max(before, now), least = std::min(before, now);
            const double missing = 0.5 * dt * points()[i].stiffness * most * least / (most - least);
            add_impulse(points()[i], touches_[i], missing);
            taken_[i] = missing;
            work += missing * (before - now) / dt;
        }
        const ImpulseResponse k = host_.respond(impulse_);
        if (!(k.square > 0)) return;
        const double x = k.factor_for(work);
        add_to_trial(w_, x, k);
        for (double& taken : taken_) taken *= x;
    }

    bool comes_out(const GroundPoint& p, const Touch& t) const {
        return p.overlap > 0 && !(t.overlap > 0) && plane(p).restitution.value_or(1) < 1;
    }
    /// Friction over pressure, along e.
    static Vec3 friction_part(const GroundPoint& p, double overlap, const Vec3& slip) {
        return p.end.stiffness / (p.stiffness * overlap) * slip;
    }

    /// Which points get their restitution now, and how long the others go on waiting; whether one does. A point is due
    /// with all others of its body: when none of them touches any longer, when one has waited for long enough, or when
    /// one touches again.
    bool find_due(double dt) {
        const Bodies bodies = find_bodies(w_.structure, w_.state);
        std::vector<char> touches(bodies.count, 0), over(bodies.count, 0);
        waits_.assign(touches_.size(), 0);
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const GroundPoint& p = points()[i];
            const Touch& t = touches_[i];
            const int body = bodies.of_node[p.end.node];
            if (body < 0 || is_held(p.end.node)) continue;
            const bool in = t.overlap > 0;
            touches[body] |= in;
            if (p.waits > 0) waits_[i] = std::max(p.waits - dt, 0.0), over[body] |= in || waits_[i] == 0;
            else if (comes_out(p, t)) waits_[i] = most_wait * M_PI * std::sqrt(p.mass / p.stiffness);
        }
        due_.assign(touches_.size(), 0);
        bool any = false;
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const GroundPoint& p = points()[i];
            const int body = bodies.of_node[p.end.node];
            if (!(p.waits > 0 || waits_[i] > 0) || body < 0 || (touches[body] && !over[body])) continue;
            due_[i] = 1, waits_[i] = 0, any = true;
        }
        return any;
    }

    /// Of the points that are due, the normal velocity is to be what restitution leaves of it. One that still moves
    /// into the ground has not come back from it; one that waited may have turned round, and has less of either.
    void restitute() {
        impulse_.assign(w_.trial.velocity.size(), Vec6::Zero());
        restituted_.assign(touches_.size(), 0);
        double wanted = 0;  // impulse . velocity, afterwards
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            if (!due_[i]) continue;
            const GroundPoint& p = points()[i];
            const Touch& t = touches_[i];
            const double left = plane(p).restitution.value_or(1);
            const Vec6& v = w_.trial.velocity[p.end.node];
            const double speed = plane(p).normal.dot(v.head<3>() + Vec3(v.tail<3>()).cross(t.arm));
            if (!(speed > 0) && !(p.waits > 0)) continue;
            const double size = -(1 - left) * p.mass * speed;
            add_impulse(p, t, size);
            restituted_[i] = size;
            wanted += size * left * speed;
        }
        if (wanted == 0 && std::all_of(impulse_.begin(), impulse_.end(), [](const Vec6& f) { return f.isZero(0); }))
            return;
        const ImpulseResponse k = host_.respond(impulse_);
        if (!(k.square > 0)) return;
        const double x = (wanted - k.linear) / (2 * k.square);
        add_to_trial(w_, x, k);
        lost_ -= x * (k.linear + x * k.square);
        for (std::size_t i = 0; i < touches_.size(); ++i) taken_[i] += x * restituted_[i];
    }

    /// Friction has acted with all that the springs gave: what was taken of that, is taken of friction. It gives back
    /// no more than its heat: a point that has turned since would be pushed on by what had held it.
    void take_from_friction() {
        bool slid = false;
        double heat = 0;
        for (Vec6& f : impulse_) f.setZero();
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const GroundPoint& p = points()[i];
            const Touch& t = touches_[i];
            if (taken_[i] == 0) continue;
            const Vec3 part = p.overlap > 0   ? friction_part(p, p.overlap, p.end.slip)
                              : p.waits > 0   ? p.dragged
                              : t.overlap > 0 ? friction_part(p, t.overlap, t.slip)
                                              : Vec3(Vec3::Zero());
            if (part.isZero(0)) continue;
            const Vec3 f = -taken_[i] * part;
            impulse_[p.end.node].head<3>() += f;
            impulse_[p.end.node].tail<3>() += surface(p.end, plane(p), t.arm).cross(f);
            heat += p.rubbed + t.heat;
            slid = true;
        }
        if (!slid) return;
        const ImpulseResponse along = host_.respond(impulse_);
        double part = 1, back = along.linear + along.square;
        if (back > heat) {
            const double l = along.linear, q = along.square;
            part = q > 0 ? (std::sqrt(l * l + 4 * q * heat) - l) / (2 * q) : 0;
            back = heat;
        }
        if (!(part > 0)) return;
        add_to_trial(w_, part, along);
        lost_ -= back;
        gives_back_ = heat > 0 ? std::max(0.0, back / heat) : 0;
    }

    Host& host_;
    std::vector<Touch> touches_;  ///< as of the last add_forces or end
    std::vector<Vec6> impulse_;   ///< N s, N m s
    /// Of the normal impulse of each point, by restitution, and with what the step missed, N s.
    std::vector<double> restituted_, taken_;
    std::vector<double> waits_;  ///< s: GroundPoint::waits where the step ends; empty where no point waits
    std::vector<char> due_;      ///< points that get their restitution in this step
    double lost_ = 0;            ///< J, by friction and restitution in this step
    double gives_back_ = 0;      ///< of the heat of the points that friction is taken from
};

}  // namespace

std::unique_ptr<GroundLaw> ground_points(Workspace& w, Host& host) { return std::make_unique<GroundPoints>(w, host); }

}  // namespace hinge

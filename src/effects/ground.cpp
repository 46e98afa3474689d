// Rigid half spaces that members fall on, as points on springs: for planes that are given a stiffness or a restitution.
// Where a node, or the free end of a broken element, comes closer to the plane
// than the half depth h of its members, it is pushed back:
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
#include "effects/ground.h"

#include <algorithm>
#include <cmath>

#include "contact/ground_friction.h"
#include "core/rotation.h"
#include "effects/kinds.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

/// k of a point: this part of EA / L of each element that meets there. It goes with the mass there, so that a bar that
/// falls flat stays straight, and raises the square of the highest frequency by a fifth at most: explicit steps of 0.9
/// of what stability allows stay stable.
constexpr double normal_part = 0.4;
/// k_t / k. A point of the surface also rotates with its node, which makes it up to 2.5 times as easy to move.
constexpr double tangential_part = 0.4;
/// Part of the half depth: nodes that begin further than this below the plane are no part of what stands on it.
constexpr double buried = 0.01;
/// Friction that differs by this part of the most that there can be from the one that a step was solved with asks for
/// another solution.
constexpr double same_friction = 0.01;
/// Restitution waits for other points of the body by this part of the time that a contact of the point alone takes.
constexpr double most_wait = 1;

/// A point that may touch a plane.
struct Point {
    int plane = 0, node = 0;
    int element = -1;         ///< broken: its free end; -1: a node
    Vec3 arm = Vec3::Zero();  ///< m, from the node in the node's own frame
    double radius = 0;        ///< h, m
    double stiffness = 0;     ///< k, N/m
    double mass = 0;          ///< half of what meets there, kg
    bool left_out = false;    ///< began below the plane and has not left it yet
    double level = 0;         ///< m: how far it was inside where it began: there it is at rest
    double waits = 0;         ///< s: restitution, after it came out, waits so long for others of its body; 0: does not
    Vec3 dragged = Vec3::Zero();  ///< friction over pressure as it came out, along e
    double rubbed = 0;            ///< J: heat of friction since it came to touch, less what was given back

    // where a step begins
    double overlap = 0;                ///< o, m; negative: apart
    Vec3 slip = Vec3::Zero();          ///< e, m
    Vec3 place = Vec3::Zero();         ///< of the point, m
    Quat rotation = Quat::Identity();  ///< of the node

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.plane, s.node, s.element, s.arm, s.radius, s.stiffness, s.mass, s.left_out, s.level, s.waits, s.dragged,
          s.rubbed, s.overlap, s.slip, s.place, s.rotation);
    }
};

struct Points {
    int planes = 0, nodes = 0;
    std::vector<Point> list;
    static constexpr bool in_state_hash = false;  ///< the hash of a state is that of its arrays
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.planes, s.nodes, s.list);
    }
};

/// How a point lies somewhere.
struct Touch {
    double overlap = 0;        ///< o, m
    Vec3 arm = Vec3::Zero();   ///< from the node to the point, m
    Vec3 slip = Vec3::Zero();  ///< e, m
    bool slides = false;
    double heat = 0;  ///< J, by sliding since the step began
};

class Ground : public Effect,
               public Force,
               public ContactLaw,
               public BreakListener,
               public StepLimiter,
               public Sleeper {
public:
    Ground(Workspace& w, Host& host) : Effect(ground_effect, w, host, {.forces_vanish = true}) {
        const int planes = int(declared().size()), nodes = int(w.structure.position().size());
        const Points* there = w.state.data.find<Points>(ground_effect);
        if (!there || there->planes != planes || there->nodes != nodes) w.state.data.set(ground_effect, list_points());
    }

    void add_forces(double, std::vector<Vec6>& resisting) override {
        had_ = has_, has_ = 0;
        touches_.resize(points().size());
        for (std::size_t i = 0; i < points().size(); ++i) {
            const Point& p = points()[i];
            const Touch& t = touches_[i] = look(p, w_.trial);
            if (carries(p, t)) ++has_, first_ = has_ == 1 ? int(i) : first_;
            if (!(t.overlap > 0)) continue;
            const Vec3 &n = plane(p).normal, push = -p.stiffness * t.overlap * n, drag = tangential(p) * t.slip;
            resisting[p.node].head<3>() += push + drag;
            resisting[p.node].tail<3>() += t.arm.cross(push) + surface(p, t.arm).cross(drag);
        }
    }
    /// Left out: the slope of a friction that slides, which has no symmetry, and how the arms rotate.
    void add_blocks(const ConfigurationView&, Blocks& blocks) const override {
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const Point& p = points()[i];
            const Touch& t = touches_[i];
            if (!carries(p, t)) continue;
            blocks.stiffness(p.node, slope(p, t.arm, plane(p).friction > 0 && !t.slides));
        }
    }
    bool has_blocks() const override { return has_ > 0 || had_ > 0; }
    bool blocks_follow() const override { return has_blocks(); }

    /// A stiffness of its own, everywhere at once. That of the elements' own is within what steps leave free.
    void add_stiffest(Blocks& most) const override {
        for (const Point& p : points()) {
            if (plane(p).stiffness == 0 || is_held(p)) continue;
            const Vec3 arm = p.element < 0 ? Vec3(Vec3::Zero()) : Vec3(w_.state.rotation[p.node] * p.arm);
            most.stiffness(p.node, slope(p, arm, plane(p).friction > 0));
        }
    }

    /// Another solution is needed where a point has come to touch, or no longer does, or friction has become another.
    bool settled() override {
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const Touch now = look(points()[i], w_.trial), &before = touches_[i];
            if ((now.overlap > 0) != (before.overlap > 0)) return false;
            const double most = plane(points()[i]).friction * points()[i].stiffness * now.overlap;
            if (most > 0 && tangential(points()[i]) * (now.slip - before.slip).norm() > same_friction * most)
                return false;
        }
        return true;
    }

    /// Long steps end before a point touches.
    bool meet(const Step& step) override {
        if (!step.longer) return true;
        for (const Point& p : points()) {
            if (p.left_out || is_held(p) || rests(p)) continue;
            const Vec6 foreseen = w_.state.velocity[p.node] + (0.5 * step.dt) * w_.state.acceleration[p.node];
            const Vec3 arm = w_.state.rotation[p.node] * p.arm;
            const double closing =
                -plane(p).normal.dot(foreseen.head<3>() + Vec3(foreseen.tail<3>()).cross(arm)) * step.dt;
            if (overlap_of(p, w_.state, arm) + closing > 0) return false;
        }
        return true;
    }

    /// Friction's heat, what the step has missed where a point began or ceased to touch, and restitution.
    void end(const Step& step) override {
        lost_ = gives_back_ = 0;
        waits_.clear();
        bool begins_or_ends = false, waits = false;
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const Point& p = points()[i];
            const Touch& t = touches_[i] = look(p, w_.trial);
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
    void end_statics() override {
        lost_ = 0;
        for (const Touch& t : touches_) lost_ += t.heat;
    }
    void accumulate_energy(const Step&, Accounts& sums) const override { sums["ground_dissipated"] += lost_; }
    void before_commit(const Step&) override {
        for (std::size_t i = 0; i < points().size(); ++i) {
            Point& p = points()[i];
            const Touch t = look(p, w_.trial);
            if (!waits_.empty()) {
                if (comes_out(p, t)) p.dragged = friction_part(p, p.overlap, p.slip);
                p.waits = waits_[i];
            }
            if (!(p.overlap > 0) && t.overlap > 0 && p.waits == 0) p.rubbed = 0;  // it begins to touch
            p.rubbed += t.heat;
            if (gives_back_ > 0 && taken_[i] != 0) p.rubbed *= 1 - gives_back_;
            take(p, t, w_.trial);
        }
        lost_ = gives_back_ = 0;
        waits_.clear();
    }

    /// The free end of what breaks is where it is, at rest; a node that is gone presses no longer. What it stored where
    /// the step ended is lost: look() finds nothing at a node that is gone.
    void broke(const Break& b) override {
        double lost = 0;
        const Element& e = w_.structure.elements()[b.element];
        for (Point& p : points()) {
            if (!w_.state.gone[p.node] || p.left_out) continue;
            lost += energy(p, p.overlap, p.slip);
            p.left_out = true, p.overlap = -p.radius, p.slip.setZero(), p.waits = 0;
        }
        w_.state.accumulated["ground_dissipated"] += lost;
        for (int i = 0; i < int(declared().size()); ++i)
            if (!declared()[i].is_layer() && meets(i, b.element))
                points().push_back(free_end(i, e, b.element, w_.state));
    }

    void roll_back() override { lost_ = gives_back_ = 0, waits_.clear(); }
    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        for (const Point& p : points())
            if (bodies.of_node[p.node] >= 0 && (p.waits > 0 || look(p, w_.state).overlap > 0))
                rests[bodies.of_node[p.node]] = 0;
    }
    bool allows_long_step() const override {
        return has_ == 0 && std::none_of(points().begin(), points().end(), [](const Point& p) { return p.waits > 0; });
    }
    bool busy() const override { return has_ > 0; }
    std::string why_awake() const override { return w_.structure.node_name(points()[first_].node) + " on the ground"; }

    void add_energy(const State& state, Accounts& sums) const override { sums["ground_stored"] += stored(state); }
    void save(Writer& to) const override { to(has_, had_, first_); }
    void restore(Reader& from) override { from(has_, had_, first_); }
    bool restored(std::span<const State* const> states) override {
        const int nodes = int(w_.structure.position().size()), elements = int(w_.structure.elements().size());
        const auto within = [](int i, int n) { return i >= 0 && i < n; };
        for (const State* s : states) {
            const Points* there = s->data.find<Points>(ground_effect);
            if (!there || there->planes != int(declared().size()) || there->nodes != nodes) return false;
            for (const Point& p : there->list)
                if (!within(p.plane, there->planes) || !within(p.node, nodes) || !within(p.element + 1, elements + 1))
                    return false;
        }
        touches_.clear();
        return has_ >= 0 && had_ >= 0 && (points().empty() || within(first_, int(points().size())));
    }

private:
    const std::vector<GroundPlane>& declared() const { return declared_; }
    const std::vector<GroundPlane>& declared_ = w_.structure.model().declared<GroundPlane>(ground_effect);
    std::vector<Point>& points() const { return w_.state.data.find<Points>(ground_effect)->list; }
    const GroundPlane& plane(const Point& p) const { return declared()[p.plane]; }
    bool meets(int plane, int element) const {
        return declared()[plane].group < 0 || w_.structure.in_group(element, declared()[plane].group);
    }
    static double tangential(const Point& p) { return tangential_part * p.stiffness; }
    /// From the node to the point of the surface that touches: in small displacement nodes have no rotation to follow.
    Vec3 surface(const Point& p, const Vec3& arm) const {
        return w_.structure.large() ? Vec3(arm - p.radius * plane(p).normal) : arm;
    }
    Mat6 slope(const Point& p, const Vec3& arm, bool sticks) const {
        const Vec3& n = plane(p).normal;
        Vec6 row;
        row << n, arm.cross(n);
        Mat6 K = p.stiffness * row * row.transpose();
        if (sticks)
            for (const Vec3& along : {Vec3(n.unitOrthogonal()), Vec3(n.cross(n.unitOrthogonal()))}) {
                row << along, surface(p, arm).cross(along);
                K += tangential(p) * row * row.transpose();
            }
        return K;
    }
    bool is_held(const Point& p) const { return (w_.state.held[p.node] & 7) == 7; }
    bool rests(const Point& p) const { return w_.rests(p.node); }
    /// Whether it counts in the tangent.
    bool carries(const Point& p, const Touch& t) const { return t.overlap > (-w_.touches_within(p.radius)); }

    template <class At>
    Vec3 place_of(const Point& p, const At& at, const Vec3& arm) const {
        return w_.structure.position()[p.node] + at.displacement[p.node] + arm;
    }
    template <class At>
    double overlap_of(const Point& p, const At& at, const Vec3& arm) const {
        return p.radius - p.level - plane(p).normal.dot(place_of(p, at, arm) - plane(p).point);
    }

    /// How a point lies at a pose, on the way from where the step began.
    template <class At>
    Touch look(const Point& p, const At& at) const {
        Touch t;
        if (p.left_out || is_held(p)) return t.overlap = -p.radius, t;
        t.arm = p.element < 0 ? Vec3(Vec3::Zero()) : Vec3(at.rotation[p.node] * p.arm);
        t.overlap = overlap_of(p, at, t.arm);
        if (rests(p)) return t.overlap = std::min(0.0, t.overlap), t;
        const double mu = plane(p).friction;
        if (mu == 0) return t;
        const Vec3& n = plane(p).normal;
        Vec3 moved = place_of(p, at, t.arm) - p.place;
        if (w_.structure.large())
            moved -= rotation_vector(at.rotation[p.node] * p.rotation.conjugate()).cross(p.radius * n);
        moved -= moved.dot(n) * n;
        // of a step in which it comes to touch, the part that is left then
        const double part = p.overlap > 0 ? 1 : t.overlap > 0 ? t.overlap / (t.overlap - p.overlap) : 0;
        const contact::Friction f =
            contact::friction(p.slip, moved, part, tangential(p), mu * p.stiffness * std::max(0.0, t.overlap));
        t.slip = f.slip, t.slides = f.slides, t.heat = f.heat;
        return t;
    }
    static double energy(const Point& p, double overlap, const Vec3& slip) {
        const double o = std::max(0.0, overlap);
        return 0.5 * (p.stiffness * o * o + tangential(p) * slip.squaredNorm());
    }
    double stored(const State& state) const {
        double sum = 0;
        for (const Point& p : state.data.find<Points>(ground_effect)->list) {
            const Touch t = look(p, state);
            sum += energy(p, t.overlap, t.slip);
        }
        return sum;
    }
    /// Where the next step begins.
    template <class At>
    void take(Point& p, const Touch& t, const At& at) const {
        if (p.left_out || p.level > 0) {  // has it left the ground for the first time?
            const Vec3 arm = p.element < 0 ? Vec3(Vec3::Zero()) : Vec3(at.rotation[p.node] * p.arm);
            if (!w_.state.gone[p.node] && overlap_of(p, at, arm) + p.level <= 0) p.left_out = false, p.level = 0;
        }
        p.overlap = t.overlap;
        p.slip = t.slip;
        if (plane(p).friction == 0) return;
        p.place = place_of(p, at, t.arm);
        p.rotation = at.rotation[p.node];
    }

    /// What touches where the run begins is at rest there; what lies deeper is left out until it has left.
    void begin_at(Point& p, const State& state) const {
        const Vec3 arm = state.rotation[p.node] * p.arm;
        const double inside = overlap_of(p, state, arm);
        p.left_out = p.element < 0 && inside > (1 + buried) * p.radius;
        p.level = std::max(0.0, inside);
        p.overlap = inside - p.level;
        p.place = place_of(p, state, arm), p.rotation = state.rotation[p.node];
    }
    Point free_end(int plane, const Element& e, int element, const State& state) const {
        Point p;
        p.plane = plane, p.element = element;
        p.node = e.node[state.broken[element] == 2 ? 0 : 1];
        p.arm = state.offset_arm[element];
        p.radius = e.radius;
        const double given = declared()[plane].stiffness;
        p.stiffness = given > 0 ? given : normal_part * e.rigidity.EA / e.length;
        p.mass = 0.5 * e.mass();
        begin_at(p, state);
        return p;
    }
    Points list_points() const {
        const Structure& s = w_.structure;
        Points points;
        points.planes = int(declared().size()), points.nodes = int(s.position().size());
        for (int i = 0; i < points.planes; ++i) {
            if (declared()[i].is_layer()) continue;
            for (int n = 0; n < points.nodes; ++n) {
                Point p;
                p.plane = i, p.node = n;
                for (int element : s.elements_at(n)) {
                    if (!meets(i, element)) continue;
                    const Element& e = s.elements()[element];
                    p.radius = std::max(p.radius, e.radius);
                    const double mass = striking_mass(s, w_.state, element, e.node[0] == n ? 0 : 1);
                    p.stiffness += normal_part * e.rigidity.EA / e.length * (mass / (0.5 * e.mass()));
                    p.mass += mass;
                }
                if (p.stiffness == 0 || w_.state.gone[n]) continue;
                if (declared()[i].stiffness > 0) p.stiffness = declared()[i].stiffness;
                begin_at(p, w_.state);
                points.list.push_back(p);
            }
            for (int e = 0; e < int(s.elements().size()); ++e)
                if (w_.state.broken[e] && meets(i, e)) points.list.push_back(free_end(i, s.elements()[e], e, w_.state));
        }
        return points;
    }

    void add_impulse(const Point& p, const Touch& t, double size) {
        const Vec3 f = size * plane(p).normal;
        impulse_[p.node].head<3>() += f;
        impulse_[p.node].tail<3>() += t.arm.cross(f);
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
        add_to_trial(x, k);
        for (double& taken : taken_) taken *= x;
    }

    bool comes_out(const Point& p, const Touch& t) const {
        return p.overlap > 0 && !(t.overlap > 0) && plane(p).restitution.value_or(1) < 1;
    }
    /// Friction over pressure, along e.
    static Vec3 friction_part(const Point& p, double overlap, const Vec3& slip) {
        return tangential(p) / (p.stiffness * overlap) * slip;
    }

    /// Which points get their restitution now, and how long the others go on waiting; whether one does. A point is due
    /// with all others of its body: when none of them touches any longer, when one has waited for long enough, or when
    /// one touches again.
    bool find_due(double dt) {
        const Bodies bodies = find_bodies(w_.structure, w_.state);
        std::vector<char> touches(bodies.count, 0), over(bodies.count, 0);
        waits_.assign(touches_.size(), 0);
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const Point& p = points()[i];
            const Touch& t = touches_[i];
            const int body = bodies.of_node[p.node];
            if (body < 0 || is_held(p)) continue;
            const bool in = t.overlap > 0;
            touches[body] |= in;
            if (p.waits > 0) waits_[i] = std::max(p.waits - dt, 0.0), over[body] |= in || waits_[i] == 0;
            else if (comes_out(p, t)) waits_[i] = most_wait * M_PI * std::sqrt(p.mass / p.stiffness);
        }
        due_.assign(touches_.size(), 0);
        bool any = false;
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const Point& p = points()[i];
            const int body = bodies.of_node[p.node];
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
            const Point& p = points()[i];
            const Touch& t = touches_[i];
            const double left = plane(p).restitution.value_or(1);
            const Vec6& v = w_.trial.velocity[p.node];
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
        add_to_trial(x, k);
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
            const Point& p = points()[i];
            const Touch& t = touches_[i];
            if (taken_[i] == 0) continue;
            const Vec3 part = p.overlap > 0   ? friction_part(p, p.overlap, p.slip)
                              : p.waits > 0   ? p.dragged
                              : t.overlap > 0 ? friction_part(p, t.overlap, t.slip)
                                              : Vec3(Vec3::Zero());
            if (part.isZero(0)) continue;
            const Vec3 f = -taken_[i] * part;
            impulse_[p.node].head<3>() += f;
            impulse_[p.node].tail<3>() += surface(p, t.arm).cross(f);
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
        add_to_trial(part, along);
        lost_ -= back;
        gives_back_ = heat > 0 ? std::max(0.0, back / heat) : 0;
    }

    std::vector<Touch> touches_;  ///< as of the last add_forces or end
    std::vector<Vec6> impulse_;   ///< N s, N m s
    /// Of the normal impulse of each point, by restitution, and with what the step missed, N s.
    std::vector<double> restituted_, taken_;
    std::vector<double> waits_;  ///< s: Point::waits where the step ends; empty where no point waits
    std::vector<char> due_;      ///< points that get their restitution in this step
    int has_ = 0, had_ = 0;      ///< points that touch, at the last add_forces and the one before
    int first_ = 0;              ///< of those, the first
    double lost_ = 0;            ///< J, by friction and restitution in this step
    double gives_back_ = 0;      ///< of the heat of the points that friction is taken from
};

std::vector<PlanLine> ground_plan(const Structure& s, const RunKind&) {
    const std::size_t n = s.model().declared<GroundPlane>(ground_effect).size();
    const std::string because = n == 0   ? "not declared"
                                : n == 1 ? "model:ground"
                                         : "model:ground, " + std::to_string(n) + " planes";
    return {{ground_effect, n > 0, because, n > 0 ? s.model().asked_at("rigid ground") : ""}};
}

}  // namespace

EffectKind ground_kind() {
    return {.name = ground_effect,
            .accounts = {{"ground", 75, "stored where members press on the ground, and lost there"},
                         {"ground_stored", 76, "stored now where members press on the ground", "ground"},
                         {"ground_dissipated", 77,
                          "lost to the ground's damping, and to friction and restitution on it", "ground"}},
            .plan = ground_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                const auto& planes = w.structure.model().declared<GroundPlane>(ground_effect);
                if (std::all_of(planes.begin(), planes.end(), [](const GroundPlane& p) { return p.is_layer(); })) {
                    w.state.data.erase(ground_effect);
                    return nullptr;
                }
                return std::make_unique<Ground>(w, host);
            },
            .leave_out = leave_out_declared<ground_effect>,
            .declarer = {.planes = [](const Model& model) {
                std::vector<DeclaredPlane> list;
                for (const GroundPlane& p : model.declared<GroundPlane>(ground_effect))
                    list.push_back({p.point, p.normal});
                return list;
            }}};
}

}  // namespace hinge

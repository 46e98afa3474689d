// A ground that is a layer: springs and dashpots per area, which press on the area that members touch it with and never
// pull (contact/layer_law.h has the law). It acts on the elements, not on points, so that what lands is stopped in
// the same way with any number of elements. An element that breaks goes on as the rigid bar that hangs on its other
// node.
//
// Friction (Coulomb) is a spring along the plane at each of the two ends (contact/ground_friction.h), which the force
// of the layer on that end limits.
//
// What the dashpots take is their work by the trapezium rule, as that of loads.
#include <algorithm>
#include <cmath>

#include "contact/ground_friction.h"
#include "contact/layer_law.h"
#include "core/rotation.h"
#include "effects/ground.h"
#include "effects/kinds.h"

namespace hinge {
namespace {

constexpr const char* layer_data = "ground layer";
/// Stiffness of friction's spring over that of the layer on half the element's side, or on the end face. The spring
/// must reach Coulomb's force while it is much shorter than a bar slides as it lands on its end: the impulse that a
/// column of 88 kg, tilted by 20 degrees, gets along the ground with friction 0.3 at 3 m/s is 22 N s if this is 0.4, 61
/// if 10, 65 if 100 (4 and 32 elements differ by 3 %). Explicit steps become 3 % shorter from 10 to 100.
constexpr double tangential_stiffness_part = 100;
/// Part of the half depth: ends that begin further than this below the plane are no part of what stands on it.
constexpr double deep_in_the_layer = 0.01;
/// Forces that differ by this part of themselves from what a step was solved with ask for another solution.
constexpr double same_force = 0.01;

/// An end of a strip.
struct End {
    int node = 0;
    Vec3 arm = Vec3::Zero();  ///< of the free end of a broken element: m, from the node in the node's own frame
    double area = 0;          ///< of the section, m^2
    double stiffness = 0;     ///< of friction's spring, N/m
    bool has_face = false;    ///< the member ends here; taken up where the end is apart from the ground
    bool left_out = false;    ///< began below the plane and has not left it yet
    double level = 0;         ///< m: how far it was inside where it began: there it is at rest

    // where a step begins
    Vec3 slip = Vec3::Zero();  ///< e, m
    Vec3 loss = Vec3::Zero();  ///< force of the dashpots, as it resists, N

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.node, s.arm, s.area, s.stiffness, s.has_face, s.left_out, s.level, s.slip, s.loss);
    }
};

/// An element over a plane.
struct Strip {
    int plane = 0, element = 0;
    bool gone = false;  ///< with the node that carried it
    contact::LayerPiece piece;
    End end[2];
    bool touches = false;  ///< where a step begins
    double stored = 0;     ///< J, there

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.plane, s.element, s.gone, s.piece.stiffness, s.piece.damping, s.piece.width, s.piece.length, s.piece.taper,
          s.piece.end_area, s.end, s.touches, s.stored);
    }
};

struct Strips {
    int planes = 0, nodes = 0;
    std::vector<Strip> list;
    static constexpr bool in_state_hash = false;  ///< the hash of a state is that of its arrays
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.planes, s.nodes, s.list);
    }
};

/// How a strip lies somewhere.
struct StripTouch {
    bool touches = false;    ///< nothing below counts where neither it nor the last step did
    Vec3 at = Vec3::Zero();  ///< where the first end is, m
    contact::LayerPlace place;
    contact::LayerPress press;
    Vec3 arm[2];                                              ///< from the node to the end, m
    Vec3 resists[2], loss[2] = {Vec3::Zero(), Vec3::Zero()};  ///< N; the dashpots' part
    contact::Friction friction[2];
    double work = 0;  ///< J, of the dashpots since the step began
    bool carries() const { return press.area[0] > 0 || press.area[2] > 0; }
};

class GroundLayer : public Effect,
                    public Force,
                    public ContactLaw,
                    public BreakListener,
                    public StepLimiter,
                    public Sleeper {
public:
    GroundLayer(Workspace& w, Host& host) : Effect(ground_effect, w, host, {.forces_vanish = true}) {
        const int planes = int(declared().size()), nodes = int(w.structure.position().size());
        const Strips* there = w.state.data.find<Strips>(layer_data);
        if (!there || there->planes != planes || there->nodes != nodes) w.state.data.set(layer_data, list_strips());
    }

    void add_forces(double, std::vector<Vec6>& resisting) override {
        had_ = has_, has_ = 0;
        find_touches();
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const StripTouch& t = touches_[i];
            if (!t.touches) continue;
            if (t.carries()) ++has_, first_ = has_ == 1 ? int(i) : first_;
            const Strip& s = strips()[i];
            for (int e : {0, 1}) {
                const Vec3 drag = s.end[e].stiffness * t.friction[e].slip;
                Vec6& r = resisting[s.end[e].node];
                r.head<3>() += t.resists[e] + drag;
                r.tail<3>() += t.arm[e].cross(t.resists[e]) + surface(s, t.arm[e]).cross(drag);
            }
        }
    }
    /// Left out: the slope of a friction that slides, which has no symmetry, how the arms rotate, and how the area
    /// changes as a bar topples.
    void add_blocks(const ConfigurationView&, Blocks& blocks) const override {
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const Strip& s = strips()[i];
            const StripTouch& t = touches_[i];
            if (!t.touches || !t.carries()) continue;
            Vec6 row[2];
            for (int e : {0, 1}) row[e] = row_of(plane(s).normal, t.arm[e]);
            const double(&area)[3] = t.press.area;
            const Mat6 one = area[0] * row[0] * row[0].transpose(), other = area[2] * row[1] * row[1].transpose(),
                       mixed = area[1] * row[0] * row[1].transpose();
            if (s.end[0].node == s.end[1].node) {
                const Mat6 sum = one + other + mixed + mixed.transpose();
                blocks.stiffness(s.end[0].node, Mat6(s.piece.stiffness * sum));
                if (s.piece.damping > 0) blocks.damping(s.end[0].node, Mat6(s.piece.damping * sum));
            } else {
                Mat12 sum;
                sum << one, mixed, mixed.transpose(), other;
                blocks.stiffness(s.end[0].node, s.end[1].node, Mat12(s.piece.stiffness * sum));
                if (s.piece.damping > 0) blocks.damping(s.end[0].node, s.end[1].node, Mat12(s.piece.damping * sum));
            }
            for (int e : {0, 1})
                if (plane(s).friction > 0 && area[2 * e] > 0 && !t.friction[e].slides)
                    blocks.stiffness(s.end[e].node, slope_of_friction(s, e, t.arm[e]));
        }
    }
    bool has_blocks() const override { return has_ > 0 || had_ > 0; }
    bool blocks_follow() const override { return has_blocks(); }

    /// Everywhere at once, each end with the larger of what it has flat and upright. Newmark's steps take a dashpot
    /// that stops its node for a spring whose frequency is the dashpot's rate: longer ones would throw the node back.
    void add_stiffest(Blocks& most) const override {
        for (const Strip& s : strips()) {
            const double mass = 0.5 * w_.structure.elements()[s.element].mass();
            for (int e : {0, 1}) {
                const End& end = s.end[e];
                if (is_held(end.node)) continue;
                const Vec3 arm = arm_of(end, w_.state);
                const Vec6 row = row_of(plane(s).normal, arm);
                const Mat6 square = row * row.transpose();
                const double area = std::max(part_of(s, e) * s.piece.width * s.piece.length, end.area);
                const double c = s.piece.damping * area, by_rate = w_.kind.explicit_steps ? 0 : c * c / mass;
                Mat6 K = (s.piece.stiffness * area + by_rate) * square;
                if (plane(s).friction > 0) K += slope_of_friction(s, e, arm);
                most.stiffness(end.node, K);
                if (c > 0) most.damping(end.node, Mat6(c * square));
            }
        }
    }

    /// Another solution is needed where the forces are others than those that the last one foresaw.
    bool settled() override {
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const Strip& s = strips()[i];
            const StripTouch &before = touches_[i], now = look(s, w_.trial);
            if (!now.touches && !before.touches) continue;
            const double least = same_force * s.piece.stiffness * s.piece.width * s.piece.length * just_touches *
                                 w_.structure.elements()[s.element].radius;
            double change[2];
            for (int e : {0, 1})
                change[e] = s.piece.stiffness * (now.place.overlap[e] - before.place.overlap[e]) +
                            s.piece.damping * (now.place.rate[e] - before.place.rate[e]);
            const double(&area)[3] = before.press.area;
            const double foreseen[2] = {before.press.force[0] + area[0] * change[0] + area[1] * change[1],
                                        before.press.force[1] + area[1] * change[0] + area[2] * change[1]};
            for (int e : {0, 1}) {
                const double force = now.press.force[e];
                if (std::abs(force - foreseen[e]) > same_force * std::max(force, std::abs(foreseen[e])) + least)
                    return false;
                const double most = plane(s).friction * force;
                const double other = (now.friction[e].slip - before.friction[e].slip).norm();
                if (most > least && s.end[e].stiffness * other > same_force * most) return false;
            }
        }
        return true;
    }
    /// In explicit steps the forces were taken at the predicted velocity, and those do the work.
    void solved(const Step&, const std::vector<Vec6>&) override {
        if (!w_.kind.explicit_steps) find_touches();
    }

    /// Long steps end before a strip touches.
    bool meet(const Step& step) override {
        if (!step.longer) return true;
        for (const Strip& s : strips()) {
            for (const End& end : s.end) {
                if (s.gone || end.left_out || is_held(end.node) || w_.rests(end.node)) continue;
                const Vec6 foreseen = w_.state.velocity[end.node] + (0.5 * step.dt) * w_.state.acceleration[end.node];
                const Vec3 arm = arm_of(end, w_.state);
                const double closing = -row_of(plane(s).normal, arm).dot(foreseen) * step.dt;
                if (overlap_of(s, end, place_of(end, w_.state, arm)) + closing > 0) return false;
            }
        }
        return true;
    }

    void accumulate_energy(const Step&, Accounts& sums) const override {
        double lost = 0;
        for (const StripTouch& t : touches_) lost += t.work + t.friction[0].heat + t.friction[1].heat;
        sums["ground_dissipated"] += lost;
    }
    /// Where the next step begins.
    void before_commit(const Step&) override {
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            Strip& s = strips()[i];
            const StripTouch& t = touches_[i];
            if (!t.touches && !s.touches && !waits(s)) continue;
            take(s, t);
            if (!t.touches) take_up_widths(s);
            for (int e : {0, 1}) {
                End& end = s.end[e];
                const double inside = overlap_of(s, end, place_of(end, w_.trial, arm_of(end, w_.trial)));
                if (inside + end.level <= 0) end.left_out = false, end.level = 0;
                if (inside <= 0 && end.slip.isZero(0)) take_up_face(s, e);
            }
        }
    }
    /// Forces where a step begins that were found anew.
    void acceleration_found() override {
        for (std::size_t i = 0; i < touches_.size(); ++i)
            for (int e : {0, 1}) strips()[i].end[e].loss = touches_[i].loss[e];
    }

    /// The strip of what breaks goes on as that of the rigid bar; what was attached to a node that is gone presses no
    /// longer.
    void broke(const Break& b) override {
        double lost = 0;
        const int partner = w_.structure.elements()[b.element].partner;
        for (Strip& s : strips()) {
            if (s.gone) continue;
            if (s.element == b.element) {
                lost += energy(s);
                attach(s);
                const StripTouch t = look(s, w_.state);
                take(s, t);
                lost -= energy(s);
            }
            if (w_.state.gone[s.end[0].node] || w_.state.gone[s.end[1].node])
                lost += energy(s), s.gone = true, take(s, StripTouch());
            for (int e : {0, 1}) s.end[e].has_face = member_ends(s, e);
            const bool lumps_change = s.element == b.element || s.element == partner;
            if (lumps_change && !s.touches && !s.gone) take_up_widths(s);
        }
        w_.state.accumulated["ground_dissipated"] += lost;
        touches_.clear();
    }

    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        for (const Strip& s : strips()) {
            const int body = bodies.of_node[s.end[0].node];
            if (body >= 0 && look(s, w_.state).touches) rests[body] = 0;
        }
    }
    bool allows_long_step() const override { return has_ == 0; }
    bool busy() const override { return has_ > 0; }
    std::string why_awake() const override {
        return w_.structure.element_name(strips()[first_].element) + " on the ground";
    }

    void add_energy(const State& state, Accounts& sums) const override { sums["ground_stored"] += stored(state); }
    void save(Writer& to) const override { to(has_, had_, first_); }
    void restore(Reader& from) override { from(has_, had_, first_); }
    bool restored(std::span<const State* const> states) override {
        const int nodes = int(w_.structure.position().size()), elements = int(w_.structure.elements().size());
        const auto within = [](int i, int n) { return i >= 0 && i < n; };
        for (const State* s : states) {
            const Strips* there = s->data.find<Strips>(layer_data);
            if (!there || there->planes != int(declared().size()) || there->nodes != nodes) return false;
            for (const Strip& p : there->list)
                if (!within(p.plane, there->planes) || !within(p.element, elements) || !within(p.end[0].node, nodes) ||
                    !within(p.end[1].node, nodes))
                    return false;
        }
        touches_.clear();
        return has_ >= 0 && had_ >= 0 && (strips().empty() || within(first_, int(strips().size())));
    }

private:
    const std::vector<GroundPlane>& declared() const { return declared_; }
    const std::vector<GroundPlane>& declared_ = w_.structure.model().declared<GroundPlane>(ground_effect);
    std::vector<Strip>& strips() const { return w_.state.data.find<Strips>(layer_data)->list; }
    const GroundPlane& plane(const Strip& s) const { return declared()[s.plane]; }
    bool is_held(int node) const { return (w_.state.held[node] & 7) == 7; }

    static Vec6 row_of(const Vec3& direction, const Vec3& arm) {
        Vec6 row;
        row << direction, arm.cross(direction);
        return row;
    }
    template <class At>
    static Vec3 arm_of(const End& end, const At& at) {
        return end.arm.isZero(0) ? Vec3(Vec3::Zero()) : Vec3(at.rotation[end.node] * end.arm);
    }
    template <class At>
    Vec3 place_of(const End& end, const At& at, const Vec3& arm) const {
        return w_.structure.position()[end.node] + at.displacement[end.node] + arm;
    }
    double overlap_of(const Strip& s, const End& end, const Vec3& place) const {
        const GroundPlane& p = plane(s);
        return w_.structure.elements()[s.element].radius - end.level - p.normal.dot(place - p.point);
    }
    /// From the node to the point of the surface that touches: in small displacement nodes have no rotation to follow.
    Vec3 surface(const Strip& s, const Vec3& arm) const {
        return w_.structure.large() ? Vec3(arm - w_.structure.elements()[s.element].radius * plane(s).normal) : arm;
    }
    Mat6 slope_of_friction(const Strip& s, int e, const Vec3& arm) const {
        const Vec3& n = plane(s).normal;
        Mat6 K = Mat6::Zero();
        for (const Vec3& along : {Vec3(n.unitOrthogonal()), Vec3(n.cross(n.unitOrthogonal()))}) {
            const Vec6 row = row_of(along, surface(s, arm));
            K += s.end[e].stiffness * row * row.transpose();
        }
        return K;
    }

    void find_touches() {
        const std::vector<Strip>& all = strips();
        touches_.resize(all.size());
        for (std::size_t i = 0; i < all.size(); ++i) touches_[i] = look(all[i], w_.trial);
    }

    /// How a strip lies at a pose, on the way from where the step began.
    template <class At>
    StripTouch look(const Strip& s, const At& at) const {
        StripTouch t;
        if (s.gone) return t;
        const Vec3& n = plane(s).normal;
        const double touching = w_.touches_within(w_.structure.elements()[s.element].radius);
        Vec3 place[2];
        for (int e : {0, 1}) {
            const End& end = s.end[e];
            t.arm[e] = arm_of(end, at);
            place[e] = place_of(end, at, t.arm[e]);
            double& o = t.place.overlap[e];
            o = overlap_of(s, end, place[e]);
            // none of its own, but the other end may lie on the ground
            if (end.left_out || is_held(end.node) || w_.rests(end.node)) o = std::min(0.0, o);
        }
        t.touches = t.place.overlap[0] > -touching || t.place.overlap[1] > -touching;
        if (!t.touches && !s.touches) return t;

        t.at = place[0];
        const Vec3 chord = place[1] - place[0];
        const double length = chord.norm(), rise = n.dot(chord) / length;
        t.place.lean[0] = rise, t.place.lean[1] = -rise;
        for (int e : {0, 1}) t.place.rate[e] = -row_of(n, t.arm[e]).dot(w_.velocity(at, s.end[e].node));
        t.press = contact::press(s.piece, t.place, touching);
        const Vec3 turned = (n - rise / length * chord) / length;  // derivative of `rise` by the second end
        for (int e : {0, 1}) {
            const double sign = e == 0 ? -1 : 1;
            t.loss[e] = (t.press.elastic[e] - t.press.force[e]) * n;
            t.resists[e] = -t.press.force[e] * n + sign * (t.press.leaning[0] - t.press.leaning[1]) * turned;
        }
        add_history(s, at, place, t);
        return t;
    }

    /// Friction and the work of the dashpots since the step began.
    template <class At>
    void add_history(const Strip& s, const At& at, const Vec3 (&place)[2], StripTouch& t) const {
        const GroundPlane& p = plane(s);
        double part = 1;  // of a step in which it comes to touch, the part that is left then
        Vec3 arm[2], before[2];
        double deepest = 0;
        for (int e : {0, 1}) {
            arm[e] = arm_of(s.end[e], w_.state);
            before[e] = place_of(s.end[e], w_.state, arm[e]);
            const double o = t.place.overlap[e];
            if (s.touches || o <= deepest) continue;
            deepest = o;
            part = std::min(1.0, o / (o - std::min(0.0, overlap_of(s, s.end[e], before[e]))));
        }
        for (int e : {0, 1}) {
            const End& end = s.end[e];
            Vec3 moved = place[e] - before[e];
            // in statics its dashpots do no work
            if (w_.kind.dynamic) t.work += 0.5 * (end.loss + t.loss[e]).dot(moved);
            if (p.friction == 0) continue;
            if (w_.structure.large())
                moved -= rotation_vector(at.rotation[end.node] * w_.state.rotation[end.node].conjugate())
                             .cross(w_.structure.elements()[s.element].radius * p.normal);
            moved -= moved.dot(p.normal) * p.normal;
            t.friction[e] = contact::friction(end.slip, moved, part, end.stiffness, p.friction * t.press.force[e]);
        }
    }

    /// A touch as where the next step begins.
    static void take(Strip& s, const StripTouch& t) {
        s.touches = t.touches;
        s.stored = t.press.stored;
        for (int e : {0, 1}) {
            s.end[e].slip = t.friction[e].slip;
            s.end[e].loss = t.loss[e];
        }
    }
    /// Something changes as it leaves the ground.
    static bool waits(const Strip& s) {
        for (int e : {0, 1})
            if (s.end[e].left_out || s.end[e].level > 0 || s.end[e].has_face != (s.piece.end_area[e] > 0)) return true;
        return false;
    }
    static double energy(const Strip& s) {
        double sum = s.stored;
        for (const End& end : s.end) sum += 0.5 * end.stiffness * end.slip.squaredNorm();
        return sum;
    }
    /// J: of the trial where the state is at its pose just now, as step control has it, else as it was kept.
    double stored(const State& state) const {
        const std::vector<Strip>& list = state.data.find<Strips>(layer_data)->list;
        double sum = 0;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const Strip& s = list[i];
            const bool tried = touches_.size() == list.size() && (s.touches || touches_[i].touches) &&
                               touches_[i].at == place_of(s.end[0], state, arm_of(s.end[0], state));
            if (!tried) {
                sum += energy(s);
                continue;
            }
            sum += touches_[i].press.stored;
            for (int e : {0, 1}) sum += 0.5 * s.end[e].stiffness * touches_[i].friction[e].slip.squaredNorm();
        }
        return sum;
    }

    bool member_ends(const Strip& s, int e) const {
        const Structure& structure = w_.structure;
        if (w_.state.broken[s.element] && !s.end[e].arm.isZero(0)) return true;
        for (int other : structure.elements_at(s.end[e].node))
            if (other != s.element && !w_.state.broken[other] &&
                structure.elements()[other].member == structure.elements()[s.element].member)
                return false;
        return true;
    }
    /// Part of a strip's area that its end has: that of the element's mass which is lumped there (element_mass.h), so
    /// that what lands flat is stopped without bending; else half.
    double part_of(const Strip& s, int end) const {
        const Structure& structure = w_.structure;
        const Element& e = structure.elements()[s.element];
        const bool broken = w_.state.broken[s.element] || (e.partner >= 0 && w_.state.broken[e.partner]);
        return structure.lumped() && !broken ? e.inertia.own[end] / e.mass() : 0.5;
    }
    /// A broken element: its free end is on an arm of the node that carries it.
    void attach(Strip& s) const {
        const int free = w_.state.broken[s.element] == 2 ? 1 : 0;
        s.end[free].node = w_.structure.elements()[s.element].node[1 - free];
        s.end[free].arm = w_.state.offset_arm[s.element];
    }
    /// Where it is apart from the ground: so no energy changes with a break.
    void take_up_widths(Strip& s) const {
        for (int e : {0, 1}) s.piece.taper[e] = 6 * part_of(s, e) - 2;
    }
    /// Friction's spring is that of the face where there is one: what lands on an end then sticks as firmly with short
    /// elements as with long ones.
    void take_up_face(Strip& s, int e) const {
        End& end = s.end[e];
        s.piece.end_area[e] = end.has_face ? end.area : 0;
        end.stiffness = tangential_stiffness_part * s.piece.stiffness *
                        (end.has_face ? end.area : part_of(s, e) * s.piece.width * s.piece.length);
    }
    Strip strip_of(int plane, int element) const {
        const Structure& structure = w_.structure;
        const Element& e = structure.elements()[element];
        const GroundPlane& declared = this->declared()[plane];
        Strip s;
        s.plane = plane, s.element = element;
        s.piece.stiffness = declared.layer_stiffness, s.piece.damping = declared.layer_damping;
        s.piece.width = 2 * e.radius, s.piece.length = e.length;
        for (int i : {0, 1}) s.end[i].node = e.node[i];
        if (w_.state.broken[element]) attach(s);
        take_up_widths(s);
        for (int i : {0, 1}) {
            End& end = s.end[i];
            end.area = structure.model().members()[e.member].section->area;
            end.has_face = member_ends(s, i);
            take_up_face(s, i);
            // what touches where the run begins is at rest there; what lies deeper is left out until it has left
            const double inside = overlap_of(s, end, place_of(end, w_.state, arm_of(end, w_.state)));
            end.left_out = end.arm.isZero(0) && inside > (1 + deep_in_the_layer) * e.radius;
            end.level = std::max(0.0, inside);
            s.gone = s.gone || w_.state.gone[end.node];
        }
        return s;
    }
    Strips list_strips() const {
        const Structure& structure = w_.structure;
        Strips strips;
        strips.planes = int(declared().size()), strips.nodes = int(structure.position().size());
        for (int i = 0; i < strips.planes; ++i) {
            const GroundPlane& p = declared()[i];
            if (!p.is_layer()) continue;
            for (int e = 0; e < int(structure.elements().size()); ++e)
                if (p.group < 0 || structure.in_group(e, p.group)) strips.list.push_back(strip_of(i, e));
        }
        return strips;
    }

    std::vector<StripTouch> touches_;  ///< as of the last add_forces or solved
    int has_ = 0, had_ = 0;            ///< strips that touch, at the last add_forces and the one before
    int first_ = 0;                    ///< of those, the first
};

}  // namespace

EffectKind ground_layer_kind() {
    return {.name = layer_data,  // its accounts and its line of the plan are those of `ground`
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                const auto& planes = w.structure.model().declared<GroundPlane>(ground_effect);
                if (std::none_of(planes.begin(), planes.end(), [](const GroundPlane& p) { return p.is_layer(); })) {
                    w.state.data.erase(layer_data);
                    return nullptr;
                }
                return std::make_unique<GroundLayer>(w, host);
            }};
}

}  // namespace hinge

// A layer of springs and dashpots per area: the law of all other planes. It presses on the area that members touch it
// with and never pulls (contact/layer_law.h has the law). It acts on the elements, not on points, so that what lands is
// stopped in the same way with any number of elements. An element that breaks goes on as the rigid bar that hangs on
// its other node.
//
// Friction (Coulomb) is a spring along the plane at each of the two ends (contact/ground_friction.h), which the force
// of the layer on that end limits.
//
// What the dashpots take is their work by the trapezium rule, as that of loads.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/ground_friction.h"
#include "effects/ground_law.h"
#include "state/bodies.h"

namespace hinge {
namespace {

/// Stiffness of friction's spring over that of the layer on half the element's side, or on the end face. The spring
/// must reach Coulomb's force while it is much shorter than a bar slides as it lands on its end: the impulse that a
/// column of 88 kg, tilted by 20 degrees, gets along the ground with friction 0.3 at 3 m/s is 22 N s if this is 0.4, 61
/// if 10, 65 if 100 (4 and 32 elements differ by 3 %). Explicit steps become 3 % shorter from 10 to 100.
constexpr double tangential_stiffness_part = 100;
/// Forces that differ by this part of themselves from what a step was solved with ask for another solution.
constexpr double same_force = 0.01;
/// Strips that are further from their plane than this many times the largest half depth are left alone until a node has
/// moved as far. Any value gives the same bits: it weighs the strips near the ground against how often all are listed.
constexpr double near_depths = 4;

/// Contact of a strip at a pose.
struct StripTouch {
    bool touches = false;
    bool counts = false;     ///< it touches, or did where the step begins: else all below is zero
    Vec3 at = Vec3::Zero();  ///< where the first end is, m
    contact::LayerPlace place;
    contact::LayerPress press;
    Vec3 arm[2];                                              ///< from the node to the end, m
    Vec3 resists[2], loss[2] = {Vec3::Zero(), Vec3::Zero()};  ///< N; the dashpots' part
    contact::Friction friction[2];
    double work = 0;  ///< J, of the dashpots since the step began
    bool carries() const { return press.area[0] > 0 || press.area[2] > 0; }
};

class GroundLayer : public GroundLaw {
public:
    using GroundLaw::GroundLaw;

    void list(GroundData& to) const override {
        for (int i = 0; i < int(planes_.size()); ++i)
            for (int e = 0; planes_[i].is_layer() && e < int(w_.structure.elements().size()); ++e)
                if (presses_on(i, e)) to.strips.push_back(strip_of(i, e));
    }

    void add_forces(std::vector<Vec6>& resisting) override {
        pressed.begin();
        find_touches();
        for (int i : near_) {
            const StripTouch& t = touches_[i];
            if (!t.touches) continue;
            if (t.carries()) pressed.add(std::size_t(i));
            const GroundStrip& s = strips()[i];
            for (int e : {0, 1}) add_force(s.end[e], plane(s), t.arm[e], t.resists[e], t.friction[e].slip, resisting);
        }
    }
    /// Left out: the slope of a friction that slides, which has no symmetry, how the arms rotate, and how the area
    /// changes as a bar topples.
    void add_blocks(Blocks& blocks) const override {
        for (int i : near_) {
            const GroundStrip& s = strips()[i];
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
                    blocks.stiffness(s.end[e].node, slope_of_friction(s.end[e], plane(s), t.arm[e]));
        }
    }
    /// Everywhere at once, each end with the larger of what it has flat and upright. Newmark's steps take a dashpot
    /// that stops its node for a spring whose frequency is the dashpot's rate: longer ones would throw the node back.
    void add_stiffest(Blocks& most) const override {
        for (const GroundStrip& s : strips()) {
            const double mass = 0.5 * w_.structure.elements()[s.element].mass();
            for (int e : {0, 1}) {
                const GroundEnd& end = s.end[e];
                if (is_held(end.node)) continue;
                const Vec3 arm = arm_of(end, w_.state);
                const Vec6 row = row_of(plane(s).normal, arm);
                const Mat6 square = row * row.transpose();
                const double area = std::max(part_of(s, e) * s.piece.width * s.piece.length, s.area[e]);
                const double c = s.piece.damping * area, by_rate = w_.kind.explicit_steps ? 0 : c * c / mass;
                Mat6 K = (s.piece.stiffness * area + by_rate) * square;
                if (plane(s).friction > 0) K += slope_of_friction(end, plane(s), arm);
                most.stiffness(end.node, K);
                if (c > 0) most.damping(end.node, Mat6(c * square));
            }
        }
    }

    /// Another solution is needed where the forces are others than those that the last one foresaw.
    bool has_converged() const override {
        const std::vector<int> all = touches_.empty() || is_listed(w_.trial) ? std::vector<int>() : all_strips();
        for (int i : all.empty() ? near_ : all) {
            const GroundStrip& s = strips()[i];
            const StripTouch &before = touches_[i], now = touch(s, w_.trial);
            if (!now.touches && !before.touches) continue;
            const double least =
                same_force * s.piece.stiffness * s.piece.width * s.piece.length * just_touches * s.end[0].radius;
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
    void solved() override {
        if (!w_.kind.explicit_steps) find_touches();
    }

    bool touches_within(const Step& step) const override {
        return std::any_of(strips().begin(), strips().end(), [&](const GroundStrip& s) {
            return !s.gone && (GroundLaw::touches_within(s.end[0], plane(s), step) ||
                               GroundLaw::touches_within(s.end[1], plane(s), step));
        });
    }

    double lost() const override {
        double lost = 0;
        for (int i : near_) lost += touches_[i].work + touches_[i].friction[0].heat + touches_[i].friction[1].heat;
        return lost;
    }
    /// Where the next step begins.
    void before_commit() override {
        for (int i : near_) {
            GroundStrip& s = strips()[i];
            const StripTouch& t = touches_[i];
            if (!t.touches && !s.touches && !changes_when_apart(s)) continue;
            keep(s, t);
            if (!t.touches) set_widths(s);
            for (int e : {0, 1}) {
                GroundEnd& end = s.end[e];
                const double inside = overlap_of(end, plane(s), place_of(end, w_.trial, arm_of(end, w_.trial)));
                if (inside + end.level <= 0) end.left_out = false, end.level = 0;
                if (inside <= 0 && end.slip.isZero(0)) set_face(s, e);
            }
        }
    }
    /// Forces where a step begins that were found anew.
    void acceleration_found() override {
        for (int i : near_)
            for (int e : {0, 1}) strips()[i].loss[e] = touches_[i].loss[e];
    }

    /// The strip of what breaks goes on as that of the rigid bar; what was attached to a node that is gone presses no
    /// longer.
    double broke(const Break& b) override {
        double lost = 0;
        const int partner = w_.structure.elements()[b.element].partner;
        for (GroundStrip& s : strips()) {
            if (s.gone) continue;
            if (s.element == b.element) {
                lost += energy(s);
                attach(s);
                const StripTouch t = touch(s, w_.state);
                keep(s, t);
                lost -= energy(s);
            }
            if (w_.state.gone[s.end[0].node] || w_.state.gone[s.end[1].node])
                lost += energy(s), s.gone = true, keep(s, StripTouch());
            for (int e : {0, 1}) s.has_face[e] = member_ends(s, e);
            const bool lumps_change = s.element == b.element || s.element == partner;
            if (lumps_change && !s.touches && !s.gone) set_widths(s);
        }
        forget();
        return lost;
    }

    void hold_up(const Bodies& bodies, std::vector<char>& held_up) const override {
        for (const GroundStrip& s : strips())
            if (const int body = bodies.of_node[s.end[0].node]; body >= 0 && s.touches) held_up[body] = 1;
    }
    /// Strips of what has come to rest stay as they are, with what they store, until it takes part again.
    void rest_changed() override {
        for (GroundStrip& s : strips())
            if (!s.gone && w_.rests(s.end[0].node)) keep(s, touch(s, w_.state));
        forget();
    }
    /// Of the trial where the state is at its pose just now, as step control has it, else as it was kept.
    double stored(const State& state) const override {
        const std::vector<GroundStrip>& list = state.data.find<GroundData>(ground_effect)->strips;
        double sum = 0;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const GroundStrip& s = list[i];
            const bool tried = touches_.size() == list.size() && !w_.rests(s.end[0].node) &&
                               (s.touches || touches_[i].touches) &&
                               touches_[i].at == place_of(s.end[0], state, arm_of(s.end[0], state));
            sum += tried ? touches_[i].press.stored : energy(s);
            for (int e = 0; tried && e < 2; ++e)
                sum += 0.5 * s.end[e].stiffness * touches_[i].friction[e].slip.squaredNorm();
        }
        return sum;
    }
    std::string name_of_first() const override { return w_.structure.element_name(strips()[pressed.first].element); }
    void restored() override { forget(); }

private:
    std::vector<GroundStrip>& strips() const { return data().strips; }
    const GroundPlane& plane(const GroundStrip& s) const { return planes_[s.plane]; }

    void find_touches() {
        if (touches_.empty() || !is_listed(w_.trial)) list_near(w_.trial);
        for (int i : near_) {
            const GroundStrip& s = strips()[i];
            if (s.touches || !is_apart(s, w_.trial)) touches_[i] = touch(s, w_.trial);
            else if (touches_[i].counts) touches_[i] = {};
        }
    }
    void forget() { touches_.clear(), near_.clear(); }

    /// Lists the strips that may touch until a node has moved by margin_ from where it is at this pose.
    template <class At>
    void list_near(const At& at) {
        const std::vector<GroundStrip>& all = strips();
        forget();
        touches_.resize(all.size());
        double largest = 0;
        for (const GroundStrip& s : all) largest = std::max(largest, s.end[0].radius);
        margin_ = near_depths * largest;
        listed_at_ = at.displacement;
        for (int i = 0; i < int(all.size()); ++i)
            if (!all[i].gone && !w_.rests(all[i].end[0].node) && (acts_apart(all[i]) || is_near(all[i], at)))
                near_.push_back(i);
    }
    template <class At>
    bool is_near(const GroundStrip& s, const At& at) const {
        return std::any_of(s.end, s.end + 2, [&](const GroundEnd& end) {
            return overlap_of(end, plane(s), place_of(end, at, Vec3::Zero())) >= -margin_ - just_touches * end.radius;
        });
    }
    /// What touched where the step begins, what changes as it leaves, and what is on an arm that may rotate.
    static bool acts_apart(const GroundStrip& s) {
        return s.touches || changes_when_apart(s) || !s.end[0].arm.isZero(0) || !s.end[1].arm.isZero(0);
    }
    template <class At>
    bool is_listed(const At& at) const {
        double most[4] = {0, 0, 0, 0};  // by turns: in a single one each comparison waits for the one before
        for (int n = 0; n < int(listed_at_.size()); ++n)
            if (!w_.rests(n)) most[n % 4] = std::max(most[n % 4], (at.displacement[n] - listed_at_[n]).squaredNorm());
        return std::max(std::max(most[0], most[1]), std::max(most[2], most[3])) < margin_ * margin_;
    }
    std::vector<int> all_strips() const {
        std::vector<int> all(strips().size());
        std::iota(all.begin(), all.end(), 0);
        return all;
    }

    /// o of an end at such a place, m: none of its own where it is left out or held, but the other end of its strip may
    /// lie on the ground.
    double overlap_at(const GroundEnd& end, const GroundPlane& plane, const Vec3& place) const {
        const double o = overlap_of(end, plane, place);
        return end.left_out || is_held(end.node) ? std::min(0.0, o) : o;
    }
    /// Whether neither end is within reach of the ground.
    template <class At>
    bool is_apart(const GroundStrip& s, const At& at) const {
        const double touching = w_.touches_within(s.end[0].radius);
        return std::none_of(s.end, s.end + 2, [&](const GroundEnd& end) {
            return overlap_at(end, plane(s), place_of(end, at, arm_of(end, at))) > -touching;
        });
    }

    /// Contact of a strip at a pose, on the way from where the step began.
    template <class At>
    StripTouch touch(const GroundStrip& s, const At& at) const {
        StripTouch t;
        if (s.gone) return t;
        const Vec3& n = plane(s).normal;
        const double touching = w_.touches_within(s.end[0].radius);
        Vec3 place[2];
        for (int e : {0, 1}) {
            const GroundEnd& end = s.end[e];
            t.arm[e] = arm_of(end, at);
            place[e] = place_of(end, at, t.arm[e]);
            t.place.overlap[e] = overlap_at(end, plane(s), place[e]);
        }
        t.touches = t.place.overlap[0] > -touching || t.place.overlap[1] > -touching;
        t.counts = t.touches || s.touches;
        if (!t.counts) return t;

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
    void add_history(const GroundStrip& s, const At& at, const Vec3 (&place)[2], StripTouch& t) const {
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
            part = std::min(1.0, o / (o - std::min(0.0, overlap_of(s.end[e], p, before[e]))));
        }
        for (int e : {0, 1}) {
            const GroundEnd& end = s.end[e];
            const Vec3 moved = place[e] - before[e];
            // in statics its dashpots do no work
            if (w_.kind.dynamic) t.work += 0.5 * (s.loss[e] + t.loss[e]).dot(moved);
            if (p.friction == 0) continue;
            const Vec3 along = moved_along(end, p, moved, w_.state.rotation[end.node], at.rotation[end.node]);
            t.friction[e] = contact::friction(end.slip, along, part, end.stiffness, p.friction * t.press.force[e]);
        }
    }

    /// Where the next step begins.
    static void keep(GroundStrip& s, const StripTouch& t) {
        s.touches = t.touches;
        s.stored = t.press.stored;
        for (int e : {0, 1}) {
            s.end[e].slip = t.friction[e].slip;
            s.loss[e] = t.loss[e];
        }
    }
    /// Something changes as it leaves the ground.
    static bool changes_when_apart(const GroundStrip& s) {
        for (int e : {0, 1})
            if (s.end[e].left_out || s.end[e].level > 0 || s.has_face[e] != (s.piece.end_area[e] > 0)) return true;
        return false;
    }
    static double energy(const GroundStrip& s) {
        double sum = s.stored;
        for (const GroundEnd& end : s.end) sum += 0.5 * end.stiffness * end.slip.squaredNorm();
        return sum;
    }
    Mat6 slope_of_friction(const GroundEnd& end, const GroundPlane& plane, const Vec3& arm) const {
        Mat6 K = Mat6::Zero();
        add_slope_of_friction(end, plane, arm, K);
        return K;
    }

    bool member_ends(const GroundStrip& s, int e) const {
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
    double part_of(const GroundStrip& s, int end) const {
        const Structure& structure = w_.structure;
        const Element& e = structure.elements()[s.element];
        const bool broken = w_.state.broken[s.element] || (e.partner >= 0 && w_.state.broken[e.partner]);
        return structure.lumped() && !broken ? e.inertia.own[end] / e.mass() : 0.5;
    }
    /// A broken element: its free end is on an arm of the node that carries it.
    void attach(GroundStrip& s) const {
        const int free = w_.state.broken[s.element] == 2 ? 1 : 0;
        s.end[free].node = w_.structure.elements()[s.element].node[1 - free];
        s.end[free].arm = w_.state.offset_arm[s.element];
    }
    /// Where it is apart from the ground: so no energy changes with a break.
    void set_widths(GroundStrip& s) const {
        for (int e : {0, 1}) s.piece.taper[e] = 6 * part_of(s, e) - 2;
    }
    /// Friction's spring is that of the face where there is one: what lands on an end then sticks as firmly with short
    /// elements as with long ones.
    void set_face(GroundStrip& s, int e) const {
        s.piece.end_area[e] = s.has_face[e] ? s.area[e] : 0;
        s.end[e].stiffness = tangential_stiffness_part * s.piece.stiffness *
                             (s.has_face[e] ? s.area[e] : part_of(s, e) * s.piece.width * s.piece.length);
    }
    GroundStrip strip_of(int plane, int element) const {
        const Element& e = w_.structure.elements()[element];
        GroundStrip s;
        s.plane = plane, s.element = element;
        s.piece.stiffness = planes_[plane].layer_stiffness, s.piece.damping = planes_[plane].layer_damping;
        s.piece.width = 2 * e.radius, s.piece.length = e.length;
        for (int i : {0, 1}) s.end[i].node = e.node[i], s.end[i].radius = e.radius;
        if (w_.state.broken[element]) attach(s);
        set_widths(s);
        for (int i : {0, 1}) {
            s.area[i] = w_.structure.model().members()[e.member].section->area;
            s.has_face[i] = member_ends(s, i);
            set_face(s, i);
            begin_at(s.end[i], planes_[plane]);
            s.gone = s.gone || w_.state.gone[s.end[i].node];
        }
        return s;
    }

    std::vector<StripTouch> touches_;  ///< of each strip, as of the last add_forces or solved; of those near the ground
    std::vector<int> near_;            ///< strips that may touch, rising
    std::vector<Vec3> listed_at_;      ///< m, displacements of the nodes when near_ was listed
    double margin_ = 0;                ///< m, by which a node may move until near_ is listed anew
};

}  // namespace

std::unique_ptr<GroundLaw> ground_layer(Workspace& w) { return std::make_unique<GroundLayer>(w); }

}  // namespace hinge

// Loads along members: forces and moments per length, and point loads between the ends.
//
// Each element passes its part of the load on to its two nodes by the lever rule, and the member's two end nodes get
// what that misses of the fixed-end moments (clamped_member.h).
//
// Large displacement: forces that are given in space keep their direction. The correction is that of the load's
// components in the axes that the member has now (chord from end to end) and rotates with them. The part of the load on
// a broken element goes with it. With p_delta = "member" each pair of elements also gets what its axial force changes
// in its fixed-end moments (PressedPair).
#include "effects/member_loads.h"

#include <cmath>
#include <map>

#include "effects/clamped_member.h"
#include "effects/history_jump.h"
#include "effects/kinds.h"
#include "model/member_ends.h"

namespace hinge {
namespace {

constexpr double as_one = 1e-9;  ///< of an element's length: a load so near to a node acts on it

/// A part of a load, at a point of an element.
struct Portion {
    int element;     ///< of the member, 0 to n - 1
    double eta, xi;  ///< place in the element and in the member, 0 to 1
    Vec3 force, moment;
};

/// Of a spread load, per length of the member where it begins or ends; `along`: the member's direction at the start.
Vec3 force_per_length(const MemberLoad& load, int end, const Vec3& along) {
    const Vec3& q = load.force[end];
    return load.axes != LoadAxes::projected || q.isZero(0) ? q : Vec3(q.cross(along).norm() / q.norm() * q);
}

/// The part of a spread load that lies between two places of a member: where, and its values there.
struct Stretch {
    double from, to;  ///< 0 to 1 of the member
    Vec3 force[2], moment[2];
};
Stretch stretch_of(const MemberLoad& load, double begin, double end, const Vec3& along) {
    Stretch s{std::max(begin, load.from), std::min(end, load.to), {}, {}};
    const Vec3 force[2] = {force_per_length(load, 0, along), force_per_length(load, 1, along)};
    const double place[2] = {s.from, s.to};
    for (int k : {0, 1}) {
        const double part = load.is_partial() ? (place[k] - load.from) / (load.to - load.from) : place[k];
        s.force[k] = (1 - part) * force[0] + part * force[1];
        s.moment[k] = (1 - part) * load.moment[0] + part * load.moment[1];
    }
    return s;
}

/// The element at a place of a member of n elements, and the place in it, 0 to 1. Where two elements meet it is 0 of
/// the second one.
int element_at(double at, int n) { return std::min(n - 1, int(at * n + as_one)); }
double place_in(int element, double at, int n) {
    const double eta = at * n - element;
    return eta < as_one ? 0 : eta > 1 - as_one ? 1 : eta;
}
/// True if a load acts on a node of the elements: then none of their sections has it between its ends.
bool is_on_node(const MemberLoad& load, int n) {
    if (load.spread()) return false;
    const double eta = place_in(element_at(load.at, n), load.at, n);
    return eta == 0 || eta == 1;
}

std::vector<Portion> portions(const MemberLoad& load, int n, double length, const Vec3& along) {
    std::vector<Portion> list;
    if (!load.spread()) {
        const int element = element_at(load.at, n);
        list.push_back({element, place_in(element, load.at, n), load.at, load.force[0], load.moment[0]});
        return list;
    }
    if (load.is_partial()) {
        for (int i = 0; i < n; ++i) {
            const Stretch s = stretch_of(load, double(i) / n, (i + 1.0) / n, along);
            for (int k = 0; k < 3 && s.to > s.from; ++k) {
                const double part = gauss_point[k], xi = s.from + part * (s.to - s.from),
                             metres = gauss_weight[k] * length * (s.to - s.from);
                list.push_back({i, xi * n - i, xi, metres * ((1 - part) * s.force[0] + part * s.force[1]),
                                metres * ((1 - part) * s.moment[0] + part * s.moment[1])});
            }
        }
        return list;
    }
    const Vec3 force[2] = {force_per_length(load, 0, along), force_per_length(load, 1, along)};
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k) {
            const double xi = (i + gauss_point[k]) / n, part = gauss_weight[k] * length / n;
            list.push_back({i, gauss_point[k], xi, part * ((1 - xi) * force[0] + xi * force[1]),
                            part * ((1 - xi) * load.moment[0] + xi * load.moment[1])});
        }
    return list;
}

/// What a change of the nodes' places and rotations rotates two nodes' axes by: that of the chord, and about it the
/// mean of the nodes. 3 x 12. `span`: of the chord, m.
Eigen::Matrix<double, 3, 12> rotation_of_axes(const Vec3& span) {
    const Vec3 z = span.normalized();
    Eigen::Matrix<double, 3, 12> by;
    by.block<3, 3>(0, 6) = skew(z) / span.norm();
    by.block<3, 3>(0, 0) = -by.block<3, 3>(0, 6);
    by.block<3, 3>(0, 3) = by.block<3, 3>(0, 9) = 0.5 * z * z.transpose();
    return by;
}

class MemberLoads : public Effect, public Load, public Force, public SectionForceSource, public StepLimiter {
public:
    MemberLoads(Workspace& w, Host& host) : Effect(member_loads_effect, w, host, {.mean_forces = true}) {
        const Structure& s = w.structure;
        const std::vector<std::pair<int, int>> elements_of = elements_of_members(s);
        place_.assign(s.position().size(), -1);
        for (const MemberLoad& load : declared()) {
            const auto [first, end] = elements_of[load.member];
            const std::size_t known = loads_.size();
            take_up(load, first, end);
            traits_.calls_script = traits_.calls_script || (load.has_history && !load.history.points());
            for (std::size_t i = known; i < loads_.size(); ++i) {
                const Loaded& l = loads_[i];
                traits_.forces_vanish = traits_.forces_vanish || l.may_jump;
                for (int k = 0; k < l.ends.count; ++k) on_element_[l.ends.first + k].push_back(int(i));
            }
            for (int i = first; i < end; ++i)
                for (int node : s.elements()[i].node)
                    if (place_[node] < 0) place_[node] = int(nodes_.size()), nodes_.push_back(node);
        }
        before_.assign(nodes_.size(), Vec6::Zero());
    }

    // ---- loads in local axes: statics has the derivative of their directions by the nodes' motion
    // --------------------
    void add_forces(double, std::vector<Vec6>&) override {}
    bool has_blocks() const override {
        return !w_.kind.dynamic && w_.structure.large() &&
               std::any_of(loads_.begin(), loads_.end(), [](const Loaded& l) { return l.local; });
    }
    bool blocks_follow() const override { return has_blocks(); }
    void add_blocks(const Pose& at, Blocks& blocks) const override {
        if (has_blocks())
            for (const Loaded& l : loads_)
                if (l.local) add_derivative(l, at, factor_now(l, w_.factor), blocks);
    }

    /// Of those with a history as in Loads::add_static_loads.
    void begin_statics() override {
        for (std::size_t i = 0; i < loads_.size(); ++i) {
            Loaded& l = loads_[i];
            const double factor = is_next_pair(i) ? loads_[i - 1].factor : l.history ? l.history(0) : 1;
            l.factor = l.kept_factor = factor == 0 ? 1 : factor;
        }
    }
    void add_static_loads(const Pose& at, std::vector<Vec6>& external) const override {
        for (const Loaded& l : loads_)
            if (!l.held) act(l, at, l.factor, [&](int node, const Vec6& f) { external[node] += f; });
    }
    void add_held_loads(const Pose& at, std::vector<Vec6>& external) const override {
        for (const Loaded& l : loads_)
            if (l.held) act(l, at, 1, [&](int node, const Vec6& f) { external[node] += f; });
    }
    bool follows_nodes() const override { return w_.structure.large(); }

    /// The factors at the end of the step. Where a history has jumped, the acceleration is found anew.
    void begin(const Step& step) override {
        bool jumped = false;
        for (std::size_t i = 0; i < loads_.size(); ++i) {
            Loaded& l = loads_[i];
            if (!l.may_jump) continue;
            if (is_next_pair(i)) {
                l.over.begin = loads_[i - 1].over.begin, l.over.end = loads_[i - 1].over.end;
                continue;
            }
            const History::Over over = l.history.over(step.begin, step.end());
            l.over.begin = over.begin, l.over.end = over.end;
            jumped = jumped || l.over.jumps();
        }
        if (jumped) return host_.accelerations_anew();
        factors_at(step.end(), &StepFactor::end);
    }
    void act_at(double time) override { factors_at(time, &StepFactor::begin); }
    void acceleration_found() override {
        before_ = acting(w_.state);
        for (Loaded& l : loads_) l.kept_factor = l.factor, l.over.kept = l.over.begin;
    }
    void subtract_following_loads(std::vector<Vec6>& resisting) override {
        for (const Loaded& l : loads_)
            act(l, w_.trial, l.factor, [&](int node, const Vec6& f) {
                if (!w_.rests(node)) resisting[node] -= f;
            });
    }

    bool has_fixed_ends() const override { return true; }
    void add_fixed_ends(const Pose& at, double factor, std::vector<beam::FixedEnd>& all) const override {
        for (const Loaded& l : loads_) {
            Vec3 m[2];
            const double now = factor_now(l, factor);
            find_moments(l, now, at, m);
            for (int i = l.ends.first; i < l.ends.first + l.ends.count; ++i)
                if (!w_.state.broken[i]) add_fixed_end(l, i, now, at, m, all[i]);
        }
    }

    /// A force along y makes dMx/dz fall, one along x lets dMy/dz rise.
    void add_points(int first, int plane, const Pose& at, double factor,
                    std::vector<beam::BowPoint>& to) const override {
        const auto on = on_element_.find(first);
        if (on == on_element_.end()) return;
        for (const int i : on->second) {
            const Loaded& l = loads_[i];
            if (l.pieces.empty() && !(l.at > 0 && l.at < 1)) continue;
            const Mat3 axes = l.local ? Mat3(Mat3::Identity()) : l.ends.chord(w_.structure, at).axes;
            const double now = factor_now(l, factor), length = w_.structure.elements()[first].length;
            const auto add = [&](double place, const Vec3& point, const Vec3& couple) {
                to.push_back({2 * place - 1, (plane == 0 ? 1 : -1) * now * length * axes.col(1 - plane).dot(point),
                              now * axes.col(plane).dot(couple)});
            };
            for (const Portion& p : l.pieces) add(p.xi, p.force, p.moment);
            if (l.pieces.empty()) add(l.at, l.point, l.couple);
        }
    }

    /// By the trapezium rule; of the fixed-end part on what flows, with that which it flowed by.
    void accumulate_energy(const Step&, Accounts& sums) const override {
        for (const PlasticIncrement& y : w_.yielding) {
            const auto on = on_element_.find(y.element);
            if (on == on_element_.end()) continue;
            beam::FixedEnd part;
            for (const int i : on->second) {
                Vec3 m[2];
                const double now = factor_now(loads_[i], w_.factor);
                find_moments(loads_[i], now, w_.trial, m);
                add_fixed_end(loads_[i], y.element, now, w_.trial, m, part);
            }
            sums["work"] += work_on_flow(y, part);
        }
        if (!w_.kind.dynamic) return;  // statics counts the work of F itself
        const std::vector<Vec6> now = acting(w_.trial);
        double work = 0;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const int n = nodes_[i];
            const Vec6 mean = 0.5 * (now[i] + before_[i]);
            work += mean.head<3>().dot(w_.trial.displacement[n] - w_.state.displacement[n]) +
                    mean.tail<3>().dot(w_.rotation_step[n]);
        }
        sums["work"] += work;
    }
    void before_commit(const Step&) override {
        before_ = acting(w_.trial);
        for (Loaded& l : loads_) l.kept_factor = l.factor, l.over.kept = l.over.end;
    }

    /// The fixed-end part: an element's forces balance what its nodes got of the load and of the correction.
    void add_section_forces(int element, double side, SectionForces& forces) const override {
        const auto on = on_element_.find(element);
        if (on == on_element_.end()) return;
        for (const int i : on->second) {
            const Loaded& l = loads_[i];
            const double factor = kept_factor(l);
            const int end = side < 0 ? 0 : 1;
            const Share& share = l.shares[element - l.ends.first];
            Vec3 force = share.force[end], moment = share.moment[end];
            if (!l.local) {
                const Mat3 to_local = axes_of(element_frame(w_.structure, element, w_.state)).transpose();
                force = to_local * force, moment = to_local * moment;
            }
            if (!l.on_node) add_share(side, factor * force, factor * moment, forces);
            if (!l.ends.whole(w_.state)) continue;
            const MemberEnds::Chord chord = l.ends.chord(w_.structure, w_.state);
            const Vec3 m[2] = {factor * end_moment(l, 0, chord.axes), factor * end_moment(l, 1, chord.axes)};
            l.ends.add_section_forces(element, end, chord.span.norm(), m, forces);
            const Pressed by_N = pressed(l, factor, w_.state, w_.state.force);
            if (!by_N.counts) continue;
            by_N.pair.add_section_forces(element, end, by_N.chord.span.norm(), by_N.m, forces);
            if (by_N.is_middle(element, end)) forces.Mx += by_N.middle[0], forces.My += by_N.middle[1];
        }
    }

    void show_loads(std::vector<ShownLoad>& to) const override {
        for (const Loaded& l : loads_) {
            const MemberLoad& load = declared()[l.declared];
            const double factor = kept_factor(l);
            if (factor == 0) continue;
            const int n = l.member.count;
            for (int element = l.ends.first; element < l.ends.first + l.ends.count; ++element) {
                const int k = element - l.member.first;
                const Element& e = w_.structure.elements()[element];
                if (w_.state.broken[element]) continue;
                ShownLoad shown{-1, element, -1, {}, {}};
                const Mat3 to_space = factor * (l.local ? Mat3(axes_of(element_frame(w_.structure, element, w_.state)))
                                                        : Mat3(Mat3::Identity()));
                if (load.spread() && load.is_partial()) {
                    const Stretch s = stretch_of(load, double(k) / n, (k + 1.0) / n, e.chord.normalized());
                    if (!(s.to > s.from)) continue;
                    shown.from = s.from * n - k, shown.to = s.to * n - k;
                    for (int end : {0, 1})
                        shown.force[end] = to_space * s.force[end], shown.moment[end] = to_space * s.moment[end];
                } else if (!load.spread()) {
                    if (k != element_at(load.at, n)) continue;
                    shown.at = place_in(k, load.at, n);
                    if (l.on_node) shown.node = e.node[shown.at > 0.5], shown.element = -1, shown.at = -1;
                    shown.force[0] = to_space * load.force[0], shown.moment[0] = to_space * load.moment[0];
                    shown.force[1].setZero(), shown.moment[1].setZero();
                } else {
                    const Vec3 along = e.chord.normalized();
                    for (int end : {0, 1}) {
                        const double xi = double(k + end) / n;
                        shown.force[end] = to_space * ((1 - xi) * force_per_length(load, 0, along) +
                                                       xi * force_per_length(load, 1, along));
                        shown.moment[end] = to_space * ((1 - xi) * load.moment[0] + xi * load.moment[1]);
                    }
                }
                to.push_back(shown);
            }
        }
    }

    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        for (const Loaded& l : loads_)
            if (l.history)
                for (int i = l.ends.first; i < l.ends.first + l.ends.count; ++i) {
                    const int body = bodies.of_node[w_.structure.elements()[i].node[0]];
                    if (!w_.state.broken[i] && body >= 0) rests[body] = 0;
                }
    }
    bool changes_within(double now, std::span<const double> after) const override {
        for (std::size_t i = 0; i < loads_.size(); ++i) {
            const Loaded& l = loads_[i];
            if (!l.history || is_next_pair(i)) continue;
            if (l.history.bends_within(now, now + after.back())) return true;
            const double factor = l.history(now);
            for (const double t : after)
                if (l.history(now + t) != factor) return true;
        }
        return false;
    }

    void save(Writer& to) const override { save_fields(*this, to); }
    void restore(Reader& from) override { fields(*this, from); }
    bool restored(std::span<const State* const>) override { return before_.size() == nodes_.size(); }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.before_);
        for (auto& l : s.loads_) {
            a(l.factor, l.kept_factor);
            if (l.may_jump) a(l.over.kept, l.over.begin, l.over.end);
        }
    }

private:
    /// What an element passes on to its two nodes, in the load's axes, N and N m.
    struct Share {
        Vec3 force[2] = {Vec3::Zero(), Vec3::Zero()}, moment[2] = {Vec3::Zero(), Vec3::Zero()};
    };
    /// A load on the elements between two ends: the member's, or where its pairs of elements are beam-columns those of
    /// each pair.
    struct Loaded {
        MemberEnds ends, member;
        int declared;  ///< its place in the list of the model
        bool local;
        History history;
        std::vector<Share> shares;  ///< of the member's elements
        /// The correction's moment at each end about x and about y is linear in the load's components across: of the
        /// forces, N m, and of the moments, N m, both in the load's axes.
        Vec3 of_force[2][2], of_moment[2][2];
        Vec3 spread[2] = {Vec3::Zero(), Vec3::Zero()}, point = Vec3::Zero(),
             couple = Vec3::Zero();  ///< N/m at these ends; N and N m of a point load
        double at = -1;              ///< of the point load, 0 to 1 between them
        /// A load over a part of a pair of elements, as point loads between its ends, for what N does to them.
        std::vector<Portion> pieces = {};
        double factor = 1, kept_factor = 1;  ///< of its history, on the trial and on the state
        bool held = false, may_jump = false;
        bool on_node = false;  ///< it acts on a node of the elements (is_on_node)
        StepFactor over = {};  ///< where its history may jump within a step
    };
    const std::vector<MemberLoad>& declared() const {
        return w_.structure.model().declared<MemberLoad>(member_loads_effect);
    }

    /// Adds a load of the script on the elements from `first` to `end`.
    void take_up(const MemberLoad& load, int first, int end) {
        const Element& e = w_.structure.elements()[first];
        const int n = end - first, at_once = w_.structure.p_delta() && e.forms_pairs ? 2 : n;
        const std::vector<Portion> all = portions(load, n, n * e.length, e.chord.normalized());
        for (int k = 0; k < n; k += at_once) {
            std::vector<Portion> here;
            for (Portion p : all) {
                if (p.element < k || p.element >= k + at_once) continue;
                p.element -= k, p.xi = (p.xi * n - k) / at_once;
                here.push_back(p);
            }
            if (!here.empty()) loads_.push_back(taken_up(load, {first, n}, {first + k, at_once}, here));
        }
    }
    Loaded taken_up(const MemberLoad& load, const MemberEnds& member, const MemberEnds& ends,
                    const std::vector<Portion>& parts) const {
        const int first = ends.first, n = ends.count, all = member.count;
        const Element& e = w_.structure.elements()[first];
        Loaded l{ends, member, int(&load - declared().data()), load.axes == LoadAxes::local, load.history, {}, {}, {}};
        l.held = load.held, l.on_node = is_on_node(load, all);
        l.may_jump = load.history && load.history.may_jump_in(steep * w_.kind.dt);
        if (l.may_jump) l.over.kept = l.over.begin = l.over.end = load.history.from(w_.state.time);
        const double begin = double(first - member.first) / all;
        for (int of : {0, 1}) {
            if (!load.spread()) break;
            const double xi = begin + double(of * n) / all;
            const auto at_end = [&](int end) { return force_per_length(load, end, e.chord.normalized()); };
            l.spread[of] = (1 - xi) * at_end(0) + xi * at_end(1);
        }
        if (load.spread() && load.is_partial()) l.pieces = pieces_of(load, begin, double(n) / all, e);
        if (!load.spread()) {
            l.at = std::clamp((load.at - begin) * all / n, 0.0, 1.0);
            l.point = load.force[0], l.couple = load.moment[0];
        }
        l.shares.resize(n);
        for (int end_of : {0, 1})
            for (int plane : {0, 1}) l.of_force[end_of][plane].setZero(), l.of_moment[end_of][plane].setZero();
        const ClampedMember clamped(w_.structure, first, first + n);
        for (const Portion& p : parts) {
            const double lever[2] = {1 - p.eta, p.eta};
            for (int i : {0, 1}) {
                l.shares[p.element].force[i] += lever[i] * p.force;
                l.shares[p.element].moment[i] += lever[i] * p.moment;
            }
            for (int of : {0, 1})
                for (int plane : {0, 1}) {
                    const int to = 6 * of + 3 + plane;
                    const auto passed_on = [&](int direction) {
                        return lever[0] * clamped.arrives(p.element, direction, to) +
                               lever[1] * clamped.arrives(p.element + 1, direction, to);
                    };
                    l.of_force[of][plane] += (clamped.of_force(of, plane, p.xi) - passed_on(1 - plane)) * p.force;
                    l.of_moment[of][plane] += (clamped.of_moment(of, plane, p.xi) - passed_on(3 + plane)) * p.moment;
                }
        }
        return l;
    }

    /// Gauss's rule with three points on each of `rows` stretches on either side of the middle of a pair from `begin`,
    /// `width` of its member long.
    std::vector<Portion> pieces_of(const MemberLoad& load, double begin, double width, const Element& e) const {
        constexpr int rows = 3;
        std::vector<Portion> list;
        if (!w_.structure.p_delta() || !e.forms_pairs) return list;
        const double member = w_.structure.model().members()[load.member].elements * e.length;
        for (int i = 0; i < 2 * rows; ++i) {
            const double half = begin + width * (i / rows) / 2;
            const Stretch whole = stretch_of(load, half, half + width / 2, e.chord.normalized());
            if (!(whole.to > whole.from)) continue;
            const double step = (whole.to - whole.from) / rows, from = whole.from + (i % rows) * step;
            const Stretch s = stretch_of(load, from, from + step, e.chord.normalized());
            for (int k = 0; k < 3; ++k) {
                const double part = gauss_point[k], metres = gauss_weight[k] * member * (s.to - s.from);
                list.push_back({0, 0, (s.from + part * (s.to - s.from) - begin) / width,
                                metres * ((1 - part) * s.force[0] + part * s.force[1]),
                                metres * ((1 - part) * s.moment[0] + part * s.moment[1])});
            }
        }
        return list;
    }

    void factors_at(double time, double StepFactor::*of_step) {
        for (std::size_t i = 0; i < loads_.size(); ++i) {
            Loaded& l = loads_[i];
            l.factor = is_next_pair(i) ? loads_[i - 1].factor
                       : l.may_jump    ? l.over.*of_step
                       : l.history     ? l.history(time)
                                       : 1;
        }
    }
    /// Whether this is a further pair of the load before: a function of the script is asked once.
    bool is_next_pair(std::size_t i) const { return i > 0 && loads_[i - 1].declared == loads_[i].declared; }

    /// What acts of a load on the trial at this load factor, 1 in dynamics; and on the state.
    static double factor_now(const Loaded& l, double load_factor) { return l.held ? 1 : load_factor * l.factor; }
    double kept_factor(const Loaded& l) const { return l.held ? 1 : w_.acting_factor() * l.kept_factor; }
    /// The corrections at the member's ends, in its axes; none where it is not whole.
    void find_moments(const Loaded& l, double factor, const Pose& at, Vec3 m[2]) const {
        m[0].setZero(), m[1].setZero();
        if (!l.ends.whole(w_.state)) return;
        const Mat3 axes = l.ends.axes(w_.structure, at);
        for (int end : {0, 1}) m[end] = factor * end_moment(l, end, axes);
    }
    /// What a load adds to the resultants of an element, with the corrections m at its member's ends.
    void add_fixed_end(const Loaded& l, int element, double factor, const Pose& at, const Vec3 m[2],
                       beam::FixedEnd& to) const {
        const Share& share = l.shares[element - l.ends.first];
        const Vec3 along = l.local ? Vec3(0, 0, 1) : direction_of(w_.structure, element, at);
        const double own_part = l.on_node ? 0 : factor;
        const bool twists = own_part != 0 && (!share.moment[0].isZero(0) || !share.moment[1].isZero(0));
        const Mat3 to_element = l.local || !twists
                                    ? Mat3(Mat3::Identity())
                                    : Mat3(axes_of(element_frame(w_.structure, element, at)).transpose());
        for (int end : {0, 1}) {
            const double side = end == 0 ? 1 : -1;  // the section balances what its node got
            const Vec3 there = l.ends.moment_at(element, end, m),
                       own = twists ? Vec3(side * factor * (to_element * share.moment[end])) : Vec3(Vec3::Zero());
            to.add(end, there.x() + own.x(), there.y() + own.y(), side * own_part * along.dot(share.force[end]),
                   own.z());
        }
        if (!l.ends.whole(w_.state)) return;
        const Pressed by_N = pressed(l, factor, at, w_.force_of_fixed_ends());
        for (int end = 0; end < 2 && by_N.counts; ++end) {
            const Vec3 there = by_N.pair.moment_at(element, end, by_N.m);
            to.add(end, there.x(), there.y(), 0, 0);
            if (by_N.is_middle(element, end)) to.add(end, by_N.middle[0], by_N.middle[1], 0, 0);
        }
    }

    /// What N changes in the moments at a pair's two ends, in its axes, and in the section between its elements.
    struct Pressed {
        bool counts = false;
        MemberEnds pair;
        MemberEnds::Chord chord = {};
        Vec3 m[2] = {Vec3::Zero(), Vec3::Zero()};
        double middle[2] = {0, 0};
        bool is_middle(int element, int end) const { return (element == pair.first) == (end == 1); }
    };
    /// `force`: p of all elements, of which N is taken.
    Pressed pressed(const Loaded& l, double factor, const Pose& at, const std::vector<Vec6>& force) const {
        Pressed is{false, l.ends};
        const bool between = l.at < 0 || (l.at > 0 && l.at < 1);
        if (!w_.structure.p_delta() || l.ends.count != 2 || !between) return is;
        const PressedPair by_N(w_.structure, l.ends.first, force, w_.trial.heat);
        if (!by_N.counts()) return is;
        is.counts = true;
        is.chord = is.pair.chord(w_.structure, at);
        const auto across = [&](const Vec3& f, int plane) {
            return factor * (l.local ? f[1 - plane] : is.chord.axes.col(1 - plane).dot(f));
        };
        const auto add_point = [&](int plane, double at_part, const Vec3& point, const Vec3& couple) {
            const double P = across(point, plane), x = 2 * at_part - 1,
                         M = factor * (l.local ? couple[plane] : is.chord.axes.col(plane).dot(couple));
            if (P != 0) {
                for (int of : {0, 1}) is.m[of][plane] += P * by_N.of_force(of, plane, x);
                is.middle[plane] += P * by_N.middle_of_force(plane, x);
            }
            if (M == 0) return;
            for (int of : {0, 1}) is.m[of][plane] += M * by_N.of_couple(of, plane, x);
            is.middle[plane] += M * by_N.middle_of_couple(plane, x);
        };
        for (int plane : {0, 1}) {
            for (const Portion& p : l.pieces) add_point(plane, p.xi, p.force, p.moment);
            if (!l.pieces.empty()) continue;
            const double q[2] = {across(l.spread[0], plane), across(l.spread[1], plane)};
            if (l.at < 0) {
                for (int of : {0, 1}) is.m[of][plane] = by_N.of_spread(of, plane, q);
                is.middle[plane] = by_N.middle_of_spread(plane, 0.5 * (q[0] + q[1]));
                continue;
            }
            add_point(plane, l.at, l.point, l.couple);
        }
        return is;
    }

    /// The correction at an end, in the member's axes; `axes`: those.
    Vec3 end_moment(const Loaded& l, int end, const Mat3& axes) const {
        Vec3 m = Vec3::Zero();
        for (int plane : {0, 1}) {
            const Vec3 &f = l.of_force[end][plane], &c = l.of_moment[end][plane];
            m[plane] = l.local ? f[1 - plane] + c[plane] : axes.col(1 - plane).dot(f) + axes.col(plane).dot(c);
        }
        return m;
    }

    /// Subtracts from the stiffness what the forces on two nodes change by when the axes that carry them rotate.
    static void add_rotating(const int node[2], const Vec3& span, const Vec6 f[2], Blocks& blocks) {
        const Eigen::Matrix<double, 3, 12> by = rotation_of_axes(span);
        Mat12 K;
        for (int end : {0, 1}) {
            K.middleRows<3>(6 * end) = skew(f[end].head<3>()) * by;
            K.middleRows<3>(6 * end + 3) = skew(f[end].tail<3>()) * by;
        }
        blocks.stiffness(node[0], node[1], K);
    }

    void add_derivative(const Loaded& l, const Pose& at, double factor, Blocks& blocks) const {
        const auto& elements = w_.structure.elements();
        const auto place = [&](int node) { return Vec3(w_.structure.position()[node] + at.displacement[node]); };
        for (std::size_t i = 0; i < l.shares.size(); ++i) {
            const int element = l.ends.first + int(i);
            if (w_.state.broken[element]) continue;
            const int* node = elements[element].node;
            const Mat3 to_space = factor * axes_of(element_frame(w_.structure, element, at));
            Vec6 f[2];
            for (int end : {0, 1}) f[end] << to_space * l.shares[i].force[end], to_space * l.shares[i].moment[end];
            add_rotating(node, place(node[1]) - place(node[0]), f, blocks);
        }
        if (!l.ends.whole(w_.state)) return;
        const MemberEnds::Chord chord = l.ends.chord(w_.structure, at);
        const int node[2] = {elements[l.ends.first].node[0], elements[l.ends.first + l.ends.count - 1].node[1]};
        Vec3 m[2];
        for (int end : {0, 1}) m[end] = factor * (chord.axes * end_moment(l, end, chord.axes));
        Vec6 f[2];
        l.ends.pass_on(w_.structure, chord.span, m, [&](int n, const Vec6& force) { f[n == node[1]] = force; });
        add_rotating(node, chord.span, f, blocks);
    }

    /// Calls add(node, force and moment in space) with all that a load asks of the nodes at such a place.
    template <class Add>
    void act(const Loaded& l, const Pose& at, double factor, Add add) const {
        const auto& elements = w_.structure.elements();
        bool broken = false;
        for (std::size_t i = 0; i < l.shares.size(); ++i) {
            const int element = l.ends.first + int(i);
            if (w_.state.broken[element]) {
                broken = true;
                continue;
            }
            const Share& share = l.shares[i];
            const Mat3 to_space =
                l.local ? Mat3(axes_of(element_frame(w_.structure, element, at))) : Mat3(Mat3::Identity());
            for (int end : {0, 1}) {
                Vec6 f;
                f << factor * (to_space * share.force[end]), factor * (to_space * share.moment[end]);
                add(elements[element].node[end], f);
            }
        }
        if (broken) return;
        const MemberEnds::Chord chord = l.ends.chord(w_.structure, at);
        Vec3 m[2];
        for (int end : {0, 1}) m[end] = factor * (chord.axes * end_moment(l, end, chord.axes));
        l.ends.pass_on(w_.structure, chord.span, m, add);
        const bool of_state = &at.displacement == &w_.state.displacement;
        const Pressed by_N = pressed(l, factor, at, of_state ? w_.state.force : w_.force);
        if (!by_N.counts) return;
        for (int end : {0, 1}) m[end] = by_N.chord.axes * by_N.m[end];
        by_N.pair.pass_on(w_.structure, by_N.chord.span, m, add);
    }

    /// On each of nodes_, now.
    std::vector<Vec6> acting(const Pose& at) const {
        std::vector<Vec6> sum(nodes_.size(), Vec6::Zero());
        for (const Loaded& l : loads_) act(l, at, l.factor, [&](int node, const Vec6& f) { sum[place_[node]] += f; });
        return sum;
    }

    std::vector<Loaded> loads_;
    std::map<int, std::vector<int>> on_element_;  ///< places in loads_
    std::vector<int> nodes_, place_;              ///< of loaded members; of each node its place in that list, -1
    std::vector<Vec6> before_;                    ///< what acted on nodes_ at the end of the last step
};

bool acts(const Structure& s) {
    for (const MemberLoad& l : s.model().declared<MemberLoad>(member_loads_effect))
        for (int end : {0, 1})
            if (!l.force[end].isZero(0) || !l.moment[end].isZero(0)) return true;
    return false;
}

/// The whole load in space, N.
Vec3 whole_force(const Model& model, const MemberLoad& l) {
    if (l.axes == LoadAxes::local) return Vec3::Zero();
    if (!l.spread()) return l.force[0];
    const Vec3 chord = end_position(model, l.member, 1) - end_position(model, l.member, 0);
    const auto length = [&](const Vec3& force) {
        if (l.axes != LoadAxes::projected || force.isZero(0)) return chord.norm();
        const Vec3 along = force.normalized();
        return (chord - chord.dot(along) * along).norm();
    };
    return (l.is_partial() ? 0.5 * (l.to - l.from) : 0.5) *
           (length(l.force[0]) * l.force[0] + length(l.force[1]) * l.force[1]);
}

std::vector<PlanLine> member_loads_plan(const Structure& s, const RunKind&) {
    const std::size_t n = s.model().declared<MemberLoad>(member_loads_effect).size();
    const bool on = acts(s);
    return {{member_loads_effect, on,
             n == 0 ? "not declared"
             : on   ? std::to_string(n) + " on members"
                    : "all that are declared are zero",
             s.model().asked_at(member_loads_effect)}};
}

}  // namespace

EffectKind member_loads_kind() {
    return {
        .name = member_loads_effect,
        .plan = member_loads_plan,
        .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
            if (!acts(w.structure)) return nullptr;
            return std::make_unique<MemberLoads>(w, host);
        },
        .leave_out = leave_out_declared<member_loads_effect>,
        .declarer = {.loads =
                         [](const Model& model) {
                             std::vector<DeclaredLoad> list;
                             for (const MemberLoad& l : model.declared<MemberLoad>(member_loads_effect)) {
                                 DeclaredLoad load{"the load on member " + std::to_string(l.member + 1),
                                                   "member load " + std::to_string(l.number), -1, l.member};
                                 if (l.has_history) load.history = &l.history;
                                 load.constant = !l.has_history;
                                 load.load_case = l.load_case, load.force = whole_force(model, l);
                                 list.push_back(std::move(load));
                             }
                             return list;
                         },
                     .functions = [](const Model& model) -> std::vector<ScriptFunctions> {
                         const auto& list = model.declared<MemberLoad>(member_loads_effect);
                         if (std::none_of(list.begin(), list.end(), [](const MemberLoad& l) { return l.has_history; }))
                             return {};
                         return {{4, "a load's history", false, model.asked_at(member_loads_effect)}};
                     }}};
}

}  // namespace hinge

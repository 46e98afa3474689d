// Loads along members: forces and moments per length, and point loads between the ends.
//
// Each element divides its part of the load between its two nodes by the lever rule. The member's two end nodes get the
// difference to the exact fixed-end moments (clamped_member.h).
//
// Large displacement: forces that are given in space keep their direction. The correction is that of the load's
// components in the axes that the member has now (chord from end to end) and rotates with them. The part of the load on
// a broken element goes with it. With p_delta = "member" each pair of elements also gets what its axial force changes
// in its fixed-end moments (PressedPair).
#include "effects/member_loads.h"

#include <map>

#include "effects/joined_bodies.h"
#include "effects/kinds.h"
#include "effects/loaded_member.h"
#include "model/member_ends.h"

namespace hinge {
namespace {

class MemberLoads : public Effect,
                    public Load,
                    public Force,
                    public SectionForceSource,
                    public StepLimiter,
                    public BreakListener {
public:
    MemberLoads(const char* name, std::vector<MemberLoad> list, bool are_weights, Workspace& w, Host& host)
        : Effect(name, w, host, {.mean_forces = true}), list_(std::move(list)), are_weights_(are_weights) {
        const Structure& s = w.structure;
        const std::vector<std::pair<int, int>> elements_of = elements_of_members(s);
        place_.assign(s.position().size(), -1);
        for (const MemberLoad& load : list_) {
            const auto [first, end] = elements_of[load.member];
            for (LoadedMember& l : loaded_members(w, load, int(&load - list_.data()), first, end)) add(std::move(l));
            traits_.calls_script = traits_.calls_script || (load.has_history && !load.history.points());
            for (int i = first; i < end; ++i)
                for (int node : s.elements()[i].node)
                    if (place_[node] < 0) place_[node] = int(nodes_.size()), nodes_.push_back(node);
        }
        for (LoadedMember& l : loads_) l.sum_up();
        before_.assign(nodes_.size(), Vec6::Zero());
        drop_fallen();
    }
    void all_broke() override {
        drop_fallen();
        if (are_weights_) before_ = acting(w_.state);
    }

    // ---- loads in local axes: statics has the derivative of their directions by the nodes' motion
    // --------------------
    void add_forces(double, std::vector<Vec6>&) override {}
    bool has_blocks() const override {
        return !w_.kind.dynamic && w_.structure.large() &&
               std::any_of(loads_.begin(), loads_.end(), [](const LoadedMember& l) { return l.local; });
    }
    bool blocks_follow() const override { return has_blocks(); }
    void add_blocks(const Pose& at, Blocks& blocks) const override {
        if (has_blocks())
            for (const LoadedMember& l : loads_)
                if (l.local) add_derivative(w_, l, at, factor_now(l, w_.factor), blocks);
    }

    /// Of those with a history as in Loads::add_static_loads.
    void begin_statics() override {
        for (std::size_t i = 0; i < loads_.size(); ++i) {
            LoadedMember& l = loads_[i];
            const double factor = is_next_pair(i) ? loads_[i - 1].factor : l.history ? l.history(0) : 1;
            l.factor = l.kept_factor = factor == 0 ? 1 : factor;
        }
    }
    void add_static_loads(const Pose& at, std::vector<Vec6>& external) const override {
        for (const LoadedMember& l : loads_)
            if (!l.held) act(w_, l, at, l.factor, [&](int node, const Vec6& f) { external[node] += f; });
    }
    void add_held_loads(const Pose& at, std::vector<Vec6>& external) const override {
        for (const LoadedMember& l : loads_)
            if (l.held) act(w_, l, at, 1, [&](int node, const Vec6& f) { external[node] += f; });
    }
    bool follows_nodes() const override { return w_.structure.large(); }

    /// The factors at the end of the step. Where a history has jumped, the acceleration is recomputed.
    void begin(const Step& step) override {
        bool jumped = false;
        for (std::size_t i = 0; i < loads_.size(); ++i) {
            LoadedMember& l = loads_[i];
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
        for (LoadedMember& l : loads_) l.kept_factor = l.factor, l.over.kept = l.over.begin;
    }
    void subtract_following_loads(std::vector<Vec6>& resisting) override {
        for (const LoadedMember& l : loads_)
            act(w_, l, w_.trial, l.factor, [&](int node, const Vec6& f) {
                if (!w_.rests(node)) resisting[node] -= f;
            });
    }

    bool has_fixed_ends() const override { return true; }
    void add_fixed_ends(const Pose& at, double factor, std::vector<beam::FixedEnd>& all) const override {
        for (const LoadedMember& l : loads_) {
            Vec3 m[2];
            const double now = factor_now(l, factor);
            find_moments(w_, l, now, at, m);
            const CompressionMoments by_N = compression_moments(w_, l, now, at, w_.force_of_fixed_ends());
            for (int i = l.ends.first; i < l.ends.first + l.ends.count; ++i)
                if (!w_.state.broken[i]) add_fixed_end(w_, l, i, now, at, m, by_N, all[i]);
        }
    }

    /// A force along y makes dMx/dz fall, one along x lets dMy/dz rise.
    void add_points(int first, int plane, const Pose& at, double factor,
                    std::vector<beam::BowPoint>& to) const override {
        const auto on = on_element_.find(first);
        if (on == on_element_.end()) return;
        for (const int i : on->second) {
            const LoadedMember& l = loads_[i];
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
                find_moments(w_, loads_[i], now, w_.trial, m);
                add_fixed_end(w_, loads_[i], y.element, now, w_.trial, m,
                              compression_moments(w_, loads_[i], now, w_.trial, w_.force_of_fixed_ends()), part);
            }
            book(work_on_flow(y, part), sums);
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
        book(work, sums);
    }
    void before_commit(const Step&) override {
        before_ = acting(w_.trial);
        for (LoadedMember& l : loads_) l.kept_factor = l.factor, l.over.kept = l.over.end;
    }

    /// The fixed-end part: an element's forces balance what its nodes got of the load and of the correction.
    void add_section_forces(int element, double side, SectionForces& forces) const override {
        const auto on = on_element_.find(element);
        if (on == on_element_.end()) return;
        for (const int i : on->second) {
            const LoadedMember& l = loads_[i];
            const double factor = kept_factor(l);
            const int end = side < 0 ? 0 : 1;
            const LoadShare& share = l.shares[element - l.ends.first];
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
            const CompressionMoments by_N = compression_moments(w_, l, factor, w_.state, w_.state.force);
            if (!by_N.counts) continue;
            by_N.pair.add_section_forces(element, end, by_N.chord.span.norm(), by_N.m, forces);
            if (by_N.is_middle(element, end)) forces.Mx += by_N.middle[0], forces.My += by_N.middle[1];
        }
    }

    void show_loads(std::vector<ShownLoad>& to) const override {
        for (const LoadedMember& l : loads_) {
            const double factor = kept_factor(l);
            if (factor == 0 || l.dropped) continue;
            show(l, list_[l.declared], factor, to);
            for (const int i : l.merged) show(l, list_[i], factor, to);
        }
    }

    void keep_from_rest(const Bodies& bodies, std::vector<char>& rests) const override {
        for (const LoadedMember& l : loads_)
            if (l.history)
                for (int i = l.ends.first; i < l.ends.first + l.ends.count; ++i) {
                    const int body = bodies.of_node[w_.structure.elements()[i].node[0]];
                    if (!w_.state.broken[i] && body >= 0) rests[body] = 0;
                }
    }
    bool changes_within(double now, std::span<const double> after) const override {
        for (std::size_t i = 0; i < loads_.size(); ++i) {
            const LoadedMember& l = loads_[i];
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
    bool restored(std::span<const State* const>) override {
        drop_fallen();
        return before_.size() == nodes_.size();
    }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.before_);
        for (auto& l : s.loads_) {
            a(l.factor, l.kept_factor);
            if (l.may_jump) a(l.over.kept, l.over.begin, l.over.end);
        }
    }

private:
    void show(const LoadedMember& l, const MemberLoad& load, double factor, std::vector<ShownLoad>& to) const {
        const int n = l.member.count;
        for (int element = l.ends.first; element < l.ends.first + l.ends.count; ++element) {
            const int k = element - l.member.first;
            const Element& e = w_.structure.elements()[element];
            if (w_.state.broken[element]) continue;
            ShownLoad shown{-1, element, -1, {}, {}};
            shown.is_weight = are_weights_;
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
    /// In dynamics minus the work of weights is in gravity's account; in statics they are loads that are brought on.
    void book(double work, Accounts& sums) const {
        if (are_weights_ && w_.kind.dynamic) sums["gravity"] -= work;
        else sums["work"] += work;
    }
    void add(LoadedMember l) {
        std::vector<int>& here = on_element_[l.ends.first];
        if (std::any_of(here.begin(), here.end(), [&](int i) { return loads_[i].merge(l); })) return;
        traits_.forces_vanish = traits_.forces_vanish || l.may_jump;
        for (int k = 0; k < l.ends.count; ++k) on_element_[l.ends.first + k].push_back(int(loads_.size()));
        loads_.push_back(std::move(l));
    }
    /// A weight bends a member that falls, or is not whole, no more than its inertia does: it is none of these loads.
    void drop_fallen() {
        if (!are_weights_) return;
        const Bodies bodies = find_bodies(w_.structure, w_.state);
        std::vector<char> carried(bodies.count, 1);
        if (w_.kind.dynamic)
            carried = carried_bodies(w_.structure, w_.state, bodies, *declared_gravity(w_.structure.model()));
        for (LoadedMember& l : loads_) {
            const int body = bodies.of_node[w_.structure.elements()[l.ends.first].node[0]];
            if (body < 0 || !carried[body] || !l.member.whole(w_.state)) l.drop();
        }
    }

    void factors_at(double time, double StepFactor::*of_step) {
        for (std::size_t i = 0; i < loads_.size(); ++i) {
            LoadedMember& l = loads_[i];
            l.factor = is_next_pair(i) ? loads_[i - 1].factor
                       : l.may_jump    ? l.over.*of_step
                       : l.history     ? l.history(time)
                                       : 1;
        }
    }
    /// True if this is a further pair of the load before: a function of the script is called once.
    bool is_next_pair(std::size_t i) const { return i > 0 && loads_[i - 1].declared == loads_[i].declared; }

    /// Factor of a load on the trial at this load factor, 1 in dynamics; and on the state.
    static double factor_now(const LoadedMember& l, double load_factor) { return l.held ? 1 : load_factor * l.factor; }
    double kept_factor(const LoadedMember& l) const { return l.held ? 1 : w_.acting_factor() * l.kept_factor; }
    /// On each of nodes_, now.
    std::vector<Vec6> acting(const Pose& at) const {
        std::vector<Vec6> sum(nodes_.size(), Vec6::Zero());
        for (const LoadedMember& l : loads_)
            act(w_, l, at, l.factor, [&](int node, const Vec6& f) { sum[place_[node]] += f; });
        return sum;
    }

    std::vector<MemberLoad> list_;
    bool are_weights_;  ///< not loads of the script
    std::vector<LoadedMember> loads_;
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

std::unique_ptr<Effect> make_weights_on_members(const char* name, std::vector<MemberLoad> loads, Workspace& w,
                                                Host& host) {
    return std::make_unique<MemberLoads>(name, std::move(loads), true, w, host);
}

EffectKind member_loads_kind() {
    return {
        .name = member_loads_effect,
        .plan = member_loads_plan,
        .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
            if (!acts(w.structure)) return nullptr;
            return std::make_unique<MemberLoads>(
                member_loads_effect, w.structure.model().declared<MemberLoad>(member_loads_effect), false, w, host);
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

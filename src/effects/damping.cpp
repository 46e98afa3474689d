// Rayleigh damping by groups: C = alpha M + beta K of each element, M its own mass, K its elastic stiffness. The
// effective stiffness has gamma dt C (algebra/effective_stiffness.cpp); here are the forces C v and what they
// dissipate.
//
// The part of beta takes the elastic rates of the element's own deformation, p_v = beta k (d' - d_p'), where p is the
// force of its springs, p = k (d - d_p). So rotating and flying as a whole is not damped by it, however fast, and
// neither are the rotations of plastic hinges (state/elastic_rate.h). With the whole rate a hinge would stand beside a
// dashpot of the element's bending and shear stiffness, and that is the stiffer the shorter the element is. Yield is
// decided by p alone, so p_v may do work on the flow. Where a step would make more energy than a dashpot has taken so
// far, that dashpot takes the whole rate in the step (giving_); one that has made energy takes it from then on (gave).
// A broken element is not damped at all, nor is the mass that is left of it.
//
// The part of alpha takes the nodes' velocities relative to the supports of their body (whole elements and connectors
// join it): along x, y and z each the mean velocity of those of its supports that are held in that direction, zero
// where there are none and of supports that do not move. So a building that moves with its ground is not damped. A body
// without supports is damped by its velocity in space. The velocities of rotation are those in space: supports do not
// rotate. The dashpots stand on the moving supports, so these do work on them: force times the way of the supports is
// in the account of work, force times the way relative to them in that of damping.
//
// Joints and connectors take part in beta by themselves (joint_damping in all_effects.h), unless the declaration leaves
// them out.
//
// A point mass has the alpha of the elements at its node that are whole, the mean where they differ, and none once all
// are broken. Its part of C is a block of its node.
#include "effects/damping.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/text.h"
#include "effects/damped_blocks.h"
#include "effects/declared.h"
#include "effects/facts.h"
#include "effects/footing.h"
#include "effects/joined_bodies.h"
#include "effects/panels.h"
#include "effects/kinds.h"
#include "model/member_text.h"
#include "state/elastic_rate.h"
#include "state/lone_elements.h"
#include "state/node_mass.h"

namespace hinge {
namespace {

/// A point mass that has rotated by 20 mrad since, the cosine of whose half this is, is renewed in the effective
/// stiffness. What is missed until then is the part of that angle that alpha dt is.
constexpr double rotation_lag_cosine = 1 - 5e-5;

/// So many solutions of a step find what share of an element's deformation flows (theta of state/elastic_rate.h); then
/// it stays. Where hinges just flow, or just not, Newton's method would else go to and fro between the two.
constexpr int shares_follow = 4;

/// Whole rates count in more steps than these, which are more than this part of those in which the hinge
/// turned.
constexpr int few_steps = 10;
constexpr double small_part = 0.1;

/// Of each element, as the last declaration that fits it has it; empty where all is zero.
std::vector<ElementDamping> damping_of_elements(const Structure& structure) {
    std::vector<ElementDamping> of(structure.elements().size());
    bool any = false;
    for (std::size_t e = 0; e < of.size(); ++e) {
        for (const Damping& d : structure.model().declared<Damping>(damping_effect))
            if (d.group < 0 || structure.in_group(int(e), d.group)) of[e] = {d.alpha, d.beta, d.joints ? d.beta : 0};
        any = any || damps(of[e]);
    }
    if (!any) of.clear();
    return of;
}

class RayleighDamping : public Effect, public Force, public BreakListener, public WholeRates {
public:
    RayleighDamping(Workspace& w, Host& host, std::vector<ElementDamping> damping)
        : Effect(damping_effect, w, host, {.mean_forces = true}),
          damping_(std::move(damping)),
          damped_(damped_of(damping_)),
          blocks_(w.structure, w.state, damped_, damping_),
          alpha_of_panels_(alpha_of_panels(w.structure)) {
        of_element_.resize(damped_.size());
        by_stiffness_.resize(damped_.size(), Vec12::Zero());
        by_stiffness_before_ = by_stiffness_;
        before_.assign(w.structure.position().size(), Vec6::Zero());
        now_ = before_;
        std::map<int, OffsetMass> masses;
        for (const AddedMass& m : added_masses(w.structure.model()))
            if (alpha_at(m.node) != 0) add(m.mass, masses[m.node]);
        for (const auto& [node, mass] : masses)
            masses_.push_back({node, mass}), built_.push_back(w.state.rotation[node]);
        const std::vector<DeclaredLoad> loads = declared_loads(w.structure.model());
        supports_move_ = std::any_of(loads.begin(), loads.end(), [](const DeclaredLoad& l) { return l.motion; });
        find_footings();
        for (const int e : damped_)
            if (damping_[e].of_stiffness != 0 && (w.state.hinge[e] || slack_of(w.structure, w.state, e) != 0))
                flowed_.push_back({e, true});
    }

    void begin(const Step&) override { solutions_ = 0, giving_.clear(); }
    void add_forces(double time, std::vector<Vec6>& resisting) override {
        find_rates(time);
        find_forces();
        for (std::size_t n = 0; n < now_.size(); ++n) resisting[n] += now_[n];
        if (masses_lag()) renew(w_.trial);
    }

    bool has_blocks() const override { return !masses_.empty(); }
    void add_blocks(const Pose& at, Blocks& blocks) const override {
        for (const auto& [node, mass] : masses_)
            blocks.damping(node, Mat6(alpha_at(node) * offset_mass_in_space(mass, at.rotation[node])));
    }
    void all_broke() override { find_footings(); }
    void roll_back() override { find_footings(); }
    void broke(const Break& b) override {
        for (const AtNode& m : masses_)
            for (const int node : w_.structure.elements()[b.element].node)
                if (m.node == node) return renew(w_.state);
    }

    /// Where the step ends, before contact gives impulses: the accelerations of this step and of the next one follow
    /// from these forces. Explicit steps took those at the predicted velocity, and those do the work.
    void solved(const Step&, const std::vector<Vec6>&) override {
        if (!w_.kind.explicit_steps) find_forces();
        impulses_ = w_.impulses;
    }

    /// By the trapezium rule, like the work of loads.
    void accumulate_energy(const Step&, Accounts& sums) const override {
        std::vector<Vec3> ways(footings_.size());  // of the supports of each body
        for (std::size_t i = 0; i < ways.size(); ++i)
            ways[i] = footings_[i].mean(
                [&](int n, int c) { return w_.trial.displacement[n][c] - w_.state.displacement[n][c]; });
        double work = 0, by_supports = 0;
        for (std::size_t n = 0; n < now_.size(); ++n) {
            const Vec6 mean = 0.5 * (before_[n] + now_[n]);
            work += mean.head<3>().dot(w_.trial.displacement[n] - w_.state.displacement[n]) +
                    mean.tail<3>().dot(w_.rotation_step[n]);
            if (const int body = footings_.empty() ? -1 : bodies_.of_node[n]; body >= 0)
                by_supports += mean.head<3>().dot(ways[body]);
        }
        sums["damping"] += work - by_supports;
        if (by_supports != 0) sums["work"] -= by_supports;
    }

    /// Impulses that contact gave since `solved` have changed the velocities: with the forces of before, half a step of
    /// damping would do work on the bodies.
    void before_commit(const Step&) override {
        count_taken();
        before_ = now_;
        flowed_ = w_.elastic_rates;
        if (!w_.kind.explicit_steps && w_.impulses != impulses_) host_.accelerations_anew();
    }
    void acceleration_found() override { before_ = now_, by_stiffness_before_ = by_stiffness_; }

    Counts whole_rates() const override {
        Counts counts;
        for (const auto& [element, of] : dashpots_) {
            const double part = double(of.whole) / std::max(1, of.flowed);
            if (!(of.whole >= few_steps && part > small_part)) continue;
            if (counts.elements++ == 0) counts.first = element;
            counts.most_part = std::max(counts.most_part, part);
        }
        return counts;
    }

    void save(Writer& to) const override { to(before_, built_, flowed_, dashpots_, by_stiffness_before_); }
    void restore(Reader& from) override { from(before_, built_, flowed_, dashpots_, by_stiffness_before_); }
    bool restored(std::span<const State* const>) override {
        find_footings();
        const int n = int(damping_.size());
        return before_.size() == now_.size() && built_.size() == masses_.size() &&
               by_stiffness_before_.size() == by_stiffness_.size() &&
               std::all_of(
                   dashpots_.begin(), dashpots_.end(),
                   [this](const auto& t) { return std::binary_search(damped_.begin(), damped_.end(), t.first); }) &&
               std::all_of(flowed_.begin(), flowed_.end(),
                           [n](const ElasticRate& r) { return r.element >= 0 && r.element < n; });
    }

private:
    /// The part of beta of an element that has flowed.
    struct Dashpot {
        bool counts = false;        ///< it has taken an elastic rate
        double taken = 0;           ///< J, since then
        int flowed = 0, whole = 0;  ///< steps in which it flowed, and of those, in which it took the whole rate
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.counts, s.taken, s.flowed, s.whole);
        }
    };

    struct AtNode {
        int node;
        OffsetMass mass;  ///< of its point masses
    };

    /// Where supports move; none where all are at rest.
    void find_footings() {
        footings_.clear();
        if (!supports_move_) return;
        bodies_ = joined_bodies(w_.structure, w_.state);
        footings_.resize(bodies_.count);
        for (std::size_t n = 0; n < bodies_.of_node.size(); ++n)
            for (int c : {0, 1, 2})
                if (bodies_.of_node[n] >= 0 && w_.structure.fixed()[n] >> c & 1)
                    footings_[bodies_.of_node[n]].supports[c].push_back(int(n));
        velocities_.resize(footings_.size());
    }
    /// Of the supports that a node is damped relative to.
    Vec6 velocity_relative(int node) const {
        Vec6 v = w_.trial.velocity[node];
        if (const int body = footings_.empty() ? -1 : bodies_.of_node[node]; body >= 0)
            v.head<3>() -= velocities_[body];
        return v;
    }

    /// The mean of the whole elements there, 1/s.
    double alpha_at(int node) const {
        if (w_.structure.has_panels_alone(node)) return alpha_of_panels_;
        double sum = 0;
        int whole = 0;
        for (const int e : w_.structure.elements_at(node))
            if (!w_.state.broken[e]) sum += damping_[e].of_mass, ++whole;
        return whole ? sum / whole : 0;
    }

    bool masses_lag() const {
        for (std::size_t i = 0; i < masses_.size() && host_.has_effective_stiffness(); ++i)
            if (std::abs(w_.trial.rotation[masses_[i].node].dot(built_[i])) < rotation_lag_cosine) return true;
        return false;
    }

    void renew(const Pose& at) {
        for (std::size_t i = 0; i < masses_.size(); ++i) built_[i] = at.rotation[masses_[i].node];
        host_.blocks_changed(at);
    }

    /// Of the elements that flow on the way to the trial pose. Where a step begins, and the acceleration is found, what
    /// flowed in the step before flows on.
    void find_rates(double time) {
        std::vector<ElasticRate>& rates = w_.elastic_rates;
        if (time == w_.state.time) {
            rates = flowed_;
            return;
        }
        const bool held = ++solutions_ > shares_follow;
        const std::vector<ElasticRate> before = std::exchange(rates, {});
        std::size_t next = 0;
        const auto keep_before = [&](int end) {
            for (; next < before.size() && before[next].element < end; ++next)
                if (held) add_rate({before[next].element, {}}, &before[next]);
        };
        for (const PlasticIncrement& y : w_.yielding) {
            if (damping_[y.element].of_stiffness == 0 || gave(y.element) || would_give(y.element)) continue;
            keep_before(y.element);
            static const ElasticRate none = {};
            const bool was = next < before.size() && before[next].element == y.element;
            add_rate(y, !held ? nullptr : was ? &before[next] : &none);
            next += was;
            if (solutions_ > 1) leave_if_it_gives();
        }
        keep_before(int(damping_.size()));
    }
    void add_rate(const PlasticIncrement& y, const ElasticRate* as) {
        w_.elastic_rates.push_back(elastic_rate(w_.structure, w_.state, w_.trial, y, w_.assembly.step(),
                                                damping_[y.element].of_stiffness, as));
    }

    /// Takes the last rate out again where its dashpot would have given more by the end of the step than it has taken.
    void leave_if_it_gives() {
        const int element = w_.elastic_rates.back().element;
        const auto at = dashpots_.find(element);
        const Vec12 force = force_by_stiffness(element, element_frame(w_.structure, element, w_.trial));
        if ((at == dashpots_.end() ? 0 : at->second.taken) + work_of(element, force) >= 0) return;
        w_.elastic_rates.pop_back();
        giving_.insert(std::lower_bound(giving_.begin(), giving_.end(), element), element);
    }

    bool would_give(int element) const { return std::binary_search(giving_.begin(), giving_.end(), element); }
    int index_of(int element) const {
        return int(std::lower_bound(damped_.begin(), damped_.end(), element) - damped_.begin());
    }
    /// Of the dashpot of an element over the step, by the trapezium rule, J; `now`: its forces where the step ends.
    double work_of(int element, const Vec12& now) const {
        const Element& e = w_.structure.elements()[element];
        Vec12 way;
        for (int end : {0, 1})
            way.segment<6>(6 * end) << w_.trial.displacement[e.node[end]] - w_.state.displacement[e.node[end]],
                w_.rotation_step[e.node[end]];
        return 0.5 * (by_stiffness_before_[std::size_t(index_of(element))] + now).dot(way);
    }

    /// True if the dashpot of an element has given more work than it has dissipated: forces by elastic rates do work on
    /// the flow of a section as well, and where this turns from step to step that may be more than what they take from
    /// the elastic motion. From then on the dashpot takes the whole rate, which always dissipates.
    bool gave(int element) const {
        const auto at = dashpots_.find(element);
        return at != dashpots_.end() && at->second.taken < 0;
    }

    /// Counts what the dashpots of elements that flow, or have flowed, take in the step.
    void count_taken() {
        for (const PlasticIncrement& y : w_.yielding) {
            if (damping_[y.element].of_stiffness == 0) continue;
            Dashpot& of = dashpots_[y.element];
            ++of.flowed;
            if (of.taken < 0 || would_give(y.element)) ++of.whole;
        }
        for (const ElasticRate& r : w_.elastic_rates) dashpots_[r.element].counts = true;
        for (auto& [element, of] : dashpots_)
            if (of.counts && of.taken >= 0) of.taken += work_of(element, by_stiffness_[std::size_t(index_of(element))]);
        by_stiffness_before_ = by_stiffness_;
    }

    /// C v at the trial pose, N and N m of each node.
    void find_forces() {
        for (std::size_t i = 0; i < footings_.size(); ++i)
            velocities_[i] = footings_[i].mean([&](int n, int c) { return w_.trial.velocity[n][c]; });
        if (w_.structure.large() && w_.trial.heat.empty() && w_.state.turned.empty()) find_by_eight();
        else
            w_.pool.share(int(damped_.size()), 64, [&](int first, int end, int) {
                for (int i = first; i < end; ++i) of_element_[i] = force_of(damped_[i], by_stiffness_[i]);
            });
        for (Vec6& n : now_) n.setZero();
        for (std::size_t i = 0; i < damped_.size(); ++i)
            for (int end : {0, 1})
                now_[w_.structure.elements()[damped_[i]].node[end]] += of_element_[i].segment<6>(6 * end);
        for (const auto& [node, mass] : masses_)
            if (!w_.rests(node))
                now_[node] +=
                    alpha_at(node) * (offset_mass_in_space(mass, w_.trial.rotation[node]) * velocity_relative(node));
    }

    /// Eight elements at once, and again those of them that are not as DampedBlocks takes them.
    void find_by_eight() {
        if (!footings_.empty()) {
            relative_.resize(now_.size());
            for (std::size_t n = 0; n < relative_.size(); ++n) relative_[n] = velocity_relative(int(n));
        }
        const std::vector<Vec6>& relative = footings_.empty() ? w_.trial.velocity : relative_;
        w_.pool.share(blocks_.size(), 8, [&](int first, int end, int) {
            for (int block = first; block < end; ++block) {
                const int from = block * lane_count, to = std::min(from + lane_count, int(damped_.size()));
                unsigned alone = ~0u;
                if (std::any_of(damped_.begin() + from, damped_.begin() + to, [this](int e) { return damps_now(e); }))
                    alone = blocks_.find(block, w_.state, w_.trial, relative, &of_element_[std::size_t(from)],
                                         &by_stiffness_[std::size_t(from)]);
                for (int i = from; i < to; ++i)
                    if (const int e = damped_[std::size_t(i)]; alone >> (i - from) & 1 || by_itself(e))
                        of_element_[std::size_t(i)] = force_of(e, by_stiffness_[std::size_t(i)]);
            }
        });
        for (const ElasticRate& r : w_.elastic_rates)
            if (damps(damping_[r.element])) {
                const std::size_t i = std::size_t(index_of(r.element));
                of_element_[i] = force_of(r.element, by_stiffness_[i]);
            }
    }
    /// Whether an element is not as DampedBlocks takes it; those that flow are not either.
    bool by_itself(int element) const {
        return !damps_now(element) || is_lone(w_.structure, w_.state, element) ||
               (!w_.trial.twist.empty() && w_.trial.twist[element] != 0) ||
               (w_.structure.wears_stiffness() && !in_pair(w_.structure, w_.state, element));
    }
    bool damps_now(int element) const {
        return !w_.state.broken[element] && !w_.rests(w_.structure.elements()[element].node[0]);
    }

    /// The part of beta at the trial pose.
    Vec12 force_by_stiffness(int element, const ElementFrame& place) const {
        const Element& e = w_.structure.elements()[element];
        const Vec6 rate = deformation_rates(place, w_.trial.velocity[e.node[0]], w_.trial.velocity[e.node[1]]);
        const beam::Stiffness k = stiffness_now(w_.structure, w_.state, element);
        const ElasticRate* flow = w_.elastic_rates.empty() ? nullptr : find_rate(w_.elastic_rates, element);
        return nodal_forces(place, damping_[element].of_stiffness * (flow ? flow->forces(k, rate) : k.times(rate)));
    }

    /// Of both parts.
    Vec12 force_of(int element, Vec12& by_stiffness) const {
        const Element& e = w_.structure.elements()[element];
        by_stiffness.setZero();
        if (!damps_now(element)) return Vec12::Zero();
        const ElementDamping& c = damping_[element];
        const ElementFrame place = element_frame(w_.structure, element, w_.trial);
        Vec12 force = Vec12::Zero();
        if (c.of_mass != 0) {
            Vec12 relative;
            relative << velocity_relative(e.node[0]), velocity_relative(e.node[1]);
            force = c.of_mass * inertia_now(w_.structure, w_.state, element).times(axes_of(place), relative);
            if (is_lone(w_.structure, w_.state, element)) {
                const int inner = inner_end(element, e);
                const Vec3 arm = w_.trial.rotation[e.node[inner]] * w_.state.offset_arm[element];
                force.segment<6>(6 * inner) += c.of_mass * (lone_mass(e, arm) * relative.segment<6>(6 * inner));
            }
        }
        if (c.of_stiffness != 0) force += by_stiffness = force_by_stiffness(element, place);
        return force;
    }

    std::vector<ElementDamping> damping_;
    std::vector<int> damped_;                                ///< elements
    DampedBlocks blocks_;                                    ///< of those
    std::vector<Vec6> relative_;                             ///< of all nodes, where supports move: velocity_relative
    std::vector<Vec12> of_element_;                          ///< of those
    std::vector<Vec12> by_stiffness_, by_stiffness_before_;  ///< the part of beta, and where the last step ended
    std::map<int, Dashpot> dashpots_;                        ///< of elements that flow or have flowed
    double alpha_of_panels_ = 0;
    std::vector<AtNode> masses_;
    std::vector<Quat> built_;  ///< of those: orientation that they have in the effective stiffness
    Bodies bodies_;            ///< where supports move
    bool supports_move_ = false;
    std::vector<Footing> footings_;    ///< of those bodies; empty where no support moves
    std::vector<Vec3> velocities_;     ///< m/s, of the supports of each body at the trial pose
    long impulses_ = 0;                ///< Workspace::impulses, where the forces of this step were found
    std::vector<Vec6> before_, now_;   ///< of each node: where the last step ended, and where this one is tried to end
    int solutions_ = 0;                ///< of this step so far
    std::vector<int> giving_;          ///< elements whose dashpots would give in this step, rising
    std::vector<ElasticRate> flowed_;  ///< of damped elements that flowed in the last step, rising
};

std::vector<PlanLine> damping_plan(const Structure& s, const RunKind&) {
    const std::vector<Damping>& declared = s.model().declared<Damping>(damping_effect);
    if (declared.empty()) return {{damping_effect, false, "not declared", ""}};
    const bool any = !damping_of_elements(s).empty() || alpha_of_panels(s) != 0;
    return {{damping_effect, any, any ? "model:damping" : "declared by model:damping, but damps no member",
             s.model().asked_at(damping_effect)}};
}

}  // namespace

EffectKind damping_kind() {
    return {.name = damping_effect,
            .accounts = {{"damping", 80, "dissipated by Rayleigh damping"}},
            .plan = damping_plan,
            .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                std::vector<ElementDamping> damping = damping_of_elements(w.structure);
                if (damping.empty() && alpha_of_panels(w.structure) == 0) return nullptr;
                damping.resize(w.structure.elements().size());
                return std::make_unique<RayleighDamping>(w, host, std::move(damping));
            },
            .dynamic_only = true,
            .leave_out = leave_out_declared<damping_effect>,
            .damping = damping_of_elements};
}

}  // namespace hinge

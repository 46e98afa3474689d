// When elements break (eq 16): limits of curvature and axial strain, or rules of the script's own.
#include "section/fracture_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/errors.h"
#include "effects/facts.h"
#include "effects/fracture.h"
#include "effects/fracture_reach.h"
#include "effects/hinge_limits.h"
#include "effects/kinds.h"
#include "state/hinges.h"
#include "state/turned_ends.h"

namespace hinge {
namespace {

using Where = FractureRule::Where;

/// The script's node at an end of an element, -1 inside a member.
int joint_at(const Structure& s, const Element& e, int end) { return s.declared_node(e.node[end - 1]); }

bool rules_call_functions(const Model& model) {
    const auto& rules = fracture_rules(model);
    return std::any_of(rules.begin(), rules.end(), [](const FractureRule& r) { return bool(r.hook); });
}

/// An element that has flowed and has a rule of the script's own: its strains as factors of its forces.
struct StrainFactors {
    int element;
    double x[2], y[2], axial, per_length;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.element, s.x, s.y, s.axial, s.per_length);
    }
};

class Fracture : public Effect, public Breaker, public BreakListener, public RuleCalls {
public:
    Fracture(Workspace& w, Host& host);
    const char* stage_name() const override { return fracture_effect; }
    bool by_strain() const override { return w_.structure.can_yield() || !candidates_.empty(); }
    void find_breaks(Step& step) override;
    void after_commit(const Step&) override {
        for (const PlasticIncrement& y : w_.yielding) add_if_reachable(y.element);
    }
    /// The partner of a pair gets plastic deformation (state/breaking.h): its limits may come within reach.
    void broke(const Break& b) override {
        std::erase(candidates_, b.element);
        if (w_.structure.p_delta()) add_if_reachable(w_.structure.elements()[b.element].partner);
    }

    void save_step() override { kept_before_.clear(), strained_before_.clear(); }
    void roll_back() override {
        for (auto kept = kept_before_.rbegin(); kept != kept_before_.rend(); ++kept) *kept->at = kept->before;
        for (const Strained& s : strained_before_) std::copy(s.before.begin(), s.before.end(), s.at);
    }
    void save(Writer& to) const override { to(candidates_, yielded_, called_); }
    void restore(Reader& from) override { from(candidates_, yielded_, called_); }
    bool restored(std::span<const State* const>) override;
    const std::vector<long>& calls() const override { return called_; }

private:
    void add_if_reachable(int element);
    void add_candidate(int element);
    void check_element(int element, const beam::ReturnMapResult* flow, bool news);
    StrainFactors strain_factors(int element) const;
    void add_shear(beam::FractureStrains& to, int element, const Vec6& p) const {
        const Element& e = w_.structure.elements()[element];
        const double soft = heat_of(w_.trial.heat, element).stiffness;
        beam::add_shear(to, p, soft * e.rigidity.GAx, soft * e.rigidity.GAy, e.length);
    }
    void list_newly_strained();
    bool is_breaking(int element) const {
        return std::any_of(step_->breaks.begin(), step_->breaks.end(),
                           [&](const Break& b) { return b.element == element; });
    }
    Vec6 elastic_deformation(int element, const Vec6& plastic, const beam::ReturnMapResult* flow) const;
    Vec6 deformation_before(int element) const;
    Vec6 without_slack(Vec6 deformation, int element, const beam::ReturnMapResult* flow = nullptr) const;
    int weaker_end(int element, const beam::ReturnMapResult* flow) const;
    /// Resultants in the places of p, with those of loads between the nodes; f_y of them.
    bool flows_at(const beam::ReturnMapResult* flow, int end, int weaker) const;
    Break at_limit(int element, const Vec6& elastic, const Vec6& plastic, const beam::ReturnMapResult* flow) const;
    Vec6 resultants_at(int element, double r) const { return w_.force[element] + w_.assembly.fixed_end(element).at(r); }
    double yield_at(int element, double r) const {
        return yield_function_at(w_.structure, w_.state, element, w_.structure.conventional() ? 0 : r,
                                 beam::resultants(resultants_at(element, r), r));
    }
    void list_section(int element, int side, const Vec6& elastic, const Vec6& plastic,
                      const beam::ReturnMapResult* flow);
    void call_rule();

    FractureRuleData& numbers() const { return *w_.state.data.find<FractureRuleData>(fracture_effect); }
    int rule_of(const Element& e) const { return rule_of_member_[e.member]; }  ///< its index, -1: none

    const std::vector<FractureRule>& rules_;
    std::vector<int> rule_of_member_;
    HingeLimits hinges_;
    Step* step_ = nullptr;         ///< the one that is decided on
    std::vector<int> candidates_;  ///< elements that could break without flowing in the step, rising
    std::vector<char> in_candidates_;
    std::vector<SectionView> sections_;   ///< in this step, of one rule
    std::vector<StrainFactors> yielded_;  ///< rising
    std::vector<int> newly_strained_;     ///< of those, strained in this step as never before
    std::size_t kept_a_section_ = 0;      ///< numbers that rules keep of a section
    std::vector<long> called_;            ///< of each rule: how often its function was
    // for a step that is taken back
    struct Kept {
        double* at;
        double before;
    };
    struct Strained {
        double* at;
        std::array<double, 3> before;
    };
    std::vector<Kept> kept_before_;
    std::vector<Strained> strained_before_;
};

Fracture::Fracture(Workspace& w, Host& host)
    : Effect(fracture_effect, w, host, {.forces_vanish = true}),
      rules_(fracture_rules(w.structure.model())),
      hinges_(w, rules_, rule_of_member_) {
    for (const MemberData& member : w.structure.model().members())
        rule_of_member_.push_back(fracture_rule_of(rules_, member));
    traits_.calls_script = rules_call_functions(w.structure.model());
    const std::size_t elements = w.structure.elements().size();
    for (const FractureRule& rule : rules_) kept_a_section_ = std::max(kept_a_section_, rule.keep.size());
    const bool news = std::any_of(rules_.begin(), rules_.end(), [](const FractureRule& r) {
        return r.hook && r.where == FractureRule::Where::plastic;
    });
    if (!w.state.data.find<FractureRuleData>(fracture_effect)) w.state.data.set(fracture_effect, FractureRuleData{});
    numbers().resize(news ? 3 * elements : 0, 2 * elements * kept_a_section_);
    called_.assign(rules_.size(), 0);
    in_candidates_.assign(elements, 0);
    for (std::size_t i = 0; i < elements; ++i) add_if_reachable(int(i));
    std::vector<Break> past;  // statics breaks nothing
    for (std::size_t i = 0; i < elements; ++i)
        if (!w.state.broken[i]) hinges_.add_reached(int(i), past, true);
    for (const Break& b : past) add_candidate(b.element);
}

bool Fracture::restored(std::span<const State* const> states) {
    const int n = int(w_.structure.elements().size());
    const auto within = [n](int e) { return e >= 0 && e < n; };
    if (!std::all_of(candidates_.begin(), candidates_.end(), within)) return false;
    if (called_.size() != rules_.size()) return false;
    for (const StrainFactors& w : yielded_)
        if (!within(w.element)) return false;
    for (const State* s : states)
        if (const auto* there = s->data.find<FractureRuleData>(fracture_effect); !there || !there->is_alike(numbers()))
            return false;
    in_candidates_.assign(n, 0);
    for (int e : candidates_) in_candidates_[e] = 1;
    return true;
}

void Fracture::add_candidate(int index) {
    if (in_candidates_[index]) return;
    in_candidates_[index] = 1;
    candidates_.insert(std::lower_bound(candidates_.begin(), candidates_.end(), index), index);
}

/// Lists the element as one that eq 16 is checked for at every step, whether or not it flows.
void Fracture::add_if_reachable(int index) {
    const Element& e = w_.structure.elements()[index];
    if (rule_of(e) < 0 || in_candidates_[index] || w_.state.broken[index]) return;
    const FractureRule& rule = rules_[rule_of(e)];
    const bool heated = !w_.state.heat.empty() && !(rule.no_strains() && !rule.hook);  // no bound of strains holds
    if (heated || ever_within_reach(rule, e, without_slack(flowed(w_.state, index), index), w_.structure.p_delta()) ||
        (rule.hook && (rule.where == Where::all || (rule.where == Where::yielded && w_.state.yielded[index])))) {
        add_candidate(index);
    } else if (rule.hook && rule.where == Where::plastic && w_.state.yielded[index]) {
        const auto at = std::lower_bound(yielded_.begin(), yielded_.end(), index,
                                         [](const StrainFactors& w, int element) { return w.element < element; });
        if (at == yielded_.end() || at->element != index) yielded_.insert(at, strain_factors(index));
    }
}

/// Lists the elements that have flowed before and are strained more than ever: a script's rule is called for them
/// without flow.
void Fracture::list_newly_strained() {
    newly_strained_.clear();
    for (StrainFactors& w : yielded_) {
        const int i = w.element;
        if (w_.state.broken[i]) continue;
        if (w_.structure.model().options().shift == Shift::elastic_and_plastic || !w_.trial.heat.empty())
            w = strain_factors(i);  // its point may have moved, or heat has softened it
        const Vec6 &p = w_.force[i], plastic = without_slack(flowed(w_.state, i), i);
        const double strain[3] = {std::abs(w.x[0] * p[0] + w.x[1] * p[1] + w.per_length * (plastic[1] - plastic[0])),
                                  std::abs(w.y[0] * p[2] + w.y[1] * p[3] + w.per_length * (plastic[3] - plastic[2])),
                                  std::abs(w.axial * p[4] + w.per_length * plastic[4])};
        double* most = &numbers().strained[3 * std::size_t(i)];
        if (strain[0] <= most[0] && strain[1] <= most[1] && strain[2] <= most[2]) continue;
        newly_strained_.push_back(i);
        strained_before_.push_back({most, {most[0], most[1], most[2]}});
        for (int c = 0; c < 3; ++c) most[c] = std::max(most[c], strain[c]);
    }
}

/// Curvatures and axial strain of an element as factors of its forces, elastic; see Stiffness::solve.
StrainFactors Fracture::strain_factors(int index) const {
    const Element& e = w_.structure.elements()[index];
    const beam::Stiffness k = stiffness_now(w_.structure, w_.state, index, heat_of(w_.trial.heat, index));
    const double x = k.determinant_x() * e.length, y = k.determinant_y() * e.length;
    return {index,
            {-(k.x12 + k.x22) / x, (k.x11 + k.x12) / x},
            {-(k.y12 + k.y22) / y, (k.y11 + k.y12) / y},
            1 / (k.axial * e.length),
            1 / e.length};
}

/// Eq 16, element by element, where a limit can be reached: in those that flow, and those that could break
/// without.
void Fracture::find_breaks(Step& step) {
    step_ = &step;
    step.breaks.clear(), sections_.clear();
    list_newly_strained();
    auto candidate = candidates_.begin();  // all three rise
    auto news = newly_strained_.begin();
    auto flowing = w_.yielding.begin();
    constexpr int none = std::numeric_limits<int>::max();
    while (true) {
        const int c = candidate != candidates_.end() ? *candidate : none,
                  n = news != newly_strained_.end() ? *news : none,
                  f = flowing != w_.yielding.end() ? flowing->element : none, e = std::min({c, n, f});
        if (e == none) break;
        if (!w_.state.broken[e] && rule_of(w_.structure.elements()[e]) >= 0)
            check_element(e, f == e ? &flowing->flow : nullptr, n == e);
        candidate += c == e, news += n == e, flowing += f == e;
    }
    call_rule();
    std::sort(step_->breaks.begin(), step_->breaks.end(),
              [](const Break& a, const Break& b) { return a.element < b.element; });
}

/// The section that flows, else the one whose forces over its strengths are larger (the measure of eq 14, whatever the
/// law: laws are not evaluated far from flow).
int Fracture::weaker_end(int index, const beam::ReturnMapResult* flow) const {
    if (flow && !w_.structure.conventional() && flow->lambda[0] != flow->lambda[1])
        return flow->lambda[0] > flow->lambda[1] ? 1 : 2;
    const Vec6 p = resultants_at(index, 0);
    const beam::YieldSurface& strength = w_.structure.elements()[index].yield;
    const double f1 = beam::yield_function(resultants_at(index, -1), -1, strength),
                 f2 = beam::yield_function(resultants_at(index, 1), 1, strength);
    const double m1 = p[0] * p[0] + p[2] * p[2], m2 = p[1] * p[1] + p[3] * p[3];
    return f1 > f2 || (f1 == f2 && m1 > m2) ? 1 : 2;
}

/// At the end of the step, from the forces; where bending follows N, from where the nodes are.
[[gnu::always_inline]] inline Vec6 Fracture::elastic_deformation(int index, const Vec6& plastic,
                                                                 const beam::ReturnMapResult* flow) const {
    if (w_.structure.p_delta() && flow && !flow->elastic.isZero(0)) return flow->elastic;
    if (w_.structure.p_delta())
        return element_deformation(w_.structure, index, w_.trial) + taken_up(w_.state, index) - plastic;
    const Vec6 d = stiffness_now(w_.structure, w_.state, index, no_heat).solve(w_.force[index]);
    return w_.trial.heat.empty() ? d : Vec6(d / w_.trial.heat[std::size_t(index)].stiffness);
}

/// The whole deformation at the start of the step, without slack.
Vec6 Fracture::deformation_before(int index) const {
    const Vec6 d =
        w_.structure.p_delta()
            ? Vec6(element_deformation(w_.structure, index, w_.state) + taken_up(w_.state, index))
            : Vec6(stiffness_now(w_.structure, w_.state, index).solve(w_.state.force[index]) + flowed(w_.state, index));
    return without_slack(d, index);
}

/// A deformation less the slack at the start of the step and that of `flow`: slack strains nothing.
[[gnu::always_inline]] inline Vec6 Fracture::without_slack(Vec6 deformation, int index,
                                                           const beam::ReturnMapResult* flow) const {
    deformation[4] -= slack_of(w_.structure, w_.state, index) + (flow ? flow->slack : 0);
    return deformation;
}

/// True if the section at an end flows in the step.
bool Fracture::flows_at(const beam::ReturnMapResult* flow, int end, int weaker) const {
    return flow && (w_.structure.conventional() ? end == weaker : flow->lambda[end - 1] > 0);
}

/// The end at which a limit of the element's rule is reached, 0: at neither; and which.
Break Fracture::at_limit(int index, const Vec6& elastic, const Vec6& plastic, const beam::ReturnMapResult* flow) const {
    const Element& e = w_.structure.elements()[index];
    const FractureRule& rule = rules_[rule_of(e)];
    const Break holds = {index, 0};
    if (rule.none() || (rule.plastic_only && !flow)) return holds;
    const bool by_section = rule.strain_measure == FractureRule::StrainMeasure::section && !w_.structure.conventional();
    const auto with_shear = [&](beam::FractureStrains strains) {
        if (std::isfinite(rule.shear_strain)) add_shear(strains, index, resultants_at(index, 0));
        return strains;
    };
    if (!by_section) {
        const beam::FractureStrains strains = with_shear(beam::fracture_strains(elastic + plastic, e.length));
        if (!beam::reached(strains, rule)) return holds;
        return {index, weaker_end(index, flow), beam::most_beyond(strains, rule)};
    }
    const beam::FractureStrains strains[2] = {with_shear(beam::section_strains(elastic, plastic, e.length, 1)),
                                              with_shear(beam::section_strains(elastic, plastic, e.length, 2))};
    if (!beam::reached(strains[0], rule) && !beam::reached(strains[1], rule)) return holds;
    const int weaker = weaker_end(index, flow);
    for (const int end : {weaker, 3 - weaker}) {
        const beam::FractureStrains& strain = strains[end - 1];
        if (rule.plastic_only && !flows_at(flow, end, weaker)) continue;
        if (beam::reached(strain, rule)) return {index, end, beam::most_beyond(strain, rule)};
    }
    return holds;
}

/// Breaks the element if a limit is reached (eq 16); else lists its sections for which a rule of the script is to be
/// called. `news`: the element is strained as never before.
void Fracture::check_element(int index, const beam::ReturnMapResult* flow, bool news) {
    const Element& e = w_.structure.elements()[index];
    const FractureRule& rule = rules_[rule_of(e)];
    hinges_.add_reached(index, step_->breaks, in_candidates_[index]);
    if (rule.no_strains() && !rule.hook) return;
    Vec6 plastic = flowed(w_.state, index);
    if (flow) plastic += flow->plastic;
    if (!flow && !rule.hook && w_.trial.heat.empty() && in_pair(w_.structure, w_.state, index) &&
        !now_within_reach(rule, e, plastic, w_.force[index], w_.force[e.partner]))
        return;
    const Vec6 elastic = elastic_deformation(index, plastic, flow);
    plastic = without_slack(plastic, index, flow);
    if (flow && !flow->yields()) flow = nullptr;
    if (is_breaking(index)) return;
    if (const Break b = at_limit(index, elastic, plastic, flow); b.end > 0) return step_->breaks.push_back(b);
    if (!rule.hook) return;
    if (!sections_.empty() && rule_of(w_.structure.elements()[sections_.back().element]) != rule_of(e)) call_rule();
    const int weaker = weaker_end(index, flow);
    for (int side : {weaker, 3 - weaker}) {
        const bool flows = flows_at(flow, side, weaker);
        const int bit = w_.structure.conventional() ? hinge_at_middle : side == 1 ? hinge_at_1 : hinge_at_2;
        const bool asked = flows || e.yield.elastic() || rule.where == Where::all ||
                           ((rule.where == Where::yielded || news) && w_.state.yielded[index] & bit);
        if (!asked) continue;
        list_section(index, side, elastic, plastic, flow);
        sections_.back().plastic = flows;
        if (news && !flow) break;  // the other end is strained alike
    }
}

void Fracture::list_section(int index, int side, const Vec6& elastic, const Vec6& plastic,
                            const beam::ReturnMapResult* flow) {
    const Element& e = w_.structure.elements()[index];
    const Vec6 before = deformation_before(index);
    const auto strains = [&](const Vec6& deformation) -> SectionView::Strains {
        const beam::FractureStrains s = beam::fracture_strains(deformation, e.length);
        return {s.curvature_x, s.curvature_y, s.axial, s.twist};
    };
    const double r = side == 1 ? -1 : 1;
    const Vec6 p = resultants_at(index, r);
    SectionView& v = sections_.emplace_back();
    v.time = step_->end(), v.dt = step_->dt, v.step = double(w_.state.step + 1);
    v.member = e.member, v.element = index, v.end = side, v.node = joint_at(w_.structure, e, side);
    v.strain = strains(elastic + plastic);
    v.plastic_strain = strains(plastic);
    v.strain_rate = strains((elastic + plastic - before) / step_->dt);
    v.force = {beam::moment_at(p[0], p[1], r), beam::moment_at(p[2], p[3], r), p[4], p[5]};
    v.f_y = yield_at(index, r);
    v.plastic_work = w_.state.plastic_work[index] + (flow ? flow->dissipation : 0);
    beam::FractureStrains shear{};
    add_shear(shear, index, resultants_at(index, 0));
    v.shear_x = shear.shear_x, v.shear_y = shear.shear_y;
    v.hinge_rotation_x = hinges_.rotation(index, side, 0);
    v.hinge_rotation_y = hinges_.rotation(index, side, 1);
    if (rules_[rule_of(e)].keep.empty()) return;
    v.kept = &numbers().kept[(2 * std::size_t(index) + std::size_t(side) - 1) * kept_a_section_];
}

/// Asks the rule of the sections listed, all of them its own: of an element's second one only if the first holds.
void Fracture::call_rule() {
    if (sections_.empty()) return;
    const int number = rule_of(w_.structure.elements()[sections_[0].element]);
    const FractureRule& rule = rules_[number];
    called_[number] += long(sections_.size());
    for (const SectionView& v : sections_)
        for (std::size_t i = 0; i < rule.keep.size(); ++i) kept_before_.push_back({v.kept + i, v.kept[i]});
    std::size_t at = 0;
    while (at < sections_.size()) {
        try {
            rule.hook.ask(sections_, at);
        } catch (const HookError& e) {
            const SectionView& at_error = sections_[at];
            throw HookError(
                std::string(e.what()) + " (fracture rule" + (rule.asked_at.empty() ? "" : " of " + rule.asked_at) +
                ", " + w_.structure.element_name(at_error.element) + ", end " + std::to_string(at_error.end) + ")");
        }
        if (at >= sections_.size()) break;
        const SectionView& breaks = sections_[at];
        if (!is_breaking(breaks.element)) step_->breaks.push_back({breaks.element, breaks.end});
        while (at < sections_.size() && sections_[at].element == breaks.element) ++at;
    }
    sections_.clear();
}

std::vector<PlanLine> fracture_plan(const Structure& s, const RunKind&) {
    const auto& list = fracture_rules(s.model());
    const auto& members = s.model().members();
    const bool rules = !list.empty(), breakable = std::any_of(members.begin(), members.end(), [&](const MemberData&m) {
                                          return fracture_rule_of(list, m) >= 0;
                                      });
    return {{fracture_effect, breakable,
             !rules       ? "not declared"
             : !breakable ? "no member is in the rule's group"
                          : "model:fracture",
             s.model().asked_at(fracture_effect)}};
}

}  // namespace

EffectKind fracture_kind() {
    return {
        .name = fracture_effect,
        .accounts =
            {{"fracture", 50, "released by fracture: strain energy, and kinetic energy of what breaks off", {}, true},
             {"fracture_elastic", 51, "strain energy released by broken elements", "fracture", true},
             {"fracture_kinetic", 52, "kinetic energy lost as an offset mass is taken over", "fracture", true}},
        .plan = fracture_plan,
        .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
            if (!built::fracture || fracture_rules(w.structure.model()).empty()) {
                w.state.data.erase(fracture_effect);
                return nullptr;
            }
            return std::make_unique<Fracture>(w, host);
        },
        .dynamic_only = true,
        .leave_out = leave_out_declared<fracture_effect>,
        .declarer = {.functions = [](const Model& model) -> std::vector<ScriptFunctions> {
            if (!rules_call_functions(model)) return {};
            return {{0, "a function in model:fracture", true, model.asked_at(fracture_effect)}};
        }},
        .may_break =
            [](const Model& model, int member) {
                return built::fracture && fracture_rule_of(fracture_rules(model), model.members()[member]) >= 0;
            },
        .stages = {"restart"}};
}

}  // namespace hinge

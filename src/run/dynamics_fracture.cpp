// Dynamics, the stage of eq 16: what breaks in a step, by limits or by a rule of the script's own.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "beam/fracture.h"
#include "core/errors.h"
#include "run/dynamics.h"
#include "state/hinges.h"

namespace hinge {
namespace {

using Where = FractureRule::Where;

/// The script's node at an end of an element, -1 inside a member.
int joint_at(const Structure& s, const Element& e, int end) {
    return e.node[end - 1] < int(s.model().nodes().size()) ? e.node[end - 1] : -1;
}

double resultant(double w) { return w > 0 ? 1 / std::sqrt(w) : std::numeric_limits<double>::infinity(); }

/// Whether limits alone could be met by elastic strain on top of the plastic one. (Elastic curvature is a mean of the
/// two end moments over EI, and neither is above the fully plastic one.)
bool within_reach(const FractureRule& rule, const Element& e, const beam::FractureStrains& plastic) {
    const auto elastic = [](double w, double rigidity) { return (1 + 1e-6) * resultant(w) / rigidity; };
    return e.yield.elastic() ||
           rule.curvature_x <= std::abs(plastic.curvature_x) + elastic(e.yield.x, e.rigidity.EIx) ||
           rule.curvature_y <= std::abs(plastic.curvature_y) + elastic(e.yield.y, e.rigidity.EIy) ||
           rule.axial_strain <= std::abs(plastic.axial) + elastic(e.yield.n, e.rigidity.EA);
}

/// Calls a rule of the script's own; where it fails, the message says which rule, and asked of whom.
template <class Whom, class Ask>
void saying_which(const FractureRule& rule, Whom whom, Ask ask) {
    try {
        ask();
    } catch (const HookError& e) {
        throw HookError(std::string(e.what()) + " (fracture rule" +
                        (rule.asked_at.empty() ? "" : " of " + rule.asked_at) + ", " + whom() + ")");
    }
}

/// The flow of an element, where it flows: `yielding` rises, and so must the elements asked for.
class Flows {
public:
    explicit Flows(const std::vector<Yielding>& yielding) : next_(yielding.begin()), end_(yielding.end()) {}
    const beam::Flow* of(int element) {
        while (next_ != end_ && next_->element < element) ++next_;
        return next_ != end_ && next_->element == element ? &next_->flow : nullptr;
    }

private:
    std::vector<Yielding>::const_iterator next_, end_;
};

}  // namespace

/// Eq 16 has to be asked of the element at every step, whether or not it flows.
void Dynamics::heed_fracture(int index) {
    const Element& e = structure_->elements()[index];
    if (e.fracture < 0 || in_candidates_[index] || state_.broken[index]) return;
    const FractureRule& rule = structure_->model().fracture()[e.fracture];
    if (within_reach(rule, e, beam::fracture_strains(state_.plastic[index], e.length)) ||
        (rule.hook && (rule.where == Where::all || (rule.where == Where::yielded && state_.yielded[index])))) {
        in_candidates_[index] = 1;
        fracture_candidates_.insert(std::lower_bound(fracture_candidates_.begin(), fracture_candidates_.end(), index),
                                    index);
    } else if (rule.hook && rule.where == Where::plastic && state_.yielded[index]) {
        const auto at = std::lower_bound(watched_.begin(), watched_.end(), index,
                                         [](const Watched& w, int e) { return w.element < e; });
        if (at == watched_.end() || at->element != index) watched_.insert(at, watch_strains(index));
    }
}

/// Of elements that have flowed before, those that are strained as never: what a script's rule is to be asked of
/// without flow.
void Dynamics::list_news() {
    news_.clear();
    for (Watched& w : watched_) {
        const int i = w.element;
        if (state_.broken[i]) continue;
        if (structure_->model().options().shift == Shift::whole) w = watch_strains(i);  // its point may have moved
        const Vec6 &p = force_[i], &plastic = state_.plastic[i];
        const double strain[3] = {std::abs(w.x[0] * p[0] + w.x[1] * p[1] + w.per_length * (plastic[1] - plastic[0])),
                                  std::abs(w.y[0] * p[2] + w.y[1] * p[3] + w.per_length * (plastic[3] - plastic[2])),
                                  std::abs(w.axial * p[4] + w.per_length * plastic[4])};
        double* most = &state_.strained[3 * std::size_t(i)];
        if (strain[0] <= most[0] && strain[1] <= most[1] && strain[2] <= most[2]) continue;
        news_.push_back(i);
        strained_before_.push_back({most, {most[0], most[1], most[2]}});
        for (int c = 0; c < 3; ++c) most[c] = std::max(most[c], strain[c]);
    }
}

/// Curvatures and axial strain of an element as factors of its forces, elastic; see Stiffness::solve.
Dynamics::Watched Dynamics::watch_strains(int index) const {
    const Element& e = structure_->elements()[index];
    const beam::Stiffness k = stiffness_now(*structure_, state_, index);
    const double x = (k.x11 * k.x22 - k.x12 * k.x12) * e.length, y = (k.y11 * k.y22 - k.y12 * k.y12) * e.length;
    return {index,
            {-(k.x12 + k.x22) / x, (k.x11 + k.x12) / x},
            {-(k.y12 + k.y22) / y, (k.y11 + k.y12) / y},
            1 / (k.axial * e.length),
            1 / e.length};
}

/// Eq 16, element by element, where it can be met: those that flow, and those that could break without.
void Dynamics::fracture() {
    to_break_.clear(), asked_.clear();
    list_news();
    auto candidate = fracture_candidates_.begin();  // all three rise
    auto news = news_.begin();
    auto flowing = yielding_.begin();
    constexpr int none = std::numeric_limits<int>::max();
    while (true) {
        const int c = candidate != fracture_candidates_.end() ? *candidate : none,
                  n = news != news_.end() ? *news : none, f = flowing != yielding_.end() ? flowing->element : none,
                  e = std::min({c, n, f});
        if (e == none) break;
        if (!state_.broken[e] && structure_->elements()[e].fracture >= 0)
            judge(e, f == e ? &flowing->flow : nullptr, n == e);
        candidate += c == e, news += n == e, flowing += f == e;
    }
    ask_sections();
    for (std::size_t rule = 0; rule < structure_->model().fracture().size(); ++rule)
        if (structure_->model().fracture()[rule].batch) ask_batch(int(rule));
    std::sort(to_break_.begin(), to_break_.end(), [](const Break& a, const Break& b) { return a.element < b.element; });
}

/// The section that flows, else the one nearer to it.
int Dynamics::weaker_end(int index, const beam::Flow* flow) const {
    const Element& e = structure_->elements()[index];
    const Vec6& p = force_[index];
    const double f1 = beam::yield_function(p, -1, e.yield), f2 = beam::yield_function(p, 1, e.yield);
    const double m1 = p[0] * p[0] + p[2] * p[2], m2 = p[1] * p[1] + p[3] * p[3];
    if (flow && !structure_->conventional() && flow->lambda[0] != flow->lambda[1])
        return flow->lambda[0] > flow->lambda[1] ? 1 : 2;
    return f1 > f2 || (f1 == f2 && m1 > m2) ? 1 : 2;
}

/// Breaks the element if a limit is reached; else lists its sections that a rule of the script's is to be asked of.
/// `news`: the element is strained as never before.
void Dynamics::judge(int index, const beam::Flow* flow, bool news) {
    const Element& e = structure_->elements()[index];
    const FractureRule& rule = structure_->model().fracture()[e.fracture];
    const Vec6 elastic = stiffness_now(*structure_, state_, index).solve(force_[index]);
    Vec6 plastic = state_.plastic[index];
    if (flow) plastic += flow->plastic;
    const beam::FractureStrains strains = beam::fracture_strains(elastic + plastic, e.length);
    if (beam::reached(strains, rule.curvature_x, rule.curvature_y, rule.axial_strain, rule.tension_only))
        return to_break_.push_back({index, weaker_end(index, flow)});
    if (!rule.hook) return;
    if (!asked_.empty() && structure_->elements()[asked_.back().element].fracture != e.fracture) ask_sections();
    const int weaker = weaker_end(index, flow);
    for (int side : {weaker, 3 - weaker}) {
        const bool flows = flow && (structure_->conventional() ? side == weaker : flow->lambda[side - 1] > 0);
        const int bit = structure_->conventional() ? hinge_at_middle : side == 1 ? hinge_at_1 : hinge_at_2;
        const bool asked = flows || e.yield.elastic() || rule.where == Where::all ||
                           ((rule.where == Where::yielded || news) && state_.yielded[index] & bit);
        if (!asked) continue;
        list_section(index, side, elastic, plastic, flow);
        asked_.back().plastic = flows;
        if (news && !flow) break;  // the other end is strained alike
    }
}

void Dynamics::list_section(int index, int side, const Vec6& elastic, const Vec6& plastic, const beam::Flow* flow) {
    const Element& e = structure_->elements()[index];
    const Vec6 &p = force_[index],
               before = stiffness_now(*structure_, state_, index).solve(state_.force[index]) + state_.plastic[index];
    const beam::FractureStrains now = beam::fracture_strains(elastic + plastic, e.length),
                                stays = beam::fracture_strains(plastic, e.length),
                                rate = beam::fracture_strains((elastic + plastic - before) / settings_.dt, e.length);
    const double r = side == 1 ? -1 : 1;
    SectionView& v = asked_.emplace_back();
    v.time = state_.time + settings_.dt, v.dt = settings_.dt, v.step = double(state_.step + 1);
    v.member = e.member, v.element = index, v.end = side, v.node = joint_at(*structure_, e, side);
    v.curvature_x = now.curvature_x, v.curvature_y = now.curvature_y, v.axial_strain = now.axial, v.twist = now.twist;
    v.plastic_curvature_x = stays.curvature_x, v.plastic_curvature_y = stays.curvature_y,
    v.plastic_axial_strain = stays.axial, v.plastic_twist = stays.twist;
    v.curvature_rate_x = rate.curvature_x, v.curvature_rate_y = rate.curvature_y, v.axial_strain_rate = rate.axial,
    v.twist_rate = rate.twist;
    v.Mx = beam::moment_at(p[0], p[1], r), v.My = beam::moment_at(p[2], p[3], r), v.N = p[4], v.Mz = p[5];
    v.f_y = beam::yield_function(p, r, e.yield);
    v.plastic_work = state_.plastic_work[index] + (flow ? flow->dissipation : 0);
    if (structure_->model().fracture()[e.fracture].keep.empty()) return;
    v.kept = &state_.kept[(2 * std::size_t(index) + std::size_t(side) - 1) * kept_a_section_];
}

/// Asks the rule of the sections listed, all of them its own: of an element's second one only if the first holds.
void Dynamics::ask_sections() {
    if (asked_.empty()) return;
    const FractureRule& rule = structure_->model().fracture()[structure_->elements()[asked_[0].element].fracture];
    for (const SectionView& v : asked_)
        for (std::size_t i = 0; i < rule.keep.size(); ++i) kept_before_.push_back({v.kept + i, v.kept[i]});
    std::size_t at = 0;
    const auto whom = [&] {
        return structure_->element_name(asked_[at].element) + ", end " + std::to_string(asked_[at].end);
    };
    while (at < asked_.size()) {
        saying_which(rule, whom, [&] { rule.hook.ask(asked_, at); });
        if (at >= asked_.size()) break;
        const SectionView& breaks = asked_[at];
        to_break_.push_back({breaks.element, breaks.end});
        while (at < asked_.size() && asked_[at].element == breaks.element) ++at;
    }
    asked_.clear();
}

/// A rule's elements, read where the step has ended.
class Dynamics::Asked : public ElementList {
public:
    Asked(const Dynamics& run, const std::vector<int>& elements) : run_(run), elements_(elements) {}
    int count() const override { return int(elements_.size()); }
    double time() const override { return run_.state_.time + run_.settings_.dt; }
    double dt() const override { return run_.settings_.dt; }
    long step() const override { return run_.state_.step + 1; }
    void read(SectionField field, int end, double* out) const override;

private:
    enum Part { total, plastic, rate };
    using Strains = std::array<double, 4>;
    const std::vector<Strains>& strains(Part part) const;
    const Dynamics& run_;
    const std::vector<int>& elements_;
    mutable std::vector<Strains> strains_[3];  ///< of each element, once asked for
};

const std::vector<Dynamics::Asked::Strains>& Dynamics::Asked::strains(Part part) const {
    std::vector<Strains>& list = strains_[part];
    if (!list.empty()) return list;
    list.reserve(elements_.size());
    Flows flows(run_.yielding_);
    for (int index : elements_) {
        const Element& e = run_.structure_->elements()[index];
        const State& state = run_.state_;
        if (state.broken[index]) {
            list.push_back({});
            continue;
        }
        const beam::Flow* flow = flows.of(index);
        Vec6 d = Vec6::Zero();
        if (part == rate)
            d = stiffness_now(*run_.structure_, state, index).solve(run_.force_[index] - state.force[index]) /
                run_.settings_.dt;
        else d = state.plastic[index];
        if (part == total) d += stiffness_now(*run_.structure_, state, index).solve(run_.force_[index]);
        if (flow) d += flow->plastic / (part == rate ? run_.settings_.dt : 1);
        const beam::FractureStrains s = beam::fracture_strains(d, e.length);
        list.push_back({s.curvature_x, s.curvature_y, s.axial, s.twist});
    }
    return list;
}

void Dynamics::Asked::read(SectionField field, int end, double* out) const {
    if (field <= SectionField::twist_rate) {
        for (const Strains& s : strains(Part(int(field) / 4))) *out++ = s[int(field) % 4];
        return;
    }
    Flows flows(run_.yielding_);
    const double r = end == 1 ? -1 : 1;
    for (int index : elements_) {
        const beam::Flow* flow = flows.of(index);
        const Element& e = run_.structure_->elements()[index];
        const Vec6& p = run_.force_[index];
        const bool broken = run_.state_.broken[index];
        const auto value = [&]() -> double {
            switch (field) {
                case SectionField::member: return e.member + 1;
                case SectionField::element: return index + 1;
                case SectionField::end: return end;
                case SectionField::node: return joint_at(*run_.structure_, e, end) + 1;
                case SectionField::broken: return broken;
                case SectionField::plastic_work:
                    return run_.state_.plastic_work[index] + (flow ? flow->dissipation : 0);
                case SectionField::time: return time();
                case SectionField::dt: return dt();
                case SectionField::step: return double(step());
                default: break;
            }
            if (broken) return 0;
            switch (field) {
                case SectionField::Mx: return beam::moment_at(p[0], p[1], r);
                case SectionField::My: return beam::moment_at(p[2], p[3], r);
                case SectionField::N: return p[4];
                case SectionField::Mz: return p[5];
                case SectionField::plastic:
                    return flow && (run_.structure_->conventional() || flow->lambda[end - 1] > 0);
                default: return beam::yield_function(p, r, e.yield);
            }
        };
        *out++ = value();
    }
}

void Dynamics::ask_batch(int rule) {
    if (rule_elements_.empty()) {
        rule_elements_.resize(structure_->model().fracture().size());
        for (std::size_t i = 0; i < structure_->elements().size(); ++i)
            if (const int r = structure_->elements()[i].fracture; r >= 0) rule_elements_[r].push_back(int(i));
    }
    const FractureRule& declared = structure_->model().fracture()[rule];
    const std::vector<int>& elements = rule_elements_[rule];
    std::vector<int> places;
    saying_which(
        declared, [] { return std::string("all its elements"); },
        [&] { declared.batch(Asked(*this, elements), places); });
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    Flows flows(yielding_);
    for (int place : places) {
        const int e = elements[place];
        const beam::Flow* flow = flows.of(e);
        const bool known =
            std::any_of(to_break_.begin(), to_break_.end(), [&](const Break& b) { return b.element == e; });
        if (!state_.broken[e] && !known) to_break_.push_back({e, weaker_end(e, flow)});
    }
}

}  // namespace hinge

// Dynamics, the stage of eq 16: what breaks in a step, by limits or by a rule of the script's own.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "beam/fracture.h"
#include "core/errors.h"
#include "sim/dynamics.h"
#include "sim/hinges.h"

namespace hinge {
namespace {

using Where = FractureRule::Where;

/// The script's node at an end of an element, -1 inside a member.
int joint_at(const Structure& s, const Element& e, int end) { return e.node[end - 1] < int(s.model().nodes().size()) ? e.node[end - 1] : -1; }

double resultant(double w) { return w > 0 ? 1 / std::sqrt(w) : std::numeric_limits<double>::infinity(); }

/// Whether limits alone could be met by elastic strain on top of the plastic one. (Elastic curvature is a mean of the two end
/// moments over EI, and neither is above the fully plastic one.)
bool within_reach(const FractureRule& rule, const Element& e, const beam::FractureStrains& plastic) {
    const auto elastic = [](double w, double rigidity) { return (1 + 1e-6) * resultant(w) / rigidity; };
    return e.yield.elastic() || rule.curvature_x <= std::abs(plastic.curvature_x) + elastic(e.yield.x, e.rigidity.EIx) ||
           rule.curvature_y <= std::abs(plastic.curvature_y) + elastic(e.yield.y, e.rigidity.EIy) ||
           rule.axial_strain <= std::abs(plastic.axial) + elastic(e.yield.n, e.rigidity.EA);
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
        (rule.hook && (rule.where == Where::all || state_.yielded[index]))) {
        in_candidates_[index] = 1;
        fracture_candidates_.insert(std::lower_bound(fracture_candidates_.begin(), fracture_candidates_.end(), index), index);
    }
}

/// Eq 16, element by element, where it can be met: those that flow, and those that could break without.
void Dynamics::fracture() {
    to_break_.clear();
    const auto look = [&](int e, const beam::Flow* flow) {
        int end = 0;
        if (!state_.broken[e] && structure_->elements()[e].fracture >= 0 && breaks(e, flow, end)) to_break_.push_back({e, end});
    };
    auto flowing = yielding_.begin();  // both rise
    for (int e : fracture_candidates_) {
        for (; flowing != yielding_.end() && flowing->element < e; ++flowing) look(flowing->element, &flowing->flow);
        const bool flows = flowing != yielding_.end() && flowing->element == e;
        look(e, flows ? &flowing->flow : nullptr);
        flowing += flows;
    }
    for (; flowing != yielding_.end(); ++flowing) look(flowing->element, &flowing->flow);
    for (std::size_t rule = 0; rule < structure_->model().fracture().size(); ++rule)
        if (structure_->model().fracture()[rule].batch) ask_batch(int(rule));
}

/// The section that flows, else the one nearer to it.
int Dynamics::weaker_end(int index, const beam::Flow* flow) const {
    const Element& e = structure_->elements()[index];
    const Vec6& p = force_[index];
    const double f1 = beam::yield_function(p, -1, e.yield), f2 = beam::yield_function(p, 1, e.yield);
    const double m1 = p[0] * p[0] + p[2] * p[2], m2 = p[1] * p[1] + p[3] * p[3];
    if (flow && !structure_->conventional() && flow->lambda[0] != flow->lambda[1]) return flow->lambda[0] > flow->lambda[1] ? 1 : 2;
    return f1 > f2 || (f1 == f2 && m1 > m2) ? 1 : 2;
}

bool Dynamics::breaks(int index, const beam::Flow* flow, int& end) {
    const Element& e = structure_->elements()[index];
    const FractureRule& rule = structure_->model().fracture()[e.fracture];
    const Vec6 elastic = stiffness_now(*structure_, state_, index).solve(force_[index]);
    Vec6 plastic = state_.plastic[index];
    if (flow) plastic += flow->plastic;
    const beam::FractureStrains strains = beam::fracture_strains(elastic + plastic, e.length);
    if (beam::reached(strains, rule.curvature_x, rule.curvature_y, rule.axial_strain, rule.tension_only)) return end = weaker_end(index, flow), true;
    if (!rule.hook) return false;
    const bool news = rule.where == Where::plastic && strained_as_never(index, strains);
    if (rule.where == Where::plastic && !flow && !news && !e.yield.elastic()) return false;
    end = weaker_end(index, flow);
    for (int side : {end, 3 - end}) {
        const bool flows = flow && (structure_->conventional() ? side == end : flow->lambda[side - 1] > 0);
        const int bit = structure_->conventional() ? hinge_at_middle : side == 1 ? hinge_at_1 : hinge_at_2;
        const bool asked = flows || e.yield.elastic() || rule.where == Where::all || ((rule.where == Where::yielded || news) && state_.yielded[index] & bit);
        if (!asked) continue;
        const bool last = news && !flow;  // the other end is strained alike
        SectionView view = view_of(index, side, elastic, plastic, flow);
        view.plastic = flows;
        bool breaks = false;
        with_kept(index, side, view, [&] { breaks = rule.hook(view); });
        if (breaks) return end = side, true;
        if (last) break;
    }
    return false;
}

/// Whether a strain of the element is larger than ever before; then it is the one to compare with from now on.
bool Dynamics::strained_as_never(int index, const beam::FractureStrains& now) {
    double* most = &state_.strained[3 * std::size_t(index)];
    const double strain[3] = {std::abs(now.curvature_x), std::abs(now.curvature_y), std::abs(now.axial)};
    if (strain[0] <= most[0] && strain[1] <= most[1] && strain[2] <= most[2]) return false;
    kept_before_.push_back({most, std::vector<double>(most, most + 3)});
    for (int i = 0; i < 3; ++i) most[i] = std::max(most[i], strain[i]);
    return true;
}

SectionView Dynamics::view_of(int index, int side, const Vec6& elastic, const Vec6& plastic, const beam::Flow* flow) const {
    const Element& e = structure_->elements()[index];
    const Vec6 &p = force_[index], before = stiffness_now(*structure_, state_, index).solve(state_.force[index]) + state_.plastic[index];
    const beam::FractureStrains now = beam::fracture_strains(elastic + plastic, e.length), stays = beam::fracture_strains(plastic, e.length),
                                rate = beam::fracture_strains((elastic + plastic - before) / settings_.dt, e.length);
    const double r = side == 1 ? -1 : 1;
    SectionView v{};
    v.time = state_.time + settings_.dt, v.dt = settings_.dt, v.step = double(state_.step + 1);
    v.member = e.member, v.element = index, v.end = side, v.node = joint_at(*structure_, e, side);
    v.curvature_x = now.curvature_x, v.curvature_y = now.curvature_y, v.axial_strain = now.axial, v.twist = now.twist;
    v.plastic_curvature_x = stays.curvature_x, v.plastic_curvature_y = stays.curvature_y, v.plastic_axial_strain = stays.axial, v.plastic_twist = stays.twist;
    v.curvature_rate_x = rate.curvature_x, v.curvature_rate_y = rate.curvature_y, v.axial_strain_rate = rate.axial, v.twist_rate = rate.twist;
    v.Mx = beam::moment_at(p[0], p[1], r), v.My = beam::moment_at(p[2], p[3], r), v.N = p[4], v.Mz = p[5];
    v.f_y = beam::yield_function(p, r, e.yield);
    v.plastic_work = state_.plastic_work[index] + (flow ? flow->dissipation : 0);
    return v;
}

/// Calls `ask` with the numbers that the section's rule keeps; what a step that is taken back wrote there is taken back as well.
template <class Ask>
void Dynamics::with_kept(int index, int side, SectionView& view, Ask ask) {
    const FractureRule& rule = structure_->model().fracture()[structure_->elements()[index].fracture];
    if (!rule.keep.empty()) {
        view.kept = &state_.kept[(2 * std::size_t(index) + std::size_t(side) - 1) * kept_a_section_];
        kept_before_.push_back({view.kept, std::vector<double>(view.kept, view.kept + rule.keep.size())});
    }
    try {
        ask();
    } catch (const HookError& e) {
        throw HookError(std::string(e.what()) + " (fracture rule" + (rule.asked_at.empty() ? "" : " of " + rule.asked_at) + ", " + structure_->element_name(index) +
                        ", end " + std::to_string(side) + ")");
    }
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
    mutable std::vector<Strains> strains_[3];   ///< of each element, once asked for
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
        if (part == rate) d = stiffness_now(*run_.structure_, state, index).solve(run_.force_[index] - state.force[index]) / run_.settings_.dt;
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
                case SectionField::plastic_work: return run_.state_.plastic_work[index] + (flow ? flow->dissipation : 0);
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
                case SectionField::plastic: return flow && (run_.structure_->conventional() || flow->lambda[end - 1] > 0);
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
    try {
        declared.batch(Asked(*this, elements), places);
    } catch (const HookError& e) {
        throw HookError(std::string(e.what()) + " (fracture rule" + (declared.asked_at.empty() ? "" : " of " + declared.asked_at) + ", all its elements)");
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    Flows flows(yielding_);
    for (int place : places) {
        const int e = elements[place];
        const beam::Flow* flow = flows.of(e);
        const bool known = std::any_of(to_break_.begin(), to_break_.end(), [&](const Break& b) { return b.element == e; });
        if (!state_.broken[e] && !known) to_break_.push_back({e, weaker_end(e, flow)});
    }
    std::sort(to_break_.begin(), to_break_.end(), [](const Break& a, const Break& b) { return a.element < b.element; });
}

}  // namespace hinge

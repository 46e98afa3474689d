#include "section/potential_law.h"

#include <algorithm>

#include "section/flow_end.h"
#include "section/flow_return.h"

namespace hinge::beam {
namespace {

/// The screen of a section whose material weakens it before any flow.
YieldSurface screen_with(YieldSurface screen, const SectionMaterial& material) {
    double factor = 1;
    for (const auto& m : material.laws) factor *= m->initial();
    if (factor < 1)
        for (double* w : {&screen.x, &screen.y, &screen.n, &screen.z}) *w /= factor * factor;
    return screen;
}

}  // namespace

PotentialLaw::PotentialLaw(const YieldSurface& screen, const Vec4& strength, SectionMaterial material,
                           bool remembers_flow, int own_variables)
    : SectionLaw(screen_with(screen, material)),
      problem_(*this, strength, std::move(material), remembers_flow, own_variables) {}

std::string PotentialLaw::words() const {
    std::string text = name();
    for (const auto& m : problem_.material.laws) text += ", " + m->words();
    return text;
}

bool PotentialLaw::calls_script() const {
    const MaterialLaws& laws = problem_.material.laws;
    return std::any_of(laws.begin(), laws.end(), [](const auto& l) { return l->calls_script(); });
}

void PotentialLaw::start(bool end_of_member, double* history) const {
    for (const auto& m : problem_.material.laws) {
        m->start(end_of_member, history);
        history += m->history_size();
    }
}

ElementFlow PotentialLaw::return_alone(const Vec6& trial, const Stiffness& k, const SectionConditions& at,
                                       const ElementFlow& before) const {
    constexpr double ends[2] = {-1, 1};
    return find_flow(problem_, trial, k, ends, 2, at, &before);
}

ReturnMapResult PotentialLaw::return_to_surface(const Vec6& trial, const Stiffness& k, const double* sections, int n,
                                                const SectionConditions& at) const {
    ReturnMapResult out;
    static_cast<ElementFlow&>(out) = find_flow(problem_, trial, k, sections, n, at, nullptr);
    out.dissipation = out.p.dot(out.plastic) + work_of(*at.fixed_end, out, sections, n, at) + out.path_work;
    return out;
}

bool PotentialLaw::next_round(const ElementFlow& flow, const SectionConditions& at, double tolerance,
                              HeldRound& held) const {
    return beam::next_round(problem_, flow, at, tolerance, held);
}

bool PotentialLaw::return_together(const PairElastic& pair, const SectionConditions* at, double tolerance,
                                   ElementFlow (&flow)[2]) const {
    return beam::return_together(problem_, pair, at, tolerance, flow);
}

Mat6 PotentialLaw::tangent(const ElementFlow& flow, const Stiffness& k, const double* sections, int n,
                           const SectionConditions& at) const {
    return tangent_of_element(problem_, flow, k, sections, n, at);
}

Mat12 PotentialLaw::pair_tangent(const Mat12& elastic, const ElementFlow* const (&flow)[2],
                                 const SectionConditions* at) const {
    return tangent_of_pair(problem_, elastic, flow, at);
}

double PotentialLaw::work_of(const FixedEnd& part, const ElementFlow& flow, const double* sections, int n,
                             const SectionConditions&) const {
    double work = 0;
    for (int i = 0; i < n; ++i)
        if (flow.lambda[i] > 0) work += resultants(part.at(sections[i]), sections[i]).dot(flow.section[i]);
    return work;
}

void PotentialLaw::commit(const ElementFlow& flow, int section, double dt, double* history) const {
    const int flow_at = problem_.flow_at;
    if (!(flow.lambda[section] > 0)) {  // the other end alone flows
        if (flow_at >= 0) std::fill_n(history + flow_at, 4, 0.0);
        return;
    }
    const Vec4 e = problem_.normalised(flow.section[section]);
    const double strain = mean_strain(problem_, flow, section, history);
    for (const auto& m : problem_.material.laws) {
        m->commit(problem_.material.zone, e, strain, dt, history);
        history += m->history_size();
    }
    if (flow_at >= 0) std::copy_n(e.data(), 4, history);
}

double PotentialLaw::stored(const double* history) const {
    double sum = 0;
    for (const auto& m : problem_.material.laws) {
        sum += m->stored(problem_.material.zone, history);
        history += m->history_size();
    }
    return sum;
}

double PotentialLaw::softness(const double* history, const ElementFlow* flow, int section) const {
    double sum = 0;
    const Vec4 e = flow && flow->lambda[section] > 0 ? problem_.normalised(flow->section[section]) : Vec4(Vec4::Zero());
    for (const auto& m : problem_.material.laws) {
        sum += m->softness(problem_.material.zone, history, e);
        history += m->history_size();
    }
    return sum;
}

double PotentialLaw::yield_function(const Vec4& q, const double* history, double temperature) const {
    return shape_function(problem_.relative(q, history, {0, temperature}), problem_.own(history));
}

bool PotentialLaw::surely_elastic(const Vec6& p, const double* sections, int n, const SectionConditions& at) const {
    for (int i = 0; i < n; ++i) {
        const Vec4 q = resultants(p + at.fixed_end->at(sections[i]), sections[i]);
        const double* history = at.history_of(i, problem_.history_size);
        if (!surely_inside(problem_.relative(q, history, {at.dt, at.temperature}), problem_.own(history))) return false;
    }
    return true;
}

}  // namespace hinge::beam

#include "section/flow_problem.h"

namespace hinge::beam {

FlowProblem::FlowProblem(const PlasticWork& of, const Vec4& strength, SectionMaterial with, bool remembers_flow,
                         int own_variables)
    : work(of), per_strength(strength.cwiseInverse()), material(std::move(with)) {
    material.zone.per_strength = per_strength;
    for (const auto& m : material.laws) {
        history_size += m->history_size();
        moves_surface |= m->moves_surface();
        back_follows_strain |= m->back_follows_strain();
        back_follows_flow |= m->back_follows_flow();
        follows_rotation |= m->follows_rotation();
        follows_rate |= m->follows_rate();
        wears_stiffness |= m->wears_stiffness();
    }
    flow_at = remembers_flow ? history_size : -1;
    if (remembers_flow) history_size += 4;
    own_at = own_variables > 0 ? history_size : -1;
    history_size += own_variables;
}

WorkOfFlow FlowProblem::work_at(const Vec4& e, const double* own_variables) const {
    WorkOfFlow w;
    w.value = w.initial = work.potential(e, own_variables, w.q, w.curvature);
    return w;
}

MaterialLaw::Factor FlowProblem::factor_at(const double* history, double strain, const Moment& at) const {
    MaterialLaw::Factor f;
    for (const auto& m : material.laws) {
        const MaterialLaw::Factor own = m->factor(history, strain, at);
        f = {f.value * own.value, f.slope * own.value + f.value * own.slope};
        if (history) history += m->history_size();
    }
    return f;
}

double FlowProblem::mean_factor(const double* history, double strain, const Moment& at, bool of_work) const {
    double mean = 1, rate = 1;
    MaterialLaw::Integrals more;
    const double* own = history;
    for (const auto& m : material.laws) {
        if (m->follows_rate() && of_work) rate *= m->factor(own, strain, at).value;
        else if (m->follows_rate()) more = m->integrals(strain, at.dt);
        else mean *= m->mean_factor(own, strain, at);
        if (own) own += m->history_size();
    }
    if (of_work || more.zeroth == 0) return rate * mean;
    double start = 1, end = 1;  // beside a rate the other factors are linear in the strain
    for (const auto& m : material.laws) {
        if (!m->follows_rate()) start *= m->factor(history, 0, at).value, end *= m->factor(history, strain, at).value;
        if (history) history += m->history_size();
    }
    return mean + (start * more.zeroth + (end - start) / strain * more.first) / strain;
}

MaterialLaw::Turned FlowProblem::turned(const double* history, const Vec4& e, double done) const {
    MaterialLaw::Turned out;
    if (!follows_rotation) return out;
    for (const auto& m : material.laws) {
        if (m->follows_rotation()) {
            const MaterialLaw::Turned own = m->turned(material.zone, history, e, done);
            out = {out.factor * own.factor, out.slope * own.factor + out.factor * own.slope};
        }
        if (history) history += m->history_size();
    }
    return out;
}

double FlowProblem::mean_turned(const double* history, const Vec4& e, double done) const {
    double mean = 1;
    for (const auto& m : material.laws) {
        if (m->follows_rotation()) mean *= m->mean_turned(material.zone, history, e, done);
        if (history) history += m->history_size();
    }
    return mean;
}

void FlowProblem::add_back(const double* history, double strain, const Vec4& e, Vec4& back, Vec4& modulus) const {
    for (const auto& m : material.laws) {
        m->add_back(material.zone, history, strain, e, back, modulus);
        if (history) history += m->history_size();
    }
}

double FlowProblem::more_by_back(const double* history, double strain, const Vec4& e) const {
    double sum = 0;
    for (const auto& m : material.laws) {
        sum += m->more_by_back(material.zone, history, strain, e);
        if (history) history += m->history_size();
    }
    return sum;
}

Vec4 FlowProblem::relative(const Vec4& q, const double* history, const Moment& at) const {
    Vec4 of = q.cwiseProduct(per_strength);
    if (material.laws.empty()) return of;
    Vec4 back = Vec4::Zero(), hardens = Vec4::Zero();
    add_back(history, 0, Vec4::Zero(), back, hardens);
    return (of - back) / (factor_at(history, 0, at).value * turned(history, Vec4::Zero(), 0).factor);
}

Vec4 FlowProblem::normalised(const Vec4& flow) const {
    Vec4 e = flow.cwiseQuotient(per_strength);
    for (int c = 0; c < 4; ++c)
        if (per_strength[c] == 0) e[c] = 0;
    return e;
}

}  // namespace hinge::beam

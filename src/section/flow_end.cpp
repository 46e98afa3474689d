#include "section/flow_end.h"

namespace hinge::beam {

void harden(const FlowProblem& problem, const FlowingEnd& end, const Vec4& e, WorkOfFlow& w) {
    if (problem.keeps_strength()) return;
    const double energy = problem.material.zone.energy, D = w.initial, turned = end.turned.factor;
    const MaterialLaw::Factor own = problem.factor_at(end.history, D / energy, end.moment),
                              f = {turned * own.value, turned * own.slope};
    const Vec4 Ce = end.hardens.cwiseProduct(e);
    w.curvature = f.value * w.curvature + f.slope / energy * w.q * w.q.transpose();
    w.curvature.diagonal() += end.hardens;
    w.q = f.value * w.q + Ce;
    w.value = turned * D * problem.mean_factor(end.history, D / energy, end.moment, false) + 0.5 * e.dot(Ce);
}

FlowSoFar flow_so_far(const FlowProblem& problem, const ElementFlow& flow, int section, const double* history) {
    if (problem.keeps_strength() || !(flow.lambda[section] > 0)) return {};
    return {mean_strain(problem, flow, section, history), problem.normalised(flow.section[section])};
}

double mean_strain(const FlowProblem& problem, const ElementFlow& flow, int section, const double* history) {
    if (problem.keeps_strength() || !(flow.lambda[section] > 0)) return 0;
    Vec4 q;
    Mat4 curvature;
    return problem.work.potential(problem.normalised(flow.section[section]), problem.own(history), q, curvature) /
           problem.material.zone.energy;
}

FlowSoFar add_flow(const FlowProblem& problem, const FlowingEnd& end, int section, ElementFlow& out) {
    if (!end.flows()) return {};
    WorkOfFlow w = end.e == end.known_at ? end.known : problem.work_at(end.e, end.own);
    harden(problem, end, end.e, w);
    out.plastic += end.plastic();
    out.lambda[section] = 0.5 * w.initial;
    out.section[section] = problem.per_strength.cwiseProduct(end.e);
    if (end.own) out.path_work += problem.work.more_on_the_way(end.e, end.own, w.initial);
    if (problem.keeps_strength()) return {0, end.e};
    const double D = w.initial, strain = D / problem.material.zone.energy, beyond = w.value - w.q.dot(end.e);
    out.potential += beyond;
    out.path_work += beyond + D * (problem.turned(end.history, end.e, D).mean *
                                       problem.mean_factor(end.history, strain, end.moment, true) -
                                   end.turned.factor * problem.mean_factor(end.history, strain, end.moment, false));
    if (problem.back_follows_strain) out.path_work += problem.more_by_back(end.history, strain, end.e);
    return {strain, end.e};
}

bool is_beyond(const FlowProblem& problem, const FlowingEnd& end, const Vec4& q, Vec4& direction) {
    if (problem.keeps_strength()) return problem.work.outside(q, end.own, direction);
    return problem.work.outside(q / (end.turned.factor * problem.factor_at(end.history, 0, end.moment).value), end.own,
                                direction);
}

}  // namespace hinge::beam

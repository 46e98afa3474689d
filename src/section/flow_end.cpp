#include "section/flow_end.h"

namespace hinge::beam {
namespace {

/// The factor that follows the rotation times those of the work, after a flow of work D at the initial strength.
MaterialLaw::Factor factor_at(const FlowProblem& problem, const FlowingEnd& end, double D) {
    const MaterialLaw::Factor own = problem.factor_at(end.history, D / problem.material.zone.energy, end.moment);
    return {end.turned.factor * own.value, end.turned.factor * own.slope};
}

/// q and the curvature; `steeper`: a slope in addition to that of the factor `f`, over the work, 1/J.
void harden_forces(const FlowProblem& problem, const FlowingEnd& end, const MaterialLaw::Factor& f, double steeper,
                   const Vec4& Ce, WorkOfFlow& w) {
    w.curvature = f.value * w.curvature + (f.slope / problem.material.zone.energy + steeper) * w.q * w.q.transpose();
    w.curvature.diagonal() += end.hardens;
    w.q = f.value * w.q + Ce;
}

}  // namespace

void harden(const FlowProblem& problem, const FlowingEnd& end, const Vec4& e, WorkOfFlow& w) {
    if (problem.keeps_strength()) return;
    const double D = w.initial;
    const Vec4 Ce = end.hardens.cwiseProduct(e);
    harden_forces(problem, end, factor_at(problem, end, D), 0, Ce, w);
    w.value =
        end.turned.factor * D * problem.mean_factor(end.history, D / problem.material.zone.energy, end.moment, false) +
        0.5 * e.dot(Ce);
}

void harden_and_turn(const FlowProblem& problem, const FlowingEnd& end, const Vec4& e, WorkOfFlow& w) {
    if (problem.keeps_strength()) return;
    const MaterialLaw::Factor f = factor_at(problem, end, w.initial);
    harden_forces(problem, end, f, end.turned.slope * f.value / end.turned.factor, end.hardens.cwiseProduct(e), w);
}

MaterialLaw::Factor resistance_on_ray(const FlowProblem& problem, const FlowingEnd& end, double D, double t) {
    const MaterialLaw::Factor f = factor_at(problem, end, t * D);
    return {f.value * D, f.slope * D * D / problem.material.zone.energy};
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
    out.path_work += beyond + D * (problem.mean_turned(end.history, end.e, D) *
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

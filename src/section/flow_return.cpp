#include "section/flow_return.h"

#include <cmath>

#include "section/flow_search.h"

namespace hinge::beam {
namespace {

constexpr int most_rounds = 200;

/// Whether the back resultants that a round went by are those of the flow that it found.
bool back_is_found(const FlowProblem& problem, const FlowingEnd& end, const SectionConditions& at, int section,
                   const FlowSoFar& now, const Vec6& trial) {
    FlowingEnd again = end;
    again.by_loads = Vec4::Zero();
    again.set_history(at, section, problem, now);
    const Vec4 moved = again.hardens.cwiseProduct(now.e) - again.fixed;
    const Vec4 went_by = end.hardens.cwiseProduct(now.e) - (end.fixed - end.by_loads);
    return (moved - went_by).norm() <= flow_tolerance * (1 + end.carries(trial).norm());
}

/// One round: with what the round before has found, which `held` has. `converged`: null, or set to whether this round
/// has found the same, and then `held` is of the next round.
ElementFlow find_round(const FlowProblem& problem, const Vec6& trial, const Stiffness& k, const double* sections, int n,
                       const SectionConditions& at, const ElementFlow* before, HeldRound& held, bool* converged) {
    const double close = problem.back_follows_flow ? flow_tolerance : 10 * flow_tolerance;  // of factors
    const double energy = problem.material.zone.energy;
    ElementFlow out;
    out.p = trial;
    FlowingEnd ends[2];
    for (int i = 0; i < n; ++i) {
        const HeldRound::Section& of = held.of[i];
        ends[i] = FlowingEnd(sections[i], k, at, i, problem, {of.strain, of.e});
        if (!held.first && problem.follows_rotation) ends[i].turned.factor = of.factor;
    }
    out.converged = find_flow_of_ends(problem, trial, k, ends, n, before);
    out.evaluations = ends[0].evaluations + ends[1].evaluations;
    bool same = true;
    for (int i = 0; i < n; ++i) {
        const FlowSoFar now = add_flow(problem, ends[i], i, out);
        if (!converged || !problem.in_rounds()) continue;
        HeldRound::Section& of = held.of[i];
        const double elastic = (1 + ends[i].carries(trial).norm()) / (ends[i].k[2] * energy),
                     taken = ends[i].turned.factor,
                     found = problem.turned(ends[i].history, now.e, now.strain * energy).factor;
        same = same &&
               (!problem.back_follows_strain || std::abs(now.strain - of.strain) <= 10 * flow_tolerance * elastic) &&
               (!problem.back_follows_flow || back_is_found(problem, ends[i], at, i, now, trial)) &&
               std::abs(found - taken) <= close;
        of.factor = of.search.next(taken, found);
        of.strain = now.strain, of.e = now.e;
    }
    if (converged) *converged = same, held.first = false;
    if (out.flows()) out.p = trial - k.times(out.plastic);
    return out;
}

}  // namespace

/// Where back resultants follow the mean plastic strain, or the strength follows the rotation, those of the round
/// before are taken, until they change no more: a round leaves about H / E of the change before.
ElementFlow find_flow(const FlowProblem& problem, const Vec6& trial, const Stiffness& k, const double* sections, int n,
                      const SectionConditions& at, const ElementFlow* before) {
    HeldRound held;
    if (at.held) return held = *at.held, find_round(problem, trial, k, sections, n, at, before, held, nullptr);
    ElementFlow last;
    for (int round = 0; round < most_rounds; ++round) {
        bool converged = false;
        ElementFlow out = find_round(problem, trial, k, sections, n, at, round == 0 ? before : &last, held, &converged);
        out.evaluations += last.evaluations;
        if (!out.converged || converged) return out;
        last = out;
    }
    last.converged = false;
    return last;
}

bool next_round(const FlowProblem& problem, const ElementFlow& flow, const SectionConditions& at, double tolerance,
                HeldRound& held) {
    const auto differ = [&](double a, double b) { return !(std::abs(a - b) <= tolerance * std::abs(a)); };
    bool same = true;
    for (int i : {0, 1}) {
        HeldRound::Section& of = held.of[i];
        const double* history = at.history_of(i, problem.history_size);
        const FlowSoFar now = flow_so_far(problem, flow, i, history);
        const double energy = problem.material.zone.energy,
                     found = problem.turned(history, now.e, now.strain * energy).factor,
                     taken = held.first ? problem.turned(history, Vec4::Zero(), 0).factor : of.factor;
        if (differ(found, taken) || (problem.back_follows_strain && differ(now.strain, of.strain)) ||
            (problem.back_follows_flow && !((now.e - of.e).norm() <= tolerance * now.e.norm())))
            same = false;
        of.factor = of.search.next(taken, found);
        of.strain = now.strain, of.e = now.e;
    }
    held.first = false;
    return same;
}

}  // namespace hinge::beam

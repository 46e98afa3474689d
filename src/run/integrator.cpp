#include "run/integrator.h"

#include <algorithm>

#include "state/rotate.h"

namespace hinge {

void Integrator::move_to_rotated(int first, int end) {
    if (w_.structure.large()) return rotate_all(w_.rotation_step, w_.state.rotation, w_.trial.rotation, first, end);
    for (int i = first; i < end; ++i) w_.trial.small_rotation[i] = w_.state.small_rotation[i] + w_.rotation_step[i];
}

/// Forces that are not finite: of an element, at a node, or of a load.
Failure Integrator::find_culprit() const {
    for (std::size_t i = 0; i < w_.force.size(); ++i)
        if (!w_.state.broken[i] && !w_.force[i].allFinite())
            return {.cause = Cause::force_not_finite, .element = int(i)};
    for (std::size_t i = 0; i < w_.resisting.size(); ++i)
        if (!w_.resisting[i].allFinite()) return {.cause = Cause::force_not_finite, .node = int(i)};
    for (std::size_t i = 0; i < w_.external.size(); ++i)
        if (!w_.external[i].allFinite()) return {.cause = Cause::load_not_finite, .node = int(i)};
    const auto size = [&](std::size_t i) { return (w_.external[i] - w_.resisting[i]).cwiseAbs().maxCoeff(); };
    std::size_t most = 0;  // each is finite, what they add up to is not
    for (std::size_t i = 0; i < w_.resisting.size(); ++i)
        if (size(i) > size(most)) most = i;
    return {.cause = Cause::forces_unbounded, .node = int(most)};
}

Failure Integrator::failure_of(const SolverSettings& solver, const SolveReport& report) {
    if (solver.direct) return {.cause = Cause::not_factorised};
    if (report.indefinite) return weakest_part();
    if (report.iterations < solver.max_iterations) return {.cause = Cause::solution_not_finite};
    return {.cause = Cause::solver_not_converged, .count = report.iterations};
}

/// Where the effective stiffness is not positive definite, and what makes it so there.
Failure Integrator::weakest_part() {
    const EffectiveStiffness::Weakest weakest = effective()->weakest_part();
    Failure f{.cause = Cause::not_positive_definite, .node = weakest.node};
    if (weakest.node < 0) return f;
    const int e = f.element = weakest.element;
    f.other = weakest.other;
    if (e < 0) return f;
    f.yields =
        std::any_of(w_.yielding.begin(), w_.yielding.end(), [&](const PlasticIncrement& y) { return y.element == e; });
    f.value = std::max(0.0, -w_.force[e][4]);
    return f;
}

}  // namespace hinge

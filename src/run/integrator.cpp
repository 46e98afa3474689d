#include "run/integrator.h"

#include "core/text.h"
#include "state/rotate.h"

namespace hinge {

void Integrator::move_to_rotated(int first, int end) {
    if (w_.structure.large()) return rotate_all(w_.rotation_step, w_.state.rotation, w_.trial.rotation, first, end);
    for (int i = first; i < end; ++i) w_.trial.small_rotation[i] = w_.state.small_rotation[i] + w_.rotation_step[i];
}

std::string Integrator::name_the_culprit() const {
    const Structure& s = w_.structure;
    for (std::size_t i = 0; i < w_.force.size(); ++i)
        if (!w_.state.broken[i] && !w_.force[i].allFinite())
            return "the forces of " + s.element_name(int(i)) + " are not finite";
    for (std::size_t i = 0; i < w_.resisting.size(); ++i)
        if (!w_.resisting[i].allFinite()) return "the forces at " + s.node_name(int(i)) + " are not finite";
    for (std::size_t i = 0; i < w_.external.size(); ++i)
        if (!w_.external[i].allFinite()) return "the load on " + s.node_name(int(i)) + " is not finite";
    const auto size = [&](std::size_t i) { return (w_.external[i] - w_.resisting[i]).cwiseAbs().maxCoeff(); };
    std::size_t most = 0;  // each is finite, what they add up to is not
    for (std::size_t i = 0; i < w_.resisting.size(); ++i)
        if (size(i) > size(most)) most = i;
    return "the forces at " + s.node_name(int(most)) + " grow without bound";
}

void Integrator::fail_to_solve(Step& step, const SolverSettings& solver, const SolveReport& report) {
    step.failure = solver.direct
                       ? "the effective stiffness could not be factorised"
                       : "conjugate gradients did not converge in " + count_text(report.iterations, "iteration");
    remedy = solver.direct ? nullptr : "solver = 'direct', more solver_iterations";
}

}  // namespace hinge

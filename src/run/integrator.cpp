#include "run/integrator.h"

#include <algorithm>

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
    remedy = nullptr;
    if (solver.direct) {
        step.failure = "the effective stiffness could not be factorised";
    } else if (report.indefinite) {
        step.failure = "the effective stiffness is not positive definite" + weakest_part();
        remedy = "solver = 'direct'";
    } else if (report.iterations < solver.max_iterations) {
        step.failure = "the solution for the accelerations is not finite";
    } else {
        step.failure = "conjugate gradients did not converge in " + count_text(report.iterations, "iteration");
        remedy = "solver = 'direct', more solver_iterations";
    }
}

/// Where the effective stiffness is not positive definite, and what makes it so there.
std::string Integrator::weakest_part() {
    const Structure& s = w_.structure;
    const EffectiveStiffness::Weakest weakest = effective()->weakest_part();
    if (weakest.node < 0) return {};
    const std::string at = " at " + s.node_name(weakest.node) + ": ";
    if (weakest.element < 0) {
        return at + "what effects add to the stiffness " +
               (weakest.other < 0 ? std::string("there") : "between it and " + s.node_name(weakest.other)) +
               " is negative for the motion that is solved for";
    }
    const int e = weakest.element;
    std::string why;
    if (std::any_of(w_.yielding.begin(), w_.yielding.end(), [&](const PlasticIncrement& y) { return y.element == e; }))
        why = ", which yields,";
    else if (const double N = w_.force[e][4]; N < 0) why = ", under a compression of " + number_text(-N, 3) + " N,";
    return at + s.element_name(e) + why + " has a negative stiffness for the motion that is solved for";
}

}  // namespace hinge

#include "effects/effect.h"

#include <cmath>

#include "state/hinges.h"

namespace hinge {

double ImpulseResponse::factor_for(double work) const {
    const double root = linear * linear + 4 * square * work;
    if (!(root >= 0 && square > 0)) return 1;
    const double far = -0.5 * (linear + std::copysign(std::sqrt(root), linear)) / square,
                 near = far != 0 ? -work / square / far : 1;
    const double exact = std::abs(far - 1) < std::abs(near - 1) ? far : near;
    return std::abs(exact - 1) < 0.5 ? exact : 1;
}

double Effect::work_on_flow(const PlasticIncrement& of, const beam::FixedEnd& part) const {
    double section[2];
    const int n = w_.assembly.sections(section);
    return law_now(w_.structure.elements()[of.element], heat_of(w_.trial.heat, of.element))
        ->work_of(part, of.flow, section, n, w_.assembly.conditions(w_.state, of.element));
}

void add_to_trial(Workspace& w, double x, const ImpulseResponse& response) {
    ++w.impulses;
    w.state.accumulated["work"] += x * response.by_supports;
    for (std::size_t i = 0; i < response.change.size(); ++i) w.trial.velocity[i] += x * response.change[i];
}

}  // namespace hinge

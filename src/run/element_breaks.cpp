#include "run/element_breaks.h"

#include <cmath>

#include "run/effect_forces.h"
#include "state/breaking.h"

namespace hinge {

bool ElementBreaks::apply(const std::vector<Break>& breaks) {
    std::vector<Reached> broken;
    for (const Break& b : breaks) broken.push_back({b.element, "broken"});
    host_.reached(broken);
    std::vector<Vec6> impulse(w_.resisting.size(), Vec6::Zero());
    for (const Break& b : breaks) {
        for (const auto& listener : effects_.break_listeners) listener->breaks(b, impulse);
        integrator_->removed(b.element);
        const std::vector<std::uint8_t> held = w_.state.held;
        for (const auto& listener : effects_.break_listeners) listener->broke(b);
        if (EffectiveStiffness* effective = integrator_->effective(); effective && held != w_.state.held)
            effective->set_held(w_.state.held);
        w_.assembly.deactivate(b.element);
    }
    if (w_.points_moved) read_active(w_);
    if (w_.constraints) rebuild_constraints();
    Mass& mass = mass_.renewed(w_.state);
    const double before = forces_.work_of_supports(w_.state.velocity, w_.state.velocity);
    const bool solved = !std::isnan(pass_on(w_.state, mass, impulse));
    w_.state.accumulated["work"] += forces_.work_of_supports(w_.state.velocity, w_.state.velocity) - before;
    for (const auto& listener : effects_.break_listeners) listener->all_broke();
    return solved;
}

void ElementBreaks::rebuild_constraints() {
    constraints_due = false;
    for (const std::vector<int>& group : w_.constraints->reduction().groups())
        for (const int n : group)
            for (const int e : w_.structure.elements_at(n)) mass_.changed(e);
    w_.constraints->rebuild();
    if (EffectiveStiffness* effective = integrator_->effective()) effective->set_held(w_.state.held);
}

}  // namespace hinge

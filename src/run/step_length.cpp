#include "run/step_length.h"

#include <algorithm>
#include <cmath>

#include "algebra/stable_step.h"
#include "core/built.h"
#include "core/errors.h"
#include "effects/all_effects.h"
#include "state/nodes.h"

namespace hinge {
namespace {

constexpr double much_flow = 4;        ///< times an abrupt change of the motion: of plastic work in a step
constexpr double most_rotation = 0.5;  ///< rad: of a node in a step, with step control
constexpr double most_phase = 0.9;     ///< rad: of what effects join nodes by, in a step of dt = "auto" (Newmark)
constexpr double crushed_part = 0.05;  ///< of its length, to which an element is pressed flat

/// Whether step control acts in this scene by default, whatever its dt.
bool calls_for_control(const Structure& structure, const EffectList& effects) {
    return (built::plasticity && structure.can_yield()) || effects.any(&EffectTraits::forces_vanish);
}

}  // namespace

DynamicSettings fitted_to_effects(DynamicSettings s, const Workspace& w, const EffectList& effects) {
    if (s.controlled_by_default && !s.automatic && !calls_for_control(w.structure, effects)) s.step_control = 0;
    Blocks stiffness, damping(1, false);
    for (const auto& limiter : effects.step_limiters) limiter->add_stiffest(stiffness), limiter->add_stiffest(damping);
    const bool none =
        stiffness.pairs.empty() && stiffness.nodes.empty() && damping.pairs.empty() && damping.nodes.empty();
    if (none || !(s.explicit_steps() || s.automatic)) return s;
    const JoinedStep limit =
        s.explicit_steps() ? stable_step_of_joined(w.structure, w.state, damping_of(w.structure), stiffness, damping)
                           : JoinedStep{most_phase / std::sqrt(fastest_of_joined(w.structure, w.state, stiffness)), -1};
    if (s.chosen) {
        const double wanted = s.explicit_steps() ? usual_step({limit.dt, -1}, w.structure) : limit.dt;
        if (wanted < s.dt) s.dt = s.duration / std::ceil(s.duration / wanted);
    } else if (s.explicit_steps() && s.dt > limit.dt) {
        char text[120];
        std::snprintf(text, sizeof text, "model:dynamic: dt = %.6g s; explicit steps stay stable up to %.6g s (", s.dt,
                      limit.dt);
        throw InputError(text + std::string("with what panels, springs, dashpots and contact add at ") +
                         w.structure.node_name(limit.node) +
                         "); give a shorter one, dt = 'auto', or integrator = 'newmark'");
    }
    return s;
}

Failure find_crushed(const Structure& structure, const State& state) {
    Failure flat{.value = crushed_part};
    for (int i = 0; structure.large() && i < int(structure.elements().size()); ++i) {
        const Element& e = structure.elements()[i];
        const double part = chord_of(e, state.displacement).norm() / e.length;
        if (!state.broken[i] && part < flat.value) flat.value = part, flat.element = i;
    }
    return flat;
}

StepLength::StepLength(const DynamicSettings& s, const Workspace& w)
    : w_(w),
      automatic_(s.automatic),
      controls_(s.controlled()),
      size_(s.dt, s.duration, s.automatic, s.controlled(), w.state.time),
      control_(s.step_control, s.controlled_by_default),
      begun_(s.automatic || !s.controlled_by_default || (built::plasticity && w.structure.can_yield())) {
    if (!control_.by_default()) return;
    lumped_.assign(w.structure.position().size(), 0);
    for (const Element& e : w.structure.elements())
        for (int n : e.node) lumped_[n] += 0.5 * e.mass();
}

long StepLength::next(const EffectList& effects, bool calm, double jump) {
    if (!size_.varies()) return size_.length();
    const auto is_calm = [&] {
        const auto& list = effects.step_limiters;
        return calm && std::all_of(list.begin(), list.end(), [](const auto& l) { return l->allows_long_step(); });
    };
    const auto changes = [&] {
        double after[StepSize::long_step];
        for (long i = 0; i < StepSize::long_step; ++i) after[i] = double(i + 1) * size_.own();
        const auto& list = effects.step_limiters;
        return std::any_of(list.begin(), list.end(),
                           [&](const auto& l) { return l->changes_within(w_.state.time, after); });
    };
    return size_.next(automatic_ && is_calm(), jump, changes);
}

/// The kinetic energy of the nodes where the step is tried to end, with half of each element's mass on either node: it
/// costs next to nothing, and is near enough to see a jump.
double StepLength::motion_of_trial() const {
    const double* mass = lumped_.data();
    const Vec6* v = w_.trial.velocity.data();
    return w_.pool.sum(int(lumped_.size()), some_nodes, [mass, v](int first, int end) {
        double sum = 0;
        for (int i = first; i < end; ++i) sum += 0.5 * mass[i] * v[i].head<3>().squaredNorm();
        return sum;
    });
}

/// Whether the motion changes so much in the step that is tried that it may hide a loss: its kinetic energy differs
/// from what the two steps before lead to, or much flows in hinges.
bool StepLength::is_abrupt(double largest) {
    motion_ = motion_of_trial();
    const double limit = control_.abrupt() * largest;
    const double expected = motions_.size() < 2 ? motion_ : 2 * motions_[0] - motions_[1];
    double flow = 0;
    for (const PlasticIncrement& y : w_.yielding) flow += std::abs(y.flow.dissipation);
    return !(std::abs(motion_ - expected) <= limit && flow <= much_flow * limit);
}

Failure StepLength::rotation_too_large() const {
    for (std::size_t i = 0; w_.structure.large() && i < w_.rotation_step.size(); ++i)
        if (const double angle = w_.rotation_step[i].norm(); !(angle <= most_rotation))
            return {.cause = Cause::rotation_too_large, .node = int(i), .value = angle, .limit = most_rotation};
    return {};
}

double StepLength::commit(double begin, double dt) {
    size_.count_step();
    if (control_.by_default() && begun_) motions_.insert(motions_.begin(), motion_), motions_.resize(2, motion_);
    return automatic_ || (control_.on() && !control_.by_default()) ? size_.end() : begin + dt;
}

}  // namespace hinge

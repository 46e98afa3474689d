#include "run/automatic_step.h"

#include <algorithm>
#include <cmath>

#include "effects/all_effects.h"
#include "run/step_size.h"

namespace hinge {
namespace {

/// Times by which dt = "auto" is shorter than a twelfth of a wave's time for one solution a step to be safe from
/// hinges. Beyond it steps are that twelfth, and Newton's method solves them (newmark.cpp). A blow, a swing and a pull
/// on round bars, 2 and 8 elements, yielding: four short steps take the time of one with Newton's method at 3 to 6
/// times.
constexpr double most_shortened = 4;

/// Part of the stable step that dt = "auto" may take at most, for rounding and for what effects add.
constexpr double close_to_limit = 0.98;

}  // namespace

double shortest_step(const Structure& structure, double duration) {
    double courant = 0;                            // largest axial Courant number of a step of 1 s
    for (const Element& e : structure.elements())  // no wave runs along one without mass
        if (e.mass() > 0) courant = std::max(courant, std::sqrt(e.rigidity.EA / e.rigidity.rhoA) / e.length);
    const double wave = 12 * courant, hinges = axial_courant_number(structure, 1) / 0.9;
    return duration / std::ceil(duration * (hinges > most_shortened * wave ? wave : std::max(wave, hinges)));
}

double usual_step(const StableStep& limit, const Structure& structure) {
    double part = structure.can_yield() ? 0.45 : 0.9;
    for (const EffectKind& kind : all_effects())
        if (kind.part_of_stable_step) part = std::min(part, kind.part_of_stable_step(structure.model()));
    return part * limit.dt;
}

StableStep explicit_limit(const Structure& structure, bool breaks) {
    return stable_step(structure, damping_of(structure), breaks);
}

double explicit_step(const Structure& structure, double duration, bool breaks) {
    const StableStep limit = explicit_limit(structure, breaks);
    const double usual = usual_step(breaks ? explicit_limit(structure, false) : limit, structure);
    return duration / std::ceil(duration / std::min(usual, close_to_limit * limit.dt));
}

}  // namespace hinge

#include "record/probe.h"

#include "core/rotation.h"
#include "run/run.h"

namespace hinge {
namespace {

/// How a node has rotated against another, as a rotation vector in space.
double relative_rotation(const Run& run, const Probe& p) {
    const State& state = run.state();
    if (!run.structure().large())
        return (state.small_rotation[p.node] - state.small_rotation[p.relative_to])[p.component - 3];
    return rotation_vector(state.rotation[p.node] * state.rotation[p.relative_to].conjugate())[p.component - 3];
}

}  // namespace

double value_of(const Run& run, const Probe& p) {
    if (p.relative_to >= 0) {
        if (p.quantity == Probe::Quantity::displacement && p.component >= 3) return relative_rotation(run, p);
        const auto of = [&](int node) { return value_of(run, Probe{node, p.quantity, p.component, {}, {}, {}}); };
        const double difference = of(p.node) - of(p.relative_to);
        return p.height > 0 ? difference / p.height : difference;
    }
    switch (p.quantity) {
        case Probe::Quantity::velocity: return run.state().velocity[p.node][p.component];
        case Probe::Quantity::acceleration: return run.state().acceleration[p.node][p.component];
        case Probe::Quantity::reaction: return run.reaction(p.node)[p.component];
        default:
            return p.component < 3 ? run.state().displacement[p.node][p.component]
                                   : run.displacement(p.node)[p.component];
    }
}

double abscissa(const Run& run) { return run.is_static() ? run.state().factor : run.state().time; }

const char* unit_of(const Probe& p) {
    const bool turns = p.component >= 3;
    if (p.height > 0) return "";  // a drift
    switch (p.quantity) {
        case Probe::Quantity::velocity: return turns ? "rad/s" : "m/s";
        case Probe::Quantity::acceleration: return turns ? "rad/s^2" : "m/s^2";
        case Probe::Quantity::reaction: return turns ? "N m" : "N";
        default: return turns ? "rad" : "m";
    }
}

const std::vector<std::string>& node_quantities() {
    static const std::vector<std::string> names = {"ux",  "uy",  "uz",  "rx",  "ry", "rz", "vx", "vy",
                                                   "vz",  "vrx", "vry", "vrz", "ax", "ay", "az", "arx",
                                                   "ary", "arz", "fx",  "fy",  "fz", "mx", "my", "mz"};
    return names;
}

}  // namespace hinge

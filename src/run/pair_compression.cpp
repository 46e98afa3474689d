#include "run/pair_compression.h"

#include <numbers>

#include "beam/beam_column.h"
#include "state/configuration.h"
#include "state/hinges.h"

namespace hinge {

PairCompression pair_compression(const Structure& structure, const State& state, const std::vector<Vec6>& force,
                                 int first) {
    constexpr double clamped = std::numbers::pi * std::numbers::pi;  // p'
    const Element& e = structure.elements()[first];
    if (e.partner != first + 1 || state.broken[first] || state.broken[first + 1] || structure.conventional()) return {};
    const double N = -0.5 * (force[first][4] + force[first + 1][4]);
    const beam::PairKind<double> k = pair_kind_of(e, heat_of(state.heat, first));
    const auto part = [&](int plane) { return N * k.c[plane] * (1 + clamped * k.shear[plane].flexible) / clamped; };
    return {N, {part(0), part(1)}};
}

}  // namespace hinge

#include "run/linear_solution.h"

#include <cmath>
#include <numbers>

#include "algebra/modes.h"
#include "core/errors.h"
#include "effects/all_effects.h"
#include "state/bodies.h"

namespace hinge {

LinearSolution solve_linearly(const Model& model, std::vector<std::uint8_t> held) {
    auto linear = std::make_shared<Model>(model);
    linear->lock(false);
    for (const char* effect : {"large displacement", "plasticity", "fracture", "contact"}) leave_out(effect, *linear);
    make_linear(*linear);
    const auto structure = std::make_shared<const Structure>(linear);
    const State start = initial_state(*structure);
    StaticSettings settings;
    settings.steps = 1;
    settings.held = std::move(held);
    settings.held.resize(start.displacement.size(), 0);
    LinearSolution s{nullptr, std::vector<char>(start.displacement.size(), 1)};
    try {
        s.run = std::make_unique<Statics>(structure, start, settings);
    } catch (const InputError&) {
        for (const std::vector<int>& body : nodes_of(find_bodies(*structure, start)))
            if (!free_motions(*structure, body).empty())
                for (int n : body) settings.held[n] = 63, s.solved[n] = 0;
        try {
            s.run = std::make_unique<Statics>(structure, start, settings);
        } catch (const InputError&) { return {}; }  // a mechanism, which hinge check and statics name
    }
    s.run->advance();
    if (s.run->verdict() != Verdict::completed) return {};
    return s;
}

double euler_load(const beam::Rigidity& r, double length) {
    return std::pow(std::numbers::pi / length, 2) * std::min(r.EIx, r.EIy);
}

}  // namespace hinge

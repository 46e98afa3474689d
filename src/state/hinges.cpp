#include "state/hinges.h"

#include <algorithm>

namespace hinge {

namespace {

/// Springs after the step with `flow`, or where the state is.
beam::EndSprings springs_after(const Structure& structure, const State& state, int element, const ElementHeat& heat,
                               const beam::ElementFlow* flow) {
    const Element& e = structure.elements()[element];
    beam::EndSprings out;
    if (!e.law || !e.law->wears_stiffness()) return out;
    const double* history = history_of(structure, state, element);
    const double whole = e.length * structure.model().members()[e.member].elements;
    for (int i : {0, 1}) {
        const double softness = e.law->softness(history + i * e.law->history_size(), flow, i) / heat.stiffness;
        out.x[i] = softness * whole / (6 * e.rigidity.EIx), out.y[i] = softness * whole / (6 * e.rigidity.EIy);
    }
    return out;
}

}  // namespace

beam::EndSprings springs_of(const Structure& structure, const State& state, int element, const ElementHeat& heat) {
    return springs_after(structure, state, element, heat, nullptr);
}

Softening softening_of(const Structure& structure, const State& state, const PlasticIncrement& y,
                       const ElementHeat& heat) {
    Softening out;
    if (!structure.wears_stiffness()) return out;
    const Vec6 growth = springs_after(structure, state, y.element, heat, &y.flow).compliance() -
                        springs_of(structure, state, y.element, heat).compliance();
    out.turned = growth.cwiseProduct(y.flow.p);
    out.stored = 0.5 * out.turned.dot(y.flow.p);
    return out;
}

void move_point(const Structure& structure, State& state, int element, double s) {
    const Element& e = structure.elements()[element];
    const ElementHeat& heat = heat_of(state.heat, element);
    const Vec6& p = state.force[element];
    const beam::Stiffness after = heat.stiffness * beam::stiffness(e.rigidity, e.length, s);
    state.plastic[element] += stiffness_now(structure, state, element).solve(p) -
                              in_series(after, springs_of(structure, state, element, heat)).solve(p);
    state.point[element] = s;
}

namespace {

/// What its plastic deformation leaves of each element's deformation.
void elastic_deformations(const Structure& structure, const State& state, const Configuration& pose, int first,
                          const ElementFrame* place, Vec6 (&d)[2]) {
    for (int i : {0, 1}) {
        const Vec6 whole = place ? element_deformation(structure, first + i, pose, place[i])
                                 : element_deformation(structure, first + i, pose);
        d[i] = whole - state.plastic[first + i];
    }
}

}  // namespace

beam::PairMatrix pair_tangent(const Structure& structure, const State& state, const Configuration& pose,
                              const ElementAssembly& assembly, int first,
                              const beam::ReturnMapResult* const (&flow)[2]) {
    const ElementHeat& heat = heat_of(pose.heat, first);
    Vec6 elastic[2];
    elastic_deformations(structure, state, pose, first, nullptr, elastic);
    for (int i : {0, 1})
        if (flow[i]) elastic[i] -= flow[i]->plastic;
    const beam::SectionConditions at[2] = {assembly.conditions(state, first), assembly.conditions(state, first + 1)};
    const beam::ElementFlow* flows[2] = {flow[0], flow[1]};
    return beam::pair_tangent(elastic_pair(structure, state, first, heat), elastic,
                              *law_now(structure.elements()[first], heat), flows, at);
}

beam::PairMatrix elastic_pair_tangent(const Structure& structure, const State& state, const Configuration& pose,
                                      int first, const ElementFrame* place) {
    Vec6 d[2];
    elastic_deformations(structure, state, pose, first, place, d);
    const ElementHeat& heat = heat_of(pose.heat, first);
    const beam::ElasticPair pair = elastic_pair(structure, state, first, heat);
    beam::PairMatrix K = pair.stiffness_beyond(d[0], d[1]);
    for (int i : {0, 1}) K.block<6, 6>(6 * i, 6 * i) += pair.of[i].matrix();
    return K;
}

std::vector<int> commit_flow(const Structure& structure, State& state, const std::vector<PlasticIncrement>& yielding,
                             double dt, std::vector<int>& flowing) {
    const std::vector<int> before = flowing;
    for (int e : before) state.hinge[e] = 0;
    flowing.clear();
    for (const PlasticIncrement& y : yielding) {
        state.plastic[y.element] += y.flow.plastic;
        state.plastic_work[y.element] += y.flow.dissipation;
        if (structure.wears_stiffness()) {
            const Softening soft = softening_of(structure, state, y, heat_of(state.heat, y.element));
            state.plastic[y.element] -= soft.turned;
            state.plastic_work[y.element] -= soft.stored;
            state.accumulated["plastic"] -= soft.stored;
        }
        const beam::SectionLaw& law = *structure.elements()[y.element].law;
        if (const int size = law.history_size(); size > 0)
            for (int i = 0, n = structure.conventional() ? 1 : 2; i < n; ++i)
                law.commit(y.flow, i, dt, &state.history[structure.history_at(y.element) + i * size]);
        std::uint8_t bits = y.flow.yields() ? hinge_at_middle : 0;
        if (!structure.conventional())
            bits = std::uint8_t((y.flow.lambda[0] > 0) * hinge_at_1 + (y.flow.lambda[1] > 0) * hinge_at_2);
        state.hinge[y.element] = bits;
        state.yielded[y.element] |= bits;
        flowing.push_back(y.element);
    }
    std::vector<int> moved;
    if (structure.model().options().shift != Shift::elastic_and_plastic || structure.conventional()) return moved;
    const auto wanted = [&](int index) {
        const Element& e = structure.elements()[index];
        if (const std::uint8_t bits = state.hinge[index]) return bits & hinge_at_1 ? 1.0 : -1.0;  // eqs 6a-b: s = -r
        const bool partner_flows = e.partner >= 0 && state.hinge[e.partner] && !state.broken[e.partner];
        return partner_flows && structure.model().options().formulation == Formulation::asi_gauss ? 0.0 : e.s;
    };
    std::vector<int> look = before;
    look.insert(look.end(), flowing.begin(), flowing.end());
    for (std::size_t i = 0, n = look.size(); i < n; ++i)
        if (const int partner = structure.elements()[look[i]].partner; partner >= 0) look.push_back(partner);
    std::sort(look.begin(), look.end());
    look.erase(std::unique(look.begin(), look.end()), look.end());
    for (int e : look)
        if (const double s = wanted(e); !state.broken[e] && s != state.point[e]) {
            move_point(structure, state, e, s);
            moved.push_back(e);
        }
    return moved;
}

}  // namespace hinge

// Stages of the assembly that few elements need: loads between the nodes, heat, ends that have lost stiffness, and the
// return of pairs to the yield surface. They are apart from assembly_stages.cpp, so that they stay out of its loops.
#include "beam/pair_return.h"
#include "state/element_block.h"
#include "state/hinges.h"

namespace hinge {

/// f_y at each section anew, of the eight elements from `element` on, with what loads between the nodes do there.
[[gnu::noinline]] void ElementAssembly::add_fixed_ends(int element, const Kind& kind, const Lanes (&p)[6],
                                                       Lanes (&f)[2]) const {
    static_assert(sizeof(beam::FixedEnd) == 8 * sizeof(double));
    Lanes fixed[lane_count];
    transpose_rows<8>(fixed_ends_[element].moment, std::min(lane_count, int(fixed_ends_.size()) - element), fixed);
    double section[2];
    const int section_count = sections(section);
    for (int s = 0; s < section_count; ++s) {
        const double n1 = (1 - section[s]) / 2, n2 = (1 + section[s]) / 2;
        const Lanes mx = n2 * (p[1] + fixed[1]) - n1 * (p[0] + fixed[0]),
                    my = n2 * (p[3] + fixed[3]) - n1 * (p[2] + fixed[2]), n = p[4] + n1 * fixed[4] + n2 * fixed[5],
                    mz = p[5] + n1 * fixed[6] + n2 * fixed[7];
        f[s] = kind.yield[0] * mx * mx + kind.yield[1] * my * my + kind.yield[2] * n * n + kind.yield[3] * mz * mz;
    }
}

/// What heat makes of the deformation of the eight elements without force.
[[gnu::noinline]] void ElementAssembly::take_off_heat(int element, const ElementHeats& heats, Lanes (&d)[6]) {
    for (int i = 0; i < std::min(lane_count, int(heats.size()) - element); ++i) {
        const Vec6 of_heat = heats[std::size_t(element + i)].deformation();
        for (int c = 0; c < 6; ++c) d[c][i] -= of_heat[c];
    }
}

/// Forces of those of the eight elements whose ends have lost stiffness.
[[gnu::noinline]] void ElementAssembly::add_springs(const Block& b, int element, const State& state,
                                                    const Lanes (&d)[6], Lanes (&p)[6]) const {
    const auto deformation = [&](int i) { return Vec6(d[0][i], d[1][i], d[2][i], d[3][i], d[4][i], d[5][i]); };
    const auto set = [&](int i, const Vec6& force) {
        for (int c = 0; c < 6; ++c) p[c][i] = force[c];
    };
    for (int i = 0; i < lane_count; ++i) {
        if (!(b.whole >> i & 1)) continue;
        const Element& e = structure_.elements()[element + i];
        if (structure_.p_delta() && e.forms_pairs && b.whole >> (i ^ 1) & 1) {
            const beam::ElasticPair pair = elastic_pair(structure_, state, element + i, no_heat);
            if (pair.has_springs()) {
                const Vec6 of[2] = {deformation(i), deformation(i + 1)};
                const Vec12 beyond = pair.forces_beyond(of[0], of[1]);
                for (int j : {0, 1}) set(i + j, pair.of[j].times(of[j]) + beyond.segment<6>(6 * j));
            }
            ++i;
        } else if (const beam::EndSprings springs = springs_of(structure_, state, element + i); springs.any()) {
            set(i, in_series(declared_stiffness(structure_, state, element + i), springs).times(deformation(i)));
        }
    }
}

/// Their forces by the stiffness that heat leaves.
[[gnu::noinline]] void ElementAssembly::soften(int element, const ElementHeats& heats, Lanes (&p)[6]) {
    for (int i = 0; i < std::min(lane_count, int(heats.size()) - element); ++i)
        for (int c = 0; c < 6; ++c) p[c][i] *= heats[std::size_t(element + i)].stiffness;
}

/// f_y by the strength that heat leaves.
[[gnu::noinline]] void ElementAssembly::weaken(int element, const ElementHeats& heats, Lanes (&f)[2]) {
    for (int i = 0; i < std::min(lane_count, int(heats.size()) - element); ++i) {
        const double strength = heats[std::size_t(element + i)].strength;
        for (Lanes& of_section : f) of_section[i] /= strength * strength;
    }
}

/// Whether the law of lane i tells quickly that its sections stay elastic.
bool ElementAssembly::no_section_flows(int element, int i, const State& state, const ElementHeats& heat,
                                       const Lanes (&p)[6]) const {
    double section[2];
    const int section_count = sections(section);
    Vec6 trial;
    for (int c = 0; c < 6; ++c) trial[c] = p[c][i];
    return law_now(structure_.elements()[element + i], heat_of(heat, element + i))
        ->surely_elastic(trial, section, section_count, conditions(state, element + i));
}

/// The return to the yield surface of a pair, the first of which is lane i.
[[gnu::noinline]] void ElementAssembly::return_pair(int element, int i, const Kind& kind, const State& state,
                                                    const ElementHeats& heats, const Lanes (&d)[6], Lanes (&p)[6],
                                                    Found& found) const {
    const ElementHeat& heat = heat_of(heats, element + i);
    const Element& e = structure_.elements()[element + i];
    beam::ElasticPair pair = {pair_kind_of(e, heat), {}};
    Vec6 elastic[2];
    for (int j : {0, 1}) {
        const int at = i + j;
        pair.of[j] = heat.stiffness * kind.stiffness(at);
        if (kind.wears_stiffness) pair.springs[j] = springs_of(structure_, state, element + at, heat);
        for (int c = 0; c < 6; ++c) elastic[j][c] = d[c][at];
    }
    beam::ReturnMapResult flow[2];
    const beam::SectionConditions at[2] = {conditions(state, element + i), conditions(state, element + i + 1)};
    if (no_section_flows(element, i, state, heats, p) && no_section_flows(element, i + 1, state, heats, p)) return;
    const bool converged = beam::return_to_surface(pair, elastic, *law_now(e, heat), flow, return_tolerance_, at);
    if (!converged && found.unreturned < 0) found.unreturned = element + i;
    for (int j : {0, 1}) {
        for (int c = 0; c < 6; ++c) p[c][i + j] = flow[j].p[c];
        if (flow[j].flows()) found.yielding.push_back({element + i + j, flow[j]});
    }
}

}  // namespace hinge

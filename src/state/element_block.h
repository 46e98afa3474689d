// Data of eight elements that the stages of the assembly share. Only for the files of ElementAssembly.
#pragma once

#include <vector>

#include "beam/beam_column.h"
#include "beam/element_mass.h"
#include "beam/turning_inertia.h"
#include "beam/winding.h"
#include "state/element_assembly.h"

namespace hinge {

/// Elements 8 i to 8 i + 7, in that order.
struct ElementAssembly::Block {
    int node[2][lane_count];
    Lanes chord[3];
    const Kind* kind;
    unsigned whole;  ///< a bit for each element that takes part
};

/// Data of blocks with the same eight sections, lengths and directions: nearly all blocks of a regular frame.
struct ElementAssembly::Kind {
    Lanes length, axes[4];                       // w x y z
    Lanes k[8];                                  // x11 x12 x22 y11 y12 y22 axial twist
    Lanes yield[4];                              // x y n z
    Lanes mass, rotary[3];                       // rho A L/6, rho I L/6: the linear mass
    Lanes more[2], more_across, more_rotary[2];  // additional terms of the cubic mass
    beam::PairKind<Lanes> pair;                  // effect of N on the bending of pairs
    bool can_yield, moves_surface, takes_shear, wears_stiffness;

    beam::Stiffness stiffness(int i) const {
        return {k[0][i], k[1][i], k[2][i], k[3][i], k[4][i], k[5][i], k[6][i], k[7][i]};
    }
};

struct ElementAssembly::Found {
    std::vector<PlasticIncrement> yielding;
    std::vector<int> rotated, far;
    int folded = -1, unreturned = -1;
    // of a block with wound elements
    beam::Winding winding[lane_count];
    beam::Triad<Lanes> frame;
    Lanes d[6], p[6];
    beam::NodalForces<Lanes> out;

    static void put(beam::Triple<Lanes>& lanes, int i, const beam::Triple<double>& of_element) {
        lanes.x[i] = of_element.x, lanes.y[i] = of_element.y, lanes.z[i] = of_element.z;
    }
    /// Nodal forces of the wound elements, from p.
    [[gnu::noinline]] void take_forces(unsigned which) {
        for (int i = 0; i < lane_count; ++i) {
            if (!(which >> i & 1)) continue;
            Vec6 of_element;
            for (int c = 0; c < 6; ++c) of_element[c] = p[c][i];
            const Vec12 f = beam::rates(winding[i]).transpose() * of_element;
            for (int end : {0, 1}) {
                put(out.force[end], i, {f[6 * end], f[6 * end + 1], f[6 * end + 2]});
                put(out.moment[end], i, {f[6 * end + 3], f[6 * end + 4], f[6 * end + 5]});
            }
        }
    }
};

/// Blocks that one thread takes at a time.
inline constexpr int piece = 64;

}  // namespace hinge

// Rayleigh damping of eight elements at once: elements in large displacement, whole and not wound, that do not flow.
#pragma once

#include <span>
#include <vector>

#include "algebra/node_blocks.h"
#include "core/lanes.h"
#include "state/configuration.h"

namespace hinge {

/// Whether the damping of an element is not zero.
inline bool damps(const ElementDamping& c) { return c.of_mass != 0 || c.of_stiffness != 0; }
/// The elements that damping acts on, in rising order.
inline std::vector<int> damped_of(const std::vector<ElementDamping>& damping) {
    std::vector<int> elements;
    for (std::size_t e = 0; e < damping.size(); ++e)
        if (damps(damping[e])) elements.push_back(int(e));
    return elements;
}

class DampedBlocks {
public:
    /// `damped`: elements in rising order; `damping`: of all elements.
    DampedBlocks(const Structure& structure, const State& state, std::span<const int> damped,
                 std::span<const ElementDamping> damping);

    int size() const { return int(blocks_.size()); }
    /// C v of the elements 8 i to 8 i + 7 of the list at `trial`, N and N m on both nodes, and of that the part of
    /// beta. `relative`: the velocities that the part of alpha takes, of all nodes. Returns which of the eight are
    /// wound, a bit each: of these the results have no meaning.
    unsigned find(int i, const State& state, const Configuration& trial, const std::vector<Vec6>& relative,
                  Vec12* force, Vec12* by_stiffness);

private:
    struct Block {
        int element[lane_count], node[2][lane_count];
        int count = 0;             ///< less than eight in the last one, which repeats its last element
        double point[lane_count];  ///< for which k is
        Lanes chord[3], axes[4];   // w x y z
        Lanes k[8];                // beta times x11 x12 x22 y11 y12 y22 axial twist
        Lanes own[2], across, rotary[2][3], rotary_across[3];  // alpha times the element's mass
    };
    void set_stiffness(Block& b, int lane, const State& state);

    const Structure& structure_;
    std::span<const ElementDamping> damping_;
    std::vector<Block> blocks_;
};

}  // namespace hinge

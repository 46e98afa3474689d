// Elements wound by more than a third of a turn: the assembly stage that finds them, and their part of the state.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "beam/winding.h"
#include "state/element_block.h"
#include "state/turned_ends.h"

namespace hinge {
namespace {

/// 1 + cos of the angle between a wound element's end and its chord, below which its bending angle has no direction:
/// 177 degrees.
constexpr double least_open = 1e-3;

/// Whether an end has turned past half a turn against its element since its plastic deformation came about: then the
/// measure, which ends at half a turn, has gone over to the other side, and the elastic part would be a whole turn off.
bool turned_over(const double (&bent)[4], const Vec6& plastic) {
    for (int e : {0, 1}) {
        const double x = bent[e], y = bent[2 + e], angle = std::hypot(x, y), over = 1 - 2 * std::numbers::pi / angle;
        const auto off = [&](double times) { return std::hypot(times * x - plastic[e], times * y - plastic[2 + e]); };
        if (angle > 0 && off(over) < off(1)) return true;
    }
    return false;
}

}  // namespace

/// Which elements of the block are wound, a bit each; puts their frame and deformation in the place of those found.
[[gnu::noinline]] unsigned ElementAssembly::find_wound(const Block& b, int element, const Lanes& rotated,
                                                       const State& state, const Configuration& pose,
                                                       Found& found) const {
    unsigned wound = 0;
    for (int i = 0; i < lane_count; ++i) {
        const int index = element + i;
        if (!(b.whole >> i & 1)) continue;
        if (rotated[i] < beam::far_rotation && (state.twist.empty() || state.twist[index] == 0)) continue;
        const Element& e = structure_.elements()[index];
        found.far.push_back(index);
        beam::Winding& w = found.winding[i];
        w = winding_of(e, index, pose);
        const bool is_wound = beam::wind(w);
        double bent[4];
        for (int c = 0; c < 4; ++c) bent[c] = is_wound ? w.d[c] : found.d[c][i];
        if (turned_over(bent, state.plastic[index])) found.folded = found.unreturned = index;
        if (!is_wound) continue;
        wound |= 1u << i;
        if (w.open < least_open) found.folded = index;
        Found::put(found.frame.x, i, w.frame.x);
        Found::put(found.frame.y, i, w.frame.y);
        Found::put(found.frame.z, i, w.frame.z);
        for (int c = 0; c < 6; ++c) found.d[c][i] = w.d[c];
    }
    return wound;
}

/// An element's twist is remembered from a third of a turn on: below, it can be told from the nodes' rotations alone.
std::vector<int> ElementAssembly::save_turns(State& state, Configuration& trial) const {
    std::vector<int> turned;
    if (far_.empty() && state.twist.empty()) return turned;
    const auto keep = [&](int index) {
        const Element& e = structure_.elements()[index];
        beam::Winding w = winding_of(e, index, state);
        beam::wind(w);
        const bool far = std::abs(w.twist) > beam::remembered_twist && !state.broken[index];
        if (far && state.twist.empty()) state.twist.assign(state.broken.size(), 0);
        if (!state.twist.empty()) state.twist[index] = far ? w.twist : 0;
    };
    for (int index : far_)
        if (state.twist.empty() || state.twist[index] == 0) keep(index);
    for (std::size_t i = 0; i < state.twist.size(); ++i)
        if (state.twist[i] != 0) keep(int(i));
    for (int index : far_)
        if (turn_ends(structure_, state, index)) turned.push_back(index);
    trial.twist = state.twist;
    if (!turned.empty()) trial.turned = state.turned;
    return turned;
}

}  // namespace hinge

#include "state/turned_ends.h"

#include <algorithm>
#include <cmath>

#include "core/rotation.h"
#include "state/configuration.h"

namespace hinge {
namespace {

constexpr double far_hinge = 2;     ///< rad: plastic rotation of an end that is taken up
constexpr double most_elastic = 1;  ///< rad: elastic rotation with which it is; slender members have up to 0.6

}  // namespace

Vec6 taken_up(const State& state, int element) {
    if (state.turned.empty()) return Vec6::Zero();
    return Eigen::Map<const Vec6>(state.turned[element].flowed);
}

Vec6 flowed(const State& state, int element) { return state.plastic[element] + taken_up(state, element); }

bool turn_ends(const Structure& structure, State& state, int element) {
    const Vec6 plastic = state.plastic[element];
    if (state.broken[element] ||
        std::max(std::hypot(plastic[0], plastic[2]), std::hypot(plastic[1], plastic[3])) < far_hinge)
        return false;
    const ElementFrame place = element_frame(structure, element, state);
    const Vec6 elastic = element_deformation(structure, element, state, place) - plastic;
    for (int c : {0, 1, 2, 3, 5})
        if (!(std::abs(elastic[c]) <= most_elastic)) return false;
    const Element& e = structure.elements()[element];
    const Mat3 axes = axes_of(place);
    if (state.turned.empty()) state.turned.resize(state.plastic.size());
    TurnedEnds& turned = state.turned[element];
    for (int end : {0, 1}) {
        const Vec3 rotation = {elastic[end], elastic[2 + end], (end == 0 ? -0.5 : 0.5) * elastic[5]};
        const Quat wanted = Quat(axes) * rotated(rotation, Quat::Identity());
        const Quat by = (state.rotation[e.node[end]].conjugate() * wanted * e.axes.conjugate()).normalized();
        const double numbers[4] = {by.w(), by.x(), by.y(), by.z()};
        std::copy_n(numbers, 4, turned.by[end]);
    }
    if (!state.twist.empty()) state.twist[element] = 0;
    Vec6 left = element_deformation(structure, element, state) - elastic;
    left[4] = plastic[4];
    state.plastic[element] = left;
    Eigen::Map<Vec6>(turned.flowed) += plastic - left;
    return true;
}

}  // namespace hinge

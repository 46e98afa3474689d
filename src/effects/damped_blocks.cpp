#include "effects/damped_blocks.h"

#include <algorithm>

#include "beam/winding.h"
#include "state/gather.h"
#include "state/hinges.h"

namespace hinge {

using beam::Triple;

DampedBlocks::DampedBlocks(const Structure& structure, const State& state, std::span<const int> damped,
                           std::span<const ElementDamping> damping)
    : structure_(structure), damping_(damping), blocks_((damped.size() + lane_count - 1) / lane_count) {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        Block& b = blocks_[i];
        b.count = int(std::min<std::size_t>(lane_count, damped.size() - i * lane_count));
        for (int lane = 0; lane < lane_count; ++lane) {
            const int element = b.element[lane] = damped[i * lane_count + std::size_t(std::min(lane, b.count - 1))];
            const Element& e = structure.elements()[element];
            for (int end : {0, 1}) b.node[end][lane] = e.node[end];
            for (int c = 0; c < 3; ++c) b.chord[c][lane] = e.chord[c];
            const double q[4] = {e.axes.w(), e.axes.x(), e.axes.y(), e.axes.z()};
            for (int c = 0; c < 4; ++c) b.axes[c][lane] = q[c];
            const beam::Inertia& m = structure.inertia(element);
            const double alpha = damping[element].of_mass;
            b.across[lane] = alpha * m.across;
            for (int end : {0, 1}) b.own[end][lane] = alpha * m.own[end];
            for (int c = 0; c < 3; ++c) {
                b.rotary_across[c][lane] = alpha * m.rotary_across[c];
                for (int end : {0, 1}) b.rotary[end][c][lane] = alpha * m.rotary[end][c];
            }
            set_stiffness(b, lane, state);
        }
    }
}

void DampedBlocks::set_stiffness(Block& b, int lane, const State& state) {
    const int element = b.element[lane];
    const beam::Stiffness k = declared_stiffness(structure_, state, element);
    const double ks[8] = {k.x11, k.x12, k.x22, k.y11, k.y12, k.y22, k.axial, k.twist};
    for (int c = 0; c < 8; ++c) b.k[c][lane] = damping_[element].of_stiffness * ks[c];
    b.point[lane] = state.point[element];
}

unsigned DampedBlocks::find(int i, const State& state, const Configuration& trial, const std::vector<Vec6>& relative,
                            Vec12* force, Vec12* by_stiffness) {
    Block& b = blocks_[std::size_t(i)];
    for (int lane = 0; lane < lane_count; ++lane)
        if (state.point[b.element[lane]] != b.point[lane]) set_stiffness(b, lane, state);

    const Triple<Lanes> way = gather(trial.displacement, b.node[1]) - gather(trial.displacement, b.node[0]);
    const beam::ElementFrame<Lanes> place =
        beam::place<Lanes>(Triple<Lanes>{b.chord[0], b.chord[1], b.chord[2]} + way, gather(trial.rotation, b.node[0]),
                           gather(trial.rotation, b.node[1]), {b.axes[0], b.axes[1], b.axes[2], b.axes[3]});
    unsigned wound = 0;
    const Lanes rotated = dot(place.theta[0], place.theta[0]) + dot(place.theta[1], place.theta[1]);
    if (any_not_below(rotated, beam::far_rotation))
        for (int lane = 0; lane < lane_count; ++lane)
            if (!(rotated[lane] < beam::far_rotation)) wound |= 1u << lane;

    const Motion v[2] = {gather_motion(trial.velocity, b.node[0]), gather_motion(trial.velocity, b.node[1])};
    Lanes rate[6];
    const Triple<Lanes> linear[2] = {v[0].linear, v[1].linear}, angular[2] = {v[0].angular, v[1].angular};
    beam::deformation_rates(place, linear, angular, rate);
    const Lanes p[6] = {b.k[0] * rate[0] + b.k[1] * rate[1],
                        b.k[1] * rate[0] + b.k[2] * rate[1],
                        b.k[3] * rate[2] + b.k[4] * rate[3],
                        b.k[4] * rate[2] + b.k[5] * rate[3],
                        b.k[6] * rate[4],
                        b.k[7] * rate[5]};
    const beam::NodalForces<Lanes> stiff = beam::nodal_forces(place, p);

    const Motion r[2] = {gather_motion(relative, b.node[0]), gather_motion(relative, b.node[1])};
    Triple<Lanes> spin[2];
    for (int end : {0, 1})
        spin[end] = {dot(place.frame.x, r[end].angular), dot(place.frame.y, r[end].angular),
                     dot(place.frame.z, r[end].angular)};
    for (int end : {0, 1}) {
        const Triple<Lanes>&own = spin[end], &other = spin[1 - end];
        const Triple<Lanes> L = {b.rotary[end][0] * own.x + b.rotary_across[0] * other.x,
                                 b.rotary[end][1] * own.y + b.rotary_across[1] * other.y,
                                 b.rotary[end][2] * own.z + b.rotary_across[2] * other.z};
        const Triple<Lanes> heavy = b.own[end] * r[end].linear + b.across * r[1 - end].linear,
                            turning = L.x * place.frame.x + L.y * place.frame.y + L.z * place.frame.z;
        const Triple<Lanes>&f = stiff.force[end], &m = stiff.moment[end];
        const Lanes of_stiffness[lane_count] = {f.x, f.y, f.z, m.x, m.y, m.z},
                    whole[lane_count] = {heavy.x + f.x,   heavy.y + f.y,   heavy.z + f.z,
                                         turning.x + m.x, turning.y + m.y, turning.z + m.z};
        Lanes row[lane_count];
        transpose(of_stiffness, row);
        for (int lane = 0; lane < b.count; ++lane) store_row<6>(by_stiffness[lane].data() + 6 * end, row[lane]);
        transpose(whole, row);
        for (int lane = 0; lane < b.count; ++lane) store_row<6>(force[lane].data() + 6 * end, row[lane]);
    }
    return wound;
}

}  // namespace hinge

// Dynamics, explicit: what takes the place of yield, operator, solve and correct when K drops out of eq 15.
#include <cmath>

#include "run/dynamics.h"
#include "state/nodes.h"

namespace hinge {

/// Explicit: a' = M^-1 (F - R), and half of it and of what was there before go into the velocity.
void Dynamics::accelerate() {
    const double half = 0.5 * settings_.dt;
    const std::vector<Vec6>& inverse = mass_->lumped_inverse();
    const auto move = [&](int i, const Lanes& a, Fastest& most) {
        const Lanes v =
            load_row<6>(state_.velocity[i].data()) + half * (load_row<6>(state_.acceleration[i].data()) + a);
        store_row<6>(trial_.acceleration[i].data(), a);
        store_row<6>(trial_.velocity[i].data(), v);
        if (const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; v2 > most.speed) most = {v2, i, 0};
    };
    const int nodes = int(nodal_.size());
    fastest_of_.assign((nodes + some_nodes - 1) / some_nodes, {});
    const double check = pool_.sum(nodes, some_nodes, [&](int first, int end) {
        Lanes sum{};
        for (int i = first; i < end; ++i) {
            const Lanes f = load_row<6>(external_[i].data()) - load_row<6>(nodal_[i].data());
            sum += f;
            move(i, load_row<6>(inverse[i].data()) * f, fastest_of_[first / some_nodes]);
        }
        return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + (sum[4] + sum[5]);
    });
    if (!std::isfinite(check)) {
        failure_ = name_the_culprit();
        return;
    }
    for (int n : held_nodes_) {
        Vec6& r = reaction_[n];
        r.setZero();
        for (int c = 0; c < 6; ++c)
            if (state_.held[n] >> c & 1) r[c] = nodal_[n][c] - external_[n][c];
    }
    if (!mass_->heavy().empty()) mass_->turn_offset_masses(state_, trial_);
    for (const Mass::Heavy& h : mass_->heavy()) {
        Vec6 a = h.inverse * (external_[h.node] - nodal_[h.node]);
        for (int c = 0; c < 6; ++c)
            if (state_.held[h.node] >> c & 1) a[c] = 0;
        move(h.node, load_row<6>(a.data()), fastest_of_.back());
    }
    move_supports();
    meet_supports();
    if (built::fracture) keep_stub_momentum(trial_.acceleration);
    note_fastest();
}

}  // namespace hinge

#include "run/central_differences.h"

#include <cmath>

#include "state/nodes.h"

namespace hinge {

/// du = dt v + dt^2 a / 2; offset masses say what they resist beside their mass times the acceleration.
void CentralDifferences::predict(const Step& step) {
    const double dt = step.dt;
    w_.pool.share(int(w_.rotation_step.size()), some_nodes, [&](int first, int end, int) {
        w_.for_awake(first, end, [&](int from, int to) {
            for (int i = from; i < to; ++i) {
                const Lanes v = load_row<6>(w_.state.velocity[i].data()),
                            a = load_row<6>(w_.state.acceleration[i].data());
                const Lanes move = dt * v + (0.5 * dt * dt) * a;
                store_row<3>(w_.trial.displacement[i].data(), load_row<3>(w_.state.displacement[i].data()) + move);
                store_row<3>(w_.rotation_step[i].data(), second_three(move));
                store_row<6>(w_.trial.velocity[i].data(), v + dt * a);
                store_row<6>(w_.trial.acceleration[i].data(), Lanes{});
            }
            move_to_rotated(from, to);
        });
    });
}

/// The values of the nodes that constraints join.
std::vector<Vec6> CentralDifferences::of_joined(const std::vector<Vec6>& of) const {
    std::vector<Vec6> values;
    if (w_.constraints)
        for (const std::vector<int>& group : w_.constraints->reduction().groups())
            for (const int n : group) values.push_back(of[n]);
    return values;
}

/// (T^T M T) q = T^T (F - R); R has what the acceleration towards the centre of rotation resists.
void CentralDifferences::solve_joined() {
    joined_force_.resize(w_.resisting.size(), Vec6::Zero());
    joined_change_.resize(w_.resisting.size(), Vec6::Zero());
    for (const std::vector<int>& group : w_.constraints->reduction().groups())
        for (const int n : group) {
            joined_force_[n] = w_.external[n] - w_.resisting[n];
            for (int c = 0; c < 6; ++c)
                if (w_.state.held[n] >> c & 1) joined_force_[n][c] = 0;
        }
    mass_.now()->solve_joined(joined_force_, joined_change_, w_.state);
}

/// Eq 15 without K: a' = M^-1 (F - R), and half of it and of what was there before go into the velocity.
void CentralDifferences::accelerate(Step& step) {
    const double half = 0.5 * step.dt;
    Mass& mass = *mass_.now();
    const Vec6 *inverse = mass.lumped_inverse().data(), *external = w_.external.data(),
               *resisting = w_.resisting.data(), *v_before = w_.state.velocity.data(),
               *a_before = w_.state.acceleration.data();
    Vec6 *velocity = w_.trial.velocity.data(), *acceleration = w_.trial.acceleration.data();
    const auto move = [&](int i, const Lanes& a, Fastest& most) {
        const Lanes v = load_row<6>(v_before[i].data()) + half * (load_row<6>(a_before[i].data()) + a);
        store_row<6>(acceleration[i].data(), a);
        store_row<6>(velocity[i].data(), v);
        if (const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; v2 > most.speed) most = {v2, i, 0};
    };
    const int nodes = int(w_.resisting.size());
    begin_fastest((nodes + some_nodes - 1) / some_nodes);
    power_of_.assign(fastest_of_.size(), 0);
    const std::vector<Vec6> towards_centre = of_joined(w_.trial.acceleration);
    const double check = w_.pool.sum(nodes, some_nodes, [&](int first, int end) {
        Lanes sum{}, power{};
        for (int i = first; i < end; ++i) {
            if (w_.rests(i)) continue;
            const Lanes f = load_row<6>(external[i].data()) - load_row<6>(resisting[i].data());
            const Lanes a = load_row<6>(inverse[i].data()) * f;
            sum += f;
            power += a * f;
            move(i, a, fastest_of_[first / some_nodes]);
        }
        power_of_[first / some_nodes] = ((power[0] + power[1]) + (power[2] + power[3])) + (power[4] + power[5]);
        return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + (sum[4] + sum[5]);
    });
    if (!std::isfinite(check)) {
        step.failure = find_culprit();
        return;
    }
    take_reactions([&](int n, int c) { return w_.resisting[n][c] - w_.external[n][c]; });
    if (!mass.heavy().empty()) mass.rotate_offset_masses(w_.state, w_.trial);
    double power = 0;
    for (const double of_piece : power_of_) power += of_piece;
    for (const Mass::Heavy& h : mass.heavy()) {
        if (w_.constraints && w_.constraints->reduction().joins(h.node)) continue;
        const Vec6 f = w_.external[h.node] - w_.resisting[h.node];
        Vec6 a = h.inverse * f;
        for (int c = 0; c < 6; ++c)
            if (w_.state.held[h.node] >> c & 1) a[c] = 0;
        power += a.dot(f);
        move(h.node, load_row<6>(a.data()), fastest_of_.back());
    }
    if (w_.constraints) {
        solve_joined();
        auto turning = towards_centre.begin();
        for (const std::vector<int>& group : w_.constraints->reduction().groups())
            for (const int n : group) {
                power += joined_change_[n].dot(joined_force_[n]);
                const Vec6 a = joined_change_[n] + *turning++;
                move(n, load_row<6>(a.data()), fastest_of_.back());
            }
    }
    swing_ = 0.5 * half * half * power;
    note_fastest(step.end());
}

}  // namespace hinge

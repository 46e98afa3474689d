// Dynamics, what a dissipative integrator takes out (Wood, Bossak and Zienkiewicz 1980).
//
// Forces meet M ((1 - alpha) a' + alpha a) instead of M a'. While a step is tried its acceleration is that blend.
#include "run/dynamics.h"
#include "state/turning.h"

namespace hinge {
namespace {

/// x . M y of an element, each a velocity or an acceleration of its two nodes.
double through_mass(const beam::Inertia& m, const Mat3& to_element, const Vec6 x[2], const Vec6 y[2]) {
    const Vec3 xa = to_element * x[0].tail<3>(), xb = to_element * x[1].tail<3>(), ya = to_element * y[0].tail<3>(),
               yb = to_element * y[1].tail<3>();
    return m.own[0] * x[0].head<3>().dot(y[0].head<3>()) + m.own[1] * x[1].head<3>().dot(y[1].head<3>()) +
           m.across * (x[0].head<3>().dot(y[1].head<3>()) + x[1].head<3>().dot(y[0].head<3>())) +
           xa.dot(m.rotary[0].cwiseProduct(ya)) + xb.dot(m.rotary[1].cwiseProduct(yb)) +
           xa.dot(m.rotary_across.cwiseProduct(yb)) + xb.dot(m.rotary_across.cwiseProduct(ya));
}

}  // namespace

/// The step is solved: the trial's acceleration becomes the one at the end of the step, and what was taken out is
/// counted.
void Dynamics::leave_met() {
    const double alpha = settings_.alpha();
    next_met_ = trial_.acceleration;
    for (std::size_t i = 0; i < next_met_.size(); ++i)
        trial_.acceleration[i] = (next_met_[i] - alpha * state_.acceleration[i]) / (1 - alpha);
    numerical_ = dissipated();
}

/// The work by the trapezium rule of what the forces met, less the change of the kinetic energy. With b and b' met, V =
/// v + dv/2, dv = dt ((1 - gamma) a + gamma a') and du = dt V + dt^2 (beta - gamma/2) (a' - a) that is dt V . M ((b +
/// b')/2 - (1 - gamma) a - gamma a') + dt^2 (beta - gamma/2) (b + b')/2 . M (a' - a).
double Dynamics::dissipated() const {
    const double dt = settings_.dt, gamma = settings_.gamma(), c = dt * dt * (settings_.beta - 0.5 * gamma);
    struct AtNode {
        Vec6 mean_velocity, lag, mean_met, rise;
    };
    const auto at = [&](int n) {
        const Vec6 &a = state_.acceleration[n], &next = trial_.acceleration[n];
        const Vec6 met = 0.5 * (met_[n] + next_met_[n]);
        const Vec6 rate = (1 - gamma) * a + gamma * next;
        return AtNode{dt * (state_.velocity[n] + 0.5 * dt * rate), met - rate, c * met, next - a};
    };
    double sum = 0;
    for (std::size_t i = 0; i < structure_->elements().size(); ++i) {
        if (state_.broken[i]) continue;
        const Element& e = structure_->elements()[i];
        const AtNode one = at(e.node[0]), two = at(e.node[1]);
        const Vec6 v[2] = {one.mean_velocity, two.mean_velocity}, lag[2] = {one.lag, two.lag},
                   met[2] = {one.mean_met, two.mean_met}, rise[2] = {one.rise, two.rise};
        const Mat3 to_element = axes_of(place_element(*structure_, int(i), trial_)).transpose();
        const beam::Inertia m = structure_->inertia(int(i));
        sum += through_mass(m, to_element, v, lag) + through_mass(m, to_element, met, rise);
    }
    for (std::size_t i = 0; i < state_.offset_mass.size(); ++i) {
        if (state_.offset_mass[i].mass == 0) continue;
        const AtNode n = at(int(i));
        const Mat6 m = offset_mass_in_space(state_.offset_mass[i], trial_.rotation[i]);
        sum += n.mean_velocity.dot(m * n.lag) + n.mean_met.dot(m * n.rise);
    }
    return sum;
}

}  // namespace hinge

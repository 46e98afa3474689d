// Dynamics, inertia by itself: accelerations and velocities from M alone, and the stubs that hang on nodes.
#include <algorithm>
#include <cmath>

#include "run/dynamics.h"

namespace hinge {
namespace {

/// A stub's inertia about its own axis is a thousandth of that across: its part of the operator must not lag by more
/// than 2 mrad, the cosine of whose half this is.
constexpr double offset_turn = 1 - 5e-7;

}  // namespace

/// M a = F - R: at the start, and again whenever a force has vanished at once. With the acceleration of before, half a
/// step of a force that is no longer there would go into the velocities.
void Dynamics::find_acceleration() {
    std::vector<double> given;  // of the supports that move
    for (const Moved& m : moved_) given.push_back(state_.acceleration[m.node][m.component]);
    const auto give = [&] {
        for (std::size_t i = 0; i < moved_.size(); ++i)
            state_.acceleration[moved_[i].node][moved_[i].component] = given[i];
    };
    for (Vec6& a : state_.acceleration) a.setZero();
    give();
    trial_ = pose_of(state_);
    iteration_ = 0;
    recover();
    apply_loads(state_.time);
    renew_mass(trial_);
    for (std::size_t i = 0; i < nodal_.size(); ++i) nodal_[i] = external_[i] - nodal_[i];
    take_reactions(nodal_);
    mass_->solve(nodal_, state_.acceleration, state_, 1e-12);
    if (explicit_steps()) give();  // else the support's own mass is in its reaction
    for (Moved& m : moved_) m.force = reaction_[m.node][m.component] + momentum_at(m, state_.acceleration, false);
    give();
    yielding_.clear();
    restart_ = false;
    if (settings_.alpha() != 0) met_ = state_.acceleration;
    stub_rate_ = tried_stub_rate_;
    for (std::size_t i = 0; i < stub_rate_.size(); ++i)
        stub_rate_[i] += state_.acceleration[i].tail<3>().cross(state_.rotation[i] * state_.offset_mass[i].moment);
}

/// M alone, of what turned or broke since it was last needed.
void Dynamics::renew_mass(const Pose& pose) {
    in_mass_stale_.assign(state_.broken.size(), 0);
    if (mass_) mass_->renew(mass_stale_, state_, pose);
    else mass_ = std::make_unique<Mass>(*structure_, state_);
    mass_stale_.clear();
}

/// change_ = M^-1 impulse, and what x times it takes: square x^2 + linear x. Supports that move add x by_supports to
/// it.
Dynamics::Kick Dynamics::kick(const std::vector<Vec6>& impulse) {
    Kick out;
    right_ = impulse;
    for (std::size_t i = 0; i < right_.size(); ++i) {
        out.linear += right_[i].dot(trial_.velocity[i]);
        for (int c = 0; c < 6; ++c)
            if (state_.held[i] >> c & 1) out.by_supports -= right_[i][c] * trial_.velocity[i][c], right_[i][c] = 0;
    }
    renew_mass(trial_);
    mass_->solve(right_, change_, state_, 1e-10);
    for (std::size_t i = 0; i < right_.size(); ++i) out.square += 0.5 * right_[i].dot(change_[i]);
    for (const Moved& m : moved_) out.by_supports += trial_.velocity[m.node][m.component] * momentum_at(m, change_);
    return out;
}

void Dynamics::renew_hung_operator(std::size_t node) {
    if (state_.offset_mass[node].mass == 0) return;
    hung_built_.resize(state_.offset_mass.size(), Quat::Identity());
    hung_built_[node] = state_.rotation[node];
    if (effective_)
        effective_->set_offset_mass(int(node), offset_mass_in_space(state_.offset_mass[node], state_.rotation[node]));
}

/// Rigid stubs: m (a - g) + a x S + w x (w x S) and S x (a - g) + J a + w x J w, S and J about the node, in space.
void Dynamics::add_hung_inertia() {
    const Vec3 g = structure_->model().gravity().value_or(Vec3::Zero());
    tried_stub_rate_.assign(state_.offset_mass.size(), Vec3::Zero());
    for (std::size_t i = 0; i < state_.offset_mass.size(); ++i) {
        const OffsetMass& h = state_.offset_mass[i];
        if (h.mass == 0) continue;
        const Mat3 R = trial_.rotation[i].toRotationMatrix();
        const Vec3 S = R * h.moment, a = trial_.acceleration[i].head<3>() - g, alpha = trial_.acceleration[i].tail<3>(),
                   w = trial_.velocity[i].tail<3>();
        const Vec3 in_body = R.transpose() * w, Jw = R * (h.inertia * in_body),
                   Ja = R * (h.inertia * (R.transpose() * alpha));
        tried_stub_rate_[i] = alpha.cross(S) + w.cross(w.cross(S));
        nodal_[i].head<3>() += h.mass * a + tried_stub_rate_[i];
        nodal_[i].tail<3>() += S.cross(a) + Ja + w.cross(Jw);
        if (trial_.rotation[i].coeffs().dot(hung_built_[i].coeffs()) < offset_turn) renew_hung_operator(i);
    }
}

/// A stub's part of the momentum, w x S, turns with it: over a step it changes by a little else than the trapezium rule
/// makes of the rates that the forces met. The node takes the difference, so that linear momentum stays what it was.
/// Called with the change of the acceleration since the stresses were recovered.
void Dynamics::keep_stub_momentum(const std::vector<Vec6>& change) {
    const double alpha = settings_.alpha(), gamma = settings_.gamma();
    next_stub_rate_ = tried_stub_rate_;
    for (std::size_t i = 0; i < next_stub_rate_.size(); ++i) {
        const OffsetMass& h = state_.offset_mass[i];
        if (h.mass == 0) continue;
        const Vec3 S = state_.rotation[i] * h.moment, next_S = trial_.rotation[i] * h.moment;
        const Vec3 S_met = effective_ ? Vec3(hung_built_[i] * h.moment) : next_S;
        next_stub_rate_[i] =
            (tried_stub_rate_[i] + (1 - alpha) * change[i].tail<3>().cross(S_met) - alpha * stub_rate_[i]) /
            (1 - alpha);
        const Vec3 met = settings_.dt * ((1 - gamma) * stub_rate_[i] + gamma * next_stub_rate_[i]);
        double mass = h.mass;
        for (int e : structure_->elements_at(int(i)))
            if (!state_.broken[e])
                mass += 0.5 * structure_->elements()[e].rigidity.rhoA * structure_->elements()[e].length;
        const Vec3 missed =
            (trial_.velocity[i].tail<3>().cross(next_S) - state_.velocity[i].tail<3>().cross(S) - met) / mass;
        for (int c = 0; c < 3; ++c)
            if (!(state_.held[i] >> c & 1)) trial_.velocity[i][c] -= missed[c];
    }
}

}  // namespace hinge

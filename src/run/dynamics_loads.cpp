// Dynamics, what comes from outside: loads, and supports that move.
#include "run/dynamics.h"

namespace hinge {

/// F at the end of the step, and where the supports are then.
void Dynamics::loads() {
    const std::vector<NodalLoad>& loads = structure_->model().loads();
    for (auto& [i, acting] : rule_loads_) {
        const double end = state_.time + settings_.dt;
        if (state_.gone[loads[i].node]) continue;
        if (loads[i].force_rule) acting.head<3>() = loads[i].force_rule(end);
        if (loads[i].moment_rule) acting.tail<3>() = loads[i].moment_rule(end);
    }
    apply_loads(state_.time + settings_.dt);
    foresee_supports();
}

/// F at time t: gravity and the script's loads. Only nodes with loads change.
void Dynamics::apply_loads(double t) {
    for (Loaded& l : loaded_) l.now.setZero();
    const std::vector<NodalLoad>& loads = structure_->model().loads();
    for (std::size_t i = 0; i < loads.size(); ++i) {
        if (state_.gone[loads[i].node]) continue;
        const double factor = loads[i].history ? loads[i].history(t) : 1.0;
        loaded_[load_at_[i]].now.head<3>() += factor * loads[i].force;
        loaded_[load_at_[i]].now.tail<3>() += factor * loads[i].moment;
    }
    for (const auto& [i, acting] : rule_loads_)
        if (!state_.gone[loads[i].node]) loaded_[load_at_[i]].now += acting;
    for (const Loaded& l : loaded_)
        if (resting_.empty() || resting_[l.node] < 0) external_[l.node] = l.gravity + l.now;
}

// ---- supports that move --------------------------------------------------------------------------------------------

/// Velocity and acceleration by differences backwards, of second order: a motion is asked for once a step.
void Dynamics::foresee_supports() {
    const double dt = settings_.dt;
    for (Moved& m : moved_) {
        if (state_.gone[m.node]) continue;
        if (!m.begun) {
            m.now = state_.displacement[m.node][m.component];
            m.from = m.path(state_.time) - m.now;
            m.begun = true;
        }
        if (m.apart != dt) {
            m.before = m.path(state_.time - dt) - m.from;
            m.long_before = m.path(state_.time - 2 * dt) - m.from;
            m.apart = dt;
        }
        m.next = m.path(state_.time + dt) - m.from;
        m.speed = (3 * m.next - 4 * m.now + m.before) / (2 * dt);
        m.acceleration = (2 * m.next - 5 * m.now + 4 * m.before - m.long_before) / (dt * dt);
    }
}

/// What is tried has the supports where they are at the end of the step; their rows of the solve stay zero.
void Dynamics::move_supports() {
    for (const Moved& m : moved_) {
        if (state_.gone[m.node]) continue;
        trial_.displacement[m.node][m.component] = m.next;
        trial_.velocity[m.node][m.component] = m.speed;
        trial_.acceleration[m.node][m.component] =
            (1 - settings_.alpha()) * m.acceleration + settings_.alpha() * state_.acceleration[m.node][m.component];
    }
}

/// The force by which a support is moved: what was met where the step was solved from, and what the solve added.
void Dynamics::meet_supports() {
    for (Moved& m : moved_) {
        double& force = reaction_[m.node][m.component];
        if (effective_)
            for (int e : structure_->elements_at(m.node)) {
                const Element& element = structure_->elements()[e];
                if (state_.broken[e]) continue;
                Vec12 change;
                change << change_[element.node[0]], change_[element.node[1]];
                force += support_parts_.at(e).row((element.node[0] == m.node ? 0 : 6) + m.component).dot(change);
            }
        else force += momentum_at(m, trial_.acceleration, false);
        m.next_force = force;
    }
}

/// The row of M of a support's freedom, times such a value of each node; with or without the stubs that hang on it.
double Dynamics::momentum_at(const Moved& m, const std::vector<Vec6>& of, bool stubs) const {
    const int c = m.component;
    double sum = stubs && !state_.offset_mass.empty() ? state_.offset_mass[m.node].mass * of[m.node][c] : 0;
    for (int e : structure_->elements_at(m.node)) {
        if (state_.broken[e]) continue;
        const Element& element = structure_->elements()[e];
        const int end = element.node[0] == m.node ? 0 : 1;
        const beam::Inertia inertia = structure_->inertia(e);
        sum += inertia.own[end] * of[m.node][c] + inertia.across * of[element.node[1 - end]][c];
    }
    return sum;
}

/// What supports do as the nodes get such a velocity at once, and theirs stays.
double Dynamics::work_on_momentum(const std::vector<Vec6>& velocity) const {
    double work = 0;
    for (const Moved& m : moved_)
        if (!state_.gone[m.node]) work += state_.velocity[m.node][m.component] * momentum_at(m, velocity);
    return work;
}

/// By the trapezium rule, as if velocity and place followed from the accelerations as a free node's do; and what they
/// do beyond that, so that a path may set off at once. With v' = v'_N + j and u' = u'_N + k, V the mean velocity, dv_N
/// as Newmark has it and b the mean acceleration that the forces met: j (M V) + j/2 (M dv_N) - k (M b).
double Dynamics::work_of_supports() const {
    const double dt = settings_.dt, beta = settings_.beta, gamma = settings_.gamma();
    const bool damped = settings_.alpha() != 0;
    double work = 0;
    for (const Moved& m : moved_) {
        if (state_.gone[m.node]) continue;
        work += 0.5 * (m.force + m.next_force) * (m.next - m.now);
        const double v = state_.velocity[m.node][m.component], a = state_.acceleration[m.node][m.component],
                     next_a = trial_.acceleration[m.node][m.component];
        const double j = m.speed - v - dt * ((1 - gamma) * a + gamma * next_a),
                     k = m.next - m.now - dt * v - dt * dt * ((0.5 - beta) * a + beta * next_a);
        const double mv = 0.5 * (momentum_at(m, state_.velocity) + momentum_at(m, trial_.velocity));
        const double mdv =
            dt * ((1 - gamma) * momentum_at(m, state_.acceleration) + gamma * momentum_at(m, trial_.acceleration));
        const double mb = 0.5 * (momentum_at(m, damped ? met_ : state_.acceleration) +
                                 momentum_at(m, damped ? next_met_ : trial_.acceleration));
        work += j * mv + 0.5 * j * mdv - k * mb;
    }
    return work;
}

double Dynamics::work_of_loads() const {
    double work = 0;
    for (const Loaded& l : loaded_) {
        const Vec6 mean = 0.5 * (l.now + l.before);
        work += mean.head<3>().dot(trial_.displacement[l.node] - state_.displacement[l.node]) +
                mean.tail<3>().dot(increment_[l.node]);
    }
    return work;
}

void Dynamics::book_supports() {
    state_.accumulated.work += work_of_supports();
    for (Moved& m : moved_) {
        if (state_.gone[m.node]) continue;
        m.force = m.next_force;
        m.long_before = m.before, m.before = m.now, m.now = m.next;
    }
}

}  // namespace hinge

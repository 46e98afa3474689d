#include "run/constraints.h"

#include "core/errors.h"
#include "core/text.h"
#include "state/node_mass.h"

namespace hinge {

Constraints::Constraints(Workspace& w, const EffectList& effects)
    : w_(w),
      constrainers_(effects.constrainers),
      reduction_(w.structure, w.state.held, list_at(w.state)),
      unbalanced_(w.state.displacement.size(), Vec6::Zero()),
      factors_vary_(w.structure.large() && any_of(constrainers_, &Constrainer::factors_vary)) {}

std::vector<LinearConstraint> Constraints::list_at(const Pose& at) const {
    std::vector<LinearConstraint> list;
    for (const auto& c : constrainers_) c->add_constraints(at, list);
    return list;
}

void Constraints::begin() {
    const std::vector<Vec6> given = w_.state.velocity;
    w_.trial.velocity = given;
    const auto expanded = [&](std::vector<Vec6> of) { return reduction_.expand(of), of; };
    const std::vector<Vec6> wanted = expanded(given);
    for (const Reduction::Dependent& d : reduction_.dependents()) {
        const Vec6 &has = given[d.node], &must = wanted[d.node];
        if (!has.isZero(0) && !has.isApprox(must, 1e-9))
            throw InputError(d.declared_by + (": " + w_.structure.node_name(d.node)) + " begins with a velocity of " +
                             vector_text(has.head<3>(), 4) + " m/s and " + vector_text(has.tail<3>(), 4) +
                             " rad/s, but moves with " + w_.structure.node_name(d.parts[0].node) +
                             "; give both the velocity of one rigid body, or the latter alone");
    }
    w_.state.velocity = wanted;
    w_.trial.velocity = wanted;
}

void Constraints::place(const Pose& from, const std::vector<Vec3>& rotation_step) {
    for (const auto& c : constrainers_) c->place(from, rotation_step, w_.trial);
}

void Constraints::rebuild() { reduction_ = Reduction(w_.structure, w_.state.held, list_at(w_.state)); }

void Constraints::renew() {
    if (factors_vary_) reduction_.renew(list_at(w_.trial));
}

void Constraints::set_velocities() {
    for (const auto& c : constrainers_) c->set_velocities(w_.trial);
}

void Constraints::set_accelerations(bool of_step) {
    const bool weighted = of_step && w_.scheme.alpha != 0;
    const auto convert = [&](auto rule) {
        if (!weighted) return;
        for (const std::vector<int>& group : reduction_.groups())
            for (const int n : group)
                w_.trial.acceleration[n] = rule(w_.state.acceleration[n], w_.trial.acceleration[n]);
    };
    convert([&](const Vec6& a, const Vec6& of) -> Vec6 { return w_.scheme.next_of_weighted(a, of); });
    for (const auto& c : constrainers_) c->set_accelerations(w_.trial);
    convert([&](const Vec6& a, const Vec6& next) -> Vec6 { return w_.scheme.weighted(a, next); });
}

/// Lumped masses are not in R; offset masses are.
void Constraints::add_inertia() {
    for (const std::vector<int>& group : reduction_.groups())
        for (const int n : group) {
            const LumpedMass own = lumped_mass_at(w_.structure, w_.state, n);
            w_.resisting[n].head<3>() += own.mass * w_.trial.acceleration[n].head<3>();
            w_.resisting[n].tail<3>() += own.rotary * w_.trial.acceleration[n].tail<3>();
        }
}

void Constraints::pass_on() {
    for (const Reduction::Dependent& d : reduction_.dependents()) {
        const Vec6& f = unbalanced_[d.node];
        for (const Reduction::Part& p : d.parts) w_.resisting[p.node] += p.factors.transpose() * f;
        for (int c = 0; c < 6; ++c)
            if (d.tied >> c & 1) w_.resisting[d.node][c] -= f[c];
    }
}

void Constraints::add_curvature(const Pose& at, Blocks& blocks) const {
    for (const auto& c : constrainers_) c->add_curvature(at, unbalanced_, blocks);
}

bool Constraints::add_curvature_of_state(const Pose& at, double factor, Blocks& blocks) const {
    std::vector<Vec6> forces(unbalanced_.size(), Vec6::Zero());
    for (std::size_t n = 0; n < of_state_.size(); ++n) forces[n] = factor * of_state_[n];
    const std::size_t others = blocks.nodes.size();
    for (const auto& c : constrainers_) c->add_curvature(at, forces, blocks);
    return has_state_ || blocks.nodes.size() == others;
}

}  // namespace hinge

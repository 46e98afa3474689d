#include "run/static_forces.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "run/constraints.h"
#include "run/effect_forces.h"
#include "run/yield_tangents.h"

namespace hinge {

StaticForces::StaticForces(const StaticProblem& problem, Stages& stages)
    : problem_(problem),
      w_(problem.w),
      follow_(any_follows()),
      potential_(w_.external.size(), Vec6::Zero()),
      stages_(stages),
      recover_stage_(stages.add("recover stresses")) {
    for (const auto& load : problem_.effects.loads) load->begin_statics();
    for (const auto& force : problem_.effects.forces) force->begin_statics();
    find_support_rates();
    find_loads();
}

// ---- what effects are asked for ---------------------------------------------------------------------------------

void StaticForces::add_steady_and_static(std::vector<Vec6>& potential, std::vector<Vec6>& others) const {
    for (const auto& load : problem_.effects.loads) {
        std::vector<Vec6>& sum = load->has_potential() ? potential : others;
        load->add_steady_loads(sum);
        load->add_static_loads(w_.trial, sum);
    }
}

void StaticForces::add_held(std::vector<Vec6>& weights, std::vector<Vec6>& others) const {
    for (const auto& load : problem_.effects.loads)
        load->add_held_loads(w_.trial, load->has_potential() ? weights : others);
}

void StaticForces::add_resistance_of_effects() {
    for (const auto& force : problem_.effects.forces) force->add_forces(w_.state.time, w_.resisting);
}

void StaticForces::find_support_rates() {
    if (problem_.effects.static_prescribers.empty()) return;
    support_rates_.assign(w_.external.size(), Vec6::Zero());
    for (const auto& settling : problem_.effects.static_prescribers) settling->add_rates(support_rates_);
    if (!w_.constraints) return;
    const auto moves = [&](const DegreeOfFreedom& of) { return !support_rates_[std::size_t(of.node)].isZero(0); };
    for (const LinearConstraint& c : w_.constraints->list_at(w_.state))
        if (moves(c.dependent) ||
            std::any_of(c.terms.begin(), c.terms.end(), [&](const auto& t) { return moves(t.of); }))
            throw InputError("a support that settles (model:settle) does not go yet with " +
                             std::string(c.declared_by) + " at its node");
}

bool StaticForces::any_follows() const { return any_of(problem_.effects.loads, &Load::follows_nodes); }

bool StaticForces::are_unsymmetric() const { return any_of(problem_.effects.loads, &Load::is_unsymmetric); }

// ---- loads ----------------------------------------------------------------------------------------------------------

void StaticForces::find_loads() {
    std::vector<Vec6> others(w_.external.size(), Vec6::Zero());
    for (Vec6& v : potential_) v.setZero();
    add_steady_and_static(potential_, others);
    for (std::size_t i = 0; i < others.size(); ++i) w_.external[i] = others[i] + potential_[i];
    if (!w_.structure.model().holds_loads()) return;
    std::vector<Vec6> weights(others.size(), Vec6::Zero());
    w_.held.assign(others.size(), Vec6::Zero());
    add_held(weights, w_.held);
    for (std::size_t i = 0; i < w_.held.size(); ++i) w_.held[i] += weights[i], w_.external[i] -= weights[i];
}

Vec6 StaticForces::load(std::size_t node, double factor) const {
    if (w_.held.empty()) return factor * w_.external[node];
    return factor * w_.external[node] + w_.held[node];
}

void StaticForces::find_yielding_by_load(const std::vector<ElementTangent>& tangents) {
    yielding_by_load_.clear();
    std::vector<beam::FixedEnd>& ends = w_.assembly.fixed_ends();
    if (ends.empty() || tangents.empty()) return;
    const std::vector<beam::FixedEnd> now = ends;
    find_fixed_ends(w_, problem_.effects, w_.factor + 1);
    std::vector<beam::FixedEnd> change = std::move(ends);
    for (std::size_t i = 0; i < now.size(); ++i) change[i] = change[i] - now[i];
    ends = now;
    yielding_by_load_.assign(w_.external.size(), Vec6::Zero());
    add_response(w_.structure, w_.state, w_.trial, tangents, change, yielding_by_load_);
}

Vec6 StaticForces::load_rate(std::size_t node) const {
    if (yielding_by_load_.empty()) return w_.external[node];
    return w_.external[node] - yielding_by_load_[node];
}

/// Downwards in the upper half of the way, so that no temperature leaves the range of its properties.
std::vector<Vec6> StaticForces::internal_rates() {
    constexpr double difference = 1e-5;
    const double factor = w_.factor, change = factor > 0.5 ? -difference : difference;
    const std::vector<Vec6> now = w_.resisting;
    const std::vector<PlasticIncrement> yielding = w_.yielding;
    w_.factor = factor + change;
    recover();
    std::vector<Vec6> rates = w_.resisting;
    for (std::size_t i = 0; i < rates.size(); ++i) rates[i] = (rates[i] - now[i]) / change;
    w_.factor = factor;
    recover();
    w_.yielding = yielding;
    return rates;
}

// ---- equilibrium ------------------------------------------------------------------------------------------------

void StaticForces::recover() {
    stages_.timed(recover_stage_, [&] {
        for (Vec6& n : w_.resisting) n.setZero();
        for (const auto& heater : problem_.effects.heaters) heater->heat_at(w_.factor);
        find_fixed_ends(w_, problem_.effects, w_.factor);
        w_.assembly.run(w_.state, w_.trial, w_.resisting, w_.force, w_.yielding);
        add_resistance_of_effects();
        if (follow_) find_loads();
        if (w_.constraints) {
            w_.constraints->renew();
            w_.constraints->balance([this](int n) { return load(std::size_t(n), w_.factor); });
        }
    });
}

Vec6 StaticForces::out_of_balance(std::size_t node) const {
    return problem_.without_supported(node, load(node, w_.factor) - w_.resisting[node]);
}

StaticForces::Residual StaticForces::residual() const {
    double r = 0, s = 0;
    for (std::size_t i = 0; i < w_.resisting.size(); ++i) {
        const Vec6 acts = load(i, w_.factor);
        for (int c = 0; c < 6; ++c) {
            const double unit = c < 3 ? 1 : 1 / problem_.mean_length, f = acts[c];
            if (!(problem_.held[i] >> c & 1)) r += std::pow(unit * (f - w_.resisting[i][c]), 2);
            s += std::pow(unit * f, 2) + std::pow(unit * w_.resisting[i][c], 2);
        }
    }
    return {std::sqrt(r), std::sqrt(s)};
}

void StaticForces::find_reactions(double factor) {
    for (std::size_t i = 0; i < problem_.held.size(); ++i) {
        if (!problem_.held[i]) continue;
        const Vec6 acts = load(i, factor);
        Vec6& r = w_.reaction[int(i)];
        for (int c = 0; c < 6; ++c) r[c] = problem_.held[i] >> c & 1 ? w_.resisting[i][c] - acts[c] : 0;
    }
}

/// The best fit of the loads to the internal forces.
double StaticForces::factor_at_start() const {
    constexpr double accuracy = 1e-4;  // of the internal forces: what a run that has converged leaves is less
    double loads = 0, both = 0, internal = 0;
    for (std::size_t i = 0; i < w_.external.size(); ++i) {
        const Vec6 load = problem_.without_supported(i, w_.external[i]),
                   r = problem_.without_supported(
                       i, w_.resisting[i] - (w_.held.empty() ? Vec6(Vec6::Zero()) : w_.held[i]));
        for (int c = 0; c < 6; ++c) {
            const double unit = c < 3 ? 1 : std::pow(problem_.mean_length, -2);
            loads += unit * load[c] * load[c], both += unit * load[c] * r[c], internal += unit * r[c] * r[c];
        }
    }
    if (!(loads > 0)) return 0;
    const double missing = internal - both * both / loads;
    return missing <= accuracy * accuracy * internal ? both / loads : 0;
}

/// By the mean load factor of the step. Of weights, the part that the load factor has not reached yet is held back.
void StaticForces::add_work(double begun, double& work) const {
    const double mean = 0.5 * (begun + w_.factor);
    for (std::size_t i = 0; i < w_.external.size(); ++i) {
        const Vec3 du = w_.trial.displacement[i] - w_.state.displacement[i], turned = w_.rotation_step[i];
        const auto on = [&](const Vec6& load) { return load.head<3>().dot(du) + load.tail<3>().dot(turned); };
        work += mean * on(w_.external[i]) - on(potential_[i]);
        if (!w_.held.empty()) work += on(w_.held[i]);
        if (support_rates_.empty() || support_rates_[i].isZero(0)) continue;
        const Vec6 before = w_.reaction[int(i)], now = w_.resisting[i] - load(i, w_.factor);
        for (int c = 0; c < 6; ++c)
            if (support_rates_[i][c] != 0) work += 0.5 * (before[c] + now[c]) * (c < 3 ? du[c] : turned[c - 3]);
    }
}

}  // namespace hinge

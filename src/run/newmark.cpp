#include "run/newmark.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/stable_step.h"
#include "core/rotation.h"
#include "effects/all_effects.h"
#include "run/effect_forces.h"
#include "run/step_size.h"
#include "run/yield_tangents.h"
#include "state/nodes.h"
#include "state/rotate.h"

namespace hinge {
namespace {

/// Part of the elastic stiffness by which a plastic tangent may differ from the one in the effective stiffness, in
/// short steps: inertia rules there, and one solution a step does not see the difference. In the first 0.06 s of Case I
/// of the ten-storey impact 0, 0.05, 0.2 and 0.8 rebuild 296,000, 34,000, 18,000 and 15,000 elements, all with 37,300
/// to 37,400 iterations of conjugate gradients and an energy error of 0.002 to 0.003 % of the energy. In tests/hard,
/// with 1/4 to 1/64 of a scene's step, it grows by up to 0.3 % at 0.4 and by up to 8 % at 0.8 and above.
constexpr double same_tangent = 0.2;

/// The same in Newton's method, which still converges quadratically with it. A frame of 300 members of which 15 flow
/// builds 48 elements a step, 74 at 0 and 20 at 0.002, with 3.1 solutions each time. From 1e-5 on, members that are not
/// damped change a sway by 1e-7 (elastic_damping_test).
constexpr double same_in_newton = 1e-6;

/// A change of the velocities by this part of themselves is rounding: at rest or in free flight there is nothing to
/// solve. A thousand times the rounding of one number, since some thousand are summed up. Twenty members in flight take
/// 6 iterations of conjugate gradients a step without it, 2 at 3e-15 and 3e-14, one at 3e-13; tests/hard takes a tenth
/// more without it. More is paid for in momentum: the whipping chain of tests/hard loses 2e-13 of it, 1e-11 at 3e-12,
/// 2e-9 at 3e-9.
constexpr double velocity_rounding = 3e-13;

/// Whether a and b differ by no more than `part` of the elastic stiffness k, entry by entry.
bool near(const Mat6& a, const Mat6& b, const beam::Stiffness& k, double part) {
    if (part == 0) return false;
    const Mat6 e = k.matrix();
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 6; ++i)
            if (std::abs(a(i, j) - b(i, j)) > part * std::sqrt(e(i, i) * e(j, j))) return false;
    return true;
}

/// Whether steps are longer than damping lets a velocity be predicted with the acceleration held: the force of damping
/// would fling it. Elements of which inertia alone is the faster are left to axial_courant_number: a half tells the two
/// apart. In 15 runs of a cantilever (2 to 50 % of critical, 100 to 20,000 steps a period) parts from 0.1 to 2 made no
/// difference; without the rule one run failed, and the energy errors of five others rose from below 1e-9 of the
/// energy, one to 2e-3.
bool damped_stiffly(const Structure& structure, double dt) {
    const std::vector<ElementDamping> damping = damping_of(structure);
    if (damping.empty()) return false;
    const double damped = stable_step(structure, damping).dt;
    return dt > damped && damped < 0.5 * stable_step(structure).dt;
}

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

Newmark::Newmark(Workspace& w, KeptMass& mass, Stages& stages, const DynamicSettings& settings)
    : ImplicitIntegrator(w, mass, stages, w.scheme),
      settings_(settings),
      iterations_(settings.iterations),
      tolerance_(settings.tolerance) {
    displacement_predictor_ =
        settings.predictor == Predictor::displacement ||
        (settings.predictor == Predictor::by_step &&
         (axial_courant_number(w.structure, settings.dt) > 1 || damped_stiffly(w.structure, settings.dt)));
    const bool can_yield = built::plasticity && w.structure.can_yield();
    if (iterations_ == 0) {
        const bool newton = displacement_predictor_ && (can_yield || w.structure.large());
        iterations_ = newton ? 30 : 1;
        if (newton) tolerance_ = std::max(tolerance_, 1e-6);
    }
    if (iterations_ == 1) w.assembly.set_return_tolerance(one_solution);
    if (can_yield) yield_stage_ = stages.add("yield");
    stiffness_stage_ = stages.add("stiffness");
    solve_stage_ = stages.add("solve");
    correct_stage_ = stages.add("correct");
    const std::size_t nodes = w.structure.position().size();
    lumped_.assign(nodes, 0);
    for (const Vec3& x : w.structure.position()) rounding_ = std::max(rounding_, x.cwiseAbs().maxCoeff());
    rounding_ *= 4 * std::numeric_limits<double>::epsilon() * std::sqrt(double(nodes));
    for (const Element& e : w.structure.elements())
        for (int n : e.node) lumped_[n] += 0.5 * e.mass();
}

/// A run from the start: script's velocities are those of nodes with mass.
void Newmark::prepare(const EffectList& effects) {
    if (w_.state.time != 0 || !may_be_massless(w_.structure)) return;
    find_massless();
    condense_velocities(massless_, w_.structure, w_.constraints ? &w_.constraints->reduction() : nullptr,
                        added_blocks(effects, w_.state, 0), w_.pool, w_.state);
}

void Newmark::begin(const EffectList& effects) {
    const bool bends = any_of(effects.forces, &Force::blocks_follow);
    if (settings_.iterations == 0 && displacement_predictor_ && bends)
        iterations_ = 30, tolerance_ = std::max(tolerance_, 1e-6);
    w_.solved_at_once = displacement_predictor_ && iterations_ == 1;
    massless_changes_ = effects.any(&EffectTraits::forces_vanish) && may_be_massless(w_.structure);
    const MatrixStorage storage = settings_.solver.direct ? MatrixStorage::direct
                                  : settings_.single_precision && !displacement_predictor_ && massless_.empty()
                                      ? MatrixStorage::single_precision
                                      : MatrixStorage::iterative;
    make_effective_stiffness(effects, settings_.dt, settings_.geometric && w_.structure.large(), storage);
    if (w_.structure.large()) w_.assembly.watch_rotation(settings_.rebuild_angle);
}

/// Forces that set in at once move what is massless within the next step. Half of what they do there is stored.
void Newmark::start_from_forces() {
    if (!may_be_massless(w_.structure)) return;
    find_massless();
    loose_ = w_.external;
    for (std::size_t n = 0; n < loose_.size(); ++n) loose_[n] -= w_.resisting[n];
    keep_massless(massless_, loose_);
}

/// Where the step is solved from. Short steps: du = dt v + dt^2/2 a, the acceleration held. Long ones, over which the
/// fastest waves cross an element and a held acceleration would fling it: du = 0, which is eq 15 as printed.
void Newmark::predict(const Step& step) {
    if (massless_changes_) find_massless();
    const double dt = step.dt, beta = w_.scheme.beta, alpha = w_.scheme.alpha;
    const State& s = w_.state;
    Configuration& trial = w_.trial;
    if (displacement_predictor_) {
        for (std::size_t i = 0; i < w_.rotation_step.size(); ++i) {
            trial.displacement[i] = s.displacement[i];
            w_.rotation_step[i].setZero();
            trial.acceleration[i] = -1 / (beta * dt) * s.velocity[i] - (0.5 - beta) / beta * s.acceleration[i];
            trial.velocity[i] = s.velocity[i] + w_.scheme.velocity_change(s.acceleration[i], trial.acceleration[i], dt);
            if (alpha != 0) trial.acceleration[i] = w_.scheme.weighted(s.acceleration[i], trial.acceleration[i]);
        }
        return move_to_rotated(0, int(w_.rotation_step.size()));
    }
    w_.pool.share(int(w_.rotation_step.size()), some_nodes, [&](int first, int end, int) {
        w_.for_awake(first, end, [&](int from, int to) {
            for (int i = from; i < to; ++i) {
                const Lanes v = load_row<6>(s.velocity[i].data()), a = load_row<6>(s.acceleration[i].data());
                const Lanes move = dt * v + (0.5 * dt * dt) * a;
                store_row<3>(trial.displacement[i].data(), load_row<3>(s.displacement[i].data()) + move);
                store_row<3>(w_.rotation_step[i].data(), second_three(move));
                store_row<6>(trial.velocity[i].data(), v + dt * a);
                store_row<6>(trial.acceleration[i].data(), a);
            }
            move_to_rotated(from, to);
        });
    });
}

/// With du = 0: takes the supports back to where the step begins, as all nodes are, and notes the way that is left.
/// Their velocities and accelerations are those of the end: inertia and damping are linear in them.
void Newmark::prescribed(const Step&) {
    ways_.clear();
    if (!displacement_predictor_ || effects_->prescribers.empty()) return;
    std::vector<DegreeOfFreedom> list;
    for (const auto& p : effects_->prescribers) p->list_prescribed(list);
    for (const auto& [node, c] : list) {
        if (c >= 3) {
            ways_.push_back({{node, c}, w_.rotation_step[node][c - 3]});
            w_.rotation_step[node][c - 3] = 0;
            move_to_rotated(node, node + 1);
            continue;
        }
        double &u = w_.trial.displacement[node][c], before = w_.state.displacement[node][c];
        ways_.push_back({{node, c}, u - before});
        u = before;
    }
}

/// Where nothing has moved yet, what flowed is taken to flow on.
void Newmark::recovered(const Step& step) {
    if (displacement_predictor_ && step.iteration == 0) w_.yielding = hinges_;
}

/// One solution from du = 0: the reactions that it started from are those of the step before.
void Newmark::recovered_last() {
    if (yield_stage_ >= 0) mark_yielding(false);
    if (iterations_ == 1) take_reactions([&](int n, int c) { return w_.resisting[n][c] - w_.external[n][c]; });
}

void Newmark::solve(Step& step) {
    if (yield_stage_ >= 0) stages_.timed(yield_stage_, [&] { mark_yielding(iterations_ > 1 && step.iteration == 0); });
    stages_.timed(stiffness_stage_, [&] { renew_effective_stiffness(); });
    stages_.timed(solve_stage_, [&] { solve_for_change(step); });
}

/// Which elements flow: their effective stiffness takes [D_p] (eq 10a); those that stopped go back to [D_e]. A [D_p]
/// that has hardly changed stays, and so does that of the last step where nothing has moved yet (`begins`).
void Newmark::mark_yielding(bool begins) {
    const std::vector<PlasticIncrement>& yielding = w_.yielding;
    tangents_.clear();
    for (const PlasticIncrement& y : yielding)
        tangents_.push_back(damped_.with_damping(yield_tangent(w_.structure, w_.state, w_.trial, w_.assembly, y), y));
    std::size_t next = 0;
    for (int e : was_yielding_) {
        while (next < yielding.size() && yielding[next].element < e) ++next;
        const bool flows_on = next < yielding.size() && yielding[next].element == e;
        if (!flows_on && !w_.state.broken[e]) stiffness_changed(e), built_.erase(e);
    }
    was_yielding_.clear();
    for (std::size_t i = 0; i < yielding.size(); ++i) {
        const int e = yielding[i].element;
        was_yielding_.push_back(e);
        const double same = displacement_predictor_ || iterations_ > 1 ? same_in_newton : same_tangent;
        const auto there = built_.find(e);
        if (begins && there != built_.end()) continue;
        if (there == built_.end() || !near(tangents_[i], there->second, stiffness_now(w_.structure, w_.state, e), same))
            stiffness_changed(e);
    }
}

/// Rebuilds M + beta dt^2 K for the elements that rotated, yielded or broke.
void Newmark::renew_effective_stiffness() {
    if (!rebuild_.empty()) {
        sort_rebuild();
        std::vector<ElementTangent> given =
            given_tangents(w_.structure, w_.state, w_.trial, w_.assembly, rebuild_, w_.yielding);
        damped_.add(given);
        for (std::size_t i = 0; i < tangents_.size(); ++i)
            if (const int e = w_.yielding[i].element; is_to_be_built(e)) built_[e] = tangents_[i];
        w_.force.swap(w_.state.force);  // the tangent's initial-stress part reads the forces of now
        build(w_.trial, given);
        w_.force.swap(w_.state.force);
        for (int e : rebuild_) {
            w_.assembly.mark_built(e, w_.state, w_.trial);
            if (mass_.now()) mass_.changed(e);
        }
        clear_rebuild();
    }
    effective_->assemble();
}

/// Eq 15: (M + beta dt^2 K) da = F - R - M a.
void Newmark::solve_for_change(Step& step) {
    const int nodes = int(w_.resisting.size());
    const Vec6 *external = w_.external.data(), *resisting = w_.resisting.data();
    Vec6* right = right_.data();
    const double check = w_.pool.sum(nodes, some_nodes, [external, resisting, right](int first, int end) {
        double sum = 0;
        for (int i = first; i < end; ++i) {
            right[i] = external[i] - resisting[i];
            sum += right[i].squaredNorm();
        }
        return sum;
    });
    if (!balance_supports(check, right_, step)) return;
    begin_fastest((nodes + some_nodes - 1) / some_nodes);
    motion_ = w_.pool.sum(nodes, some_nodes, [&](int first, int end) {
        double sum = 0;
        for (int i = first; i < end; ++i) {
            const double v2 = w_.trial.velocity[i].head<3>().squaredNorm();
            sum += lumped_[i] * v2;
            if (Fastest& most = fastest_of_[first / some_nodes]; v2 > most.speed) most = {v2, i, 0};
        }
        return sum;
    });
    note_fastest(step.end());
    if (step.iteration == 0 && !ways_.empty()) take_out_ways();
    SolverSettings solver = settings_.solver;
    solver.floor = motion_ * std::pow(velocity_rounding / step.dt, 2);
    const SolveReport report = effective_->solve(right_, change_, solver);
    if (!report.converged) step.failure = failure_of(solver, report);
}

/// K du of the supports' ways over the step, out of the right side of eq 15.
void Newmark::take_out_ways() {
    std::vector<Vec6> way(right_.size(), Vec6::Zero());
    for (const Way& w : ways_) way[w.of.node][w.of.component] = w.length;
    if (w_.constraints) w_.constraints->reduction().expand(way);
    effective_->subtract_stiffness(way, added_blocks(*effects_, w_.trial, 0), w_.state, w_.trial, right_);
    for (int n : w_.supported)
        for (int c = 0; c < 6; ++c)
            if (w_.state.held[n] >> c & 1) right_[n][c] = 0;
}

/// Adds what the change of the acceleration does over the step; decides whether Newton goes round again.
bool Newmark::correct(Step& step) {
    const double dt = step.dt, to_u = w_.scheme.to_displacement(dt), to_v = w_.scheme.to_velocity(dt),
                 to_a = 1 - w_.scheme.alpha;
    Configuration& trial = w_.trial;
    if (iterations_ > 1) {
        double whole = 0;
        for (const Vec6& c : change_) whole += c.head<3>().squaredNorm();
        damp_corrections(step.iteration, whole);
        if (damping_ < 1)
            for (Vec6& c : change_) c *= damping_;
    }
    const bool by_spin = displacement_predictor_ && w_.structure.large();
    if (by_spin) rotate_by_spins(to_u);
    Vec6 *a = trial.acceleration.data(), *v = trial.velocity.data();
    Vec3 *u = trial.displacement.data(), *rotation_by = w_.rotation_step.data();
    const Vec6* changes = change_.data();
    const double size =
        w_.pool.sum(int(change_.size()), some_nodes, [&, a, v, u, rotation_by, changes](int first, int end) {
            Lanes sum{};
            for (int i = first; i < end; ++i) {
                const Lanes change = load_row<6>(changes[i].data());
                store_row<6>(a[i].data(), load_row<6>(a[i].data()) + to_a * change);
                store_row<6>(v[i].data(), load_row<6>(v[i].data()) + to_v * change);
                store_row<3>(u[i].data(), load_row<3>(u[i].data()) + to_u * change);
                if (!by_spin)
                    store_row<3>(rotation_by[i].data(),
                                 load_row<3>(rotation_by[i].data()) + to_u * second_three(change));
                sum += change * change;
            }
            if (!by_spin) move_to_rotated(first, end);
            return sum[0] + sum[1] + sum[2];
        });
    if (settings_.automatic) {
        double jump = 0;
        for (std::size_t i = 0; i < change_.size(); ++i) jump += lumped_[i] * change_[i].head<3>().squaredNorm();
        jump_ = motion_ > 0 ? dt * std::sqrt(jump / motion_) : 0;
    }
    ++step.iteration;
    if (step.iteration == 1) first_change_ = size;
    if (to_u * std::sqrt(size) < rounding_ && rotates_by_rounding(to_u)) return false;  // at rest F - R is rounding
    // A last correction of a thousandth of the first is near enough: 251 of 273 runs of tests/hard keep their bounds
    // so, 246 if it must be 1e-4 of it, 254 if a hundredth will do. With step control a shorter step is nearer.
    const bool may_be_halved = settings_.controlled() && step.dt > settings_.dt / StepSize::fine_part;
    const double enough = may_be_halved ? 1e-10 : 1e-6;
    if (iterations_ > 1 && step.iteration == iterations_ && size > enough * first_change_ && first_change_ > 1e-12) {
        step.failure = {
            .cause = Cause::newton_not_converged, .value = std::sqrt(size / first_change_), .count = step.iteration};
    }
    return step.iteration < iterations_ && size > tolerance_ * tolerance_ * first_change_;
}

/// A long step rotates far: what was solved for is a spin on top of the rotation so far, not a part of it. A node that
/// is gone, without one, must not take up rounding.
void Newmark::rotate_by_spins(double to_u) {
    Configuration& trial = w_.trial;
    spin_.resize(change_.size()), rotated_.resize(change_.size());
    w_.pool.share(int(change_.size()), some_nodes, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) spin_[i] = to_u * change_[i].tail<3>();
        rotate_all(spin_, trial.rotation, rotated_, first, end);
        for (int i = first; i < end; ++i)
            if (!spin_[i].isZero(0)) trial.rotation[i] = rotated_[i];
        find_rotations(w_.state.rotation, trial.rotation, spin_, first, end);
        for (int i = first; i < end; ++i) {
            if (change_[i].tail<3>().isZero(0)) continue;
            change_[i].tail<3>() = (spin_[i] - w_.rotation_step[i]) / to_u;
            w_.rotation_step[i] = spin_[i];
        }
    });
}

/// Whether what the last correction rotates the nodes by is rounding.
bool Newmark::rotates_by_rounding(double to_u) const {
    double sum = 0;
    for (const Vec6& c : change_) sum += c.tail<3>().squaredNorm();
    return to_u * std::sqrt(sum) < 4 * std::numeric_limits<double>::epsilon() * std::sqrt(double(change_.size()));
}

/// Bossak: while a step is tried its acceleration is the weighted one of eq 15, (1 - alpha) a' + alpha a; it becomes
/// the one at the end of the step.
void Newmark::solved(const Step& step) {
    if (w_.scheme.alpha != 0) {
        w_.next_weighted = w_.trial.acceleration;
        for (std::size_t i = 0; i < w_.next_weighted.size(); ++i)
            w_.trial.acceleration[i] = w_.scheme.next_of_weighted(w_.state.acceleration[i], w_.next_weighted[i]);
    }
    if (!massless_.empty()) settle_massless(massless_, w_.state, step.dt, w_.rotation_step, w_.trial);
}

/// The work of the forces by the trapezium rule, less the change of the kinetic energy. With b and b' the weighted
/// accelerations, V = v + dv/2, dv = dt ((1 - gamma) a + gamma a') and du = dt V + dt^2 (beta - gamma/2) (a' - a) that
/// is dt V . M ((b + b')/2 - (1 - gamma) a - gamma a') + dt^2 (beta - gamma/2) (b + b')/2 . M (a' - a).
double Newmark::dissipated(const Step& step) const {
    double by_jumps = 0;
    for (std::size_t n = 0; n < loose_.size(); ++n)
        by_jumps += 0.5 * (loose_[n].head<3>().dot(w_.trial.displacement[n] - w_.state.displacement[n]) +
                           loose_[n].tail<3>().dot(w_.rotation_step[n]));
    if (w_.scheme.alpha == 0) return by_jumps;
    const double dt = step.dt, gamma = w_.scheme.gamma, c = dt * dt * (w_.scheme.beta - 0.5 * gamma);
    struct AtNode {
        Vec6 mean_velocity, lag, mean_weighted, rise;
    };
    const auto at = [&](int n) {
        const Vec6 &a = w_.state.acceleration[n], &next = w_.trial.acceleration[n];
        const Vec6 weighted = 0.5 * (w_.weighted[n] + w_.next_weighted[n]);
        const Vec6 rate = (1 - gamma) * a + gamma * next;
        return AtNode{dt * (w_.state.velocity[n] + 0.5 * dt * rate), weighted - rate, c * weighted, next - a};
    };
    double sum = by_jumps;
    for (std::size_t i = 0; i < w_.structure.elements().size(); ++i) {
        if (w_.state.broken[i]) continue;
        const Element& e = w_.structure.elements()[i];
        const AtNode one = at(e.node[0]), two = at(e.node[1]);
        const Vec6 v[2] = {one.mean_velocity, two.mean_velocity}, lag[2] = {one.lag, two.lag},
                   weighted[2] = {one.mean_weighted, two.mean_weighted}, rise[2] = {one.rise, two.rise};
        const Mat3 to_element = axes_of(element_frame(w_.structure, int(i), w_.trial)).transpose();
        const beam::Inertia& m = w_.structure.inertia(int(i));
        sum += through_mass(m, to_element, v, lag) + through_mass(m, to_element, weighted, rise);
    }
    for (std::size_t i = 0; i < w_.state.offset_mass.size(); ++i) {
        if (w_.state.offset_mass[i].mass == 0) continue;
        const AtNode n = at(int(i));
        const Mat6 m = offset_mass_in_space(w_.state.offset_mass[i], w_.trial.rotation[i]);
        sum += n.mean_velocity.dot(m * n.lag) + n.mean_weighted.dot(m * n.rise);
    }
    return sum;
}

void Newmark::find_massless() {
    massless_ = massless_nodes(w_.structure, w_.state, w_.constraints ? &w_.constraints->reduction() : nullptr);
}

void Newmark::before_commit() {
    if (w_.scheme.alpha != 0) w_.weighted.swap(w_.next_weighted);
}

void Newmark::after_commit() {
    if (displacement_predictor_) hinges_ = flowing_on(w_.yielding);
    loose_.clear();
}

template <class Self, class A>
void Newmark::fields(Self& s, A& a) {
    a(s.fastest, s.jump_, s.motion_, s.change_, s.hinges_, s.was_yielding_, s.built_, s.rebuild_, *s.effective_);
}

void Newmark::save(Writer& to) const { fields(*this, to); }

void Newmark::restore(Reader& from) {
    fields(*this, from);
    bool good = change_.size() == lumped_.size() && are_elements(was_yielding_) && are_elements(rebuild_);
    for (const PlasticIncrement& y : hinges_) good = good && are_elements({y.element});
    from.must(good && fastest.node < int(lumped_.size()));
    rebuild_was_read();
}

}  // namespace hinge

#include "run/energy_momentum.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/cayley.h"
#include "effects/all_effects.h"
#include "run/yield_tangents.h"
#include "state/node_mass.h"
#include "state/nodes.h"

namespace hinge {
namespace {

constexpr int some_elements = 64;  ///< that one thread takes at a time

/// Newton is also done where the energy of a correction is what rounding of the positions makes: a strain of some
/// 1e-15, of the model's extent; or `barely` times that where it gets no better.
constexpr double energy_rounding = 1e-30, barely = 1e4;
/// Products that change by less in a step (the sum of their squares) need no correction: their work is exact to
/// rounding.
constexpr double least_way = 1e-14;
/// With a finer tolerance a last correction of 1e-8 of the first is near enough; one that has grown a million times
/// leads nowhere. Both squared.
constexpr double near_enough = 1e-16, lost = 1e12;
/// Newton that goes slowly gets every element's stiffness anew after so many iterations.
constexpr int all_anew = 6;

}  // namespace

EnergyMomentum::EnergyMomentum(Workspace& w, KeptMass& mass, Stages& stages, const DynamicSettings& settings)
    : ImplicitIntegrator(w, mass, stages, {0.25, 0.5, 0}),
      settings_(settings),
      most_iterations_(settings.iterations ? settings.iterations : 40),
      tolerance_(settings.tolerance) {
    forces_stage_ = stages.add("mean forces");
    stiffness_stage_ = stages.add("stiffness");
    solve_stage_ = stages.add("solve");
    correct_stage_ = stages.add("correct");
    const std::size_t nodes = w.structure.position().size(), elements = w.structure.elements().size();
    for (std::vector<Vec6>* list : {&held_by_effects_, &load_, &internal_, &momentum_})
        list->assign(nodes, Vec6::Zero());
    first_.resize(elements);
    of_element_.assign(elements, Vec12::Zero());
    has_turned_.assign(elements, 0);
    built_.assign(elements, Mat3::Zero());
    middle_ = w.trial;
    find_node_inertia();
}

void EnergyMomentum::find_node_inertia() {
    rotary_.assign(w_.structure.position().size(), Mat3::Zero());
    mass_of_.resize(w_.structure.elements().size());
    for (std::size_t i = 0; i < w_.structure.elements().size(); ++i) {
        if (w_.state.broken[i]) continue;
        const Element& e = w_.structure.elements()[i];
        const beam::Inertia& m = w_.structure.inertia(int(i));
        mass_of_[i] = {{m.own[0], m.own[1]}, m.across};
        const Mat3 axes = e.axes.toRotationMatrix();
        for (int end : {0, 1}) rotary_[e.node[end]] += axes * m.rotary[end].asDiagonal() * axes.transpose();
    }
}

void EnergyMomentum::begin(const EffectList& effects) {
    make_effective_stiffness(effects, settings_.dt, settings_.geometric,
                             settings_.solver.direct ? MatrixStorage::direct : MatrixStorage::iterative);
}

/// What acts where a step begins, after the acceleration was found there.
void EnergyMomentum::start_from_forces() {
    held_by_effects_ = w_.resisting;
    load_ = w_.external;
    for (std::size_t i = 0; i < internal_.size(); ++i) w_.resisting[i] += internal_[i];
}

// ---- elements ------------------------------------------------------------------------------------------------------

EnergyMomentum::AtEnd EnergyMomentum::at_end(int index, const Pose& at) const {
    const Element& e = w_.structure.elements()[index];
    AtEnd end;
    end.place = element_frame(w_.structure, index, at);
    end.chord = chord_of(e, at.displacement);
    for (int i : {0, 1}) end.axes[i] = (at.rotation[e.node[i]] * e.axes).toRotationMatrix();
    end.d = element_deformation(w_.structure, index, at, end.place);
    const double L = e.length;
    const Mat3 &n = end.axes[0], &m = end.axes[1];
    const Vec3 x = end.chord / L;
    end.s[0] = 0.5 * x.squaredNorm();
    end.s.segment<3>(1) = n.transpose() * x;
    end.s.segment<3>(4) = m.transpose() * x;
    for (int i = 0; i < 3; ++i) end.s.segment<3>(7 + 3 * i) = m.transpose() * n.col(i);
    return end;
}

/// (dd/ds)^T p: forces on the products of an end that do the work of p. Of all that do, those of the least norm: as if
/// the deformation did not change where the products leave those of a real element. With y the derivatives by chord/L
/// and by the spin of node 2 against node 1, which tell all, and J theirs of the products, that is J (J^T J)^-1 times
/// what p does on y: the forces on node 2. The directions of an axis system add up to 1, so J^T J has the inverse
/// below.
EnergyMomentum::Products EnergyMomentum::on_products(const AtEnd& end, double L, const Vec6& p) {
    Vec3 f, g;
    if (end.place.wound) {
        const Vec6 on_2 = (beam::rates(*end.place.wound).transpose() * p).tail<6>();
        f = on_2.head<3>(), g = on_2.tail<3>();
    } else {
        const beam::NodalForces<double> on = beam::nodal_forces(end.place, p.data());
        f = {on.force[1].x, on.force[1].y, on.force[1].z};
        g = {on.moment[1].x, on.moment[1].y, on.moment[1].z};
    }
    f *= L;
    const Vec3 x = end.chord / L;
    const double q = x.squaredNorm(), fx = f.dot(x) / q, gx = g.dot(x) / q;
    const Vec3 f_across = f - fx * x, g_across = g - gx * x;
    const Vec3 b_across = (2 * g_across + x.cross(f_across)) / (4 + q);
    const Vec3 a = fx / (2 + q) * x + 0.5 * (f_across - x.cross(b_across)), b = 0.5 * gx * x + b_across;
    const Mat3 &n = end.axes[0], &m = end.axes[1];
    Products on;
    on[0] = x.dot(a);
    on.segment<3>(1) = n.transpose() * a;
    on.segment<3>(4) = m.transpose() * (a + x.cross(b));
    for (int i = 0; i < 3; ++i) on.segment<3>(7 + 3 * i) = m.transpose() * n.col(i).cross(b);
    return on;
}

/// Where the step begins.
void EnergyMomentum::begin_elements() {
    w_.pool.share(int(first_.size()), some_elements, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            if (w_.state.broken[i]) continue;
            first_[i] = at_end(i, w_.state);
            first_[i].p = stiffness_now(w_.structure, w_.state, i).times(first_[i].d - w_.state.plastic[i]);
        }
    });
    for (int i = 0; w_.structure.p_delta() && i < int(first_.size()); i += 2) {
        const Vec12 beyond =
            elastic_pair(w_.structure, w_.state, i, no_heat)
                .forces_beyond(first_[i].d - w_.state.plastic[i], first_[i + 1].d - w_.state.plastic[i + 1]);
        for (int k : {0, 1}) first_[i + k].p += beyond.segment<6>(6 * k);
    }
}

/// What the strain energy of a pair whose bending follows N and its hinges take in beyond mean p . dd of its elements:
/// their law is not linear.
double EnergyMomentum::work_beyond_means(int first, const AtEnd (&b)[2]) const {
    Vec6 before[2], after[2];
    double work = 0;
    for (int k : {0, 1}) {
        const int i = first + k;
        const auto at = std::lower_bound(w_.yielding.begin(), w_.yielding.end(), i,
                                         [](const PlasticIncrement& y, int element) { return y.element < element; });
        const bool flows = at != w_.yielding.end() && at->element == i;
        const Vec6 flow = flows ? at->flow.plastic : Vec6(Vec6::Zero()), p = 0.5 * (first_[i].p + w_.force[i]);
        before[k] = first_[i].d - w_.state.plastic[i];
        after[k] = b[k].d - w_.state.plastic[i] - flow;
        const beam::Stiffness stiffness = stiffness_now(w_.structure, w_.state, i);
        work += 0.5 * (after[k].dot(stiffness.times(after[k])) - before[k].dot(stiffness.times(before[k]))) -
                p.dot(after[k] - before[k]);
    }
    const beam::ElasticPair pair = elastic_pair(w_.structure, w_.state, first, no_heat);
    return work + pair.energy_beyond(after[0], after[1]) - pair.energy_beyond(before[0], before[1]);
}

/// Work of the mean axial force on the slack of an element in the step, J: it is neither stored nor dissipated.
double EnergyMomentum::work_on_slack(int index) const {
    if (w_.yielding.empty()) return 0;
    const auto at = std::lower_bound(w_.yielding.begin(), w_.yielding.end(), index,
                                     [](const PlasticIncrement& y, int element) { return y.element < element; });
    if (at == w_.yielding.end() || at->element != index) return 0;
    return 0.5 * (first_[index].p[4] + w_.force[index][4]) * at->flow.slack;
}

/// Mean forces of an element over the step, on its nodes.
Vec12 EnergyMomentum::mean_forces(int index, const AtEnd& b, double beyond) const {
    const AtEnd& a = first_[index];
    const double L = w_.structure.elements()[index].length;
    const Vec6 p = 0.5 * (a.p + w_.force[index]);
    const Products way = b.s - a.s;
    Products on = 0.5 * (on_products(a, L, p) + on_products(b, L, p));
    // what strain energy and hinges take in, U' - U + p . dd_p, p the mean: p . dd, and where p is not linear in d what
    // is beyond that
    const double work = p.dot(b.d - a.d) + beyond, square = way.squaredNorm();
    if (square > least_way) on += (work - on.dot(way)) / square * way;
    const Vec3 x = 0.5 * (a.chord + b.chord) / L;
    const Mat3 n = 0.5 * (a.axes[0] + b.axes[0]), m = 0.5 * (a.axes[1] + b.axes[1]);
    const Vec3 on_n = on.segment<3>(1), on_m = on.segment<3>(4);
    Mat3 between;
    for (int i = 0; i < 3; ++i) between.row(i) = on.segment<3>(7 + 3 * i).transpose();
    const Vec3 force = (on[0] * x + n * on_n + m * on_m) / L;
    const Mat3 at_n = x * on_n.transpose() + m * between.transpose(), at_m = x * on_m.transpose() + n * between;
    Vec3 moment_n = Vec3::Zero(), moment_m = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        moment_n += n.col(i).cross(at_n.col(i));
        moment_m += m.col(i).cross(at_m.col(i));
    }
    Vec12 f;
    f << -force, moment_n, force, moment_m;
    return f;
}

void EnergyMomentum::find_elements_forces() {
    if (!w_.structure.p_delta()) {
        w_.pool.share(int(first_.size()), some_elements, [&](int first, int end, int) {
            for (int i = first; i < end; ++i)
                if (!w_.state.broken[i]) of_element_[i] = mean_forces(i, at_end(i, w_.trial), -work_on_slack(i));
        });
        return;
    }
    w_.pool.share(int(first_.size() / 2), some_elements, [&](int first, int end, int) {
        for (int pair = first; pair < end; ++pair) {
            const int i = 2 * pair;
            const AtEnd b[2] = {at_end(i, w_.trial), at_end(i + 1, w_.trial)};
            const double way[2] = {(b[0].s - first_[i].s).squaredNorm(), (b[1].s - first_[i + 1].s).squaredNorm()};
            const double beyond = way[0] + way[1] > 0 ? work_beyond_means(i, b) / (way[0] + way[1]) : 0;
            for (int k : {0, 1}) of_element_[i + k] = mean_forces(i + k, b[k], beyond * way[k] - work_on_slack(i + k));
        }
    });
}

// ---- a step --------------------------------------------------------------------------------------------------------

/// Momentum of a node and its angular momentum about itself, N s and N m s: of its rotary inertia and what is attached
/// to it, and of its elements' mass.
Vec6 EnergyMomentum::momentum_of(int node, const std::vector<Vec6>& velocity, const Quat& rotation) const {
    Vec6 p;
    Vec3 linear = Vec3::Zero();
    for (int index : w_.structure.elements_at(node)) {
        if (w_.state.broken[index]) continue;
        const Element& e = w_.structure.elements()[index];
        const int end = e.node[0] == node ? 0 : 1;
        const TranslationalMass& m = mass_of_[index];
        linear += m.own[end] * velocity[node].head<3>() + m.across * velocity[e.node[1 - end]].head<3>();
    }
    p << linear, rotation * (rotary_[node] * (rotation.conjugate() * Vec3(velocity[node].tail<3>())));
    if (!w_.state.offset_mass.empty() && w_.state.offset_mass[node].mass > 0)
        p += offset_mass_in_space(w_.state.offset_mass[node], rotation) * velocity[node];
    return p;
}

/// The velocities held.
void EnergyMomentum::predict(const Step& step) {
    const State& s = w_.state;
    step_ = step.dt;
    for (std::size_t i = 0; i < w_.rotation_step.size(); ++i) {
        w_.trial.displacement[i] = s.displacement[i] + step.dt * s.velocity[i].head<3>();
        w_.rotation_step[i] = step.dt * s.velocity[i].tail<3>();
        w_.trial.rotation[i] = cayley_turned(w_.rotation_step[i], s.rotation[i]);
        w_.trial.velocity[i] = s.velocity[i];
        w_.trial.acceleration[i].setZero();
        momentum_[i] = momentum_of(int(i), s.velocity, s.rotation[i]);
    }
    begin_elements();
    floor_ = 0;
    for (std::size_t i = 0; i < first_.size(); ++i) {
        if (s.broken[i]) continue;
        const Element& e = w_.structure.elements()[i];
        const Vec3 at = w_.structure.position()[e.node[0]] + s.displacement[e.node[0]];
        floor_ += energy_rounding * e.rigidity.EA * (e.length + at.squaredNorm() / e.length);
    }
    for (const auto& f : effects_->forces) floor_ += energy_rounding * f->scale_of_rounding(s);
    for (std::size_t i = 0; i < momentum_.size(); ++i)
        floor_ += energy_rounding * std::abs(momentum_[i].dot(s.velocity[i]));
}

/// Elements' forces are not those of the end of the step: effects alone add theirs to what resists.
void EnergyMomentum::recovered(const Step&) {
    internal_ = w_.resisting;
    for (Vec6& r : w_.resisting) r.setZero();
}

void EnergyMomentum::solve(Step& step) {
    stages_.timed(forces_stage_, [&] { find_elements_forces(), find_out_of_balance(step); });
    if (step.failure) return;
    stages_.timed(stiffness_stage_, [&] { mark_changed(step.iteration), renew_effective_stiffness(); });
    stages_.timed(solve_stage_, [&] {
        SolverSettings solver = settings_.solver;
        const SolveReport report = effective_->solve(right_, change_, solver);
        if (!report.converged) step.failure = failure_of(solver, report);
    });
    size_ = 0;
    for (std::size_t i = 0; i < right_.size(); ++i) size_ += right_[i].dot(change_[i]);
    size_ *= 0.5 * step.dt * step.dt;
}

/// F - f - (p' - p)/dt of each node (eq 15 for the means over a step), and the supports' reactions.
void EnergyMomentum::find_out_of_balance(Step& step) {
    const State& s = w_.state;
    const double dt = step.dt;
    const int nodes = int(right_.size());
    const double check = w_.pool.sum(nodes, some_nodes, [&](int first, int end) {
        double sum = 0;
        for (int i = first; i < end; ++i) {
            const Vec6 after = momentum_of(i, w_.trial.velocity, w_.trial.rotation[i]);
            Vec6 r = 0.5 * (load_[i] + w_.external[i]) - 0.5 * (held_by_effects_[i] + w_.resisting[i]) -
                     (after - momentum_[i]) / dt;
            if (!s.offset_mass.empty() && s.offset_mass[i].mass > 0) {
                const auto of_arm = [&](const std::vector<Vec6>& velocity, const Quat& rotation) -> Vec3 {
                    return velocity[i].tail<3>().cross(rotation * s.offset_mass[i].moment);
                };
                const Vec3 v = 0.5 * (s.velocity[i] + w_.trial.velocity[i]).head<3>();
                r.tail<3>() -= v.cross(
                    0.5 * (of_arm(s.velocity, s.rotation[i]) + of_arm(w_.trial.velocity, w_.trial.rotation[i])));
            }
            for (int e : w_.structure.elements_at(i))
                if (!s.broken[e]) r -= of_element_[e].segment<6>(w_.structure.elements()[e].node[0] == i ? 0 : 6);
            right_[i] = r;
            sum += r.squaredNorm();
        }
        return sum;
    });
    if (!balance_supports(check, right_, step)) return;
    begin_fastest(1);
    for (int i = 0; i < nodes; ++i)
        if (const double v2 = w_.trial.velocity[i].head<3>().squaredNorm(); v2 > fastest_of_[0].speed)
            fastest_of_[0] = {v2, i, 0};
}

/// Elements of which the effective stiffness is to be built anew: at the middle of the step.
void EnergyMomentum::mark_changed(int iteration) {
    for (std::size_t i = 0; i < middle_.displacement.size(); ++i) {
        middle_.displacement[i] = 0.5 * (w_.state.displacement[i] + w_.trial.displacement[i]);
        Quat half = w_.state.rotation[i];
        const Quat& end = w_.trial.rotation[i];
        const double side = half.dot(end) < 0 ? -1 : 1;
        half.coeffs() += side * end.coeffs();
        half.normalize();
        middle_.rotation[i] = half;
    }
    middle_.twist = w_.trial.twist, middle_.turned = w_.trial.turned;
    for (int e : flowing_)
        if (!w_.state.broken[e]) stiffness_changed(e);
    const double limit = settings_.rebuild_angle * settings_.rebuild_angle;
    const bool all = iteration > 0 && iteration % all_anew == 0;
    w_.pool.share(int(built_.size()), some_elements, [&](int first, int end, int) {
        for (int i = first; i < end; ++i)
            has_turned_[i] =
                !w_.state.broken[i] && !is_to_be_built(i) &&
                (all || (axes_of(element_frame(w_.structure, i, middle_)) - built_[i]).squaredNorm() > 2 * limit);
    });
    for (std::size_t i = 0; i < built_.size(); ++i)
        if (has_turned_[i]) stiffness_changed(int(i));
}

void EnergyMomentum::renew_effective_stiffness() {
    flowing_.clear();
    for (const PlasticIncrement& y : w_.yielding) flowing_.push_back(y.element), stiffness_changed(y.element);
    if (!rebuild_.empty()) {
        sort_rebuild();
        std::vector<ElementTangent> given =
            given_tangents(w_.structure, w_.state, w_.trial, w_.assembly, rebuild_, w_.yielding);
        damped_.add(given);
        // the tangent's initial-stress part reads the forces of the state: those where the step begins, since a first
        // iteration stretches what rotates far by more than Newton can take
        build(middle_, given);
        for (int e : rebuild_) built_[e] = axes_of(element_frame(w_.structure, e, middle_));
        clear_rebuild();
    }
    effective_->assemble();
}

/// Adds the change to where the step ends; decides whether Newton goes round again.
bool EnergyMomentum::correct(Step& step) {
    const double before = last_size_;
    damp_corrections(step.iteration, std::abs(size_));
    const double dt = step.dt, part = 0.5 * dt * dt * damping_;
    const State& s = w_.state;
    for (std::size_t i = 0; i < change_.size(); ++i) {
        // what is solved for is a motion at the middle of the step, which goes on to its end: v + c x v' / 2 = v'
        Vec3 move = part * change_[i].head<3>();
        if (!(s.held[i] & 7)) {
            const Vec3 half = 0.5 * w_.rotation_step[i], once = half.cross(move);
            move += (once + half.cross(once)) / (1 + half.squaredNorm());
        }
        w_.trial.displacement[i] += move;
        w_.rotation_step[i] += part * change_[i].tail<3>();
        const Vec3& c = w_.rotation_step[i];
        w_.trial.rotation[i] = cayley_turned(c, s.rotation[i]);
        w_.trial.velocity[i].head<3>() =
            2 / dt * (w_.trial.displacement[i] - s.displacement[i]) - s.velocity[i].head<3>();
        w_.trial.velocity[i].tail<3>() = 2 / dt * c - cayley_turned(c, Vec3(s.velocity[i].tail<3>()));
        for (int k = 3; k < 6; ++k)
            if (s.held[i] >> k & 1) w_.trial.velocity[i][k] = 0;
    }
    ++step.iteration;
    if (step.iteration == 1) first_size_ = size_;
    const double size = std::abs(size_), first = std::abs(first_size_);
    const bool last = step.iteration >= most_iterations_;
    const bool stands = size <= barely * floor_ && size > swings * before;  // rounding
    if (size <= floor_ || stands || size <= tolerance_ * tolerance_ * first || (last && size <= near_enough * first)) {
        note_fastest(step.end());
        return false;
    }
    if (last || !(size <= lost * first)) {
        step.failure = {
            .cause = Cause::newton_not_converged, .value = std::sqrt(size / first), .count = step.iteration};
        return false;
    }
    return true;
}

void EnergyMomentum::recovered_last() {
    double section[2];
    const int n = w_.assembly.sections(section);
    for (PlasticIncrement& y : w_.yielding) {
        const beam::FixedEnd& fixed = w_.assembly.fixed_end(y.element);
        y.flow.dissipation = 0.5 * (first_[y.element].p + y.flow.p).dot(y.flow.plastic) - work_on_slack(y.element) +
                             w_.structure.elements()[y.element].law->work_of(fixed, y.flow, section, n, fixed);
    }
}

/// The mean acceleration over the step: what the method has of it.
void EnergyMomentum::before_commit() {
    const double dt = step_;
    for (std::size_t i = 0; i < change_.size(); ++i)
        w_.trial.acceleration[i] = (w_.trial.velocity[i] - w_.state.velocity[i]) / dt;
}

void EnergyMomentum::after_commit() {
    held_by_effects_ = w_.resisting;
    load_ = w_.external;
}

void EnergyMomentum::removed(int element) {
    ImplicitIntegrator::removed(element);
    find_node_inertia();
}

template <class Self, class A>
void EnergyMomentum::fields(Self& s, A& a) {
    a(s.fastest, s.held_by_effects_, s.load_, s.flowing_, s.rebuild_, s.built_, *s.effective_);
}

void EnergyMomentum::save(Writer& to) const { fields(*this, to); }

void EnergyMomentum::restore(Reader& from) {
    const std::size_t nodes = right_.size();
    fields(*this, from);
    const bool good = held_by_effects_.size() == nodes && load_.size() == nodes &&
                      built_.size() == w_.structure.elements().size() && are_elements(flowing_) &&
                      are_elements(rebuild_);
    from.must(good && fastest.node < int(nodes));
    rebuild_was_read();
    find_node_inertia();
}

}  // namespace hinge

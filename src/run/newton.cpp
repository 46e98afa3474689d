#include "run/newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/rotation.h"
#include "run/constraints.h"
#include "run/yield_tangents.h"

namespace hinge {
namespace {

/// What a step leaves out of balance at first, before it is known.
constexpr double first_off_balance = 1e-3;

/// An iteration that makes the balance worse is halved so often at most.
constexpr int most_halvings = 12;

/// Newton's method no longer gets anywhere where so many iterations in a row had to be halved so often: what is out of
/// balance falls by less than a thousandth in each.
constexpr int most_idle = 5, halvings_of_idle = 8;

/// Part of the work of the out-of-balance forces along a step that may be left at its end.
constexpr double little_work = 0.3;

/// With a tangent in which hinges keep much of the elastic stiffness.
constexpr int many_iterations = 400;

double size_of(const std::vector<Vec6>& displacements) {
    return std::sqrt(dot_translations(displacements, displacements));
}

}  // namespace

struct Newton::Iteration {
    int number = 1;
    double length = 0, angle = 0;            ///< largest components of the displacements: m, rad
    StaticForces::Residual residual;         ///< where it has ended
    double last_norm = 0, first_norm = 0;    ///< N, of the residuals of the iteration before and of the first
    double off_balance = first_off_balance;  ///< the residual before it, relative
    int halvings = 0, idle = 0;              ///< idle: iterations in a row that were halved too often
};

Newton::Newton(const StaticProblem& problem, StaticForces& forces, StaticTangent& tangent)
    : problem_(problem),
      w_(problem.w),
      forces_(forces),
      tangent_(tangent),
      stiffens_(problem.effects.any(&EffectTraits::stiffens)) {
    const std::size_t nodes = w_.structure.position().size();
    for (auto* v : {&right_, &correction_, &total_, &step_, &result_.displacements, &result_.response})
        v->assign(nodes, Vec6::Zero());
}

/// The first guess is that what yields goes on yielding; or, where that leads nowhere, that all is elastic, and hinges
/// may unload.
bool Newton::find(PathControl& control, double increment, double hinge_stiffness, const std::vector<Vec6>& start) {
    passed_unstable_ = false;
    const auto from_state = [&](bool yielding_goes_on) {
        w_.trial = w_.state;
        w_.factor = w_.state.factor;
        return iterate(control, increment, hinge_stiffness, yielding_goes_on, start);
    };
    return from_state(true) || (!hinges_.empty() && !(hinge_stiffness > 0) && from_state(false));
}

bool Newton::find_from_trial(PathControl& control, double increment) {
    passed_unstable_ = false;
    return iterate(control, increment, 0, false);
}

void Newton::recover() { forces_.recover(); }

bool Newton::iterate(PathControl& control, double increment, double hinge_stiffness, bool yielding_goes_on,
                     const std::vector<Vec6>& start) {
    heat_counts_ = control.kind() != Control::load;
    result_.asked = 0;
    for (Vec3& m : w_.rotation_step) m.setZero();
    for (Vec6& v : total_) v.setZero();
    if (!start.empty()) {
        const Configuration before = w_.trial;
        total_ = step_ = start;
        move_by_step(w_.factor);
        if (w_.constraints) place_dependent_nodes(before);
    }
    forces_.recover();
    w_.yielding = yielding_goes_on ? hinges_ : std::vector<PlasticIncrement>{};
    const bool tangent_known = tangent_.take_that_of_state() && start.empty();
    const int most = hinge_stiffness > 0 ? many_iterations : problem_.settings.iterations;
    for (Iteration at; at.number <= most; ++at.number) {
        if (!(at.number == 1 && tangent_known) && !tangent_.renew(at.off_balance, hinge_stiffness)) return false;
        if (at.number > 1 && w_.structure.large() && !passed_unstable_)
            passed_unstable_ = is_unstable(at.off_balance, hinge_stiffness);
        if (!find_correction()) return false;
        const auto change = control.factor_change({at.number, increment, total_, correction_, result_.response});
        if (!change || !find_step(*change, at)) return false;
        const bool by_work = stiffens_ && control.kind() == Control::load && !(hinge_stiffness > 0) &&
                             forces_.support_rates().empty() && !forces_.are_heated();
        if (!(by_work ? search_work(*change, at) : search_line(*change, hinge_stiffness > 0, at))) return false;
        if (has_converged(at)) {
            if (w_.assembly.failure()) return false;
            result_.iterations = at.number;
            result_.displacements = total_;
            return true;
        }
        if (is_hopeless(at)) return false;
    }
    return false;
}

/// Near equilibrium hinges keep next to no stiffness in the tangent, and a node between two hinges may turn freely by
/// itself: that has rounding's sign. An equilibrium is judged with hinges that keep more; so is an iteration.
bool Newton::is_unstable(double off_balance, double hinge_stiffness) {
    if (!tangent_.more_negative_modes(modes_at_start_)) return false;
    const auto is_one_way = [&](const PlasticIncrement& y) {
        const int member = w_.structure.elements()[std::size_t(y.element)].member;
        return w_.structure.model().members()[std::size_t(member)].carries != Carries::both;
    };
    if (w_.yielding.empty() || std::any_of(w_.yielding.begin(), w_.yielding.end(), is_one_way)) return true;
    const bool so = !tangent_.renew(1, hinge_stiffness) || tangent_.more_negative_modes(modes_at_start_);
    return !tangent_.renew(off_balance, hinge_stiffness) || so;
}

bool Newton::find_response() { return find_rate(heat_counts_, result_.response); }

std::vector<Vec6> Newton::path_rate() {
    std::vector<Vec6> rate(w_.external.size(), Vec6::Zero());
    return find_rate(true, rate) ? rate : std::vector<Vec6>{};
}

bool Newton::find_rate(bool with_heat, std::vector<Vec6>& rate) {
    std::vector<Vec6> load(w_.external.size()), internal;
    if (with_heat && forces_.are_heated()) internal = forces_.internal_rates();
    const std::vector<Vec6>&of_supports = tangent_.forces_of_supports(), &rates = forces_.support_rates();
    for (std::size_t i = 0; i < load.size(); ++i) {
        load[i] = internal.empty() ? forces_.load_rate(i) : Vec6(w_.external[i] - internal[i]);
        if (!of_supports.empty()) load[i] -= of_supports[i];
        load[i] = problem_.without_supported(i, load[i]);
    }
    if (!tangent_.solve(load, rate)) return false;
    for (std::size_t i = 0; i < rates.size(); ++i) rate[i] += rates[i];
    return true;
}

/// Displacements by the out-of-balance forces, and by the loads at factor 1.
bool Newton::find_correction() {
    for (std::size_t i = 0; i < right_.size(); ++i) right_[i] = forces_.out_of_balance(i);
    if (!tangent_.solve(right_, correction_) || !find_response()) return false;
    if (first_softness_ == 0) first_softness_ = softness();
    if (first_softness_ == 0) first_softness_ = size_of(path_rate());  // heat alone
    return true;
}

/// Displacements of the iteration. False where they are beyond all bounds.
bool Newton::find_step(double factor_change, Iteration& at) {
    at.length = at.angle = 0;
    for (std::size_t i = 0; i < step_.size(); ++i) {
        step_[i] = correction_[i] + factor_change * result_.response[i];
        if (!step_[i].allFinite()) return false;
        at.length = std::max(at.length, step_[i].head<3>().cwiseAbs().maxCoeff());
        at.angle = std::max(at.angle, step_[i].tail<3>().cwiseAbs().maxCoeff());
    }
    return std::isfinite(at.length + at.angle) && at.length <= 10 * problem_.reach &&
           !(w_.structure.large() && at.angle > 1.5);
}

void Newton::move_by_step(double factor) {
    w_.factor = factor;
    for (std::size_t i = 0; i < step_.size(); ++i) {
        w_.trial.displacement[i] += step_[i].head<3>();
        w_.rotation_step[i] += step_[i].tail<3>();
        if (w_.structure.large()) w_.trial.rotation[i] = rotated(step_[i].tail<3>(), w_.trial.rotation[i]);
        else w_.trial.small_rotation[i] += step_[i].tail<3>();
    }
}

/// The step is a linear one: dependent nodes have left their places by what rotations are beyond that.
void Newton::place_dependent_nodes(const Pose& from) {
    std::vector<Vec3> rotations;
    for (const Vec6& v : step_) rotations.push_back(v.tail<3>());
    w_.constraints->place(from, rotations);
}

/// The set of hinges may differ at the two ends of the step, and Newton's method then swings between them: a step that
/// makes the balance worse is taken by half, and by half again. False where the forces are not finite, or not found.
bool Newton::search_line(double factor_change, bool whole_steps, Iteration& at) {
    const Configuration before = w_.trial;
    const std::vector<Vec3> turned_before = w_.rotation_step;
    const double factor_before = w_.factor;
    double share = 1;
    for (at.halvings = 0;; ++at.halvings, share /= 2) {
        if (at.halvings > 0) {
            w_.trial = before;
            w_.rotation_step = turned_before;
            for (Vec6& v : step_) v *= 0.5;
        }
        move_by_step(factor_before + share * factor_change);
        if (w_.constraints) place_dependent_nodes(before);
        forces_.recover();
        at.residual = forces_.residual();
        const double norm = at.residual.norm;
        const bool lost = w_.assembly.unreturned() >= 0;  // so far out: what there is of forces means nothing
        if (lost && (at.number == 1 || at.halvings == most_halvings || whole_steps)) return false;
        if (at.number == 1 || at.halvings == most_halvings || whole_steps || !std::isfinite(norm) ||
            (!lost && norm <= (1 - 1e-3 * share) * at.last_norm))
            break;
    }
    return end_search(at);
}

/// A flat panel has next to no stiffness against a load across it until it sags, so that the tangent there asks for
/// many times the sag, and the forces at its end are far larger than the load. The step ends where the out-of-balance
/// forces do little work along it: where the energy is least. Load control.
bool Newton::search_work(double factor_change, Iteration& at) {
    const Configuration before = w_.trial;
    const std::vector<Vec3> turned_before = w_.rotation_step;
    const double factor_before = w_.factor;
    const std::vector<Vec6> whole = step_;
    double at_start = 0;
    for (std::size_t i = 0; i < whole.size(); ++i)
        at_start += whole[i].dot(right_[i] + problem_.without_supported(i, factor_change * forces_.load_rate(i)));
    if (!(at_start > 0)) return search_line(factor_change, false, at);
    if (at.number == 1) result_.asked = size_of(whole);
    double low = 0, at_low = at_start, high = 0, at_high = 0, share = 1;
    for (at.halvings = 0;; ++at.halvings) {
        if (at.halvings > 0) {
            w_.trial = before;
            w_.rotation_step = turned_before;
            for (std::size_t i = 0; i < whole.size(); ++i) step_[i] = share * whole[i];
        }
        move_by_step(factor_before + factor_change);
        if (w_.constraints) place_dependent_nodes(before);
        forces_.recover();
        at.residual = forces_.residual();
        double now = 0;
        for (std::size_t i = 0; i < whole.size(); ++i) now += whole[i].dot(forces_.out_of_balance(i));
        const bool lost = w_.assembly.unreturned() >= 0 || !std::isfinite(now);
        if (lost && at.halvings == most_halvings) return false;
        if (!lost && (now >= -little_work * at_start || at.halvings == most_halvings)) {
            if (now <= little_work * at_start || high == 0 || at.halvings == most_halvings) break;
            low = share, at_low = now;
        } else {
            high = share, at_high = lost ? -std::numeric_limits<double>::infinity() : now;
        }
        const double secant = low + (high - low) * at_low / (at_low - at_high);
        share = at.halvings % 2 == 0 ? std::clamp(secant, low + 0.1 * (high - low), high) : 0.5 * (low + high);
    }
    return end_search(at);
}

bool Newton::end_search(Iteration& at) {
    at.idle = at.halvings >= halvings_of_idle ? at.idle + 1 : 0;
    at.last_norm = at.residual.norm;
    at.off_balance = at.residual.relative();
    if (at.number == 1) at.first_norm = std::max(at.last_norm, 1e-300);
    for (std::size_t i = 0; i < step_.size(); ++i) total_[i] += step_[i];
    return std::isfinite(at.last_norm);
}

/// Or where rounding lets it get no closer.
bool Newton::has_converged(const Iteration& at) const {
    const double norm = at.residual.norm, scale = at.residual.scale;
    const bool stalled =
        at.number > 3 && at.length <= 1e-12 * problem_.reach && at.angle <= 1e-11 && norm <= 1e-6 * scale;
    return norm <= problem_.settings.tolerance * scale || norm <= problem_.rounding || stalled;
}

bool Newton::is_hopeless(const Iteration& at) const {
    return (at.number > 8 && at.last_norm > 1e3 * at.first_norm) || at.idle >= most_idle;
}

void Newton::commit() { hinges_ = flowing_on(w_.yielding); }

double Newton::softness() const { return size_of(result_.response); }

}  // namespace hinge

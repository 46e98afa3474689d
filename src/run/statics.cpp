#include "run/statics.h"

#include <algorithm>
#include <cmath>

#include "core/doing.h"
#include "core/errors.h"
#include "core/rotation.h"
#include "core/text.h"
#include "run/yield_tangents.h"

namespace hinge {
namespace {

/// Keeps the tangent from being singular where hinges stand on both sides of a node, or make a second mechanism beside
/// the one that is driven: a share of the element's stiffness without hinges, in the tangent alone. Where N and M yield
/// together, a mechanism keeps a small stiffness of its own, because N moves along the yield surface. A share that is
/// larger than that lets Newton's method creep. So the share falls with what is out of balance, as a part of the
/// forces at work.
double hinge_regularisation(double off_balance) { return std::clamp(1e-3 * off_balance, 1e-9, 1e-4); }

/// What a step leaves out of balance at first, before it is known.
constexpr double first_off_balance = 1e-3;

/// Newton's method no longer gets anywhere where so many iterations in a row had to be halved so often: what is out of
/// balance falls by less than a thousandth in each.
constexpr int most_idle = 5, halvings_of_idle = 8;

/// A step that takes no more iterations has not leapt over a snap.
constexpr int quick = 4;

double dot(const std::vector<Vec6>& a, const std::vector<Vec6>& b) {  // translations alone: rotations have another unit
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].head<3>().dot(b[i].head<3>());
    return sum;
}

}  // namespace

Statics::Statics(std::shared_ptr<const Structure> structure, State start, StaticSettings settings)
    : Run(std::move(structure), std::move(start), RunKind{}, 1, false),
      settings_(std::move(settings)),
      held_(state_.held),
      effective_(std::make_unique<EffectiveStiffness>(*structure_, pool_, 0.0, 1.0, true, MatrixStorage::direct)) {
    const Model& model = structure_->model();
    const std::size_t nodes = structure_->position().size();
    for (std::size_t i = 0; i < settings_.held.size(); ++i) held_[i] |= settings_.held[i];
    for (auto* v : {&potential_, &right_, &change_, &response_, &last_move_}) v->assign(nodes, Vec6::Zero());
    w_.rotation_step.assign(nodes, Vec3::Zero());
    double length = 0;
    for (const Element& e : structure_->elements()) length += e.length;
    if (!structure_->elements().empty()) mean_length_ = length / double(structure_->elements().size());
    for (const Vec3& x : structure_->position()) reach_ = std::max(reach_, x.cwiseAbs().maxCoeff());
    // forces that rounding of the positions alone makes: below them equilibrium cannot be told
    for (const Element& e : structure_->elements())
        noise_ = std::max(
            noise_, 1e-15 * reach_ * (e.stiffness.axial + (e.stiffness.x22 + e.stiffness.y22) / (e.length * e.length)));
    noise_ *= std::sqrt(double(nodes));
    for (const auto& e : effects_) loads_follow_ = loads_follow_ || e->loads_follow();
    find_loads();
    refuse_idle_loads();
    find_way();
    state_.factor = 0;
    assembly_.take_up(state_);
    effective_->set_held(held_);
    step_size_ = 1.0 / settings_.steps;
    recover();
    take_reactions(0);
    refuse_mechanism();
    if (structure_->large()) modes_at_start_ = most_modes_ = most_free_modes_ = effective_->negative_modes();
    const bool moments =
        std::any_of(model.loads().begin(), model.loads().end(), [](const NodalLoad& l) { return !l.moment.isZero(); });
    // What weight does along members turns with them, but by next to nothing beside their stiffness.
    const bool turns = std::any_of(effects_.begin(), effects_.end(), [&](const auto& e) {
        return e->loads_follow() && (!e->has_potential() || !state_.offset_mass.empty());
    });
    if ((moments || turns) && structure_->large()) {
        effective_ =
            std::make_unique<EffectiveStiffness>(*structure_, pool_, 0.0, 1.0, true, MatrixStorage::unsymmetric);
        effective_->set_held(held_);
        built_ = false;
    }
}

/// F at factor 1, where the nodes are tried to be.
void Statics::find_loads() {
    std::vector<Vec6> all(w_.external.size(), Vec6::Zero());
    std::vector<Vec6>& others = all;
    for (Vec6& v : potential_) v.setZero();
    for (const auto& e : effects_) {
        std::vector<Vec6>& sum = e->has_potential() ? potential_ : others;
        e->add_steady_loads(sum);
        e->add_static_loads(w_.trial, sum);
    }
    for (std::size_t i = 0; i < all.size(); ++i) w_.external[i] = others[i] + potential_[i];
    if (!structure_->model().holds_loads()) return;
    held_loads_.assign(all.size(), Vec6::Zero());
    for (const auto& e : effects_)
        if (!e->has_potential()) e->add_held_loads(w_.trial, held_loads_);
    std::vector<Vec6> weights(all.size(), Vec6::Zero());
    for (const auto& e : effects_)
        if (e->has_potential()) e->add_held_loads(w_.trial, weights);
    for (std::size_t i = 0; i < all.size(); ++i) held_loads_[i] += weights[i], w_.external[i] -= weights[i];
}

Vec6 Statics::load_at(std::size_t node, double factor) const {
    if (held_loads_.empty()) return factor * w_.external[node];
    return factor * w_.external[node] + held_loads_[node];
}

void Statics::recover() {
    stages_.timed(recover_stage_, [&] {
        for (Vec6& n : w_.resisting) n.setZero();
        w_.factor = trial_factor_;
        find_fixed_ends(trial_factor_);
        assembly_.run(state_, w_.trial, w_.resisting, w_.force, w_.yielding);
        for (const auto& e : effects_) e->add_forces(0, w_.resisting);
        if (loads_follow_) find_loads();
    });
}

/// What elements that flow resist with as the load factor grows, by what loads between their nodes do there.
void Statics::find_flow_by_load(const std::vector<ElementTangent>& given) {
    flow_by_load_.clear();
    if (assembly_.fixed_ends().empty() || given.empty()) return;
    const std::vector<beam::FixedEnd> now = assembly_.fixed_ends();
    find_fixed_ends(trial_factor_ + 1);
    std::vector<beam::FixedEnd> change = std::move(assembly_.fixed_ends());
    for (std::size_t i = 0; i < now.size(); ++i) change[i] = change[i] - now[i];
    assembly_.fixed_ends() = now;
    flow_by_load_.assign(w_.external.size(), Vec6::Zero());
    add_response(*structure_, state_, w_.trial, given, change, flow_by_load_);
}

/// What the load asks of a node per unit of its factor.
Vec6 Statics::unit_load(std::size_t node) const {
    if (flow_by_load_.empty()) return w_.external[node];
    return w_.external[node] - flow_by_load_[node];
}

/// `off_balance`: what is out of balance, as a part of the forces at work.
bool Statics::renew_and_factorise(double off_balance) {
    if (asked_to_end) throw Interrupted("");  // a static run is done anew
    stages_.timed(stiffness_stage_, [&] {
        std::vector<int> list;
        if (structure_->large() || !built_) {
            for (std::size_t i = 0; i < state_.broken.size(); ++i)
                if (!state_.broken[i]) list.push_back(int(i));
        } else {
            list = was_yielding_;
            for (const PlasticIncrement& y : w_.yielding) list.push_back(y.element);
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
        }
        was_yielding_.clear();
        const double share = std::max(hinge_regularisation(off_balance), stiffening_);
        std::vector<ElementTangent> given = given_tangents(*structure_, state_, w_.trial, assembly_, list, w_.yielding);
        find_flow_by_load(given);
        std::size_t next = 0;
        for (const PlasticIncrement& y : w_.yielding) {
            const Element& e = structure_->elements()[y.element];
            const beam::Rigidity& r = e.rigidity;
            Vec6 bare;
            bare << r.EIx, r.EIx, r.EIy, r.EIy, r.EA, r.GJ;
            while (given[next].element < y.element) ++next;
            given[next].own += share * bare.asDiagonal().toDenseMatrix() / e.length;
            was_yielding_.push_back(y.element);
        }
        w_.force.swap(state_.force);  // the tangent's initial-stress part reads the forces of now
        effective_->build(list, state_, w_.trial, given);
        w_.force.swap(state_.force);
        Blocks blocks = blocks_at(w_.trial, 0);
        const bool has_blocks = !blocks.pairs.empty() || !blocks.nodes.empty();
        if (has_blocks || had_blocks_) effective_->set_blocks(std::move(blocks));
        had_blocks_ = has_blocks;
        built_ = true;
        effective_->assemble();
    });
    bool good = false;
    stages_.timed(solve_stage_, [&] { good = effective_->factorise(); });
    return good;
}

double Statics::out_of_balance(double& scale) const {
    double r = 0, s = 0;
    for (std::size_t i = 0; i < w_.resisting.size(); ++i) {
        const Vec6 load = load_at(i, trial_factor_);
        for (int c = 0; c < 6; ++c) {
            const double unit = c < 3 ? 1 : 1 / mean_length_, f = load[c];
            if (!(held_[i] >> c & 1)) r += std::pow(unit * (f - w_.resisting[i][c]), 2);
            s += std::pow(unit * f, 2) + std::pow(unit * w_.resisting[i][c], 2);
        }
    }
    scale = std::sqrt(s);
    return std::sqrt(r);
}

void Statics::move(double factor, const std::vector<Vec6>& by) {
    trial_factor_ = factor;
    for (std::size_t i = 0; i < by.size(); ++i) {
        w_.trial.displacement[i] += by[i].head<3>();
        w_.rotation_step[i] += by[i].tail<3>();
        if (structure_->large()) w_.trial.rotation[i] = rotated(by[i].tail<3>(), w_.trial.rotation[i]);
        else w_.trial.small_rotation[i] += by[i].tail<3>();
    }
}

/// Newton from the last equilibrium. `increment`: of the factor (load), of the way to the target (displacement), of the
/// arc (in units of the first step's).
Statics::Outcome Statics::equilibrate(double increment, bool flowing_on) {
    w_.trial = configuration_of(state_);
    trial_factor_ = state_.factor;
    return go_on_from_trial(increment, flowing_on);
}

/// The same from what is tried.
Statics::Outcome Statics::go_on_from_trial(double increment, bool flowing_on) {
    for (Vec3& m : w_.rotation_step) m.setZero();
    std::vector<Vec6> total(w_.resisting.size(), Vec6::Zero()), step(w_.resisting.size());
    double arc = 0;
    recover();
    // the first guess: what flowed flows on; or, if that did not lead anywhere, all is elastic and hinges may unload
    w_.yielding = flowing_on ? hinges_ : std::vector<PlasticIncrement>{};
    double first = 0, last_balance = 0, off_balance = first_off_balance;
    const bool tangent_known = tangent_known_ && w_.yielding.empty();
    tangent_known_ = tangent_of_trial_ = false;
    const int iterations = stiffening_ > 0 ? 400 : settings_.iterations;
    int idle = 0;
    for (int iteration = 1; iteration <= iterations; ++iteration) {
        if (!(iteration == 1 && tangent_known) && !renew_and_factorise(off_balance)) return Outcome::diverged;
        if (iteration > 1 && structure_->large())
            wavered_ = wavered_ || effective_->more_negative_modes(modes_at_start_) ||
                       (modes_at_start_ == 0 && modes_within_pairs() > 0);
        for (std::size_t i = 0; i < w_.resisting.size(); ++i) {
            right_[i] = load_at(i, trial_factor_) - w_.resisting[i];
            for (int c = 0; c < 6; ++c)
                if (held_[i] >> c & 1) right_[i][c] = 0;
            response_[i] = unit_load(i);
            for (int c = 0; c < 6; ++c)
                if (held_[i] >> c & 1) response_[i][c] = 0;
        }
        SolverSettings direct;
        direct.direct = true;
        const std::vector<Vec6> asked = response_;
        if (!effective_->solve(right_, change_, direct).converged ||
            !effective_->solve(asked, response_, direct).converged)
            return Outcome::diverged;
        if (first_softness_ == 0) first_softness_ = softness();

        double d_factor = 0;
        if (settings_.control == Control::load) {
            d_factor = iteration == 1 ? increment : 0;
        } else if (settings_.control == Control::displacement) {
            const int n = settings_.node, c = settings_.component;
            const auto at = [&](const std::vector<Vec6>& v) { return v[n][c]; };
            const double wanted = iteration == 1 ? increment * way_ : increment * way_ - at(total);
            if (at(response_) == 0) return Outcome::diverged;
            if (first_response_ == 0) first_response_ = at(response_);
            d_factor = (wanted - at(change_)) / at(response_);
        } else if (iteration == 1) {
            const double size = std::sqrt(dot(response_, response_));
            if (last_arc_ == 0) last_arc_ = size * step_size_;  // the first step is a load step
            arc = last_arc_ * increment;
            const double forward = dot(last_move_, response_);
            d_factor = (forward < 0 ? -1 : 1) * arc / size;
        } else {  // |total + change + d response| = arc: of the two roots, the one that goes on
            for (std::size_t i = 0; i < step.size(); ++i) step[i] = total[i] + change_[i];
            const double a = dot(response_, response_), b = dot(step, response_), c = dot(step, step) - arc * arc,
                         disc = b * b - a * c;
            if (disc < 0) return Outcome::diverged;
            const double r1 = (-b + std::sqrt(disc)) / a, r2 = (-b - std::sqrt(disc)) / a;
            d_factor = dot(total, step) + r1 * dot(total, response_) >= dot(total, step) + r2 * dot(total, response_)
                           ? r1
                           : r2;
        }
        double size = 0, angle = 0;
        for (std::size_t i = 0; i < step.size(); ++i) {
            step[i] = change_[i] + d_factor * response_[i];
            if (!step[i].allFinite()) return Outcome::diverged;
            size = std::max(size, step[i].head<3>().cwiseAbs().maxCoeff());
            angle = std::max(angle, step[i].tail<3>().cwiseAbs().maxCoeff());
        }
        if (!std::isfinite(size + angle) || size > 10 * reach_ || (structure_->large() && angle > 1.5))
            return Outcome::diverged;
        // The set of hinges may differ at the two ends of the step, and Newton then swings between them: a step that
        // makes the balance worse is taken by half, and by half again.
        const Configuration before = w_.trial;
        const std::vector<Vec3> moved_before = w_.rotation_step;
        const double factor_before = trial_factor_;
        double scale = 0, r = 0, share = 1;
        int halving = 0;
        for (;; ++halving, share /= 2) {
            if (halving > 0) {
                w_.trial = before;
                w_.rotation_step = moved_before;
                for (Vec6& v : step) v *= 0.5;
            }
            move(factor_before + share * d_factor, step);
            recover();
            r = out_of_balance(scale);
            if (iteration == 1 || halving == 12 || stiffening_ > 0 || !std::isfinite(r) ||
                r <= (1 - 1e-3 * share) * last_balance)
                break;
        }
        idle = halving >= halvings_of_idle ? idle + 1 : 0;
        last_balance = r;
        off_balance = r / scale;
        for (std::size_t i = 0; i < step.size(); ++i) total[i] += step[i];
        if (!std::isfinite(r)) return Outcome::diverged;
        if (iteration == 1) first = std::max(r, 1e-300);
        const bool stalled = iteration > 3 && size <= 1e-12 * reach_ && angle <= 1e-11 && r <= 1e-6 * scale;
        if (r <= settings_.tolerance * scale || r <= noise_ || stalled) {
            if (!assembly_.failure().empty()) return Outcome::diverged;
            converged_in_ = iteration;
            last_move_ = total;
            return Outcome::converged;
        }
        if (iteration > 8 && r > 1e3 * first) return Outcome::diverged;
        if (idle >= most_idle) return Outcome::diverged;
    }
    return Outcome::diverged;
}

void Statics::take_reactions(double factor) {
    for (std::size_t i = 0; i < held_.size(); ++i) {
        if (!held_[i]) continue;
        Vec6& r = reaction_[int(i)];
        for (int c = 0; c < 6; ++c) r[c] = held_[i] >> c & 1 ? w_.resisting[i][c] - load_at(i, factor)[c] : 0;
    }
}

void Statics::commit(double before) {
    const Step step{state_.time, 0, false, 0, {}, {}};
    double& work = state_.accumulated["work"];
    for (std::size_t i = 0; i < w_.external.size(); ++i) {
        const Vec3 du = w_.trial.displacement[i] - state_.displacement[i];
        const double mean = 0.5 * (before + trial_factor_);
        // gravity is let on slowly: the part of it that is not there yet is held back by the load
        work += mean * (w_.external[i].head<3>().dot(du) + w_.external[i].tail<3>().dot(w_.rotation_step[i])) -
                (potential_[i].head<3>().dot(du) + potential_[i].tail<3>().dot(w_.rotation_step[i]));
        if (!held_loads_.empty())
            work += held_loads_[i].head<3>().dot(du) + held_loads_[i].tail<3>().dot(w_.rotation_step[i]);
    }
    take_reactions(trial_factor_);
    for (const auto& e : effects_) e->accumulate_energy(step, state_.accumulated);
    for (const auto& e : effects_) e->before_commit(step);
    state_.displacement = w_.trial.displacement;
    state_.rotation = w_.trial.rotation;
    state_.small_rotation = w_.trial.small_rotation;
    state_.force = w_.force;
    assembly_.keep_turns(state_, w_.trial);
    state_.factor = trial_factor_;
    hinges_ = flowing_on(w_.yielding);
    for (const auto& e : effects_) e->after_commit(step);
    tangent_known_ = tangent_of_trial_ && !w_.points_moved;
    if (w_.points_moved) assembly_.take_up(state_), w_.points_moved = false;
    ++substeps_;
}

/// An equilibrium that much further on, and whether it can be held as far as that could be where the run began. Under
/// load control one that can, but that Newton's iteration came to by way of tangents that cannot, may lie beyond a
/// snap: that is none.
Statics::Found Statics::try_step(double increment) {
    wavered_ = doubtful_ = false;
    if (on_try) on_try();
    if (equilibrate(increment, true) != Outcome::converged &&
        (hinges_.empty() || stiffening_ > 0 || equilibrate(increment, false) != Outcome::converged))
        return Found::nothing;
    modes_ = negative_modes();
    free_modes_ = modes_under_control();
    if (modes_ > modes_at_start_) return Found::unstable;
    doubtful_ = settings_.control == Control::load && (wavered_ || !leads_back(increment));
    return doubtful_ && !settings_.past_unstable ? Found::nothing : Found::stable;
}

/// Whether an elastic structure comes back to where it was when the load of the step that was tried is taken off again.
/// If not, the step has leapt over a snap. Asked where Newton's iteration took long, as it does over a leap.
bool Statics::leads_back(double increment) {
    if (!structure_->large() || converged_in_ <= quick || !w_.yielding.empty() || !hinges_.empty()) return true;
    const Configuration arrived = w_.trial;
    const std::vector<Vec3> rotation_step = w_.rotation_step;
    const std::vector<Vec6> force = w_.force, resisting = w_.resisting, external = w_.external, move = last_move_,
                            response = response_;
    const double factor = trial_factor_;
    const int iterations = converged_in_;
    const bool lost = go_on_from_trial(-increment, false) != Outcome::converged;
    const bool back = !wavered_ && (lost || [&] {
        double off = 0, way = 0;
        for (std::size_t i = 0; i < arrived.displacement.size(); ++i) {
            off = std::max(off, (w_.trial.displacement[i] - state_.displacement[i]).norm());
            way = std::max(way, (arrived.displacement[i] - state_.displacement[i]).norm());
        }
        return off <= 1e-2 * way;
    }());
    w_.trial = arrived, w_.rotation_step = rotation_step;
    w_.force = force, w_.resisting = resisting, w_.external = external, last_move_ = move, response_ = response;
    w_.yielding.clear();
    trial_factor_ = factor, converged_in_ = iterations;
    tangent_of_trial_ = false;
    return back;
}

/// Where one mechanism takes over from another, a new hinge lets many others unload at once. Newton's method then
/// swings between two sets of hinges, however short the step. A tangent in which hinges keep more of the element's
/// stiffness comes to the new set, slowly; the step must reach beyond the exchange.
bool Statics::past_exchange(double increment) {
    if (settings_.control == Control::load || hinges_.empty()) return false;
    const std::vector<Vec6> arrived_by = last_move_;
    for (tried_ = increment; tried_ >= increment / 100 && tried_ >= smallest_step; tried_ /= 4)
        for (double stiffening : {1e-3, 1e-2, 1e-1}) {
            last_move_ = arrived_by;
            stiffening_ = stiffening;
            const bool found = try_step(tried_) != Found::nothing &&
                               (settings_.control == Control::arc || free_modes_ <= most_free_modes_);
            stiffening_ = 0;
            if (found) return true;
        }
    last_move_ = arrived_by;
    return false;
}

/// Ends the run at a limit load: completed where the script asked for that and there was a way to it.
void Statics::end_at_limit(const std::string& why, const std::string& advice) {
    if (const std::string of_element = assembly_.failure(); !of_element.empty())
        return fail(why + advice + "; " + of_element);
    if (!settings_.to_limit || substeps_ == 0) return fail(why + advice);
    verdict_ = Verdict::completed;
    reason_ = "limit load: " + why;
    limit_ = true;
}

/// How far the loads move the structure by its last tangent, m.
double Statics::softness() const { return std::sqrt(dot(response_, response_)); }

double Statics::part_done() const {
    const double arcs = double(steps_done()) / settings_.steps;
    return settings_.control == Control::arc ? at_target_ ? 1 : std::max(arcs, state_.factor / settings_.target)
           : settings_.control == Control::displacement ? progress_
                                                        : state_.factor;
}

bool Statics::advance() {
    if (verdict_ != Verdict::running) return false;
    // the way still to go: to factor 1, to the target, or the steps allowed
    const bool arc = settings_.control == Control::arc;
    const auto done = [&] { return settings_.control == Control::displacement ? progress_ : state_.factor; };
    const bool ends_at_limit = settings_.control == Control::load && !settings_.past_unstable;
    const auto over = [&] { return arc ? at_target_ || steps_done() >= settings_.steps : done() >= 1 - 1e-12; };
    if (over()) {
        verdict_ = Verdict::completed;
        return false;
    }
    double left = arc ? arc_scale_ : std::min(1.0 / settings_.steps, 1 - done());
    if (!arc && 1 - done() - left < 1e-9) left = 1 - done();
    const long substeps_before = substeps_;
    while (left > 0 && verdict_ == Verdict::running) {
        double increment = arc ? left : std::min(step_size_, left);
        if (!arc && left - increment < 1e-9) increment = left;
        const double before = state_.factor, asked = increment;
        const std::vector<Vec6> arrived_by = last_move_;
        // Driven by displacement, an equilibrium that even that cannot hold is that of another branch, which Newton's
        // iteration has leapt to, or the structure's own beyond a branching point: that is so where no step is too
        // short.
        const auto left_the_path = [&] {
            return settings_.control == Control::displacement && free_modes_ > most_free_modes_ &&
                   increment / 2 >= smallest_step;
        };
        while (try_step(increment) == Found::nothing || left_the_path()) {
            ++rejected_;
            increment /= 2;
            if (increment < smallest_step && past_exchange(asked)) {
                increment = tried_;
                if (arc) arc_scale_ = left = increment;
                break;
            }
            if (increment < smallest_step) {
                char step[80];
                std::snprintf(step, sizeof step, " (step %ld halved down to %.1g of the way)", steps_done() + 1,
                              increment);
                end_at_limit("no equilibrium found beyond load factor " + number_text(state_.factor) + step,
                             advice_at_end());
                break;
            }
            step_size_ = increment;
            if (arc) arc_scale_ = left = increment;
        }
        if (verdict_ != Verdict::running) break;
        if (arc && passes_target()) {  // the last part is a step of load
            const double way = settings_.target - state_.factor;
            const auto as = [&](Control control, double part) {
                settings_.control = control;
                last_move_ = arrived_by;
                return try_step(part) != Found::nothing;
            };
            at_target_ = as(Control::load, way);
            if (at_target_) increment = left = way;
            else as(Control::arc, increment);  // it goes on, and may come by once more
        }
        if (settings_.control == Control::displacement && free_modes_ > most_free_modes_) {
            most_free_modes_ = free_modes_;
            if (!branching_) branching_ = state_.factor;
        }
        if (const int modes = modes_; modes > most_modes_) {
            const bool first = !instability_;
            const double stable = first ? locate(increment, arrived_by) : increment;
            most_modes_ = modes;
            if (ends_at_limit) {
                if (stable > 0 && try_step(stable) == Found::stable) commit(before);
                const std::string text = instability_text();
                end_at_limit(text, advice_at_end());
                break;
            }
            instability_->count = modes - modes_at_start_;
        }
        if (!arc) note_leap(increment, before);
        commit(before);
        progress_ += increment;
        if (at_target_) settings_.control = Control::arc;
        left = increment == left ? 0 : left - increment;
        if (arc)
            arc_scale_ = std::min(arc_scale_ * std::clamp(std::sqrt(5.0 / converged_in_), 0.5, 1.5),
                                  30.0);  // five iterations a step
        else if (converged_in_ <= 6) step_size_ = std::min(2 * step_size_, 1.0 / settings_.steps);
    }
    if (substeps_ == substeps_before) return false;
    ++state_.step;
    if (verdict_ == Verdict::running && over()) {
        verdict_ = Verdict::completed;
        tell_end();
    }
    if (verdict_ != Verdict::failed) look_at_pairs();
    return true;
}

std::vector<PlanLine> Statics::effects() const {
    std::vector<PlanLine> list = plan_of(*structure_, w_.kind);
    stages_.add_to(list);
    return list;
}

}  // namespace hinge

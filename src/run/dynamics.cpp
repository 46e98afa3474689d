#include "run/dynamics.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/errors.h"
#include "core/rotation.h"
#include "state/hinges.h"
#include "state/nodes.h"
#include "state/turning.h"

namespace hinge {
namespace {

/// Part of the elastic stiffness by which a plastic tangent may differ from the one in the operator.
constexpr double same_tangent = 0.2;

/// Whether a and b differ by no more than `part` of the elastic stiffness k, entry by entry.
bool near(const Mat6& a, const Mat6& b, const beam::Stiffness& k, double part) {
    if (part == 0) return false;
    const Mat6 e = k.matrix();
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 6; ++i)
            if (std::abs(a(i, j) - b(i, j)) > part * std::sqrt(e(i, i) * e(j, j))) return false;
    return true;
}

double seconds_since(std::chrono::steady_clock::time_point t) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - t).count();
}

}  // namespace

bool Dynamics::advance() {
    if (verdict_ != Verdict::running) return false;
    if (over()) {
        verdict_ = Verdict::completed;
        return false;
    }
    if (has_rules_ || controlled()) remember();
    try {
        do take_step();
        while (reject_ && again_shorter());
        if (with_contact()) state_.contact->forget();
    } catch (const HookError& e) {
        take_back();
        char at[100];
        std::snprintf(at, sizeof at, " at step %ld, t = %.6g s; the step was taken back", state_.step + 1,
                      state_.time + settings_.dt);
        throw HookError(e.what() + std::string(at));
    } catch (...) {
        if (has_rules_ || controlled()) take_back();
        throw;
    }
    guard();
    return verdict_ != Verdict::failed;
}

void Dynamics::take_step() {
    if (settings_.automatic || controlled()) choose_step();
    reject_ = false;
    std::size_t recover_at = 0;
    iteration_ = 0;
    for (std::size_t i = 0; i < stages_.size(); ++i) {
        Stage& stage = stages_[i];
        if (stage.run == &Dynamics::recover) recover_at = i;
        const auto start = std::chrono::steady_clock::now();
        (this->*stage.run)();
        stage.seconds += seconds_since(start);
        if (!failure_.empty()) {
            char at[64];
            std::snprintf(at, sizeof at, "step %ld, t = %.6g s: ", state_.step + 1, state_.time + settings_.dt);
            if (reject_ = controlled(); !reject_) fail(at + failure_);
            else failure_ = at + failure_;
            return;
        }
        if (stage.run != &Dynamics::correct) continue;
        if (again_) {
            i = recover_at - 1;   // Newton: once more
        } else if (from_rest_) {  // the stresses so far are those the last solve started from
            const auto settling = std::chrono::steady_clock::now();
            recover();
            if (can_yield()) yield();
            stages_[recover_at].seconds += seconds_since(settling);
        }
    }
    if (over()) verdict_ = Verdict::completed;
}

// ---- stages ------------------------------------------------------------------------------------------------------

/// After something broke or was released: the acceleration anew.
void Dynamics::restart() {
    if (!restart_) return;
    find_acceleration();
    loads();
}

/// Where the step is solved from. Short steps: du = dt v + dt^2/2 a, the acceleration held. Long ones, over which the
/// fastest waves cross an element and a held acceleration would fling it: du = 0, which is eq 15 to the letter.
void Dynamics::predict() {
    const double dt = settings_.dt, beta = settings_.beta, alpha = settings_.alpha(), gamma = settings_.gamma();
    if (from_rest_) {
        for (std::size_t i = 0; i < increment_.size(); ++i) {
            trial_.displacement[i] = state_.displacement[i];
            increment_[i].setZero();
            trial_.acceleration[i] =
                -1 / (beta * dt) * state_.velocity[i] - (0.5 - beta) / beta * state_.acceleration[i];
            trial_.velocity[i] =
                state_.velocity[i] + dt * ((1 - gamma) * state_.acceleration[i] + gamma * trial_.acceleration[i]);
            if (alpha != 0)
                trial_.acceleration[i] = (1 - alpha) * trial_.acceleration[i] + alpha * state_.acceleration[i];
        }
        move_supports();
        return move_to_increment(0, int(increment_.size()));
    }
    const bool keep =
        effective_ != nullptr;  // in explicit steps stubs say what they resist beside their mass times the acceleration
    pool_.share(int(increment_.size()), some_nodes, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            const Lanes v = load_row<6>(state_.velocity[i].data()), a = load_row<6>(state_.acceleration[i].data());
            const Lanes step = dt * v + (0.5 * dt * dt) * a;
            store_row<3>(trial_.displacement[i].data(), load_row<3>(state_.displacement[i].data()) + step);
            store_row<3>(increment_[i].data(), second_three(step));
            store_row<6>(trial_.velocity[i].data(), v + dt * a);
            store_row<6>(trial_.acceleration[i].data(), keep ? a : Lanes{});
        }
        move_to_increment(first, end);
    });
    move_supports();
}

/// Internal and inertia forces where the nodes are now (eqs 3, 10, 13); p of each element.
void Dynamics::recover() {
    for (Vec6& n : nodal_) n.setZero();
    sweep_.run(state_, trial_, nodal_, force_, yielding_);
    if (from_rest_ && iteration_ == 0) yielding_ = hinges_;  // nothing has moved yet: what flowed is taken to flow on
    if (built::fracture && !state_.offset_mass.empty()) add_hung_inertia();
    if (in_contact()) {
        place_contact(trial_.displacement);
        state_.contact->add_internal_forces(contact_position_, trial_.rotation, nodal_);
        if (!state_.contact->surface_contacts().empty()) renew_couplings(trial_.rotation);
    }
    for (int e : sweep_.turned()) wants_rebuild(e);
    if (iteration_ == 0 && sweep_.twisted() >= 0) failure_ = sweep_.twisted_reason();
}

/// Which elements flow: their part of the operator takes [D_p] (eq 10a); those that stopped go back to [D_e]. In short
/// steps, where inertia rules the operator, a [D_p] that has changed by less than `same_tangent` of [D_e] stays.
void Dynamics::yield() {
    tangents_.resize(yielding_.size());
    double section[2];
    const int n = sweep_.sections(section);
    std::size_t next = 0;
    for (int e : was_yielding_) {
        while (next < yielding_.size() && yielding_[next].element < e) ++next;
        const bool flows_on = next < yielding_.size() && yielding_[next].element == e;
        if (!flows_on && !state_.broken[e]) wants_rebuild(e), built_.erase(e);
    }
    was_yielding_.clear();
    for (std::size_t i = 0; i < yielding_.size(); ++i) {
        const Yielding& y = yielding_[i];
        const bool active[2] = {y.flow.lambda[0] > 0, y.flow.lambda[1] > 0};
        const beam::Stiffness k = stiffness_now(*structure_, state_, y.element);
        tangents_[i] = beam::plastic_tangent(y.flow.p, k, structure_->elements()[y.element].yield, section,
                                             y.flow.lambda, active, n);
        was_yielding_.push_back(y.element);
        const double same = from_rest_ || settings_.iterations > 1 ? 0 : same_tangent;
        const auto there = built_.find(y.element);
        if (there == built_.end() || !near(tangents_[i], there->second, k, same)) wants_rebuild(y.element);
    }
}

/// Rebuilds M + beta dt^2 K for the elements that turned, yielded or broke.
void Dynamics::renew_operator() {
    if (!rebuild_.empty()) {
        std::erase_if(rebuild_, [&](int e) { return state_.broken[e] != 0; });
        std::sort(rebuild_.begin(), rebuild_.end());
        std::vector<const Mat6*> given(rebuild_.size(), nullptr);
        for (std::size_t i = 0; i < yielding_.size(); ++i) {
            const auto at = std::lower_bound(rebuild_.begin(), rebuild_.end(), yielding_[i].element);
            if (at == rebuild_.end() || *at != yielding_[i].element) continue;
            given[at - rebuild_.begin()] = &tangents_[i];
            built_[*at] = tangents_[i];
        }
        force_.swap(state_.force);  // the tangent's initial-stress part reads the forces of now
        effective_->build(rebuild_, state_, trial_, given);
        for (std::size_t i = 0; i < rebuild_.size() && !support_parts_.empty(); ++i)
            if (const auto at = support_parts_.find(rebuild_[i]); at != support_parts_.end())
                at->second = effective_->part(rebuild_[i], state_, trial_, given[i]);
        force_.swap(state_.force);
        for (int e : rebuild_) {
            sweep_.mark_built(e, axes_of(place_element(*structure_, e, trial_)));
            in_rebuild_[e] = 0;
            if (mass_ && !in_mass_stale_[e]) in_mass_stale_[e] = 1, mass_stale_.push_back(e);
        }
        rebuild_.clear();
    }
    effective_->assemble();
}

/// (M + beta dt^2 K) da = F - R - M a.
void Dynamics::solve() {
    const int nodes = int(nodal_.size());
    std::vector<Vec6>& right = nodal_;
    const double check = pool_.sum(nodes, some_nodes, [&](int first, int end) {
        double sum = 0;
        for (int i = first; i < end; ++i) {
            right[i] = external_[i] - nodal_[i];
            sum += right[i].squaredNorm();
        }
        return sum;
    });
    if (!std::isfinite(check)) {
        failure_ = name_the_culprit();
        return;
    }
    take_reactions(right);
    // a change of the velocities by 3e-13 of themselves is rounding: at rest or in free flight there is nothing to
    // solve
    fastest_of_.assign((nodes + some_nodes - 1) / some_nodes, {});
    const double motion = pool_.sum(nodes, some_nodes, [&](int first, int end) {
        double sum = 0;
        for (int i = first; i < end; ++i) {
            const double v2 = trial_.velocity[i].head<3>().squaredNorm();
            sum += lumped_mass_[i] * v2;
            if (Fastest& most = fastest_of_[first / some_nodes]; v2 > most.speed) most = {v2, i, 0};
        }
        return sum;
    });
    note_fastest();
    motion_ = motion;
    settings_.solver.floor = motion * std::pow(3e-13 / settings_.dt, 2);
    const SolveReport report = effective_->solve(right, change_, settings_.solver);
    if (!report.converged)
        failure_ = settings_.solver.direct
                       ? "the operator could not be factorised"
                       : "conjugate gradients did not converge in " + std::to_string(report.iterations) +
                             " iterations; a shorter dt makes the system easier";
}

/// Adds what the change of the acceleration does over the step; decides whether Newton goes round again.
void Dynamics::correct() {
    const double dt = settings_.dt, to_u = settings_.beta * dt * dt, to_v = settings_.gamma() * dt,
                 to_a = 1 - settings_.alpha();
    if (settings_.iterations > 1) {  // Newton that swings between two sets of hinges is held back
        double whole = 0;
        for (const Vec6& c : change_) whole += c.head<3>().squaredNorm();
        if (iteration_ == 0) damping_ = 1;
        else if (whole > 0.25 * last_change_) damping_ = std::max(0.1, 0.6 * damping_);
        else damping_ = std::min(1.0, 1.5 * damping_);
        last_change_ = whole;
        if (damping_ < 1)
            for (Vec6& c : change_) c *= damping_;
    }
    const bool by_spin = from_rest_ && structure_->large();
    if (by_spin)  // a long step turns far: what was solved for is a spin on top of the rotation so far, not a part of
                  // its vector
        for (std::size_t i = 0; i < change_.size(); ++i) {
            const Vec3 before = increment_[i];
            trial_.rotation[i] = turned(to_u * change_[i].tail<3>(), trial_.rotation[i]);
            increment_[i] = rotation_vector(trial_.rotation[i] * state_.rotation[i].conjugate());
            change_[i].tail<3>() = (increment_[i] - before) / to_u;
        }
    const double size = pool_.sum(int(change_.size()), some_nodes, [&](int first, int end) {
        Lanes sum{};
        for (int i = first; i < end; ++i) {
            const Lanes change = load_row<6>(change_[i].data());
            store_row<6>(trial_.acceleration[i].data(), load_row<6>(trial_.acceleration[i].data()) + to_a * change);
            store_row<6>(trial_.velocity[i].data(), load_row<6>(trial_.velocity[i].data()) + to_v * change);
            store_row<3>(trial_.displacement[i].data(), load_row<3>(trial_.displacement[i].data()) + to_u * change);
            if (!by_spin)
                store_row<3>(increment_[i].data(), load_row<3>(increment_[i].data()) + to_u * second_three(change));
            sum += change * change;
        }
        if (!by_spin) move_to_increment(first, end);
        return sum[0] + sum[1] + sum[2];
    });
    meet_supports();
    if (settings_.automatic) {
        double jump = 0;
        for (std::size_t i = 0; i < change_.size(); ++i) jump += lumped_mass_[i] * change_[i].head<3>().squaredNorm();
        jump_ = motion_ > 0 ? dt * std::sqrt(jump / motion_) : 0;
    }
    ++iteration_;
    if (iteration_ == 1) first_change_ = size;
    again_ = iteration_ < settings_.iterations && size > settings_.tolerance * settings_.tolerance * first_change_;
    if (!again_ && settings_.iterations == 1 && iteration_ < 8 && in_contact() &&
        !state_.contact->surface_contacts().empty()) {
        place_contact(trial_.displacement);
        again_ = state_.contact->unsettled(contact_position_, trial_.rotation);
    }
    if (!again_) {
        if (settings_.alpha() != 0) leave_met();
        if (built::fracture) keep_stub_momentum(change_);
    }
    if (settings_.iterations > 1 && iteration_ == settings_.iterations && size > 1e-6 * first_change_ &&
        first_change_ > 1e-12)
        failure_ = "Newton did not converge in " + std::to_string(iteration_) + " iterations (last correction " +
                   std::to_string(std::sqrt(size / first_change_)) +
                   " of the first); a shorter dt or more iterations may help";
}

/// What was tried becomes the state.
void Dynamics::commit() {
    if (with_contact()) note_contacts();
    book_supports();
    state_.accumulated.work += work_of_loads();
    for (Loaded& l : loaded_) l.before = l.now;
    state_.accumulated.numerical += numerical_;
    stub_rate_.swap(next_stub_rate_);
    if (settings_.alpha() != 0) met_.swap(next_met_);
    state_.displacement.swap(trial_.displacement);
    state_.rotation.swap(trial_.rotation);
    state_.turn.swap(trial_.turn);
    state_.velocity.swap(trial_.velocity);
    state_.acceleration.swap(trial_.acceleration);
    state_.force.swap(force_);
    if (from_rest_) {
        hinges_ = yielding_;
        for (Yielding& y : hinges_)
            for (double& lambda : y.flow.lambda)
                lambda = lambda > 0 ? 1e-300 : 0;  // the next step's D_p is that of a beginning
    }
    for (int e : commit_flow(*structure_, state_, yielding_, flowing_)) {
        take_up_ = true;
        wants_rebuild(e);
    }
    if (with_fracture())
        for (const Yielding& y : yielding_) heed_fracture(y.element);
    if (built::fracture && !to_break_.empty()) {
        wake_bodies();
        right_.assign(nodal_.size(), Vec6::Zero());  // what breaking asks of the nodes
    }
    for (const auto& [element, end] : to_break_) {
        const Element& e = structure_->elements()[element];
        ++breaks_;
        const BreakReport report = break_off(*structure_, state_, element, end, right_);
        if (effective_) effective_->remove(element), effective_->set_held(state_.held);
        renew_hung_operator(report.carrier);
        if (!in_mass_stale_[element]) in_mass_stale_[element] = 1, mass_stale_.push_back(element);
        if (structure_->model().gravity())
            for (int at : {0, 1}) {
                const int n = e.node[at];
                const Vec3 weight = structure_->inertia(element).weight(at) * *structure_->model().gravity();
                external_[n].head<3>() -= weight;
                for (Loaded& l : loaded_)
                    if (l.node == n) l.gravity.head<3>() -= weight;
            }
        if (with_contact()) {
            state_.accumulated.contact_released += state_.contact->drop(element);
            bars_changed_ = true;
        }
        sweep_.drop(element);
        if (report.orphaned)
            for (int n : e.node)
                if (state_.gone[n]) held_nodes_.push_back(n);
        std::erase(fracture_candidates_, element);
    }
    if (take_up_) sweep_.take_up(state_);
    take_up_ = false;
    if (built::fracture && !to_break_.empty()) {
        renew_mass(pose_of(state_));
        const double before = work_on_momentum(state_.velocity);
        pass_on(state_, *mass_, right_);
        state_.accumulated.work += work_on_momentum(state_.velocity) - before;
        if (with_contact()) {
            list_bars();
            place_contact(state_.displacement);
            state_.contact->hang_on(bars_, contact_position_, state_.rotation);
            renew_couplings(state_.rotation);
        }
        to_break_.clear();
        restart_ = true;
    }
    if (controlled() && restart_)
        kept_remainder_ = energy().remainder;  // what breaking and letting go left in the ledger is no step's
    watch_effects();
    ++state_.step;
    pace_.done += pace_.length;
    if (settings_.automatic || controlled()) state_.time = pace_.start + double(pace_.done) * pace_.unit;
    else state_.time += settings_.dt;
}

// ---- steps that are taken back --------------------------------------------------------------------------------------

/// Whatever a step changes before it commits, beside what is tried.
void Dynamics::remember() {
    kept_before_.clear();
    strained_before_.clear();
    if (with_contact()) state_.contact->remember();
    undo_ = {state_.accumulated, pace_, restart_, bars_changed_, contact_age_, fastest_};
}

/// A rule of the script failed, or step control takes the step back: all as it was before.
void Dynamics::take_back() {
    for (auto kept = kept_before_.rbegin(); kept != kept_before_.rend(); ++kept) *kept->at = kept->before;
    for (const Strained& s : strained_before_) std::copy(s.before.begin(), s.before.end(), s.at);
    set_length(undo_.pace.length);
    state_.accumulated = undo_.accumulated;
    pace_ = undo_.pace;
    restart_ = undo_.restart, bars_changed_ = undo_.bars_changed, contact_age_ = undo_.contact_age,
    fastest_ = undo_.fastest;
    to_break_.clear();
    if (!with_contact()) return;
    state_.contact->take_back();
    place_contact(state_.displacement);
    renew_couplings(state_.rotation);
}

// ---- what the stages use ------------------------------------------------------------------------------------------

/// The element's part of the operator is to be built anew.
void Dynamics::wants_rebuild(int element) {
    if (effective_ && !in_rebuild_[element]) in_rebuild_[element] = 1, rebuild_.push_back(element);
}

void Dynamics::move_to_increment(int first, int end) {
    if (structure_->large()) return turn_all(increment_, state_.rotation, trial_.rotation, first, end);
    for (int i = first; i < end; ++i) trial_.turn[i] = state_.turn[i] + increment_[i];
}

/// What the supports must add to hold their freedoms: out of the forces, into the reactions.
void Dynamics::take_reactions(std::vector<Vec6>& right) {
    for (int n : held_nodes_) {
        Vec6& r = reaction_[n];
        r.setZero();
        for (int c = 0; c < 6; ++c)
            if (state_.held[n] >> c & 1) r[c] = -right[n][c], right[n][c] = 0;
    }
}

/// Takes up what each piece of the nodes found: squared speeds.
void Dynamics::note_fastest() {
    for (const Fastest& f : fastest_of_)
        if (f.speed > fastest_.speed * fastest_.speed)
            fastest_ = {std::sqrt(f.speed), f.node, state_.time + settings_.dt};
}

std::string Dynamics::name_the_culprit() const {
    for (std::size_t i = 0; i < force_.size(); ++i)
        if (!state_.broken[i] && !force_[i].allFinite())
            return "the forces of " + structure_->element_name(int(i)) + " are not finite";
    for (std::size_t i = 0; i < nodal_.size(); ++i)
        if (!nodal_[i].allFinite()) return "the forces at " + structure_->node_name(int(i)) + " are not finite";
    for (std::size_t i = 0; i < external_.size(); ++i)
        if (!external_[i].allFinite()) return "the load on " + structure_->node_name(int(i)) + " is not finite";
    std::size_t most = 0;  // each is finite, what they add up to is not
    for (std::size_t i = 0; i < nodal_.size(); ++i)
        if (nodal_[i].cwiseAbs().maxCoeff() > nodal_[most].cwiseAbs().maxCoeff()) most = i;
    return "the forces at " + structure_->node_name(int(most)) + " grow without bound";
}

}  // namespace hinge

// What a run of dynamics says of itself: its plan and its counts to whoever asks, all that later steps depend on to a
// checkpoint.
#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "effects/all_effects.h"
#include "run/dynamics.h"
#include "run/failure_check.h"
#include "state/hinge_records.h"
#include "state/joint_records.h"

namespace hinge {

double Dynamics::part_done() const { return double(steps_done()) / double(std::max(1L, planned_steps())); }

std::string Dynamics::way_done() const {
    return "at t = " + number_text(state_.time, 4) + " s, after " + std::to_string(steps_done()) + " of " +
           count_text(planned_steps(), "step");
}

std::optional<double> Dynamics::shortest_controlled() const {
    if (!(settings_.step_control > 0) && rejected() == 0) return {};
    return shortest_taken();
}

EffectiveStiffness::Counts Dynamics::solver_counts() const {
    const EffectiveStiffness* effective = integrator_->effective();
    return effective ? effective->counts() : EffectiveStiffness::Counts{};
}

double Dynamics::time_product(int repeats) const {
    const EffectiveStiffness* effective = integrator_->effective();
    return effective ? effective->time_product(repeats) : 0;
}

std::vector<PlanLine> Dynamics::effects() const {
    std::vector<PlanLine> list = plan_of(*structure_, w_.kind);
    std::string because = (explicit_steps()       ? "explicit steps of "
                           : settings_.conserving ? "energy-momentum method, steps of "
                                                  : "Newmark's method, steps of ") +
                          time_text(shortest()) +
                          (explicit_steps()      ? ", lumped masses"
                           : settings_.automatic ? ", eight times that where nothing happens"
                                                 : "") +
                          (structure_->cubic() ? ", cubic mass" : "");
    char how[160];
    if (length_.control().on())
        std::snprintf(how, sizeof how, ", halved where one would lose more than its share of %.2g %% of the energy",
                      100 * settings_.step_control),
            because += how;
    if (settings_.alpha() != 0)
        std::snprintf(how, sizeof how, ", of the highest frequencies %.3g is left after a step",
                      settings_.rho_infinity),
            because += how;
    list.front().because = because;
    stages_.add_to(list), times_.add_to(list);
    return list;
}

/// Parts of the effective stiffness, of M and of contact's list of pairs were made at one time or another and are
/// renewed when something has rotated or travelled far enough: they are kept as they are. What follows from the state
/// and from them alone (blocks condensed to the joints, bars, which sections elements share) is found anew.
template <class Self, class A>
void Dynamics::fields(Self& s, A& a) {
    Run::fields(s, a);
    a(s.length_, s.stages_, s.times_, s.w_.external, s.w_.steady, s.w_.force, s.w_.supported, s.w_.yielding,
      s.w_.weighted, s.forces_, s.sleepers_);
    if constexpr (A::reading) s.energy_check_.make_room(s.state_);
    a(s.energy_check_);
    for (const auto& e : s.effects_->all)
        if constexpr (A::reading) e->restore(a);
        else e->save(a);
    if constexpr (A::reading) s.integrator_->restore(a);
    else s.integrator_->save(a);
    a(s.mass_);
}

void Dynamics::save(std::string& to) const {
    save_run(to);
    Writer write(to);
    save_watches(write);
}

void Dynamics::save_run(std::string& to) const {
    Writer write(to);
    fields(*this, write);
    write(assembly_);
}

void Dynamics::restore(std::string_view saved) {
    std::string now;
    save(now);
    const auto read_all = [this](std::string_view from) {
        Reader reader(from);
        read(reader);
        restore_watches(reader);
        reader.must(reader.rest().empty());
    };
    try {
        read_all(saved);
    } catch (...) {
        read_all(now);
        throw;
    }
}

/// All that a checkpoint would hold, but for what belongs to the run itself.
void Dynamics::go_on_as(const Dynamics& before) {
    std::string saved, now;
    before.save_run(saved), save_run(now);
    const Stages stages = stages_;
    const std::vector<Notice> notices = notices_;
    const std::vector<Activation> activations = activations_;
    const double its_error = before.energy().error;
    const StepSize size = length_.size();
    length_.lengthen(before.length_);
    try {
        Reader reader(saved);
        read(reader);
    } catch (const Damaged&) {
        Reader reader(now);
        read(reader);
        length_.restore(size);
        return;
    }
    watch_as(before);
    if (auto* records = state_.data.find<HingeRecords>(hinge_records))
        for (HingeRecord& hinge : records->list) ++hinge.runs_ago;
    if (auto* records = state_.data.find<JointRecords>(joint_records)) records->one_run_later();
    stages_ = stages, notices_ = notices, activations_ = activations;
    verdict_ = Verdict::running, failure_ = {};
    state_.step = first_step_ = breaks_ = 0;
    at_start_ = state_.accumulated;
    Accounts counted;  // the potential energy of gravity counts from where `before` began
    for (const auto& e : effects_->all) e->add_energy(state_, counted);
    if (const double potential = counted["gravity"]; potential != 0) {
        state_.accumulated["gravity"] += 0;  // so that it is there
        at_start_["gravity"] += potential;
    }
    initial_ = 0;
    initial_ -= energy_of(state_).error;
    if (length_.control().on()) length_.leave_behind(-its_error);
    length_.count_anew();
    integrator_->fastest = {};
    energy_check_.begin(state_, std::lround(settings_.duration / shortest()));
}

void Dynamics::read(Reader& reader) {
    fields(*this, reader);
    reader.must(makes_sense());
    w_.trial = state_;
    std::vector<const State*> states{&state_};
    if (const State* good = energy_check_.good_state()) states.push_back(good);
    // a run that has failed may have gone back to a state from before what its effects keep, and takes no step any more
    for (const auto& e : effects_->all) reader.must(e->restored(states) || verdict_ == Verdict::failed);
    if (constraints_) constraints_->rebuild();
    assembly_.update_active(state_);
    reader(assembly_);
}

/// Whether what was read fits the structure and its settings.
bool Dynamics::makes_sense() const {
    const int nodes = int(structure_->position().size()), elements = int(structure_->elements().size());
    const auto within = [](int n) { return [n](int i) { return i >= 0 && i < n; }; };
    const auto all = [](const auto& list, auto good) { return std::all_of(list.begin(), list.end(), good); };
    const bool states = hinge::makes_sense(state_, *structure_) && (verdict_ == Verdict::failed || is_finite(state_)) &&
                        (!energy_check_.good_state() || (hinge::makes_sense(*energy_check_.good_state(), *structure_) &&
                                                         is_finite(*energy_check_.good_state())));
    const bool lengths = int(w_.external.size()) == nodes && int(w_.steady.size()) == nodes &&
                         int(w_.force.size()) == elements &&
                         int(w_.weighted.size()) == (settings_.alpha() == 0 ? 0 : nodes);
    bool held = true;  // stay where they are, in explicit steps
    for (int n = 0; states && mass_.now() && structure_->lumped() && n < nodes; ++n)
        for (int c = 0; c < 6; ++c)
            held = held && (!(state_.held[n] >> c & 1) || mass_.now()->lumped_inverse()[n][c] == 0);
    const auto good_notice = [&](const Notice& n) {
        return n.kind == Notice::Kind::starts_beyond_yield && within(elements)(n.element);
    };
    return states && lengths && held && all(notices_, good_notice) && hinge::makes_sense(failure_, *structure_) &&
           length_.size().makes_sense() && sleepers_.fits() && verdict_ >= Verdict::running &&
           verdict_ <= Verdict::failed && all(w_.supported, within(nodes)) &&
           all(w_.yielding, [&](const PlasticIncrement& y) { return within(elements)(y.element); }) &&
           all(reaction_, [&](const auto& r) { return within(nodes)(r.first); }) && fastest().node < nodes;
}

}  // namespace hinge

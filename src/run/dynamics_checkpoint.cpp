// Dynamics, what a checkpoint holds: whatever the bits of the next steps depend on, and what was counted so far.
//
// ElementMatrices of the operator, of M and of contact's list of pairs were made at one time or another and are renewed
// when something has turned or travelled far enough: they are kept as they are. What follows from the state and from
// them alone (blocks condensed to the joints, bars, which sections elements share) is found anew.
#include <algorithm>

#include "core/archive.h"
#include "run/dynamics.h"

namespace hinge {
namespace {

constexpr int most_counted = 1 << 29;  ///< of what a run counts step by step

}  // namespace

template <class Self, class A>
void Dynamics::fields(Self& s, A& a) {
    Run::fields(s, a);
    a(s.settings_.dt, s.pace_.done, s.pace_.length, s.pace_.least, s.pace_.calm, s.pace_.start, s.pace_.easy,
      s.pace_.patience, s.pace_.rejected, s.kept_remainder_, s.jump_, s.motion_, s.fastest_);
    for (auto& stage : s.stages_) a(stage.seconds);
    a(s.external_, s.change_, s.force_, s.held_nodes_, s.mass_stale_, s.flowing_, s.fracture_candidates_, s.watched_);
    for (auto& l : s.loaded_) a(l.gravity, l.now, l.before);
    for (auto& [load, acting] : s.rule_loads_) a(acting);
    a(s.yielding_, s.hinges_, s.was_yielding_, s.built_, s.rebuild_, s.hung_built_, s.met_, s.stub_rate_);
    a(s.bars_changed_, s.restart_, s.contact_age_, s.pair_rules_, s.resting_, s.weight_at_rest_);
    bool good = s.good_.has_value();
    a(s.looked_at_, s.turned_over_, good);
    if constexpr (A::reading) good ? void(s.good_ = Good{s.state_, 0}) : s.good_.reset();
    if (good) a(s.good_->state, s.good_->share);
    for (auto* sleeper : {&s.contact_sleeper_, &s.plasticity_sleeper_}) a(sleeper->awake, sleeper->quiet);
    for (auto& m : s.moved_) {
        a(m.from, m.now, m.before, m.long_before, m.apart, m.next, m.speed, m.acceleration, m.force, m.next_force,
          m.begun);
        for (int e : s.structure_->elements_at(m.node)) a(s.support_parts_.at(e));
    }
    if (s.effective_) a(*s.effective_);
    if (s.mass_) a(*s.mass_);
}

void Dynamics::save(std::string& to) const {
    Writer write(to);
    fields(*this, write);
    write(sweep_);
}

void Dynamics::restore(std::string_view saved) {
    std::string now;
    save(now);
    try {
        read(saved);
    } catch (...) {
        read(now);
        throw;
    }
}

void Dynamics::read(std::string_view saved) {
    Reader reader(saved);
    const std::size_t strained = state_.strained.size(), kept = state_.kept.size();
    fields(*this, reader);
    reader.must(state_.strained.size() == strained && state_.kept.size() == kept && makes_sense());

    const auto mark = [&](std::vector<char>& marks, const std::vector<int>& elements) {
        marks.assign(state_.broken.size(), 0);
        for (int e : elements) marks[e] = 1;
    };
    mark(in_rebuild_, rebuild_);
    mark(in_candidates_, fracture_candidates_);
    mark(in_mass_stale_, mass_stale_);
    trial_ = pose_of(state_);
    if (with_contact()) {
        list_bars();
        for (const State* s : {&state_, good_ ? &good_->state : &state_})
            reader.must(s->contact->makes_sense(int(s->displacement.size()), int(s->broken.size()), int(bars_.size())));
    }
    if (effective_) effective_->leave_out(resting_);
    sweep_.take_up(state_);
    reader(sweep_);
    reader.must(reader.rest().empty());
}

/// Whether what was read fits the structure and its settings.
bool Dynamics::makes_sense() const {
    const int nodes = int(structure_->position().size()), elements = int(structure_->elements().size());
    const auto within = [](int n) { return [n](int i) { return i >= 0 && i < n; }; };
    const auto all = [](const auto& list, auto good) { return std::all_of(list.begin(), list.end(), good); };
    const auto element = [&](const auto& of) { return within(elements)(of.element); };
    const auto node_key = [&](const auto& entry) { return within(nodes)(entry.first); };
    const auto long_as = [](const auto& list, int n) { return list.empty() || int(list.size()) == n; };
    for (const std::vector<int>* list : {&mass_stale_, &flowing_, &fracture_candidates_, &was_yielding_, &rebuild_})
        if (!all(*list, within(elements))) return false;
    const auto state = [&](const State& s) {
        return hinge::makes_sense(s, *structure_) && s.strained.size() == state_.strained.size() &&
               s.kept.size() == state_.kept.size();
    };
    const bool states = state(state_) && (verdict_ == Verdict::failed || is_finite(state_)) &&
                        (!good_ || (state(good_->state) && is_finite(good_->state)));
    const auto counts = [](int n) { return n >= 0 && n <= most_counted; };
    const bool pace = counts(pace_.calm) && counts(pace_.easy) && counts(pace_.patience) && pace_.length >= 1 &&
                      pace_.least >= 1 && pace_.done >= 0 && pace_.done <= pace_.whole &&
                      settings_.dt == pace_.unit * double(pace_.length);
    const bool lengths = int(external_.size()) == nodes && int(change_.size()) == nodes &&
                         int(force_.size()) == elements && long_as(hung_built_, nodes) &&
                         (state_.offset_mass.empty() || !hung_built_.empty()) && long_as(resting_, nodes) &&
                         stub_rate_.size() <= state_.offset_mass.size() &&
                         int(met_.size()) == (settings_.alpha() == 0 ? 0 : nodes);
    bool held = true;  // stay where they are, in explicit steps
    for (int n = 0; states && mass_ && structure_->lumped() && n < nodes; ++n)
        for (int c = 0; c < 6; ++c) held = held && (!(state_.held[n] >> c & 1) || mass_->lumped_inverse()[n][c] == 0);
    return states && pace && lengths && held && verdict_ >= Verdict::running && verdict_ <= Verdict::failed &&
           all(held_nodes_, within(nodes)) && all(watched_, element) && all(yielding_, element) &&
           all(hinges_, element) && all(weight_at_rest_, node_key) && all(reaction_, node_key) && fastest_.node < nodes;
}

}  // namespace hinge

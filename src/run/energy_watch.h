// What the energy balance error is held against, whether a run may go on, and whether a step is kept.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "run/step_size.h"
#include "state/state.h"

namespace hinge {

/// The largest energy: the largest value that any account of the balance has had so far.
///
/// An account counts only up to what the other side of the balance explains, so that energy made by an error does not
/// enlarge the value that the error is compared with: what is held or dissipated counts up to initial energy + supplied
/// work + what other accounts (gravity, springs, ground) have given; what has been given counts up to what is held or
/// dissipated. Where the balance closes, neither limit acts.
class LargestEnergy {
public:
    explicit LargestEnergy(const Structure& structure);
    /// The energy balance error as a part of the largest energy; not finite where an account is not. Below the
    /// floor all is rounding, and the part 0.
    double share(const Energy& energy, const AccountList& accounts);
    double most() const { return most_; }
    void set_most(double most) { most_ = most; }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.most_);
    }

private:
    double most_ = 0, floor_ = 0;  ///< J
};

/// An energy balance that did not close: of the step at which that was seen, whatever state the run then goes back to.
struct LostBalance {
    long step = 0;
    double time = 0;    ///< s
    double factor = 0;  ///< load factor of the state
    Energy energy;
    double share = 0;        ///< its error as a part of the largest energy
    bool went_back = false;  ///< a good state was kept, and is the run's again
};

/// Now and then the energy balance is looked at. A run in which it no longer closes, or whose error grew too much since
/// the last look, ends with the last state in which it was well.
class Guard {
public:
    Guard(double tolerance, long steps) : tolerance_(tolerance), steps_(steps) {}
    /// The state that the run begins with is good.
    void begin(const State& state);
    bool due(const State& state, bool running) const;
    /// Null while the balance closes: the state is kept as good. Else what happened; `state` becomes the last good one,
    /// if there is one, and `largest` what it was before. `may_grow`: by which the error may, since the last look.
    std::optional<std::string> look(State& state, const Energy& energy, const AccountList& accounts,
                                    LargestEnergy& largest, bool running, double may_grow, const std::string& fastest);
    const std::optional<LostBalance>& lost() const { return lost_; }
    double error() const { return error_; }  ///< J, of the balance at the last look at which it closed

    /// By how much of the largest energy the error may grow between two looks: half the tolerance. While members are in
    /// contact it swings by up to 2 % (scripts/paper/two_beam_impact.lua, steps of 40 us).
    static double may_grow(double tolerance) { return 0.5 * tolerance; }
    /// And in one step: a tenth of the tolerance, or 1 % where that is more, and never more than half of it.
    static double may_jump(double tolerance) { return std::max(0.1 * tolerance, std::min(0.01, 0.5 * tolerance)); }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        bool good = s.good_.has_value();  // where it is read: make_room has been called
        a(s.looked_at_, s.error_, good);
        if (good) a(s.good_->state, s.good_->share);
        else if constexpr (A::reading) s.good_.reset();
    }
    const State* good_state() const { return good_ ? &good_->state : nullptr; }
    /// Before its fields are read: room for a state with the same data of effects.
    void make_room(const State& like) { good_ = Good{like, 0}; }

private:
    struct Good {
        State state;
        double share;
    };
    double tolerance_;
    long steps_;
    std::optional<Good> good_;  ///< when the balance was last looked at and closed
    long looked_at_ = 0;        ///< the step of that
    double error_ = 0;          ///< J, of the balance then
    std::optional<LostBalance> lost_;
};

/// A step may lose its share of what the run may lose, or whatever the steps before it have left over.
class StepControl {
public:
    explicit StepControl(double tolerance) : tolerance_(tolerance) {}
    bool on() const { return tolerance_ > 0; }
    /// Why the step that was tried is not kept, or null.
    std::optional<std::string> refuse(const Energy& energy, const AccountList& accounts, LargestEnergy& largest,
                                      StepSize& size);
    void start_from(double error) { kept_error_ = error; }  ///< what a break left in the balance is no step's
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.kept_error_);
    }

private:
    double tolerance_;       ///< part of the largest energy that the run may lose
    double kept_error_ = 0;  ///< J, of the last step that was kept
};

}  // namespace hinge

// What the energy balance error is held against, whether a run may go on, and whether a step is kept.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/failure.h"
#include "run/step_size.h"
#include "state/state.h"

namespace hinge {

/// An energy error, as a part of the largest energy, of which a run that completes warns.
inline constexpr double large_error = 0.01;

/// The largest energy: the largest value that any account of the balance has had so far.
///
/// An account counts only up to what the other side of the balance explains, so that energy made by an error does not
/// enlarge the value that the error is compared with: what is held or dissipated counts up to initial energy + supplied
/// work + what other accounts that may give (gravity, connectors) have given; what has been given counts up to what is
/// held or dissipated. Where the balance closes, neither limit acts.
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
    double good_share = 0;   ///< the error of that state, likewise
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.step, s.time, s.factor, s.energy, s.share, s.went_back, s.good_share);
    }
};

/// The largest energy error of a run so far, among the steps whose energy balance was computed.
struct LargestError {
    double share = 0;  ///< of the largest energy up to then, with its sign
    double time = 0;   ///< s
    void include(double other, double at) {
        if (std::abs(other) > std::abs(share)) share = other, time = at;
    }
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.share, s.time);
    }
};

/// Computes the energy balance now and then. A run in which it no longer closes, or whose error grew too much since the
/// last time, ends with the last state in which the balance closed. With a tolerance of 0 no run ends; the largest
/// error is kept all the same.
class EnergyMonitor {
public:
    EnergyMonitor(double tolerance, long steps) : tolerance_(tolerance), steps_(steps) {}
    /// The state that the run begins with is good.
    void begin(const State& state);
    bool due(const State& state, bool running) const;
    /// None while the balance closes: the state is kept as good. Else what happened; `state` becomes the last good one,
    /// if there is one (lost()), and `largest` what it was before. `may_grow`: by which the error may, since the last
    /// check.
    Failure check(State& state, const Energy& energy, const AccountList& accounts, LargestEnergy& largest, bool running,
                  double may_grow);
    const std::optional<LostBalance>& lost() const { return lost_; }
    double error() const { return error_; }  ///< J, of the balance at the last check at which it closed
    const LargestError& largest_error() const { return largest_error_; }
    /// An energy error that was computed elsewhere, of a step that is kept; as LargestError::include.
    void note_error(double share, double time) { largest_error_.include(share, time); }
    /// Whether the balance must be computed although no check is due: where it may be off by `swing` J for a moment,
    /// and that would be a large error, larger than any that is known. Such a check ends no run. most: the largest
    /// energy, J.
    bool may_miss(double swing, double most) const;

    /// By how much of the largest energy the error may grow between two checks: half the tolerance, or 1 % where that
    /// is more.
    static double may_grow(double tolerance) { return std::max(0.5 * tolerance, std::min(0.01, tolerance)); }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        bool good = s.good_.has_value();  // where it is read: make_room has been called
        a(s.checked_, s.error_, s.largest_error_, s.lost_, good);
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
    std::optional<Good> good_;  ///< when the balance was last checked and closed
    long checked_ = 0;          ///< the step of that
    double error_ = 0;          ///< J, of the balance then
    LargestError largest_error_;
    std::optional<LostBalance> lost_;
};

/// A step may lose its share of what the run may lose, or whatever the steps before it have left over.
///
/// By default (`by_default`) the balance is checked every so many steps: every step while the error grows, up to 32
/// steps apart while it does not, and at once where something abrupt happens. And what dt / 64 still loses is kept: a
/// loss at one instant is no later step's, one that goes with time however short the step is, is then expected of later
/// steps. The energy monitor decides how much of that a run may have.
class StepControl {
public:
    StepControl(double tolerance, bool by_default) : tolerance_(tolerance), by_default_(by_default && tolerance > 0) {}
    bool on() const { return tolerance_ > 0; }
    bool by_default() const { return by_default_; }  ///< it is on, and the script has not said how
    /// Whether the balance of the step that is tried must be known; `abrupt`: something happens in it.
    bool due(bool abrupt, const StepSize& size) const;
    /// A change of the motion, as a part of the largest energy, that is abrupt.
    double abrupt() const;
    /// Why the step that was tried is not kept, or none. `energy`: of its end; `before`: called for the error of the
    /// balance where it begins, J.
    template <class Before>
    Failure refuse(const Energy& energy, const AccountList& accounts, LargestEnergy& largest, StepSize& size,
                   Before before) {
        const Failure why = compare(energy, accounts, largest, size);
        if (!why || since_ == 0) return why;
        begin_from(before());  // the steps that were not checked are kept, and each one is checked now
        return compare(energy, accounts, largest, size);
    }
    void skip(StepSize& size);
    /// The energy error of the last step that was checked and kept, as a part of the largest energy; 0 while that
    /// still grows fast.
    double kept_share() const { return kept_share_; }
    void begin_from(double error);    ///< the steps so far are kept, and the coming ones are checked
    void start_from(double error);    ///< what a break left in the balance is no step's
    void leave_behind(double error);  ///< the same, where only its change is known, J
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.kept_error_, s.left_, s.since_, s.since_units_, s.between_, s.first_refused_, s.rate_);
    }

private:
    Failure compare(const Energy& energy, const AccountList& accounts, LargestEnergy& largest, StepSize& size);
    double tolerance(const StepSize& size) const;
    double known_loss(double left, const StepSize& size) const;

    double tolerance_;  ///< part of the largest energy that the run may lose
    bool by_default_;
    double kept_error_ = 0;     ///< J, of the last step that was kept and checked
    double kept_share_ = 0;     ///< the same as a part of the largest energy; read at once, so not in a checkpoint
    double left_ = 0;           ///< J, of that: kept because no shorter step would make it smaller
    long since_ = 0;            ///< steps since then
    long since_units_ = 0;      ///< their length, in units of StepSize
    double first_refused_ = 0;  ///< J, the loss of the longest step that was taken back here; 0: none was
    double rate_ = 0;           ///< J a unit of StepSize, that is lost whatever the step is long
    long between_ = 1;          ///< steps from one check to the next
};

}  // namespace hinge

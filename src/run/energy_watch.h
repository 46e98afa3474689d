// What the energy balance error is held against, whether a run may go on, and whether a step is kept.
#pragma once

#include <optional>

#include "run/step_size.h"
#include "state/state.h"

namespace hinge {

/// The largest energy: the largest value that any account of the balance has had so far.
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

/// Now and then the energy balance is looked at. A run in which it no longer closes ends, with the last state in which
/// it did.
class Guard {
public:
    Guard(double tolerance, long steps) : tolerance_(tolerance), steps_(steps) {}
    bool due(const State& state, bool running) const;
    /// `share`: LargestEnergy's. Null while the balance closes: the state is kept as good. Else what happened; `state`
    /// becomes the last good one, if there is one.
    std::optional<std::string> look(State& state, double share, bool running, const std::string& fastest);

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        bool good = s.good_.has_value();  // where it is read: make_room has been called
        a(s.looked_at_, good);
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

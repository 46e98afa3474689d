// How long the next step is: dt = "auto" of Newmark's method, and the halving of steps that were taken back.
//
// The shortest step is that of automatic_step.h; it is the step of an impact. In free flight, and while nothing yields,
// breaks or touches, steps are eight times that, as long as the accelerations change little within one: where something
// vibrates, they do not. Contacts and loads are foreseen: a long step in which a contact would begin, or a load
// changes, is not taken.
//
// With step control, a step that was taken back is halved, and steps grow again once that has gone well for a while.
#pragma once

#include <algorithm>
#include <bit>

#include "model/structure.h"
#include "run/automatic_step.h"

namespace hinge {

/// How far the axial wave comes in a step, against the shortest element: the axial Courant number; where hinges may
/// chatter, the shear vibration's phase too.
double axial_courant_number(const Structure& structure, double dt);
class StepSize {
public:
    StepSize(double dt, double duration, bool automatic, bool controlled, double start);

    double dt() const { return unit_ * double(length_); }
    double own() const { return unit_ * double(own_); }  ///< s: dt of the settings, with "auto" the shortest
    double least_taken() const { return unit_ * double(least_); }
    double end() const { return start_ + double(done_) * unit_; }  ///< s, where the steps so far have ended
    bool over() const { return done_ >= whole_; }
    bool longer() const { return length_ > own_; }  ///< than the script's own dt
    /// How often the coming step has been halved from dt.
    int halvings() const { return length_ < own_ ? std::countr_zero(unsigned(own_ / length_)) : 0; }
    bool fine() const { return length_ <= own_ / fine_part; }
    bool varies() const { return automatic_ || own_ > 1; }
    long units_left() const { return whole_ - done_; }
    long left() const { return (whole_ - done_) / std::max(length_, own_); }
    long whole() const { return whole_; }
    double of_run() const { return double(length_) / double(whole_); }  ///< the coming step's part of the duration
    double part_of_run(long units) const { return double(units) / double(whole_); }
    double so_far() const { return double(done_) / double(whole_); }
    long rejected() const { return rejected_; }

    /// How many times the shortest step the next one should be, in units; `calm`: nothing needs the shortest; `jump`:
    /// dt |da| / |v| of the last step; `changes`: asked whether a load changes within a long step.
    template <class Changes>
    long next(bool calm, double jump, Changes changes) {
        if (length_ < own_) {
            if (easy_ < patience_ || done_ % (2 * length_) != 0) return length_;
            easy_ = 0;
            grew_ = true;
            return 2 * length_;
        }
        if (easy_ >= patience_) patience_ = first_patience;
        if (!automatic_) return length_;
        const long longest = long_step * own_;
        const double longer =
            double(longest) / double(length_);  // da grows with dt: what a short step says of a long one
        calm = calm && jump * longer * longer <= jump_limit;
        calm_ = calm ? calm_ + 1 : 0;
        const bool fits = done_ + longest <= whole_;
        return fits && calm && (length_ > own_ || calm_ >= calm_steps) && !changes() ? longest : own_;
    }
    /// A step of that many units follows. False where it is so long already.
    bool set_length(long length);
    long length() const { return length_; }
    long own_length() const { return own_; }
    void count_step() { done_ += length_; }
    /// A step was kept; `easy`: it lost far less than it might.
    void count_easy(bool easy);
    /// A step of `tried` units was taken back: how long the next is.
    long halved(long tried);

    static constexpr long long_step = 8;      ///< of the shortest
    static constexpr int calm_steps = 20;     ///< before steps are long: K anew costs as much as ten steps
    static constexpr int first_patience = 8;  ///< halved steps that must go well before they are doubled; twice as many
                                              ///< where a step fails that was doubled before
    static constexpr int most_patience = 128;
    static constexpr double jump_limit = 1e-3;  ///< dt |da| against |v| in a long step, weighted by mass: its error is
                                                ///< a twelfth of that
    static constexpr long fine_part = 64;       ///< of a step, that contact which a usual step misses is resolved by
    static constexpr long finest_part = 1024;   ///< of a step, with step control: a power of two, so that times stay
                                                ///< those of whole steps to the bit

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.done_, s.length_, s.least_, s.calm_, s.start_, s.easy_, s.patience_, s.grew_, s.rejected_);
    }
    bool makes_sense() const;
    /// The same, of a duration that is longer by these steps.
    void lengthen(const StepSize& before) { whole_ += before.done_; }
    /// What was counted so far was another run's.
    void count_anew() { least_ = length_, rejected_ = 0; }

private:
    double unit_;  ///< s: own steps, or with step control the finest; lengths are counted in it
    long own_, whole_;
    bool automatic_;
    long done_ = 0, length_ = own_, least_ = own_;
    int calm_ = 0;
    double start_;
    int easy_ = 0, patience_ = first_patience;
    bool grew_ = false;  ///< steps were doubled since one was taken back
    long rejected_ = 0;
};

}  // namespace hinge

// How long the coming step is, and whether the one that was tried is kept.
#pragma once

#include "effects/effect_list.h"
#include "run/energy_monitor.h"
#include "run/settings.h"

namespace hinge {

/// The settings of a run, fitted to what effects add to the elements: a chosen dt is shortened, too long an explicit
/// one refused (InputError), and step control left out where nothing calls for it. The elements' own limit was checked
/// where the settings were read.
DynamicSettings fitted_to_effects(DynamicSettings settings, const Workspace& w, const EffectList& effects);

/// An element that is pressed flat: it has no length left that steps could be short against.
Failure find_crushed(const Structure& structure, const State& state);

class StepLength {
public:
    StepLength(const DynamicSettings& settings, const Workspace& w);

    const StepSize& size() const { return size_; }
    const StepControl& control() const { return control_; }
    bool controls() const { return controls_; }  ///< steps may be taken back

    /// In units of StepSize, of the coming step. `calm`: no force has vanished; `jump`: Integrator::jump.
    long next(const EffectList& effects, bool calm, double jump);
    /// A step of that many units follows. False where it is so long already.
    bool set(long length) { return size_.set_length(length); }
    /// Of a step of `tried` units that was taken back: how long the next is.
    long halved(long tried) { return size_.halved(tried); }
    /// Where the step is taken back: all as it was before.
    void restore(const StepSize& before) { size_ = before; }

    /// Before the step that was tried is kept. By default an abrupt motion calls for its balance from the first step on
    /// in which something yields, or one of the effects acts whose forces may vanish: before that it hides no loss.
    /// `acts`: asked for that; `error`: as for refuse.
    template <class Acts, class Error>
    void begin_control(Acts acts, Error error) {
        if (begun_ || !acts()) return;
        begun_ = true;
        control_.begin_from(error());
    }
    /// Why the step that was tried is not kept, or none. `energy`: called for the energy where it ends; `error`: for
    /// the error of the balance where it begins, J.
    template <class Energies, class Error>
    Failure refuse(Energies energy, const AccountList& accounts, LargestEnergy& largest, Error error) {
        if (const Failure turned = rotation_too_large()) return turned;
        skipped_ = !control_.due(control_.by_default() && begun_ && is_abrupt(largest.most()), size_);
        if (skipped_) return {};
        return control_.refuse(energy(), accounts, largest, size_, error);
    }
    /// Whether the balance of the step that was tried has not been computed.
    bool is_skipped() const { return skipped_; }
    void note_skipped() {
        if (skipped_) control_.skip(size_);
    }
    void start_from(double error) { control_.start_from(error); }
    void leave_behind(double error) { control_.leave_behind(error); }
    /// The step is kept. Returns the time where it ends, s.
    double commit(double begin, double dt);

    /// Goes on as `before`, for the duration of this run; then what was counted so far was the other run's.
    void lengthen(const StepLength& before) { size_.lengthen(before.size_); }
    void count_anew() { size_.count_anew(); }

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.size_, s.control_, s.motions_, s.begun_);
    }

private:
    Failure rotation_too_large() const;
    bool is_abrupt(double largest);
    double motion_of_trial() const;

    const Workspace& w_;
    const bool automatic_, controls_;
    StepSize size_;
    StepControl control_;
    std::vector<double> motions_;  ///< J, motion_of_trial() of the last two steps; with control by default
    double motion_ = 0;            ///< J, of the step that is tried
    bool skipped_ = false;
    bool begun_;                  ///< step control has
    std::vector<double> lumped_;  ///< kg, at each node
};

}  // namespace hinge

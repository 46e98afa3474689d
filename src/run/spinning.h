// Free bodies that spin so fast that Newmark's method loses their angle. It follows a rotation in chords: with steps of
// omega dt radians it lags behind by about (omega dt)^2 / 12 of the angle, and by more where a body tumbles. The
// energy-momentum method (run/energy_momentum.h) keeps angular momentum and energy in steps of any length.
#pragma once

#include <optional>

#include "run/pressed_pairs.h"

namespace hinge {

/// Told once in a run.
class FastSpin {
public:
    /// Adds what has been lost since it was asked last, of the fastest of the bodies that no support holds: it is asked
    /// every hundred steps or so. `dt`: the steps since then, s. A warning when that is more than `most_lost`.
    std::optional<RunWarning> look(const Structure& structure, const State& state, double dt);

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.told_, s.asked_, s.lost_, s.turned_, s.last_);
    }

private:
    bool told_ = false, asked_ = false;
    double lost_ = 0, turned_ = 0;  ///< rad
    double last_ = 0;               ///< s
};

}  // namespace hinge

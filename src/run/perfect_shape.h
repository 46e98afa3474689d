// Perfect structures that could buckle in dynamics and do not: a straight column beyond Euler's load, a symmetric arch
// or truss that sways as it snaps through. No force acts on such a motion, so that rounding alone decides whether and
// when it begins. A run looks for that now and then, and says so.
#pragma once

#include <optional>
#include <string>

#include "effects/reports.h"
#include "run/run.h"

namespace hinge {

/// Told once in a run.
class PerfectShape {
public:
    /// Whether the run looks after so many of its steps.
    bool due(const State& state, long steps, long done) const;
    /// Looks for modes of the tangent stiffness that grow and in which the run neither moves nor is displaced, beyond
    /// rounding. A warning once such a mode would have grown by e^3, and most looks since the first such one have found
    /// one: a column whose axial force swings is beyond its load for a part of the time. Elastic where members have
    /// yielded, so that no plastic mechanism counts. `where`: "at t = 0.1 s".
    std::optional<RunWarning> look(const Run& run, const std::string& where);

    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.done_, s.moving_, s.found_, s.grown_, s.last_);
    }

private:
    bool done_ = false;
    int moving_ = 0;    ///< looks at which the run moved in the mode that grows fastest
    int found_ = 0;     ///< looks that have found such a mode, less those after them that have not
    double grown_ = 0;  ///< exponent by which it would have grown
    double last_ = 0;   ///< s, of the last look
};

}  // namespace hinge

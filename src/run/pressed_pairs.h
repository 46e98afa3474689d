// What pairs of elements cannot show of a beam that is compressed: between clamped ends their middle node does not bend
// out (beam/beam_column.h). A run looks for that now and then, and says so.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "effects/reports.h"
#include "state/state.h"

namespace hinge {

/// Compression of a pair, that begins with this element, over that at which it buckles between clamped ends, p' = pi^2
/// (beam/beam_column.h), in bending about x and about y. Both 0 where it is none, or is broken.
struct PairCompression {
    double force = 0;  ///< N, compression
    double part[2] = {0, 0};
    double most() const { return part[0] > part[1] ? part[0] : part[1]; }
};
PairCompression pressed(const Structure& structure, const State& state, const std::vector<Vec6>& force, int first);

/// Whoever is pressed beyond what a pair can show, each told once in a run.
class PressedPairs {
public:
    /// Compression beyond Euler's load between clamped ends. `where`: "at t = 0.1 s".
    std::optional<RunWarning> beyond_euler(const Structure& structure, const State& state, const std::string& where);
    /// Compression beyond p' = 6, where a pair is stiffer than the beam (beam/beam_column.h): held by stiff joints, it
    /// buckles at a load that is 1 % too high at 0.66 of that between clamped ends, 15 % at 0.87.
    std::optional<RunWarning> stiffer_than_beam(const Structure& structure, const State& state);
    /// Moments that lack what the loads along the pair make of its compression: they would bend out the middle node.
    /// `load_on`: force on a node, N. `largest_moment`: of an element, about x and about y, N m.
    std::optional<RunWarning> missed_moments(const Structure& structure, const State& state,
                                             const std::function<Vec3(int)>& load_on,
                                             const std::function<Eigen::Vector2d(int)>& largest_moment,
                                             const std::string& where);
    /// Tension that loads between the nodes of a pair make by its sag, if its ends are held apart: a pair bows by the
    /// rotations of its ends alone.
    std::optional<RunWarning> missed_tension(const Structure& structure, const State& state,
                                             const std::function<Vec3(int)>& load_on, const std::string& where);
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.euler_told_, s.moments_told_, s.tension_told_, s.stiffness_told_);
    }

private:
    bool euler_told_ = false, moments_told_ = false, tension_told_ = false, stiffness_told_ = false;
};

}  // namespace hinge

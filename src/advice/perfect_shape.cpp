// Perfect structures that could buckle in dynamics and do not: a straight column beyond Euler's load, a symmetric arch
// or truss that sways as it snaps through. No force acts on such a motion, so that rounding alone decides whether and
// when it begins.
#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>

#include "advice/adviser.h"
#include "core/text.h"
#include "effects/effect_list.h"
#include "run/dynamics.h"
#include "run/eigenmodes.h"

namespace hinge {
namespace {

constexpr long most_looks = 40;  ///< in a run
/// Part of the largest displacement or velocity that a mode has by rounding.
constexpr double rounding = 1e-8;
/// Exponent of the growth from which on it is told: 20 times. Waves that press members for an instant stay below.
constexpr double most_growth_unseen = 3;
/// Of the square of the rate of growth.
constexpr double as_fast = 0.9;
/// Looks that have found such a mode, beyond those that have not, for it to be told.
constexpr int least_found = 3;
/// No look is worth its time before a member is compressed by this part of Euler's load between its own ends (a column
/// may be four members in line), or a node is displaced by this part of the structure's size.
constexpr double least_pressed = 0.05, least_displaced = 0.01;
/// A look takes the time of 25 to 50 steps. Up to this many nodes a run has them to spare; with half as many steps from
/// look to look as there are nodes, the looks take a quarter of its time at most.
constexpr std::size_t most_nodes = 500;
/// Modes that are looked at; and looks at which the run moves in all of them, after which none follows.
constexpr int most_modes = 6, enough_moving = 3;

bool may_buckle(const Structure& structure, const State& state) {
    const double pi = std::numbers::pi;
    for (std::size_t i = 0; i < structure.elements().size(); ++i) {
        const Element& e = structure.elements()[i];
        const double length = e.length * structure.model().members()[std::size_t(e.member)].elements;
        const double euler = pi * pi * std::min(e.rigidity.EIx, e.rigidity.EIy) / (length * length);
        if (-state.force[i][4] > least_pressed * euler) return true;
    }
    Vec3 low = structure.position().front(), high = low;
    for (const Vec3& x : structure.position()) low = low.cwiseMin(x), high = high.cwiseMax(x);
    const double far = least_displaced * (high - low).norm();
    return std::any_of(state.displacement.begin(), state.displacement.end(),
                       [far](const Vec3& u) { return u.norm() > far; });
}

/// What a motion has of a mode, over the largest motion of a node.
template <class Motion>
double part_of(const std::vector<Motion>& motion, const std::vector<Vec6>& mode) {
    double both = 0, own = 0, most = 0, largest = 0;
    for (std::size_t n = 0; n < mode.size(); ++n) {
        const Vec3 moved = motion[n].template head<3>(), shape = mode[n].head<3>();
        both += shape.dot(moved), own += shape.squaredNorm();
        most = std::max(most, shape.norm()), largest = std::max(largest, moved.norm());
    }
    return largest == 0 || own == 0 ? 0 : std::abs(both) / own * most / largest;
}

/// "node 3 at {...} m along x"
std::string largest_motion(const Structure& structure, const std::vector<Vec6>& mode) {
    int node = 0, axis = 0;
    for (std::size_t n = 0; n < mode.size(); ++n)
        for (int c : {0, 1, 2})
            if (std::abs(mode[n][c]) > (1 + 1e-6) * std::abs(mode[std::size_t(node)][axis])) node = int(n), axis = c;
    return structure.node_name(node) + " along " + "xyz"[axis];
}

/// Looks for modes of the tangent stiffness that grow and in which the run neither moves nor is displaced, beyond
/// rounding. It warns once such a mode would have grown by e^3, and most looks since the first such one have found one:
/// a column whose axial force swings is beyond its load for a part of the time. Elastic where members have yielded, so
/// that no plastic mechanism counts.
class PerfectShape : public Adviser {
public:
    explicit PerfectShape(WarningLog& log) : log_(log) {}
    void after_step(const Run& run) override {
        if (run.verdict() == Verdict::running && is_due(static_cast<const Dynamics&>(run))) find_modes(run);
    }
    void save(Writer& to) const override { to(done_, moving_, found_, grown_, last_); }
    void restore(Reader& from) override { from(done_, moving_, found_, grown_, last_); }

private:
    bool is_due(const Dynamics& run) const;
    void find_modes(const Run& run);

    WarningLog& log_;
    bool done_ = false;
    int moving_ = 0;    ///< looks at which the run moved in the mode that grows fastest
    int found_ = 0;     ///< looks that have found such a mode, less those after them that have not
    double grown_ = 0;  ///< exponent by which it would have grown
    double last_ = 0;   ///< s, of the last look
};

bool PerfectShape::is_due(const Dynamics& run) const {
    const std::size_t nodes = run.state().displacement.size();
    return !done_ && nodes <= most_nodes &&
           run.steps_done() % std::max({1L, run.own_steps() / most_looks, long(nodes / 2)}) == 0;
}

void PerfectShape::find_modes(const Run& run) {
    const State& state = run.state();
    const auto is_broken = [](std::int8_t end) { return end != 0; };
    if (done_ || run.has_unsymmetric_loads()) return;
    if (std::any_of(state.broken.begin(), state.broken.end(), is_broken)) done_ = true;  // it is perfect no more
    if (done_ || !may_buckle(run.structure(), state)) return;
    const double since = state.time - last_;
    last_ = state.time;
    std::vector<NaturalMode> growing;
    try {
        const int ways = unstable_modes(run);
        if (ways > 0) growing = natural_modes(run, std::min(ways, most_modes)).list;
    } catch (const std::exception&) {  // no modes, or none that are sure: nothing is told of them
        done_ = true;
        return;
    }
    // a run that moves in a mode that grows about as fast buckles that way
    const NaturalMode* unseen = nullptr;
    double moving = 0;
    for (const NaturalMode& mode : growing) {
        if (!(mode.omega_squared < 0)) continue;
        const bool still =
            part_of(state.displacement, mode.shape) < rounding && part_of(state.velocity, mode.shape) < rounding;
        if (!still) moving = std::min(moving, mode.omega_squared);
        else if (!unseen) unseen = &mode;
    }
    if (unseen && moving < as_fast * unseen->omega_squared) unseen = nullptr;
    if (moving < 0 && !unseen && ++moving_ >= enough_moving) done_ = true;
    if (!unseen) {
        if (found_ > 0 && --found_ == 0) grown_ = 0;
        return;
    }
    const double rate = std::sqrt(-unseen->omega_squared);
    if (found_++ > 0) grown_ += since * rate;
    if (found_ < least_found || !(grown_ > most_growth_unseen)) return;
    done_ = true;
    log_.add({Warning::Kind::stability,
              "the structure can buckle at t = " + number_text(state.time, 4) + " s" +
                  ", and nothing but rounding starts it: a deviation from its perfect shape (largest at " +
                  largest_motion(run.structure(), unseen->shape) + ") would grow 10 times in each " +
                  number_text(std::log(10) / rate, 2) + " s",
              "give it an imperfection (model:imperfection) or a small load that way; without one it may stay "
              "as it is beyond the load at which it buckles"});
}

}  // namespace

std::unique_ptr<Adviser> advise_of_perfect_shape(const Run& run, WarningLog& log) {
    const bool dynamic = run.workspace().kind.dynamic;
    if (!dynamic || !run.structure().large() || run.effect_list().any(&EffectTraits::calls_script)) return nullptr;
    return std::make_unique<PerfectShape>(log);
}

}  // namespace hinge

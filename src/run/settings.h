// What a script may say of a dynamic run.
#pragma once

#include <optional>

#include "algebra/condensed.h"

namespace hinge {

/// What a step is solved from: the acceleration held (short steps), the displacement held (long ones), or whichever
/// suits dt against the time in which an axial wave crosses the shortest element.
enum class Predictor : std::uint8_t { by_step, acceleration, displacement };

struct DynamicSettings {
    double dt = 0;           ///< s
    double duration = 0;     ///< s
    bool automatic = false;  ///< dt is the shortest step (shortest_step); longer ones where nothing happens
    bool chosen = false;     ///< dt suits the elements alone: a run shortens it where its effects are stiffer
    double beta = 0.25;      ///< Newmark's beta, 0.25..1; the paper uses 0.25 without and 0.4 with contact; 0: explicit
    bool conserving = false;  ///< the energy-momentum method in place of Newmark's (run/energy_momentum.h)
    /// What a step leaves of the highest frequencies' amplitude, 0..1; below 1 Newmark's method with alpha of Wood,
    /// Bossak and Zienkiewicz (Int. J. Num. Meth. Eng. 15, 1980), M ((1 - alpha) a' + alpha a) = F' - R', and beta =
    /// beta_of(rho_infinity).
    double rho_infinity = 1;
    double alpha() const { return (rho_infinity - 1) / (rho_infinity + 1); }  ///< -1..0
    double gamma() const { return 0.5 - alpha(); }
    static double beta_of(double rho_infinity) {
        const double x = rho_infinity + 1;
        return 1 / (x * x);
    }  ///< (1 - alpha)^2 / 4
    /// 1: the paper's one solve; more: Newton until `tolerance`; 0: one solve, but Newton (30, to 1e-6) where hinges
    /// form or displacements are large, in steps too long for one.
    int iterations = 0;
    Predictor predictor = Predictor::by_step;
    double tolerance = 1e-10;     ///< of Newton: correction of the acceleration, relative to the step's first
    bool geometric = true;        ///< initial-stress stiffness in the effective stiffness (the forces are exact anyway)
    double rebuild_angle = 0.01;  ///< rad: an element's effective stiffness is rebuilt when it has rotated by this much
    bool single_precision =
        true;  ///< in steps no longer than the fastest waves need, effective stiffness in single precision
    /// The run ends, failed, when the energy balance error is a larger part of the largest energy. 0: never, the
    /// default of Shift::elastic_and_plastic, whose balance cannot close; else Dynamics::energy_may_miss.
    std::optional<double> energy_tolerance;
    /// Steps that would lose more than their share of this part of the largest energy are taken back and halved, as
    /// are those that cannot be solved; down to dt / 1024, and back up to dt. 0: every step is kept.
    double step_control = 0;
    /// The script has not said how: `step_control` acts in scenes with hinges, contact or other forces that begin or
    /// end suddenly, and with dt = "auto", by implicit steps. The balance is checked less often, and what no shorter
    /// step makes smaller is kept; then the energy monitor decides. While no step is taken back, the bits are those of
    /// step_control 0.
    bool controlled_by_default = false;
    static constexpr double default_control = 1e-3;
    void control(double by) { step_control = by, controlled_by_default = false; }
    bool rest = true;                      ///< bodies at rest are left alone until something reaches them
    static constexpr int by_elements = 0;  ///< as threads_for has it (core/thread_pool.h)
    int threads = by_elements;             ///< how many share the work of a step; any number has the same bits
    SolverSettings solver;

    bool explicit_steps() const { return beta == 0; }
    bool controlled() const { return step_control > 0; }
};

/// The fastest node of a run so far.
struct Fastest {
    double speed = 0;  ///< m/s
    int node = -1;
    double time = 0;  ///< s
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.speed, s.node, s.time);
    }
};

}  // namespace hinge

// Integrators by themselves: Newmark's method and central differences on one node that a bar holds as a spring, against
// the closed forms of their recurrences: the period, what is dissipated, and where steps cease to be stable.
#include <Eigen/Eigenvalues>

#include "effect_bench.h"
#include "run/central_differences.h"
#include "run/newmark.h"

using namespace hinge;
using namespace hinge::test;

namespace {

constexpr double start = 1e-3;  // m

/// One degree of freedom, m u'' + k u = 0: the end of a bar that can move along it, pulled by `start` and released. The
/// element's mass at the end is a third of the bar's where it is consistent, half of it where lumped.
struct Oscillator : Bench {
    static std::shared_ptr<const Structure> bar(bool lumped) {
        Frame frame(small_displacement(Formulation::conventional));
        frame.elements = 1;
        const int foot = frame.foot(0, 0, 0), end = frame.foot(1, 0, 0, 62);
        frame.member(foot, end);
        return std::make_shared<Structure>(frame.model, lumped ? MassKind::lumped : MassKind::consistent);
    }
    double k = 0, m = 0, omega = 0;
    DynamicSettings settings;
    KeptMass kept_mass;
    Stages stages;
    EffectList effects;
    std::unique_ptr<Integrator> integrator;
    double dissipated = 0;

    /// `z`: omega dt.
    Oscillator(double z, DynamicSettings chosen)
        : Bench(bar(chosen.explicit_steps()),
                {.dynamic = true, .explicit_steps = chosen.explicit_steps(), .geometric = false}),
          k(206e9 * 0.05 * 0.05),
          m(mass() / (chosen.explicit_steps() ? 2 : 3)),
          omega(std::sqrt(k / m)),
          settings(chosen),
          kept_mass(w),
          effects(w, run) {
        settings.dt = z / omega, settings.iterations = 1;
        settings.solver.direct = true;
        w.kind.dt = settings.dt;
        w.scheme = {settings.beta, settings.gamma(), settings.alpha()};
        if (settings.explicit_steps()) integrator = std::make_unique<CentralDifferences>(w, kept_mass, stages);
        else integrator = std::make_unique<Newmark>(w, kept_mass, stages, settings);
        integrator->prepare(effects);
        state.displacement[1].x() = start;
        state.acceleration[1][0] = -omega * omega * start;
        w.trial = state;
        w.weighted = state.acceleration;
        kept_mass.renewed(state);
        integrator->begin(effects);
    }

    double u() const { return state.displacement[1].x(); }
    double v() const { return state.velocity[1][0]; }
    double a() const { return state.acceleration[1][0]; }
    double energy() const { return 0.5 * k * u() * u() + 0.5 * m * v() * v(); }

    void recover(const Step& step) {
        for (Vec6& r : w.resisting) r.setZero();
        assembly.set_step(step.dt);
        assembly.run(state, w.trial, w.resisting, w.force, w.yielding);
        integrator->recovered(step);
    }
    /// As Dynamics::take_step, without effects.
    void take_step() {
        Step step;
        step.begin = state.time, step.dt = settings.dt;
        integrator->predict(step);
        integrator->prescribed(step);
        for (bool more = true; more;) {
            recover(step);
            integrator->solve(step);
            REQUIRE(!step.failure);
            more = integrator->correct(step);
        }
        integrator->solved(step);
        if (integrator->recovers_last()) recover(step), integrator->recovered_last();
        dissipated += integrator->dissipated(step);
        integrator->before_commit();
        std::swap(static_cast<Configuration&>(state), w.trial);
        state.force.swap(w.force);
        integrator->after_commit();
        state.time = step.end(), ++state.step;
    }
};

DynamicSettings newmark(double beta, double rho = 1) { return {.beta = beta, .rho_infinity = rho}; }

/// The largest distance of the displacement from start cos(n phi) in so many steps, over `start`.
double off_cosine(Oscillator& of, double phi, int steps) {
    double most = 0;
    for (int n = 1; n <= steps; ++n) {
        of.take_step();
        most = largest_of(most, std::abs(of.u() / start - std::cos(n * phi)));
    }
    return most;
}

/// Eq 15 of m u'' + k u = 0 with Bossak's weighting, for u / dt^2, v / dt and a: what one step makes of them.
Eigen::Matrix3d amplification(double z, double beta, double gamma, double alpha) {
    const double zz = z * z, of_next = 1 - alpha + beta * zz;  // of a' in eq 15
    const Eigen::RowVector3d next = -Eigen::RowVector3d(zz, zz, alpha + (0.5 - beta) * zz) / of_next;
    Eigen::Matrix3d A;
    A << 1, 1, 0.5 - beta, 0, 1, 1 - gamma, 0, 0, 0;
    A.row(0) += beta * next, A.row(1) += gamma * next, A.row(2) = next;
    return A;
}

double spectral_radius(const Eigen::Matrix3d& A) { return largest_entry(A.eigenvalues()); }

}  // namespace

TEST_CASE("Newmark's method keeps the amplitude, and its period is longer as the closed form says") {
    for (const double beta : {0.25, 0.4})
        for (const double z : {0.1, 1.0, 10.0}) {
            const double phi = std::acos(1 - 0.5 * z * z / (1 + beta * z * z));
            Oscillator of(z, newmark(beta));
            INFO("beta " << beta << ", omega dt " << z);
            CHECK_FIGURE("u", off_cosine(of, phi, 200), 1e-10);  // rounding of a solution, 200 times
            if (z < 1)
                CHECK_FIGURE("period error", std::abs(phi / z - 1 + (beta - 1. / 12) / 2 * z * z), z * z * z * z);
        }
}

TEST_CASE("Newmark's method converges to the exact solution with the square of the step") {
    const auto error = [](int steps) {
        const double time = 2.6 * pi;  // omega t
        Oscillator of(time / steps, newmark(0.25));
        for (int n = 0; n < steps; ++n) of.take_step();
        return std::abs(of.u() / start - std::cos(time));
    };
    CHECK_FIGURE("order 2", std::abs(std::log2(error(100) / error(200)) - 2), 0.01);
}

TEST_CASE("Bossak's weighting dissipates as its amplification matrix says, and counts it") {
    for (const double rho : {0.9, 0.5, 0.0})
        for (const double z : {0.3, 3.0}) {
            DynamicSettings s = newmark(DynamicSettings::beta_of(rho), rho);
            const auto A = amplification(z, s.beta, s.gamma(), s.alpha());
            Oscillator of(z, s);
            const double dt = of.settings.dt, before = of.energy();
            Eigen::Vector3d x(start / (dt * dt), 0, of.a());
            double most = 0;
            for (int n = 0; n < 50; ++n) {
                of.take_step(), x = A * x;
                most = largest_of(most, std::abs(of.u() - x[0] * dt * dt), std::abs(of.v() - x[1] * dt) / of.omega);
            }
            INFO("rho " << rho << ", omega dt " << z);
            CHECK_FIGURE("u and v", most, 1e-10 * start);
            CHECK_FIGURE("energy balance", std::abs(before - of.energy() - of.dissipated), 1e-10 * before);
            CHECK(of.dissipated > 0);
        }
    // what it is named by: of the highest frequencies a step leaves rho
    for (const double rho : {1.0, 0.9, 0.5, 0.0}) {
        const DynamicSettings s = newmark(DynamicSettings::beta_of(rho), rho);
        // the next term is 1 / z^2, and its root where an eigenvalue is a multiple one
        CHECK_FIGURE("rho", std::abs(spectral_radius(amplification(1e6, s.beta, s.gamma(), s.alpha())) - rho), 1e-3);
    }
}

TEST_CASE("central differences keep the amplitude up to omega dt = 2, and their period is shorter") {
    for (const double z : {0.1, 1.0, 1.9, 1.999}) {
        Oscillator of(z, newmark(0));
        const double phi = 2 * std::asin(0.5 * z);
        INFO("omega dt " << z);
        CHECK_FIGURE("u", off_cosine(of, phi, 200), 1e-9);
        if (z < 1) CHECK_FIGURE("period error", std::abs(phi / z - 1 - z * z / 24), z * z * z * z);
    }
    const double z = 2.01, growth = std::acosh(0.5 * z * z - 1);
    Oscillator of(z, newmark(0));
    for (int n = 0; n < 100; ++n) of.take_step();
    CHECK_FIGURE("growth beyond the limit", off(of.u() / start, std::cosh(100 * growth)), 1e-9);
    CHECK(of.u() > 1e8 * start);
}

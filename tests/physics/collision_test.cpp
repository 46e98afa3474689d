// Two beams that collide (paper 3.3, figs 13-15), bound by the paper's gap elements: momenta, and the ledger over time.
#include "helpers.h"
#include "sim/breaking.h"

using namespace hinge;
using namespace hinge::test;

namespace {

/// Beam a along x, clamped at both ends or free; beam b 0.25 m above it, crossing at `angle` degrees, falling at `speed`. The
/// crossing is `along_a` m from a's middle and `along_b` m from b's.
struct Pair {
    std::shared_ptr<const Structure> structure;
    Pair(bool clamped, double angle, double along_a, double along_b, double speed) {
        Frame frame;
        ContactRule rule;
        frame.model->set_contact(rule);
        const Vec3 d(std::cos(angle * pi / 180), std::sin(angle * pi / 180), 0), middle = Vec3(along_a, 0, 0.25) - along_b * d;
        const int a1 = frame.node(-0.5, 0, 0), a2 = frame.node(0.5, 0, 0), b1 = frame.node(middle - 0.5 * d), b2 = frame.node(middle + 0.5 * d);
        if (clamped) frame.model->fix(a1, 63), frame.model->fix(a2, 63);
        frame.member(a1, a2);
        frame.member(b1, b2);
        for (int b : {b1, b2}) frame.model->set_velocity(b, {0, 0, -speed}, Vec3::Zero());
        structure = frame.build();
    }
};

DynamicSettings settings(double dt, double duration, double beta, double tolerance = 1e-8) {
    DynamicSettings s;
    s.dt = dt;
    s.duration = duration;
    s.beta = beta;
    s.solver.tolerance = tolerance;
    return s;
}

}  // namespace

TEST_CASE("collision: two free beams keep linear momentum to 1e-9 and angular momentum to 1e-6", "[collision]") {
    const Pair pair(false, 70, 0.13, 0.07, 50);
    Dynamics run(pair.structure, initial_state(*pair.structure), settings(1e-6, 0.012, 0.25, 1e-10));
    const Momentum before = momentum(*pair.structure, run.state());
    while (run.advance()) {}
    const Momentum after = momentum(*pair.structure, run.state());
    CHECK(run.state().contact->counts().bound > 0);
    CHECK_FIGURE("linear momentum", (after.linear - before.linear).norm() / before.linear.norm(), 1e-9);
    CHECK_FIGURE("angular momentum", (after.angular - before.angular).norm() / before.angular.norm(), 1e-6);
}

TEST_CASE("collision: contact is found at every angle and offset, and the ledger closes within 1 % of the initial energy", "[collision]") {
    const double cases[][3] = {{90, 0, 0}, {70, 0, 0}, {45, 0, 0}, {20, 0, 0}, {90, 0.13, 0.07}, {70, 0.2, 0.2}, {45, 0.3, -0.1}, {20, -0.2, 0.1}, {90, 0.25, 0.25}};
    for (const auto& c : cases) {
        const Pair pair(true, c[0], c[1], c[2], 50);
        Dynamics run(pair.structure, initial_state(*pair.structure), settings(1e-5, 0.03, 0.4));
        double worst = 0, let_go = 0;
        bool never_less = true;
        while (run.advance()) {
            if (run.steps_done() % 10) continue;
            const Energy e = run.energy();
            worst = std::max(worst, std::abs(e.remainder) / e.initial);
            never_less &= e.contact_released >= let_go;
            let_go = e.contact_released;
        }
        char what[96];
        std::snprintf(what, sizeof what, "remainder, %g degrees, %g and %g m off (let go: %.1f %%)", c[0], c[1], c[2], 100 * let_go / run.energy().initial);
        CHECK(run.verdict() == Verdict::completed);
        CHECK(run.state().contact->counts().bound > 0);
        CHECK(never_less);
        CHECK_FIGURE(what, worst, 1e-2);
    }
}

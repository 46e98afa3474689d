// Free flight: what a body that nothing touches must keep.
#include "helpers.h"
#include "state/breaking.h"

using namespace hinge;
using namespace hinge::test;

namespace {

/// A beam of two members, skew in space, in flight with spin `w` about an axis across it; 3000 steps. Largest
/// deviations.
Flight fly(const Vec3& v, double spin, double dt, int steps = 3000) {
    Frame frame;
    const Vec3 along = Vec3(1, 2, -0.5).normalized(), axis = along.unitOrthogonal();
    const auto nodes = straight(frame, Vec3(1, 1, 1), Vec3(1, 1, 1) + along, 1, axis);
    // stretched as the spin wants it, so that it does not begin by ringing: u' = rho w^2 (L^2/4 - s^2) / (2 E) from the
    // middle
    for (int n : nodes)
        frame.model->set_velocity(
            n, v + spin * axis.cross(frame.model->nodes()[n].position - Vec3(1, 1, 1) - 0.5 * along), spin * axis);
    const auto structure = frame.build();
    DynamicSettings s;
    s.dt = dt;
    s.duration = steps * dt;
    Dynamics run(structure, initial_state(*structure), s);
    return worst_of_flight(run);
}

}  // namespace

TEST_CASE("flight: a beam flying for 3000 steps keeps energy and momenta to 1e-9", "[flight]") {
    const Flight f = fly({120, -30, 10}, 0, 1e-5);
    CHECK_FIGURE("energy", f.energy, 1e-9);
    CHECK_FIGURE("linear momentum", f.linear, 1e-9);
    CHECK_FIGURE("angular momentum", f.angular, 1e-9);
}

TEST_CASE("flight: spinning at 50 rad/s it keeps them to 1e-5, and the error falls with the square of dt", "[flight]") {
    const Flight coarse = fly({20, 5, 1}, 50, 4e-5, 750), fine = fly({20, 5, 1}, 50, 1e-5, 3000);
    CHECK_FIGURE("energy, dt 10 us, 0.03 s", fine.energy, 1e-5);
    CHECK_FIGURE("linear momentum", fine.linear, 1e-9);
    CHECK_FIGURE("angular momentum", fine.angular, 1e-5);
    CHECK_FIGURE("angular momentum falls with dt^2: 16 times for 4", fine.angular / coarse.angular, 1.0 / 8);
}

TEST_CASE("flight: two runs give the same bits", "[flight]") {
    std::uint64_t hashes[2];
    for (auto& h : hashes) {
        SpaceFrame frame(ModelOptions{}, 12e3, 245e6);
        const auto structure = frame.build();
        DynamicSettings s;
        s.dt = 1e-5;
        s.duration = 2e-3;
        Dynamics run(structure, initial_state(*structure), s);
        while (run.advance()) {}
        REQUIRE(run.verdict() == Verdict::completed);
        h = hash(run.state());
    }
    CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("flight: conjugate gradients and the direct solver agree", "[flight]") {
    std::vector<Vec3> ends[2];
    for (int direct = 0; direct < 2; ++direct) {
        SpaceFrame frame(ModelOptions{}, 12e3, 245e6);
        const auto structure = frame.build();
        DynamicSettings s;
        s.dt = 1e-5;
        s.duration = 2e-3;
        s.solver.direct = direct;
        s.solver.tolerance = 1e-12;
        Dynamics run(structure, initial_state(*structure), s);
        while (run.advance()) {}
        REQUIRE(run.verdict() == Verdict::completed);
        ends[direct] = run.state().displacement;
    }
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < ends[0].size(); ++i)
        difference = largest_of(difference, (ends[0][i] - ends[1][i]).norm()),
        size = largest_of(size, ends[0][i].norm());
    CHECK_FIGURE("displacements", difference / size, 1e-8);
}

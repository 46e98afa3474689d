// Free flight: what a body that nothing touches must keep.
#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

namespace {

/// A beam skew in space in flight for 0.03 s with spin `w` about an axis across it, implicit, or explicit with four
/// elements. Largest deviations.
Flight fly(const Vec3& v, double spin, double dt, bool in_explicit_steps = false) {
    Frame frame;
    const Vec3 along = Vec3(1, 2, -0.5).normalized(), axis = along.unitOrthogonal(), start(1, 1, 1);
    for (int n : straight(frame, start, start + along, in_explicit_steps ? 2 : 1, axis))
        frame.model->set_velocity(n, v + spin * axis.cross(frame.model->nodes()[n].position - start - 0.5 * along),
                                  spin * axis);
    const auto structure =
        std::make_shared<Structure>(frame.model, in_explicit_steps ? MassKind::lumped : MassKind::consistent);
    Dynamics run = dynamics(structure, {.dt = dt, .duration = 0.03, .beta = in_explicit_steps ? 0 : 0.25});
    return worst_of_flight(run);
}

}  // namespace

TEST_CASE("flight: a beam flying for 3000 steps keeps energy and momenta to 1e-9") {
    const Flight f = fly({120, -30, 10}, 0, 1e-5);
    CHECK_FIGURE("energy", f.energy, 1e-9);
    CHECK_FIGURE("linear momentum", f.linear, 1e-9);
    CHECK_FIGURE("angular momentum", f.angular, 1e-9);
}

TEST_CASE("flight: spinning at 50 rad/s it keeps them to 1e-5, and the error falls with the square of dt") {
    const Flight coarse = fly({20, 5, 1}, 50, 4e-5), fine = fly({20, 5, 1}, 50, 1e-5);
    CHECK_FIGURE("energy, dt 10 us, 0.03 s", fine.energy, 1e-5);
    CHECK_FIGURE("linear momentum", fine.linear, 1e-9);
    CHECK_FIGURE("angular momentum", fine.angular, 1e-5);
    CHECK_FIGURE("angular momentum falls with dt^2: 16 times for 4", fine.angular / coarse.angular, 1.0 / 8);
}

TEST_CASE("flight: in explicit steps it keeps both momenta to rounding, and its energy better with dt^2") {
    // the two halves of a central-difference step, velocity and displacement, each keep both momenta: what is left is
    // rounding over 1e4 steps
    const Flight coarse = fly({20, 5, 1}, 50, 1e-5, true), fine = fly({20, 5, 1}, 50, 2.5e-6, true);
    CHECK_FIGURE("linear momentum", fine.linear, 1e-12);
    CHECK_FIGURE("angular momentum", fine.angular, 1e-11);
    CHECK_FIGURE("energy, dt 2.5 us", fine.energy, 1e-4);
    CHECK_FIGURE("energy falls with dt^2: 16 times for 4", fine.energy / coarse.energy, 1.0 / 8);
}

// Effects one by one, each on a bench without a run: gravity, point masses, connectors, joints, damping, the ground.
#include "core/rotation.h"
#include "effect_bench.h"
#include "effects/connectors.h"
#include "effects/damping.h"
#include "effects/ground.h"
#include "effects/joints.h"
#include "effects/point_mass.h"

using namespace hinge;
using namespace hinge::test;

namespace {

constexpr double rounding = 1e-12;
/// Central differences of an energy that is quadratic have rounding alone: 1e-16 of the energy over h of the place.
constexpr double of_differences = 1e-6;

/// A steel bar of 3 m along x that nothing holds.
Frame free_bar(int elements = 2) {
    Frame frame;
    frame.section = square(0.1), frame.elements = elements;
    const int a = frame.node(0, 0, 0), b = frame.node(3, 0, 0);
    frame.member(a, b, Vec3::UnitZ());
    return frame;
}
constexpr double bar_mass = 7850 * 0.1 * 0.1 * 3, radius = 0.05;

}  // namespace

TEST_CASE("gravity: the weights of the nodes sum to m g, and are minus the slope of its energy") {
    const Vec3 g(0.3, -0.2, -9.81);
    Frame frame = free_bar();
    set_gravity(*frame.model, g);
    EffectOnBench bench(frame, gravity_kind());
    std::vector<Vec6> F = bench.zero();
    dynamic_cast<Load&>(*bench.effect).add_steady_loads(F);
    CHECK_FIGURE("m g", (sum_of_forces(F) - bar_mass * g).norm(), rounding * bar_mass * g.norm());

    Accounts sums;
    State lifted = bench.state;
    const Vec3 up(1, 2, 3);
    for (Vec3& u : lifted.displacement) u += up;
    bench.effect->add_energy(lifted, sums);
    CHECK_FIGURE("potential energy", std::abs(std::as_const(sums)["gravity"] + bar_mass * g.dot(up)),
                 rounding * bar_mass * g.norm() * up.norm());
    for (std::size_t n = 0; n < F.size(); ++n) {
        Accounts one;
        State moved = bench.state;
        moved.displacement[n] += up;
        bench.effect->add_energy(moved, one);
        CHECK_FIGURE("F of a node", std::abs(std::as_const(one)["gravity"] + F[n].head<3>().dot(up)),
                     rounding * bar_mass * g.norm() * up.norm());
    }
}

TEST_CASE("point mass: at an offset it has the energy of a rigid body, however its node has turned") {
    Frame frame = free_bar();
    const PointMass mass{0, 12, {0.3, 0.5, 0.7}, {0.2, -0.1, 0.4}};
    frame.model->declare(point_mass_effect, mass);
    EffectOnBench bench(frame, point_mass_kind());
    Dice dice(1);
    for (int i = 0; i < 5; ++i) {
        const Quat q = dice.rotation();
        const Vec3 v = dice.vector(2), w = dice.vector(3), w_own = q.conjugate() * w;
        bench.state.rotation[0] = q;
        bench.state.velocity[0] << v, w;
        const double energy = 0.5 * mass.mass * (v + w.cross(q * mass.offset)).squaredNorm() +
                              0.5 * w_own.dot(mass.inertia.cwiseProduct(w_own));
        CHECK_FIGURE("kinetic energy", std::abs(kinetic_energy_of_offset_masses(bench.state) - energy),
                     rounding * energy);
    }
}

TEST_CASE("connector: its forces are the slope of its energy and in balance, its blocks their slope") {
    Frame frame;
    frame.section = square(0.1);
    const int a = frame.node(0, 0, 0), b = frame.node(0.2, 0.1, 0);
    frame.member(a, frame.node(0, 0, 3)), frame.member(b, frame.node(0.2, 0.1, 3));
    Connector c;
    c.a = a, c.b = b;
    c.stiffness << 1e5, 2e5, 3e5, 400, 500, 600;
    frame.model->declare(connectors_effect, c);
    EffectOnBench bench(frame, connectors_kind());
    bench.w.trial.rotation[a] = exponential({0.1, -0.2, 0.3}), bench.w.trial.rotation[b] = exponential({0.3, 0.1, 0});
    bench.w.trial.displacement[b] = {0.02, -0.03, 0.01};

    const std::vector<Vec6> R = bench.forces();
    const double size = R[b].head<3>().norm();
    CHECK(size > 1000);
    for (const int n : {a, b})
        CHECK_FIGURE("slope of the energy",
                     (bench.slope_of_energy("connector_stored", n, 1e-4) - R[n].head<3>()).norm(),
                     of_differences * size);
    const Vec3 arm = Vec3(0.2, 0.1, 0) + bench.w.trial.displacement[b];
    CHECK_FIGURE("forces in balance", (R[a] + R[b]).head<3>().norm(), rounding * size);
    CHECK_FIGURE("moments in balance", (R[a].tail<3>() + R[b].tail<3>() + arm.cross(R[b].head<3>())).norm(),
                 rounding * size);

    Blocks blocks;
    dynamic_cast<Force&>(*bench.effect).add_blocks(bench.w.trial, blocks);
    REQUIRE(blocks.pairs.size() == 1);
    constexpr double h = 1e-5;
    for (int k = 0; k < 3; ++k) {
        bench.w.trial.displacement[b][k] += h;
        const Vec6 above = bench.forces()[b];
        bench.w.trial.displacement[b][k] -= 2 * h;
        const Vec6 slope = (above - bench.forces()[b]) / (2 * h);
        bench.w.trial.displacement[b][k] += h;
        CHECK_FIGURE("column of K", (blocks.pairs[0].K.block<3, 1>(6, 6 + k) - slope.head<3>()).norm(),
                     of_differences * 3e5);
    }
}

TEST_CASE("joint: its moments are in balance, and its blocks are their slope, for small and large rotations") {
    const Vec3 far = GENERATE(Vec3(2e-3, -1e-3, 3e-3), Vec3(0.3, -0.5, 0.2), Vec3(0.1, 3, -0.05));
    Frame frame;
    frame.section = square(0.1);
    const int a = frame.node(0, 0, 0), b = frame.node(0, 0, 0);
    frame.member(a, frame.node(0, 0, 3)), frame.member(b, frame.node(0, 3, 0), Vec3::UnitZ());
    JointProperties is;
    for (int k : {0, 1, 2}) is.axis[k].stiffness = 400 + 100 * k;
    frame.model->declare(joints_effect, Joint{-1, 0, is, a, b, exponential({0.2, 0.1, -0.3}).toRotationMatrix()});
    EffectOnBench bench(frame, joints_kind());
    const auto force = [&] { return dynamic_cast<Force*>(bench.effect.get()); };
    const Quat start = exponential({0.5, 0.1, -0.4});
    bench.w.trial.rotation[a] = start, bench.w.trial.rotation[b] = rotated(far, start);

    const std::vector<Vec6> R = bench.forces();
    const double size = R[b].tail<3>().norm();
    CHECK(size > 1);
    CHECK_FIGURE("moments in balance", (R[a] + R[b]).norm(), rounding * size);

    const auto K = [&](Yielded as) -> Mat6 {
        Blocks blocks(0, true, as);
        force()->add_blocks(bench.w.trial, blocks);
        REQUIRE(blocks.pairs.size() == 1);
        Mat6 of_spins;
        for (int i : {0, 1})
            for (int j : {0, 1})
                of_spins.block<3, 3>(3 * i, 3 * j) = blocks.pairs[0].K.block<3, 3>(6 * i + 3, 6 * j + 3);
        return of_spins;
    };
    constexpr double h = 1e-5;
    Mat6 slope;
    for (int j = 0; j < 6; ++j) {
        Quat& q = bench.w.trial.rotation[j < 3 ? a : b];
        const Quat at = q;
        const auto moments = [&](double by) {
            q = rotated(by * Vec3::Unit(j % 3), at);
            const std::vector<Vec6> r = bench.forces();
            return Vec6((Vec6() << r[a].tail<3>(), r[b].tail<3>()).finished());
        };
        slope.col(j) = (moments(h) - moments(-h)) / (2 * h);
        q = at;
    }
    CHECK_FIGURE("K of spins", (K(Yielded::goes_on) - slope).norm(), of_differences * slope.norm());
    CHECK_FIGURE("its symmetric part", (K(Yielded::at_rotation) - 0.5 * (slope + slope.transpose())).norm(),
                 of_differences * slope.norm());
}

TEST_CASE("damping: alpha resists with alpha m v, beta with beta times the stiffness, and not rotation") {
    constexpr double alpha = 0.7, beta = 0.002, dt = 0.01;
    const auto damped = [&](double of_mass, double of_stiffness) {
        Frame frame = free_bar();
        frame.model->declare(damping_effect, Damping{of_mass, of_stiffness});
        return frame;
    };
    SECTION("alpha") {
        EffectOnBench bench(damped(alpha, 0), damping_kind());
        const Vec3 v(1, 2, 3);
        for (Vec6& of : bench.w.trial.velocity) of.head<3>() = v;
        CHECK_FIGURE("alpha m v", (sum_of_forces(bench.forces()) - alpha * bar_mass * v).norm(),
                     rounding * alpha * bar_mass * v.norm());

        bench.effect->acceleration_found();  // the step begins with these forces
        for (Vec3& u : bench.w.trial.displacement) u = dt * v;
        bench.forces();
        Accounts sums;
        bench.effect->accumulate_energy({0, dt, false, 0, {}, {}}, sums);
        const double work = alpha * bar_mass * v.squaredNorm() * dt;
        CHECK_FIGURE("alpha m v^2 dt", std::abs(std::as_const(sums)["damping"] - work), rounding * work);
    }
    SECTION("beta") {
        EffectOnBench bench(damped(0, beta), damping_kind());
        const double EA = 206e9 * 0.01, rate = 0.5;
        for (std::size_t n = 0; n < bench.w.trial.velocity.size(); ++n)
            bench.w.trial.velocity[n].head<3>() = rate * bench.structure->position()[n];
        CHECK_FIGURE("beta EA strain rate", off(bench.forces()[1][0], beta * EA * rate), rounding);

        const Vec3 spin(0.1, 2, -3);
        for (std::size_t n = 0; n < bench.w.trial.velocity.size(); ++n)
            bench.w.trial.velocity[n] << spin.cross(bench.structure->position()[n]), spin;
        double most = 0;
        for (const Vec6& f : bench.forces()) most = largest_of(most, largest_entry(f));
        CHECK_FIGURE("rotation as a whole", most, rounding * beta * EA * spin.norm());
    }
}

TEST_CASE("damping: the forces of eight elements at once are those of one by one") {
    constexpr double alpha = 0.7, beta = 0.002;
    const MassShape shape = GENERATE(MassShape::linear, MassShape::cubic);
    Dice dice(5);
    Frame frame({.mass = shape});
    frame.section = square(0.1), frame.elements = 2;
    int last = frame.node(0, 0, 0);
    for (int m = 1; m < 8; ++m) {  // 14 elements: two blocks, of which the second is not full
        const int next = frame.node(m, dice(-1, 1), dice(-1, 1));
        frame.member(last, next, Vec3::UnitZ());
        last = next;
    }
    frame.model->declare(damping_effect, Damping{alpha, beta});
    EffectOnBench bench(frame, damping_kind());
    const int broken = 4;
    bench.state.broken[broken] = 1;
    Configuration& trial = bench.w.trial;
    for (std::size_t n = 0; n < trial.velocity.size(); ++n) {
        for (int c = 0; c < 3; ++c) trial.displacement[n][c] = dice(-0.1, 0.1);
        for (int c = 0; c < 6; ++c) trial.velocity[n][c] = dice(-1, 1);
        trial.rotation[n] = rotated(dice.vector(0.4), trial.rotation[n]);
    }
    std::vector<Vec6> expected = bench.zero();
    double size = 0, missed = 0;
    for (int i = 0; i < int(bench.structure->elements().size()); ++i) {
        if (i == broken) continue;
        const Element& e = bench.structure->elements()[i];
        const ElementFrame place = element_frame(*bench.structure, i, trial);
        Vec12 v;
        v << trial.velocity[e.node[0]], trial.velocity[e.node[1]];
        const Vec6 rate = deformation_rates(place, v.head<6>(), v.tail<6>());
        const Vec12 f = nodal_forces(place, beta * e.stiffness.times(rate)) +
                        alpha * bench.structure->inertia(i).times(axes_of(place), v);
        for (int end : {0, 1}) expected[e.node[end]] += f.segment<6>(6 * end);
    }
    const std::vector<Vec6> found = bench.forces();
    for (std::size_t n = 0; n < found.size(); ++n) {
        size = largest_of(size, largest_entry(expected[n]));
        missed = largest_of(missed, largest_entry(found[n] - expected[n]));
    }
    CHECK_FIGURE("C v", missed, rounding * size);
}

TEST_CASE("ground: points press with k o, along the slope of their energy, and not from above") {
    constexpr double k = 2e6, o = 1e-3;
    Frame frame = free_bar();
    GroundPlane plane;
    plane.point = {0, 0, -0.1}, plane.stiffness = k;
    frame.model->declare(ground_effect, plane);
    EffectOnBench bench(frame, ground_kind());
    CHECK(sum_of_forces(bench.forces()).isZero(0));
    CHECK(bench.stored("ground_stored") == 0);
    bench.w.trial.displacement[0].z() = -0.1 + radius - o;
    const std::vector<Vec6> R = bench.forces();
    CHECK_FIGURE("k o", (R[0].head<3>() + Vec3(0, 0, k * o)).norm(), 1e-9 * k * o);  // digits of o in the height
    CHECK(R[1].isZero(0));
    CHECK_FIGURE("slope of the energy", (bench.slope_of_energy("ground_stored", 0, 1e-5) - R[0].head<3>()).norm(),
                 of_differences * k * o);
}

TEST_CASE("ground: a layer presses on the area of a bar that lies flat, with any number of elements") {
    constexpr double o = 1e-4, v = 0.3, area = 2 * radius * 3;
    for (const int elements : {2, 8}) {
        Frame frame = free_bar(elements);
        GroundPlane plane;
        plane.point = {0, 0, -0.1};
        frame.model->declare(ground_effect, plane);
        EffectOnBench bench(frame, ground_kind());
        for (Vec3& u : bench.w.trial.displacement) u.z() = -0.1 + radius - o;
        const double still = -sum_of_forces(bench.forces()).z();
        CHECK_FIGURE("s A o", off(still, layer_stiffness * area * o), 1e-9);
        for (Vec6& of : bench.w.trial.velocity) of[2] = -v;
        const double falling = -sum_of_forces(bench.forces()).z();
        CHECK_FIGURE("d A v", off(falling - still, layer_damping * area * v), 1e-9);
        for (Vec6& of : bench.w.trial.velocity) of[2] = v;  // it never pulls
        CHECK(sum_of_forces(bench.forces()).isZero(0));
    }
}

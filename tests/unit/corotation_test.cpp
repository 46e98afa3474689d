// The frame that moves with the element: no strain from rigid motion, forces in equilibrium, one element or eight with
// the same bits.
#include "beam/corotation.h"

#include <array>
#include <cstring>

#include "beam/timoshenko.h"
#include "core/rotation.h"
#include "helpers.h"

using namespace hinge;
using namespace hinge::beam;
using namespace hinge::test;

namespace {

/// Deformation, forces and moments of one element, or of one lane of eight: eighteen numbers.
template <class Real, class Pick>
std::array<double, 18> numbers(const Real* d, const NodalForces<Real>& f, Pick pick) {
    std::array<double, 18> all;
    int n = 0;
    for (int i = 0; i < 6; ++i) all[n++] = pick(d[i]);
    for (const auto* of : {f.force, f.moment})
        for (int node : {0, 1})
            for (const Real& x : {of[node].x, of[node].y, of[node].z}) all[n++] = pick(x);
    return all;
}

/// One element somewhere in space, deformed: chord, nodal rotations, axes at the start.
struct Bar {
    Vec3 x[2];
    Quat q[2], axes;
    double L;

    beam::ElementFrame<double> placement() const {
        const Vec3 c = x[1] - x[0];
        return place<double>({c.x(), c.y(), c.z()}, quad(q[0]), quad(q[1]), quad(axes));
    }
    Vec6 deformation() const {
        Vec6 d;
        beam::deformation(placement(), L, d.data());
        return d;
    }
};

Bar random_bar(Dice& dice, double deform) {
    Bar b;
    b.L = dice(0.3, 3);
    b.axes = dice.rotation();
    const Quat turn = dice.rotation();
    b.x[0] = dice.vector(10);
    b.x[1] = b.x[0] + turn * (b.axes * Vec3(0, 0, b.L)) + dice.vector(0.2 * deform * b.L);
    for (Quat& q : b.q) q = exponential(dice.vector(deform)) * turn;
    return b;
}

}  // namespace

TEST_CASE("1000 random finite rotations and shifts, one after the other, leave no strain (1e-12)") {
    Dice dice(21);
    double worst = 0, rotation_by = 0;
    for (int bar = 0; bar < 20; ++bar) {
        Bar b;
        b.L = dice(0.5, 2);
        b.axes = dice.rotation();
        b.x[0] = dice.vector(3);
        b.x[1] = b.x[0] + b.axes * Vec3(0, 0, b.L);
        b.q[0] = b.q[1] = Quat::Identity();
        for (int step = 0; step < 1000; ++step) {
            const Vec3 turn = dice.vector(dice.pick(2) ? 3 : 0.01), about = dice.vector(2), shift = dice.vector(1);
            const Mat3 R = exponential(turn).toRotationMatrix();  // the positions by Eigen, the rotations by the engine
            for (Vec3& x : b.x) x = (R * (x - about) + about + shift).eval();
            for (Quat& q : b.q) q = rotated(turn, q);
            // back to where numbers are small: what is tested is rotation, not the size of coordinates
            if (step % 7 == 0) b.x[1] -= b.x[0], b.x[0].setZero();
            const Vec6 d = b.deformation();
            worst = largest_of(worst, largest_entry(d.head<4>()), std::abs(d[4]) / b.L, std::abs(d[5]));
        }
        rotation_by = largest_of(rotation_by, b.q[0].angularDistance(Quat::Identity()));
    }
    CHECK_FIGURE("largest strain or end rotation after 1000 rigid motions", worst, 1e-12);
    CHECK(rotation_by > 1);
}

TEST_CASE("a structure flown through 1000 rigid rotations by its state has no forces (1e-12 of EA)") {
    Frame frame;
    const int a = frame.node(0, 0, 0), b = frame.node(1, 0, 0.2), c = frame.node(0.4, 1, -0.5);
    frame.member(a, b);
    frame.member(b, c);
    const auto structure = frame.build();
    State state = initial_state(*structure);
    ThreadPool alone;
    ElementAssembly assembly(*structure, alone, false);
    assembly.update_active(state);
    Dice dice(22);
    Quat whole = Quat::Identity();
    for (int i = 0; i < 1000; ++i) whole = rotated(dice.vector(2), whole);
    Configuration pose = state;
    for (std::size_t i = 0; i < pose.displacement.size(); ++i) {
        pose.rotation[i] = whole;
        pose.displacement[i] = whole * structure->position()[i] - structure->position()[i];
    }
    std::vector<Vec6> nodal(pose.displacement.size(), Vec6::Zero()), force(state.force);
    std::vector<PlasticIncrement> yielding;
    assembly.run(state, pose, nodal, force, yielding);
    const double EA = structure->elements()[0].rigidity.EA;
    double worst = 0;
    for (const Vec6& p : force) worst = largest_of(worst, largest_entry(p) / EA);
    CHECK_FIGURE("forces over EA after 1000 rigid rotations of a structure", worst, 1e-12);
}

TEST_CASE("a rotation about any axis comes back as its rotation vector (1e-12), up to 3 rad") {
    Dice dice(23);
    double worst = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Vec3 v = dice.direction() * (trial % 4 ? dice(0, 3) : dice(0, 0.3));
        const Quat frame = dice.rotation();
        const Triad<double> f = rotated_triad(quad(frame), quad(Quat::Identity())),
                            n = rotated_triad(quad(frame * exponential(v)), quad(Quat::Identity()));
        worst = largest_of(worst, (eigen(relative_rotation(f, n)) - v).norm());
    }
    CHECK_FIGURE("rotation vector of exp(v), rad", worst, 1e-12);
}

TEST_CASE("one element or eight at once: the same bits, also where one lane leaves the series") {
    Dice dice(24);
    for (int trial = 0; trial < 300; ++trial) {
        Bar bar[lane_count];
        for (Bar& b : bar) b = random_bar(dice, dice.pick(3) ? 0.05 : 1.2);
        double p[lane_count][6];
        for (auto& row : p)
            for (double& v : row) v = dice(-1e4, 1e4);

        Triple<Lanes> chord;
        Quadruple<Lanes> q1, q2, axes;
        Lanes L, P[6], d[6];
        for (int i = 0; i < lane_count; ++i) {
            const Vec3 c = bar[i].x[1] - bar[i].x[0];
            chord.x[i] = c.x(), chord.y[i] = c.y(), chord.z[i] = c.z();
            const auto set = [&](Quadruple<Lanes>& to, const Quat& q) {
                to.w[i] = q.w(), to.x[i] = q.x(), to.y[i] = q.y(), to.z[i] = q.z();
            };
            set(q1, bar[i].q[0]), set(q2, bar[i].q[1]), set(axes, bar[i].axes);
            L[i] = bar[i].L;
            for (int c6 = 0; c6 < 6; ++c6) P[c6][i] = p[i][c6];
        }
        const beam::ElementFrame<Lanes> place8 = place(chord, q1, q2, axes);
        deformation(place8, L, d);
        const NodalForces<Lanes> f8 = nodal_forces(place8, P);
        for (int i = 0; i < lane_count; ++i) {
            const beam::ElementFrame<double> place1 = bar[i].placement();
            double d1[6];
            deformation(place1, bar[i].L, d1);
            const NodalForces<double> f1 = nodal_forces(place1, p[i]);
            const auto one = numbers(d1, f1, [](double x) { return x; }),
                       eight = numbers(d, f8, [i](const Lanes&x) { return double(x[i]); });
            REQUIRE(std::memcmp(one.data(), eight.data(), sizeof one) == 0);
        }
    }
}

TEST_CASE("nodal forces of a deformed element are in equilibrium: forces and moments sum to zero (1e-13: rounding)") {
    Dice dice(25);
    double worst = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Bar b = random_bar(dice, trial % 2 ? 0.05 : 1.0);
        double p[6];
        for (double& v : p) v = dice(-1e4, 1e4);
        const beam::ElementFrame<double> place = b.placement();
        const NodalForces<double> f = nodal_forces(place, p);
        const Vec3 chord = b.x[1] - b.x[0], f1 = eigen(f.force[0]), f2 = eigen(f.force[1]), m1 = eigen(f.moment[0]),
                   m2 = eigen(f.moment[1]);
        const double size = f2.norm() * chord.norm() + m1.norm() + m2.norm();
        worst = largest_of(worst, (f1 + f2).norm() / f2.norm(), (m1 + m2 + chord.cross(f2)).norm() / size);
    }
    CHECK_FIGURE("sum of nodal forces and moments", worst, 1e-13);
}

TEST_CASE("nodal forces do the work of p on d: f . du = p . dd (1e-7: a difference quotient)") {
    Dice dice(26);
    double worst = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const Bar b = random_bar(dice, trial % 2 ? 0.05 : 0.8);
        Vec6 p;
        for (double& v : p) v = dice(-1, 1);
        const NodalForces<double> f = nodal_forces(b.placement(), p.data());
        const double h = 1e-6;
        for (int i = 0; i < 2; ++i) {
            const Vec3 du = dice.direction(), dt = dice.direction();
            const auto moved = [&](double by) {
                Bar c = b;
                c.x[i] += by * du;
                c.q[i] = exponential(by * dt) * c.q[i];
                return c.deformation();
            };
            const double by_d = p.dot(moved(h) - moved(-h)) / (2 * h),
                         by_nodes = eigen(f.force[i]).dot(du) + eigen(f.moment[i]).dot(dt);
            worst = largest_of(worst, std::abs(by_d - by_nodes) / (1 + p.norm() / b.L));
        }
    }
    CHECK_FIGURE("f . du against p . dd", worst, 1e-7);
}

TEST_CASE("rates of the deformation are the transpose of the nodal forces: p . d' is their power (1e-13: rounding)") {
    Dice dice(27);
    double worst = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const beam::ElementFrame<double> place = random_bar(dice, trial % 2 ? 0.05 : 1.0).placement();
        double p[6], rate[6], power = 0, size = 0;
        for (double& v : p) v = dice(-1, 1);
        Triple<double> linear[2], angular[2];
        for (auto* of : {linear, angular})
            for (int node : {0, 1}) of[node] = {dice(-1, 1), dice(-1, 1), dice(-1, 1)};
        deformation_rates(place, linear, angular, rate);
        const NodalForces<double> f = nodal_forces(place, p);
        for (int node : {0, 1}) {
            const double parts[] = {dot(f.force[node], linear[node]), dot(f.moment[node], angular[node])};
            for (const double part : parts) power += part, size += std::abs(part);
        }
        for (int i = 0; i < 6; ++i) power -= p[i] * rate[i], size += std::abs(p[i] * rate[i]);
        worst = largest_of(worst, std::abs(power) / size);
    }
    CHECK_FIGURE("power of the nodal forces against p . d'", worst, 1e-13);
}

TEST_CASE("a rotation vector on top of a quaternion is Eigen's exponential, and stays a unit quaternion (1e-15)") {
    Dice dice(27);
    double worst = 0, length = 0;
    Quat q = Quat::Identity();
    for (int i = 0; i < 5000; ++i) {
        const Vec3 v = dice.vector(i % 3 == 0 ? 3 : i % 3 == 1 ? 0.1 : 1e-9);
        const Quat by_eigen = exponential(v) * q, by_engine = rotated(v, q);
        worst = largest_of(worst, (by_eigen.coeffs() - by_engine.coeffs()).norm());
        q = by_engine;
        length = largest_of(length, std::abs(q.norm() - 1));
    }
    CHECK_FIGURE("rotated(v, q) against Eigen", worst, 2e-15);
    CHECK_FIGURE("length of a quaternion after 5000 rotations", length, 1e-15);
}

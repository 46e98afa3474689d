// The cubic mass of a pair of elements: beams whose frequencies are known, frames against fine meshes, and what a free
// body keeps.
#include <numeric>

#include "helpers.h"
#include "algebra/modes.h"

using namespace hinge;
using namespace hinge::test;

namespace {

ModelOptions with_mass(MassShape mass, Displacement displacement = Displacement::large) {
    return {.displacement = displacement, .mass = mass};
}

double lowest(const Frame& frame) {
    const auto structure = frame.build();
    std::vector<int> nodes(structure->position().size());
    std::iota(nodes.begin(), nodes.end(), 0);
    return natural_frequencies(*structure, nodes, 0, 1)[0];
}

constexpr std::uint8_t clamped = 63, in_plane = 0b101010;  // in_plane: moves along x and z, rotates about y

/// Members in a row along x, in the plane x-z.
Frame row(MassShape mass, int members, int elements, std::uint8_t left, std::uint8_t right) {
    Frame frame(with_mass(mass, Displacement::small));
    frame.section = square(0.02);
    frame.elements = elements;
    const auto nodes = straight(frame, {0, 0, 0}, {double(members), 0, 0}, members);
    for (int n : nodes) frame.model->fix(n, in_plane);
    frame.model->fix(nodes.front(), left);
    frame.model->fix(nodes.back(), right);
    return frame;
}

/// Storeys 1.5 m high of bays 2 m wide in the plane x-z, clamped at the feet.
Frame storeys(MassShape mass, int high, int wide, int elements) {
    Frame frame(with_mass(mass, Displacement::small));
    frame.section = square(0.05);
    frame.elements = elements;
    std::vector<std::vector<int>> at(high + 1);
    for (int s = 0; s <= high; ++s)
        for (int b = 0; b <= wide; ++b)
            at[s].push_back(s == 0 ? frame.foot(2.0 * b, 0, 0) : frame.foot(2.0 * b, 0, 1.5 * s, in_plane));
    for (int s = 1; s <= high; ++s)
        for (int b = 0; b <= wide; ++b) {
            frame.member(at[s - 1][b], at[s][b]);
            if (b > 0) frame.member(at[s][b - 1], at[s][b]);
        }
    return frame;
}

}  // namespace

TEST_CASE("cubic mass: slender beams of two elements a member, where the linear mass is off by 4 and 3 %") {
    const double c = std::sqrt(206e9 / 7850) * 0.02 / std::sqrt(12.0), pinned = 0b000111;
    const double cantilever = std::pow(1.8751040687, 2) * c, spans = std::pow(pi / 3, 2) * c;
    const auto error = [](const Frame& frame, double exact) { return lowest(frame) / exact - 1; };
    CHECK_FIGURE("cantilever", std::abs(error(row(MassShape::cubic, 1, 2, clamped, 0), cantilever)), 2.5e-3);
    CHECK_FIGURE("three members between pins", std::abs(error(row(MassShape::cubic, 3, 2, pinned, pinned), spans)),
                 1e-3);
    CHECK(error(row(MassShape::linear, 1, 2, clamped, 0), cantilever) < -0.03);
    CHECK(error(row(MassShape::linear, 3, 2, pinned, pinned), spans) > 0.03);
    CHECK_FIGURE("cantilever, four elements", std::abs(error(row(MassShape::cubic, 1, 4, clamped, 0), cantilever)),
                 1e-3);
}

TEST_CASE("cubic mass: frames of two elements a member against a fine mesh") {
    for (const auto& [high, wide, limit] : {std::tuple{1, 1, 2e-3}, std::tuple{3, 2, 5e-4}}) {
        const double fine = lowest(storeys(MassShape::linear, high, wide, 32));
        const double cubic = off(lowest(storeys(MassShape::cubic, high, wide, 2)), fine),
                     linear = off(lowest(storeys(MassShape::linear, high, wide, 2)), fine);
        CHECK_FIGURE("sway of " + std::to_string(high) + " storeys", cubic, limit);
        CHECK_FIGURE("the linear mass has more", cubic / linear, 0.5);
    }
}

TEST_CASE("cubic mass: a pair translates and rotates as before when it does not bend (1e-14: rounding)") {
    Frame linear(with_mass(MassShape::linear)), cubic(with_mass(MassShape::cubic));
    Dice dice(1);
    for (Frame* f : {&linear, &cubic}) straight(*f, {1, -2, 0.5}, {2, 0.5, 1.5}, 2);
    const auto a = linear.build(), b = cubic.build();
    for (int i = 0; i < 5; ++i) {
        const Vec3 v = dice.vector(1), w = dice.vector(1);
        State s = initial_state(*a);
        for (std::size_t n = 0; n < s.velocity.size(); ++n) s.velocity[n] << v + w.cross(a->position()[n]), w;
        CHECK_FIGURE("kinetic energy", off(kinetic_energy(*b, s), kinetic_energy(*a, s)), 1e-14);
        const Momentum p = momentum(*a, s), q = momentum(*b, s);
        CHECK_FIGURE("linear momentum", linear_change(p, q), 1e-14);
        CHECK_FIGURE("angular momentum", angular_change(p, q), 1e-13);
    }
}

TEST_CASE("cubic mass: a body that bends and tumbles keeps its momenta and its energy") {
    const auto fly = [](MassShape mass, double dt) {
        Frame frame(with_mass(mass));
        const auto nodes = straight(frame, {0, 0, 0}, {1, 2, -0.5}, 4);
        const Vec3 across = Vec3(2, -1, 0).normalized();
        for (std::size_t i = 0; i < nodes.size(); ++i)
            frame.model->set_velocity(nodes[i], Vec3(5, 1, 0) + (i % 2 == 0 ? 1.0 : -1.0) * across, Vec3(0.5, 1, 2));
        Dynamics run = dynamics(frame.build(), {.dt = dt, .duration = 0.03});
        return worst_of_flight(run);
    };
    const Flight fine = fly(MassShape::cubic, 1e-5), coarse = fly(MassShape::cubic, 4e-5),
                 linear = fly(MassShape::linear, 1e-5);
    CHECK_FIGURE("linear momentum", fine.linear, 1e-9);
    CHECK_FIGURE("angular momentum", fine.angular, largest_of(1e-6, 3 * linear.angular));
    CHECK_FIGURE("energy", fine.energy, largest_of(1e-6, 3 * linear.energy));
    CHECK_FIGURE("energy falls with the square of dt: 16 times for 4", fine.energy / coarse.energy, 1.0 / 8);
}

TEST_CASE("cubic mass: gravity bends nothing that falls (1e-10: rounding of positions)") {
    Frame frame(with_mass(MassShape::cubic));
    const auto nodes = straight(frame, {0, 0, 0}, {3, 0, 1}, 3);
    set_gravity(*frame.model, {0, 0, -9.81});
    Dynamics run = dynamics(frame.build(), {.dt = 1e-4, .duration = 0.1});
    complete(run);
    double worst = 0;
    for (const Vec3& u : run.state().displacement) worst = largest_of(worst, (u - run.state().displacement[0]).norm());
    CHECK_FIGURE("displacements differ", worst / run.state().displacement[0].norm(), 1e-10);
}

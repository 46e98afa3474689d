// Controls of the load path of statics, and the halving of its steps, against numbers by hand.
#include <catch2/catch.hpp>

#include "run/arc_length_control.h"
#include "run/displacement_control.h"
#include "run/load_control.h"

using namespace hinge;

namespace {

using Displacements = std::vector<Vec6>;

/// Two nodes that move along x and z; the second one also rotates, which no arc counts.
Displacements moved(double x1, double z1, double x2, double z2, double rotation = 0) {
    Vec6 a = Vec6::Zero(), b = Vec6::Zero();
    a[0] = x1, a[2] = z1, b[0] = x2, b[2] = z2, b[4] = rotation;
    return {a, b};
}

}  // namespace

TEST_CASE("A step without equilibrium is halved into substeps that fill it", "[step_halving]") {
    StepHalving halving(StepRule::equal_steps(4));
    halving.begin_step(1);
    CHECK(halving.left() == 0.25);
    double increment = halving.next();
    CHECK(increment == 0.25);
    REQUIRE(halving.halve(increment));
    CHECK(increment == 0.125);
    halving.commit(increment, 7);  // seven iterations are too many for a longer one
    CHECK(halving.left() == 0.125);
    CHECK(halving.next() == 0.125);
    halving.commit(0.125, 6);
    CHECK(halving.left() == 0);
    CHECK(halving.size() == 0.25);
    CHECK(halving.rejected() == 1);

    halving.begin_step(0.25 + 5e-10);  // a rest that is rounding alone does not become a step of its own
    CHECK(halving.left() == 0.25 + 5e-10);
    CHECK(halving.next() == halving.left());

    increment = 0.25;
    int halvings = 1;  // 0.25 / 2^14 = 1.5e-5, and the next is below 1e-5
    while (halving.halve(increment)) ++halvings;
    CHECK(halvings == 15);
    CHECK(halving.size() == 0.25 / (1 << 14));
}

TEST_CASE("Steps along an arc are as long as five iterations suffice", "[step_halving]") {
    StepHalving halving(StepRule::adapted_steps());
    halving.begin_step(0.1);  // the rest of the path does not bound them
    CHECK(halving.next() == 1);
    halving.commit(1, 5);
    CHECK(halving.left() == 0);
    CHECK(halving.size() == 1);
    halving.commit(1, 45);
    CHECK(halving.size() == 0.5);  // not 1/3
    halving.go_on_with(0.01);
    CHECK(halving.next() == 0.01);
    for (int i = 0; i < 50; ++i) halving.commit(halving.next(), 1);
    CHECK(halving.size() == 30);
}

TEST_CASE("Load control adds the load in the first iteration") {
    LoadControl control(4);
    const Displacements any = moved(1, 2, 3, 4);
    CHECK(control.factor_change({1, 0.25, any, any, any}) == 0.25);
    CHECK(control.factor_change({2, 0.25, any, any, any}) == 0.0);
    CHECK(control.part_done(0.5, 2) == 0.5);
    CHECK(!control.is_over(0.999, 3));
    CHECK(control.is_over(1 - 1e-13, 4));
}

TEST_CASE("Displacement control moves one node by its part of the way") {
    DisplacementControl control(10, 1, 2, -0.4);  // z of the second node
    const Displacements correction = moved(9, 9, 9, 0.01), response = moved(9, 9, 9, -0.5);
    Displacements total = moved(0, 0, 0, 0);
    for (int iteration : {1, 2}) {
        const auto change = control.factor_change({iteration, 0.1, total, correction, response});
        REQUIRE(change);
        CHECK(total[1][2] + correction[1][2] + *change * response[1][2] == Approx(-0.04).epsilon(1e-14));
        total = moved(0, 0, 0, -0.03);
    }
    CHECK(!control.factor_change({1, 0.1, total, correction, moved(1, 1, 1, 0)}));
    CHECK(control.stabilised_modes(response) == 0);
    CHECK(control.stabilised_modes(moved(0, 0, 0, 0.1)) == 1);  // it moves on as the load falls
    control.commit(0.1, total, false);
    CHECK(control.part_done(0.7, 5) == 0.1);
}

TEST_CASE("Arc length is the length of the displacements, and the path goes on") {
    ArcLengthControl control(10, 2, 0.1);
    const Displacements none = moved(0, 0, 0, 0), response = moved(3, 0, 0, 4, 100);  // 5 m long
    const auto first = control.factor_change({1, 1, none, none, response});
    REQUIRE(first);
    CHECK(*first == Approx(0.1).epsilon(1e-14));  // the first step is a step of load: its arc is 0.5 m
    const auto length = [](const Displacements& u) {
        return std::hypot(u[0][0], u[0][2], std::hypot(u[1][0], u[1][2]));
    };

    const Displacements total = moved(0.6, 0, 0, 0.8), correction = moved(0.02, 0.1, -0.03, -0.05);
    const auto second = control.factor_change({2, 2, total, correction, response});
    REQUIRE(second);
    Displacements moves = total;
    for (int i : {0, 1}) moves[i] += correction[i] + *second * response[i];
    CHECK(length(moves) == Approx(1).epsilon(1e-13));
    CHECK(moves[0][0] * total[0][0] + moves[1][2] * total[1][2] > 0);
    CHECK(!control.factor_change({2, 2, total, moved(0, 2, 0, 0), response}));  // too far off to come back

    control.commit(1, moved(-0.3, 0, 0, -0.4), false);
    const auto falling = control.factor_change({1, 1, none, none, response});
    REQUIRE(falling);
    CHECK(*falling == Approx(-0.1).epsilon(1e-14));
    CHECK(control.reaches_target(1.9, 2.1));
    CHECK(control.reaches_target(2.1, 2));
    CHECK(!control.reaches_target(1, 1.9));
    CHECK(control.part_done(0.5, 3) == 0.3);
    CHECK((control.is_over(0.5, 10) && control.short_of_target()));
    control.commit(1, total, true);
    CHECK((control.is_over(2, 3) && !control.short_of_target()));
}

// The energy balance of a frame that yields under a sudden load, and what the paper's whole shift does to it.
#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

namespace {

struct Balance {
    double worst, plastic;
    bool monotone;
};

/// SF-1 of tests/references.md under 12 kN put on at once, for 5 ms.
Balance sudden_load(double dt, Shift shift) {
    Dynamics run = dynamics(SpaceFrame({.shift = shift}, 12e3, 245e6).build(), {.dt = dt, .duration = 5e-3});
    Balance b{0, 0, true};
    while (run.advance()) {
        const Energy e = run.energy();
        b.worst = largest_of(b.worst, std::abs(e.error));
        b.monotone &= e["plastic"] >= b.plastic;
        b.plastic = e["plastic"];
    }
    REQUIRE(run.verdict() == Verdict::completed);
    b.worst /= run.energy()["work"];
    return b;
}

}  // namespace

TEST_CASE("plastic energy balance: SF-1 under 12 kN at once closes, better with a shorter step") {
    const Balance coarse = sudden_load(5e-5, Shift::plastic), fine = sudden_load(5e-6, Shift::plastic);
    CHECK(coarse.monotone);
    CHECK(fine.monotone);
    CHECK(fine.plastic > 0);
    CHECK_FIGURE("energy error over the work of the load, dt 0.05 ms", coarse.worst, 5e-3);
    CHECK_FIGURE("energy error over the work of the load, dt 0.005 ms", fine.worst, 1e-4);
    CHECK(fine.worst < 0.2 * coarse.worst);
}

TEST_CASE("plastic energy balance: moving the elastic point with the hinge (as the paper prints it) does not close") {
    CHECK(sudden_load(5e-6, Shift::elastic_and_plastic).worst > 100 * sudden_load(5e-6, Shift::plastic).worst);
}

// Forces and moments along a bar, from those at its ends and the loads on it, against closed forms.
#include "output/resultants.h"

#include "helpers.h"

using namespace hinge::output;

namespace {

constexpr double L = 8;

/// A bar along z with the section's axes x and y, simply supported about both; its loads are in space.
struct Supported {
    Bar bar{{0, 1}, 0, BarState::elastic, -1, 1, 1, 0.3};
    std::vector<Load> loads;
    void shear(double first, double second) { bar.Qy[0] = first, bar.Qy[1] = second; }
    void moments(double first, double second) { bar.Mx[0] = first, bar.Mx[1] = second; }
    /// A force along y, of this size a metre at both ends.
    void spread(double first, double second) { loads = {{Load::force, -1, 0, -1, {{0, first, 0}, {0, second, 0}}}}; }
    Resultants carries() const {
        std::vector<const Load*> on;
        for (const Load& l : loads) on.push_back(&l);
        return {bar, L, {1, 0, 0}, {0, 1, 0}, on};
    }
};

/// Moments Mx, My and shear forces Qy, Qx at t.
void check(const Resultants& r, double t, double Mx, double Qy, double My, double Qx) {
    INFO("t = " << t);
    CHECK(r.at(Show::Mx, t) == Approx(Mx).margin(1e-9));
    CHECK(r.at(Show::Qy, t) == Approx(Qy).margin(1e-9));
    CHECK(r.at(Show::My, t) == Approx(My).margin(1e-9));
    CHECK(r.at(Show::Qx, t) == Approx(Qx).margin(1e-9));
}

}  // namespace

TEST_CASE("a point load on a simply supported bar: a kink in M, a step in Q") {
    Supported s;
    const double P = 100, a = 0.25, Q0 = -P * (1 - a), Q1 = P * a;
    s.shear(Q0, Q1);  // against y: the fibres away from y are in tension, Mx < 0
    s.loads = {{Load::force, -1, 0, a, {{0, -P, 0}, {0, 0, 0}}}};
    Resultants r = s.carries();
    check(r, 0.125, Q0 * 1, Q0, 0, 0);
    check(r, a - 1e-9, Q0 * 2, Q0, 0, 0);
    check(r, a + 1e-9, Q0 * 2, Q1, 0, 0);  // -150
    check(r, 0.625, -Q1 * 3, Q1, 0, 0);
    check(r, 1, 0, Q1, 0, 0);
    CHECK(r.jumps() == std::vector<double>{a});
    SECTION("along x it bends about y the other way round") {
        s = {};
        s.bar.Qx[0] = Q0, s.bar.Qx[1] = Q1;
        s.loads = {{Load::force, -1, 0, a, {{-P, 0, 0}, {0, 0, 0}}}};
        r = s.carries();
        check(r, a + 1e-9, 0, 0, -Q0 * 2, Q1);
        check(r, 0.625, 0, 0, Q1 * 3, Q1);
    }
    SECTION("at an end it acts on the node") {
        s.loads[0].at = 0;
        s.shear(0, 0);
        s.moments(3, 3);
        check(s.carries(), 0.5, 3, 0, 0, 0);
        CHECK(s.carries().jumps().empty());
        // or is inside, where the shear force at that end is the one before it
        s.moments(-150, 50);
        s.shear(-75, 25);
        check(s.carries(), 0, -150, -75, 0, 0);
        check(s.carries(), 0.25, -100, 25, 0, 0);
        s.loads[0].at = 1;
        s.moments(0, -600);
        check(s.carries(), 0.5, -300, -75, 0, 0);
    }
}

TEST_CASE("spread loads: M is a parabola or a cubic") {
    Supported s;
    const double w = 10;
    SECTION("uniform") {
        s.shear(-w * L / 2, w * L / 2);
        s.spread(-w, -w);
        const Resultants r = s.carries();
        check(r, 0.5, -w * L * L / 8, 0, 0, 0);
        check(r, 0.25, -w * L * L * 3 / 32, -w * L / 4, 0, 0);
        CHECK(r.jumps().empty());
    }
    SECTION("a triangle") {
        s.shear(-w * L / 6, w * L / 3);
        s.spread(0, -w);
        const double z = 0.5 * L;
        check(s.carries(), 0.5, -w * L * z / 6 + w * z * z * z / (6 * L), -w * L / 6 + w * z * z / (2 * L), 0, 0);
    }
    SECTION("a moment per length") {
        s.shear(5, 5);  // dM/dz = Q - m = 0
        s.loads = {{Load::moment, -1, 0, -1, {{5, 0, 0}, {5, 0, 0}}}};
        check(s.carries(), 0.3, 0, 5, 0, 0);
    }
    SECTION("without a load, what the ends have in common: inertia, weight") {
        s.shear(-w * L / 2, w * L / 2);
        check(s.carries(), 0.5, -w * L * L / 8, 0, 0, 0);
    }
}

TEST_CASE("a moment is largest where its slope is zero, wherever that is") {
    Supported s;
    const double w = 10, M0 = 24, M1 = -40;
    s.moments(M0, M1);
    s.shear(-w * L / 2 + (M1 - M0) / L, w * L / 2 + (M1 - M0) / L);
    s.spread(-w, -w);
    const Resultants r = s.carries();
    const double z = -s.bar.Qy[0] / w;  // Q = Q0 + w z
    const auto peaks = r.peaks(Show::Mx, 0, 1);
    REQUIRE(peaks.size() == 1);
    CHECK(peaks[0] == Approx(z / L).epsilon(1e-9));
    CHECK(r.at(Show::Mx, peaks[0]) == Approx(M0 - w * z * z / 2).epsilon(1e-9));
    CHECK(r.peaks(Show::Mx, 0, 0.5).empty());
    CHECK(r.peaks(Show::Qy, 0, 1).empty());
    CHECK(r.peaks(Show::N, 0, 1).empty());
    SECTION("a triangle, whose moment is a cubic") {
        s.moments(0, 0);
        s.shear(-w * L / 6, w * L / 3);
        s.spread(0, -w);
        const auto at = s.carries().peaks(Show::Mx, 0, 1);
        REQUIRE(at.size() == 1);
        CHECK(at[0] == Approx(std::sqrt(1.0 / 3)).epsilon(1e-9));
    }
}

TEST_CASE("a moment at a point: a step in M") {
    Supported s;
    const double m = 24;
    s.shear(m / L, m / L);
    s.loads = {{Load::moment, -1, 0, 0.5, {{m, 0, 0}, {0, 0, 0}}}};
    check(s.carries(), 0.5 - 1e-12, m / 2, m / L, 0, 0);
    check(s.carries(), 0.5 + 1e-12, -m / 2, m / L, 0, 0);
    check(s.carries(), 1, 0, m / L, 0, 0);
}

TEST_CASE("f_y between the ends is that of the moment there") {
    Supported s;
    s.bar.Mx0 = 200, s.bar.N0 = 1e3, s.bar.yield = 0;
    s.shear(-75, 25);
    s.loads = {{Load::force, -1, 0, 0.25, {{0, -100, 0}, {0, 0, 0}}}};
    const Resultants r = s.carries();
    CHECK(r.yield_at(0.25) == Approx(0.5625));  // (150 / 200)^2
    CHECK(r.class_at(0.25) == 2);
    CHECK(r.class_at(0) == 0);
    const auto at = r.class_changes();
    REQUIRE(at.size() == 6);  // 0.2 and 0.4 on both sides
    CHECK(at[1] == Approx(std::sqrt(0.2) * 200 / 75 / L).epsilon(0.02));
    CHECK(at[4] == Approx(1 - std::sqrt(0.2) * 200 / 25 / L).epsilon(0.02));
    s.bar.Mx[0] = std::nan("");
    CHECK(s.carries().class_at(0.5) == 0);
}

// N / N0 = 0.5 beside the exact plastic moment of an HEB 300 at its second end, 0.575 Mx0: eq 14 has 0.58 there.
TEST_CASE("f_y of a law that is not eq 14 is its own at the ends and in the middle") {
    Supported s;
    s.bar.Mx0 = 200, s.bar.N0 = 1e3, s.bar.N = -500, s.bar.Mx[1] = 115, s.bar.yield = 1;
    CHECK(s.carries().yield_at(1) == Approx(0.25 + 0.575 * 0.575));
    CHECK(s.carries().class_at(1) == 2);
    const double own[3] = {0.25, 0.55, 1};
    std::copy(own, own + 3, s.bar.yield_along);
    const Resultants r = s.carries();
    for (const int k : {0, 1, 2}) CHECK(r.yield_at(0.5 * k) == Approx(own[k]).epsilon(1e-12));
    CHECK(r.class_at(1) == 5);
    CHECK(r.class_at(0.5) == 2);
    SECTION("it is not above the largest of them, nor below 0") {
        for (const bool turned : {false, true}) {
            const double steep[3] = {turned ? 1.0 : 0.0, turned ? 0.95 : 0.01, turned ? 0.0 : 1.0};
            std::copy(steep, steep + 3, s.bar.yield_along);
            for (int k = 0; k <= 20; ++k) {
                CHECK(s.carries().yield_at(0.05 * k) <= 1);
                CHECK(s.carries().yield_at(0.05 * k) >= 0);
            }
        }
    }
}

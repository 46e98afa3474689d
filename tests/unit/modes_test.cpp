// Natural vibration and rigid motions: against a dense eigenvalue solver, and against beams whose frequencies are known
// in closed form.
#include <Eigen/Eigenvalues>
#include <numeric>

#include "helpers.h"
#include "algebra/modes.h"

using namespace hinge;
using namespace hinge::test;

namespace {

std::vector<int> all_nodes(const Structure& structure) {
    std::vector<int> nodes(structure.position().size());
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
}

std::vector<double> frequencies(const Structure& structure, int count) {
    const auto nodes = all_nodes(structure);
    return natural_frequencies(structure, nodes, int(free_motions(structure, nodes).size()), count);
}

/// How far the `count` lowest are from those of a dense solver, the worst of them.
double off_dense(const Structure& structure, int count) {
    const int rigid = int(free_motions(structure, all_nodes(structure)).size());
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        dense(structure, 0, 1), dense(structure, 1, 0), Eigen::EigenvaluesOnly);
    const auto found = frequencies(structure, count);
    REQUIRE(int(found.size()) == count);
    double worst = 0;
    for (int i = 0; i < count; ++i)
        worst = largest_of(worst, off(found[i], std::sqrt(solver.eigenvalues()[rigid + i])));
    return worst;
}

/// A straight bar of n elements along x whose ends are held as given.
std::shared_ptr<const Structure> bar(double length, double side, int n, std::uint8_t left, std::uint8_t right) {
    Frame frame(small_displacement());
    frame.section = square(side);
    frame.elements = n;
    const int a = frame.foot(0, 0, 0, left), b = frame.foot(length, 0, 0, right);
    frame.member(a, b);
    return frame.build();
}
constexpr std::uint8_t clamped = 63, free_end = 0, pinned = 0b001111, roller = 0b000110;

}  // namespace

TEST_CASE("the frequencies are those of a dense solver") {
    CHECK_FIGURE("space frame, 10 lowest, some of them equal", off_dense(*SpaceFrame({}, 0, infinite).build(), 10),
                 1e-8);
    CHECK_FIGURE("a bar with two elements, as many as there are", off_dense(*bar(1, 0.1, 2, clamped, free_end), 12),
                 1e-6);
    CHECK_FIGURE("the same in flight, but for its six rigid motions", off_dense(*bar(1, 0.1, 4, free_end, free_end), 6),
                 1e-6);
    CHECK_FIGURE("pinned at one point: three rigid motions", off_dense(*bar(1, 0.1, 4, 0b000111, free_end), 6), 1e-6);
    CHECK(frequencies(*bar(1, 0.1, 2, clamped, clamped), 10).size() == 6);  // fewer degrees of freedom than asked for
}

// Equal arms on one held node: each frequency of one arm as often as there are arms, and twice that in bending. The
// method that starts from one vector finds some of them only when it starts again.
TEST_CASE("repeated frequencies are all found") {
    const auto arm = frequencies(*bar(1, 0.05, 8, clamped, free_end), 6);
    for (const int arms : {3, 12}) {
        Frame frame(small_displacement());
        frame.elements = 8;
        const int hub = frame.foot(0, 0, 0);
        for (int i = 0; i < arms; ++i) {
            const double angle = 2 * pi * i / arms;
            frame.member(hub, frame.node(std::cos(angle), std::sin(angle), 0));
        }
        const auto structure = frame.build();
        for (const int count : {1, 3, 2 * arms, 4 * arms + 1, 6 * arms}) {
            const auto found = frequencies(*structure, count);
            REQUIRE(int(found.size()) == count);
            for (int i = 0; i < count; ++i) CHECK_FIGURE("one of an arm's", off(found[i], arm[i / arms]), 1e-9);
        }
    }
    Frame cube(small_displacement());  // it flies
    cube.elements = 4;
    int corner[8];
    for (int i = 0; i < 8; ++i) corner[i] = cube.node(i & 1, i >> 1 & 1, i >> 2 & 1);
    for (int i = 0; i < 8; ++i)
        for (const int side : {1, 2, 4})
            if (!(i & side)) cube.member(corner[i], corner[i | side]);
    for (const int count : {1, 4, 20, 40}) CHECK_FIGURE("a cube in flight", off_dense(*cube.build(), count), 1e-8);
}

// Euler and Bernoulli's beam. The mass moves in straight lines between the nodes, the stiffness is exact for loads at
// them: errors with the square of an element's length. One member of two elements, the default, is 4 % slow where it is
// clamped at one end and 66 % fast between two pins.
TEST_CASE("slender beams: Euler-Bernoulli, with the square of an element's length") {
    const double L = 1, b = 0.01, c = std::sqrt(206e9 / 7850 * b * b / 12);
    const std::tuple<std::uint8_t, std::uint8_t, double, double> cases[] = {{clamped, free_end, 1.8751040687, -0.0408},
                                                                            {pinned, roller, pi, 0.6602}};
    for (const auto& [left, right, root, two] : cases) {
        const double exact = root * root / (L * L) * c;
        double last = 0;
        for (int n = 2; n <= 64; n *= 2) {
            const double error = frequencies(*bar(L, b, n, left, right), 1)[0] / exact - 1;
            if (n == 2) CHECK_FIGURE("two elements", std::abs(error - two), 1e-3);
            if (n == 8 || n == 16)
                CHECK_FIGURE("a quarter of it with elements half as long", off(last / error, 4), 0.15);
            if (n == 64) CHECK_FIGURE("64 elements", std::abs(error), 1e-3);
            last = error;
        }
    }
}

// Timoshenko, simply supported: rho I w^4 / (k G A) rho A - w^2 (rho A + rho I q^2 + rho A E I q^2 / (k G A)) + E I q^4
// = 0, q = n pi / L.
TEST_CASE("a stocky beam: Timoshenko's frequencies") {
    const double L = 1, b = 0.2, E = 206e9, rho = 7850, A = b * b, I = A * A / 12, kGA = E / 2.6 * 5 / 6 * A,
                 q = pi / L;
    const double s = rho * I * rho * A / kGA, t = rho * A + rho * I * q * q + rho * A * E * I * q * q / kGA;
    const double exact = std::sqrt((t - std::sqrt(t * t - 4 * s * E * I * std::pow(q, 4))) / (2 * s)),
                 slender = q * q * std::sqrt(E * I / (rho * A));
    const double found = frequencies(*bar(L, b, 64, pinned, roller), 1)[0];
    CHECK_FIGURE("Timoshenko", off(found, exact), 1e-3);
    CHECK(off(found, slender) > 0.04);
}

TEST_CASE("rigid motions that supports leave") {
    const auto count = [](std::uint8_t left, std::uint8_t right) {
        const auto structure = bar(2, 0.1, 2, left, right);
        return free_motions(*structure, all_nodes(*structure)).size();
    };
    CHECK(count(free_end, free_end) == 6);
    CHECK(count(clamped, free_end) == 0);
    CHECK(count(pinned, roller) == 0);
    CHECK(count(0b000111, free_end) == 3);
    CHECK(count(roller, roller) == 2);  // along its axis, and about it
    const auto structure = bar(2, 0.1, 2, 0b000111, 0b000110);
    const auto motions = free_motions(*structure, all_nodes(*structure));
    REQUIRE(motions.size() == 1);  // about its axis
    CHECK(motions[0].w.normalized().cwiseAbs().isApprox(Vec3::UnitX(), 1e-9));
    CHECK(motions[0].v.norm() < 1e-9);
}

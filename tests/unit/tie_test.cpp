// The gap element: forces against finite differences of the energy, their balance, the tangent.

#include "contact/tie.h"
#include "contact_parts.h"

using namespace hinge;
using namespace hinge::contact;

namespace {

/// A tie of two bars in general position, one of them broken, with arms, everything turned since it was bound.
struct Bound {
    std::vector<Vec3> x;
    std::vector<Quat> q;
    Tie tie;
};

Bound bound_pair(unsigned seed, double stretch, double turn_each, double turn_all, bool arms) {
    Dice dice(seed);
    Bound out;
    for (int i = 0; i < 4; ++i) {
        out.x.push_back(dice.vector(0.5));
        out.q.push_back(dice.rotation(pi));
    }
    for (int i = 0; i < 4; ++i) {
        out.tie.end[i].node = i;
        out.tie.end[i].arm = arms ? dice.vector(0.3) : Vec3::Zero();
    }
    const auto point = [&](int i) { return Vec3(out.x[i] + out.q[i] * out.tie.end[i].arm); };
    for (int g = 0; g < 4; ++g) {
        out.tie.gap[g].rest = point(gap_b(g)) - point(gap_a(g));
        out.tie.gap[g].stiffness = 1e3 * (1 + g);
    }
    out.tie.normal = Vec3::UnitZ();
    out.tie.at[0] = 0.3;
    out.tie.at[1] = 0.6;
    const Quat all = dice.rotation(turn_all);
    out.tie.rotation = all;  // as a tie has that followed the whole so far
    const Vec3 shift = dice.vector(3);
    for (int i = 0; i < 4; ++i) {
        out.x[i] = all * out.x[i] + shift + dice.vector(stretch);
        out.q[i] = dice.rotation(turn_each) * all * out.q[i];
    }
    return out;
}

/// A tie of bars with these ends as they are, 1e9 N/m.
Tie tie_of(const std::vector<Vec3>& start) {
    Tie tie;
    for (int i = 0; i < 4; ++i) tie.end[i].node = i;
    for (int g = 0; g < 4; ++g) tie.gap[g] = {start[gap_b(g)] - start[gap_a(g)], 1e9};
    return tie;
}

std::vector<Vec6> forces_of(Bound& b) {
    std::vector<Vec6> f(b.x.size(), Vec6::Zero());
    add_tie_forces(b.tie, b.x, b.q, f);
    return f;
}

/// `b` with degree of freedom `k` of node `n` moved by h.
Bound nudged(const Bound& b, int n, int k, double h) {
    Bound out = b;
    nudge(out.x, out.q, n, k, h);
    return out;
}

}  // namespace

TEST_CASE("contact: a tie's forces are the derivative of their energy") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const bool arms = seed % 2;
        // The nodes rotate against each other as well: that must not matter, but for arms.
        Bound b = bound_pair(seed, 0.02, seed < 10 ? 0.05 : 1.0, 2.0, arms);
        const std::vector<Vec6> f = forces_of(b);
        double largest = 0;
        for (const Vec6& n : f) largest = largest_of(largest, largest_entry(n));
        const double h = 1e-5;
        for (int n = 0; n < 4; ++n)
            for (int k = 0; k < 6; ++k) {
                Bound up = nudged(b, n, k, h), down = nudged(b, n, k, -h);
                forces_of(up);
                forces_of(down);
                CHECK(f[n][k] == Approx((up.tie.energy - down.tie.energy) / (2 * h)).margin(1e-6 * largest));
            }
    }
}

TEST_CASE("contact: a tie's forces and moments balance") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Bound b = bound_pair(seed, 0.1, 0.5, 3.0, seed % 2);
        const std::vector<Vec6> f = forces_of(b);
        const auto [force, moment] = sums_of(b.x, f);
        double size = 0;
        for (const Vec6& n : f) size += n.norm();
        CHECK(force.norm() < 1e-14 * size);
        CHECK(moment.norm() < 1e-14 * size * 5);
    }
}

TEST_CASE("contact: a tie that moves as one piece stores nothing") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Bound b = bound_pair(seed, 0.0, 0.0, pi, seed % 2);
        for (const Vec6& n : forces_of(b)) CHECK(n.norm() < 1e-11);
        CHECK(b.tie.energy < 1e-24);
    }
}

TEST_CASE("contact: a tie resists the same way whether or not the bars have passed each other") {
    // Crossing bars 0.2 mm apart. A gap that pulled along the line between nodes would flip as they pass.
    const std::vector<Vec3> start{{-0.5, 0, 0}, {0.4, 0, 0}, {0, -0.3, 2e-4}, {0, 0.6, 2e-4}};
    Tie tie = tie_of(start);
    tie.normal = Vec3::UnitZ();
    tie.at[0] = 5.0 / 9;
    tie.at[1] = 1.0 / 3;
    // A node that spins does not loosen the tie.
    for (const Vec3& spin : {Vec3(0, 0, 0), Vec3(0.3, -0.2, 0.4)}) {
        std::vector<Quat> q(4, Quat::Identity());
        q[0] = q[3] = exponential(spin) * q[0];
        for (double way : {0.0, 1e-4, 2e-4, 3e-4, 1e-3}) {
            std::vector<Vec3> x = start;
            x[2].z() -= way;
            x[3].z() -= way;
            std::vector<Vec6> f(4, Vec6::Zero());
            add_tie_forces(tie, x, q, f);
            // As one piece rotates along a little with the shift, the force is below 4 k way, but not by much.
            CHECK(tie.energy <= 2e9 * way * way * (1 + 1e-6) + 1e-20);
            CHECK(tie.energy >= 1.7e9 * way * way);
            CHECK(tie.opening == Approx(-way).epsilon(0.2).margin(1e-15));
            CHECK(f[2][2] + f[3][2] <= -3.4e9 * way + 1e-6);  // N: 4e9 N/m times rounding of a position
            for (const Vec6& n : f) CHECK(n.tail<3>().norm() == 0);
        }
    }
}

TEST_CASE("contact: ties in degenerate positions") {
    struct Case {
        const char* name;
        Vec3 a0, a1, b0, b1;
    };
    const Case cases[] = {
        {"parallel, abreast", {0, 0, 0}, {1, 0, 0}, {0, 0, 0.05}, {1, 0, 0.05}},
        {"coincident", {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}},
        {"collinear, overlapping", {0, 0, 0}, {1, 0, 0}, {0.8, 0, 0}, {1.8, 0, 0}},
        {"collinear, end to end", {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}},
        {"an end on a side", {0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {0.5, 0, 1}},
        {"no length", {0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {0.5, 0, 0}},
        {"all one point", {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
    };
    for (const Case& c : cases) {
        INFO(c.name);
        const std::vector<Vec3> start{c.a0, c.a1, c.b0, c.b1};
        Tie tie = tie_of(start);
        Dice dice(11);
        for (double stretch : {0.0, 1e-6, 1e-3, 0.1, 3.0}) {
            std::vector<Vec3> x = start;
            std::vector<Quat> q(4, dice.rotation(1));
            for (Vec3& p : x) p = q[0] * p + dice.vector(stretch);
            std::vector<Vec6> f(4, Vec6::Zero());
            add_tie_forces(tie, x, q, f);
            const auto [force, moment] = sums_of(x, f);
            const double size = 1e9 * (stretch + 1e-15) * 20;
            CHECK(force.norm() <= 1e-13 * size + 1e-6);
            CHECK(moment.norm() <= 1e-9 * size + 1e-6);
            CHECK(tie.energy <= 4 * 0.5e9 * 12 * stretch * stretch + 1e-15);
            add_tie_stiffness(tie, x, q, [](int, int, const Mat12& m) { CHECK(m.allFinite()); });
        }
    }
}

TEST_CASE("contact: the tangent is the derivative of the forces") {
    for (unsigned seed = 0; seed < 16; ++seed) {
        const bool arms = seed % 2, broken = seed >= 12;  // both ends of a bar on one node
        Bound b = bound_pair(seed, 0.05, 0.3, 2.0, arms || broken);
        if (broken) {
            // The end keeps its place; node 1, or node 3, is left alone.
            const int from = seed < 14 ? 1 : 3, to = from - 1;
            End& end = b.tie.end[from];
            end.arm = b.q[to].conjugate() * (b.x[from] + b.q[from] * end.arm - b.x[to]);
            end.node = to;
        }
        const Eigen::MatrixXd k = gathered([&](auto add) { add_tie_stiffness(b.tie, b.x, b.q, add); }),
                              d = slope_of(
                                  [&](int n, int c, double h) {
                                      Bound there = nudged(b, n, c, h);
                                      return forces_of(there);
                                  },
                                  1e-5);
        // Moments about fixed axes make the derivative of an arm's moment lopsided; its symmetric part is the tangent.
        if (!arms && !broken) CHECK(largest_entry(d - d.transpose()) < 1e-6 * largest_entry(k));
        const double error = largest_entry(k - 0.5 * (d + d.transpose()));
        INFO("seed " << seed << " error " << error << " of " << largest_entry(k));
        CHECK(error <= 1e-6 * largest_entry(k));
    }
}

TEST_CASE("contact: stiffness of a gap element") {
    CHECK(gap_stiffness(2e8, 2e8, 0.5, 0.1) == Approx(4e8));
    CHECK(gap_stiffness(2e8, 2e8, 1e-6, 0.1) == Approx(2e9));              // floored
    CHECK(gap_stiffness(1e8, 1e12, 1, 0.1) == Approx(2e8).epsilon(1e-3));  // the softer bar rules
}

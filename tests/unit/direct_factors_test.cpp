// Factors of a grid of nodes: their solution, their sign and how many numbers they hold.
#include "algebra/direct_factors.h"

#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

namespace {

constexpr int side = 12, nodes = side * side;

/// A matrix of a square grid of nodes that are joined to their neighbours; skew: size of its part that is not
/// symmetric.
struct Grid {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6 * nodes, 6 * nodes);
    DirectFactors factors;

    Grid(bool unsymmetric, double skew) : factors(unsymmetric) {
        Dice dice(5);
        const auto some = [&] { return Mat6(Mat6::NullaryExpr([&] { return dice(-1, 1); })); };
        for (int i = 0; i < nodes; ++i) {
            const Mat6 own = some();
            add(i, i, 40 * Mat6::Identity() + own + own.transpose());
            if (i % side > 0) join(i, i - 1, some(), skew * some());
            if (i >= side) join(i, i - side, some(), skew * some());
        }
    }
    void add(int row, int column, const Mat6& block) {
        factors.add(row, column, block);
        dense.block<6, 6>(6 * row, 6 * column) += block;
    }
    void join(int a, int b, const Mat6& even, const Mat6& odd) {
        add(a, b, even + odd);
        add(b, a, even.transpose() - odd.transpose());
    }
};

}  // namespace

TEST_CASE("factors of an unsymmetric matrix solve it and hold twice what those of a symmetric one hold") {
    Grid symmetric(false, 0), unsymmetric(true, 0.3);
    REQUIRE(symmetric.factors.factorise(nodes));
    REQUIRE(unsymmetric.factors.factorise(nodes));
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(6 * nodes, -1, 1);
    for (const Grid* grid : {&symmetric, &unsymmetric}) {
        Eigen::VectorXd x(6 * nodes);
        REQUIRE(grid->factors.solve(right.data(), x.data(), nodes));
        CHECK(largest_entry((grid->dense * x - right).cwiseAbs()) < 1e-12);
    }
    // The pattern is the same, so twice L is as few as there can be. Ordered by columns alone it was three times that.
    CHECK(unsymmetric.factors.size() >= 2 * symmetric.factors.size() - 12 * nodes);
    CHECK(unsymmetric.factors.size() < 2.4 * double(symmetric.factors.size()));
}

TEST_CASE("the sign of the determinant is that of a matrix with one negative pivot") {
    Grid grid(true, 0.3);
    REQUIRE(grid.factors.factorise(nodes));
    CHECK_FALSE(grid.factors.negative_determinant());
    Grid turned(true, 0.3);
    Mat6 more = Mat6::Zero();
    more(2, 2) = -400;
    turned.add(50, 50, more);
    REQUIRE(turned.factors.factorise(nodes));
    CHECK(turned.factors.negative_determinant() == (turned.dense.determinant() < 0));
    CHECK(turned.factors.negative_determinant());
}

TEST_CASE("an unsymmetric matrix with nothing on its diagonal is solved") {
    DirectFactors factors(true);
    Mat6 turn = Mat6::Zero();  // a permutation: each column's only entry is beside the diagonal
    for (int i = 0; i < 6; ++i) turn((i + 1) % 6, i) = 2;
    factors.add(0, 0, turn);
    REQUIRE(factors.factorise(1));
    Vec6 right, x;
    right << 1, 2, 3, 4, 5, 6;
    REQUIRE(factors.solve(right.data(), x.data(), 1));
    CHECK(largest_entry((turn * x - right).cwiseAbs()) < 1e-15);
}

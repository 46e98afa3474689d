// The tests' own helpers: a number that is not one is missed by every limit, wherever it comes among the others.
#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

TEST_CASE("the largest and the smallest of numbers are not numbers if one of them is not") {
    const double nan = std::nan("");
    CHECK(largest_of(-2, -3, -1) == -1);
    CHECK(largest_of(-infinite, 4) == 4);
    CHECK(largest_of(4, infinite) == infinite);
    CHECK(smallest_of(infinite, -4) == -4);
    for (int at = 0; at < 3; ++at) {  // first, in the middle, last
        double x[3] = {1e-16, 3e-16, 2e-16};
        x[at] = nan;
        CHECK(std::isnan(largest_of(x[0], x[1], x[2])));
        CHECK(std::isnan(smallest_of(smallest_of(x[0], x[1]), x[2])));
    }
    CHECK(std::isnan(largest_of(nan, infinite)));
    CHECK(std::isnan(largest_of(infinite, nan)));
}

TEST_CASE("the largest entry of a matrix is its largest magnitude, and no number if one of its entries is none") {
    Vec6 v = (Vec6() << 1, -5, 3, 2, 0, 4).finished();
    CHECK(largest_entry(v) == 5);
    CHECK(largest_entry(v.head<1>()) == 1);
    CHECK(largest_entry(Mat6(v * v.transpose())) == 25);
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 12; ++j) {
            Mat12 m = Mat12::Identity();
            m(i, j) = std::nan("");
            CHECK(std::isnan(largest_entry(m)));
            CHECK(std::isnan(largest_entry(m.col(j))));
            CHECK(std::isnan(largest_entry(Eigen::MatrixXd(m))));
        }
}

TEST_CASE("a figure that is not a number is not within its limit") {
    CHECK_FALSE(off(std::nan(""), 1) <= 1e-3);
    CHECK_FALSE(off(1, std::nan("")) <= 1e-3);
}

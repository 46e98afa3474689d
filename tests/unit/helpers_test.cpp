// The tests' own helpers: a number that is not one is missed by every limit, wherever it comes among the others.
#include "helpers.h"

using namespace hinge;
using namespace hinge::test;

TEST_CASE("the largest and the smallest of numbers are not numbers if one of them is not", "[helpers]") {
    const double nan = std::nan("");
    CHECK(largest_of(2, 3, 1) == 3);
    CHECK(largest_of(-2, -3, -1) == -1);
    CHECK(largest_of(-infinite, 4) == 4);
    CHECK(largest_of(4, infinite) == infinite);
    CHECK(smallest_of(2, 3) == 2);
    CHECK(smallest_of(infinite, -4) == -4);
    for (int at = 0; at < 3; ++at) {  // first, in the middle, last
        double x[3] = {1e-16, 3e-16, 2e-16};
        x[at] = nan;
        CHECK(std::isnan(largest_of(x[0], x[1], x[2])));
        CHECK(std::isnan(smallest_of(smallest_of(x[0], x[1]), x[2])));
        double worst = 0, least = 1;  // as a loop collects it
        for (double error : x) worst = largest_of(worst, error), least = smallest_of(least, error);
        CHECK(std::isnan(worst));
        CHECK(std::isnan(least));
        // what the helper is for: the standard library's maximum passes
        double dropped = 0;
        for (double error : x) dropped = dropped < error ? error : dropped;
        CHECK(dropped <= 1e-13);
        CHECK_FALSE(worst <= 1e-13);
        CHECK_FALSE(worst > 1e-3);
    }
    CHECK(std::isnan(largest_of(nan, infinite)));
    CHECK(std::isnan(largest_of(infinite, nan)));
}

TEST_CASE("the largest entry of a matrix is its largest magnitude, and no number if one of its entries is none",
          "[helpers]") {
    Vec6 v = (Vec6() << 1, -5, 3, 2, 0, 4).finished();
    CHECK(largest_entry(v) == 5);
    CHECK(largest_entry(v.head<1>()) == 1);
    CHECK(largest_entry(Mat6(v * v.transpose())) == 25);
    for (int i = 0; i < 6; ++i) {
        Vec6 w = v;
        w[i] = std::nan("");
        CHECK(std::isnan(largest_entry(w)));
        Mat12 m = Mat12::Identity();
        for (int j = 0; j < 12; ++j) {
            Mat12 n = m;
            n(2 * i, j) = std::nan("");
            CHECK(std::isnan(largest_entry(n)));
        }
        Eigen::MatrixXd any = Eigen::MatrixXd::Ones(7, 5);
        any(i, i % 5) = std::nan("");
        CHECK(std::isnan(largest_entry(any)));
    }
}

TEST_CASE("a figure that is not a number is not within its limit", "[helpers]") {
    const double nan = std::nan("");
    CHECK_FALSE(nan <= infinite);
    CHECK_FALSE(off(nan, 1) <= 1e-3);
    CHECK_FALSE(off(1, nan) <= 1e-3);
    CHECK_FALSE(0 <= nan);
}

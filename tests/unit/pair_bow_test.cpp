// Moments in the span of a pair of elements under axial force, against the beam-column's differential equation.
#include <catch2/catch.hpp>
#include <cmath>

#include "beam/pair_bow.h"
#include "core/bar_bending.h"

using namespace hinge;
using namespace hinge::beam;

namespace {

/// M'' + p M = f on 0 to 1 by central differences, for given ends.
std::vector<double> solved(double p, double first, double last, const std::vector<double>& f) {
    const int n = int(f.size()) - 1;
    const double h = 1.0 / n;
    std::vector<double> c(n + 1), d(n + 1), M(n + 1);
    c[0] = 0, d[0] = first;
    for (int i = 1; i < n; ++i) {
        const double b = -2 + p * h * h - c[i - 1];
        c[i] = 1 / b, d[i] = (h * h * f[i] - d[i - 1]) / b;
    }
    M[n] = last;
    for (int i = n - 1; i >= 0; --i) M[i] = d[i] - c[i] * M[i + 1];
    M[0] = first;
    return M;
}

}  // namespace

TEST_CASE("T/p and D of a pair are tan(u/2)/u and u/sin u", "[bow]") {
    for (double p : {-60.0, -20.0, -7.3, -7.0, -1.0, -0.05, 0.05, 1.0, 2.4, 4.0, 6.0}) {
        const double u = std::sqrt(std::abs(p)), share = p > 0 ? std::tan(u / 2) / u : std::tanh(u / 2) / u,
                     D = p > 0 ? u / std::sin(u) : u / std::sinh(u);
        const BowFunctions<double> of = bow_functions(p);
        const double exact = p < pair_least ? 0.02 : 1e-6;  // e^-v is approximate there
        CHECK(of.share == Approx(share).epsilon(exact));
        CHECK(of.D == Approx(D).epsilon(1e-6).margin(p < pair_least ? 0.02 : 0));
    }
}

TEST_CASE("what the middle has beyond its node vanishes without axial force and is the beam's", "[bow]") {
    CHECK(std::abs(bow_of_rotation(0.0)) < 1e-12);
    CHECK(std::abs(bow_of_even_load(0.0)) < 1e-12);
    for (double p : {-5.0, 0.5, 2.0}) {
        // clamped ends, q l^2 = 1, x from the middle, in parts of l: M = (D cos(u x) - 1) / p
        const double u = std::sqrt(std::abs(p)), C = p > 0 ? u / std::tan(u) : u / std::tanh(u),
                     D = p > 0 ? u / std::sin(u) : u / std::sinh(u);
        CHECK(bow_of_even_load(p) == Approx((D - 1) / p - (0.5 - (1 - C) / p)).epsilon(1e-9));
        // many forces make an even load
        double sum = 0;
        const int n = 2000;
        for (int i = 0; i < n; ++i) sum += bow_of_force(p, (2.0 * i + 1) / n - 1) * 2 / n;
        CHECK(sum == Approx(bow_of_even_load(p)).epsilon(1e-5));
        const double h = 1e-6;
        for (double x : {-0.7, 0.2})
            CHECK(bow_of_couple(p, x) ==
                  Approx((bow_of_force(p, x + h) - bow_of_force(p, x - h)) / (2 * h)).epsilon(1e-6));
    }
}

TEST_CASE("the moments of a bowed bar satisfy its differential equation", "[bow]") {
    constexpr int n = 4000;
    for (double p : {-40.0, -3.0, 1.0, 5.0, 8.0})
        for (double sign : {1.0, -1.0}) {
            BarBending bar{{2, -1}, {3, 1}, sign, 1.5};
            bar.q[0] = 4, bar.q[1] = -7;
            bar.close();
            bar.compression = p;
            std::vector<double> f(n + 1);
            for (int i = 1; i < n; ++i)
                f[i] = (bar.chord_moment((i + 1.0) / n) - 2 * bar.chord_moment(double(i) / n) +
                        bar.chord_moment((i - 1.0) / n)) *
                       n * n;
            const std::vector<double> M = solved(p, bar.M[0], bar.M[1], f);
            for (int i = 0; i <= n; i += n / 10) CHECK(bar.moment(double(i) / n) == Approx(M[i]).margin(2e-4));
        }
}

TEST_CASE("a point load and a point moment on a bowed bar make a kink and a jump", "[bow]") {
    for (double p : {-12.0, 4.0}) {
        BarBending bar{{1, 0.5}, {2, 2}, 1, 2};
        bar.points.push_back({0.4, 3, 0});
        bar.points.push_back({0.7, 0, 5});
        bar.close();
        bar.compression = p;
        CHECK(bar.moment(0) == Approx(1));
        CHECK(bar.moment(1) == Approx(0.5));
        const double h = 1e-4;
        const auto slope = [&](double t) { return (bar.moment(t + h) - bar.moment(t - h)) / (2 * h); };
        CHECK(slope(0.4 + 2 * h) - slope(0.4 - 2 * h) == Approx(-3 * 2).epsilon(1e-2));
        CHECK(bar.moment(0.7 + 1e-9) - bar.moment(0.7) == Approx(-5).epsilon(1e-6));
        for (double t : {0.2, 0.55, 0.85})  // between them M'' + p M is that of the chord alone
            CHECK((bar.moment(t + h) - 2 * bar.moment(t) + bar.moment(t - h)) / (h * h) + p * bar.moment(t) ==
                  Approx((bar.chord_moment(t + h) - 2 * bar.chord_moment(t) + bar.chord_moment(t - h)) / (h * h))
                      .margin(1e-3));
    }
}

TEST_CASE("without axial force a bar has the moments on its chord", "[bow]") {
    BarBending bar{{2, -1}, {3, 1}, 1, 1.5};
    bar.close();
    for (double t : {0.0, 0.3, 1.0}) CHECK(bar.moment(t) == bar.chord_moment(t));
}

TEST_CASE("the largest moment of a span off its middle is found", "[bow]") {
    const auto largest_of_course = [](const auto& M) {
        double largest = M(0);
        for (int i = -1000; i <= 1000; ++i)
            if (std::abs(M(i / 1000.0)) > std::abs(largest)) largest = M(i / 1000.0);
        return largest;
    };
    for (double p : {1.2, 2.0, 2.3, -2.0, 0.5}) {  // an end moment: sin u (1 - x) / sin 2u over the pair
        const double u = std::sqrt(std::abs(p));
        const auto M = [&](double x) {
            return p > 0 ? std::sin(u * (1 - x)) / std::sin(2 * u) : std::sinh(u * (1 - x)) / std::sinh(2 * u);
        };
        const double beyond = largest_of_course(M) - M(0), peak = bow_peak(p, M(-1), M(0), M(1), {});
        if (p > 1) CHECK(peak == Approx(beyond).margin(2e-3 * M(0)));
        else CHECK(peak == 0);  // the end itself has the largest
    }
    const double at = -0.5, slope = 2.0;  // a force in a quarter: dM/dx falls by so much there
    for (double p : {0.3, 1.5, 2.2}) {
        const double u = std::sqrt(p);
        const auto M = [&](double x) {
            const double a = 1 + (x < at ? x : at), b = 1 - (x < at ? at : x);
            return slope * std::sin(u * a) * std::sin(u * b) / (u * std::sin(2 * u));
        };
        const BowPoint point{at, slope, 0};
        CHECK(bow_peak(p, 0, M(0), 0, {&point, 1}) == Approx(largest_of_course(M) - M(0)).margin(2e-3 * M(0)));
    }
}

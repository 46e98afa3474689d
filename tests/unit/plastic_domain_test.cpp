// The exact plastic interaction of N, Mx and My: against fibres, closed forms, differences, and its own rules.
#include "section/plastic_domain.h"

#include <Eigen/Eigenvalues>
#include <numbers>

#include "helpers.h"

using namespace hinge;
using namespace hinge::beam;
using namespace hinge::test;
using Eigen::Vector2d;

namespace {

Outline::Polygon rectangle(double x0, double x1, double y0, double y1, bool hole = false) {
    return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, hole};
}

Outline box(double b, double d, double t) {
    Outline o;
    o.polygons = {rectangle(-b / 2, b / 2, -d / 2, d / 2), rectangle(t - b / 2, b / 2 - t, t - d / 2, d / 2 - t, true)};
    return o;
}

Outline h_section(double b, double d, double web, double flange) {
    const double x = b / 2, y = d / 2, w = web / 2, f = d / 2 - flange;
    Outline o;
    o.polygons = {
        {{{-x, -y}, {x, -y}, {x, -f}, {w, -f}, {w, f}, {x, f}, {x, y}, {-x, y}, {-x, f}, {-w, f}, {-w, -f}, {-x, -f}}}};
    return o;
}

Outline pipe(double radius, double bore) {
    Outline o;
    o.circles = {{Vector2d::Zero(), radius, false}, {Vector2d::Zero(), bore, true}};
    return o;
}

Outline angle(double b, double d, double t) {
    Outline o;
    o.polygons = {{{{0, 0}, {b, 0}, {b, t}, {t, t}, {t, d}, {0, d}}}};
    o.move(-o.centroid());
    return o;
}

/// Shapes of all kinds: doubly symmetric, with one axis, with none; a hole, circles, both.
std::vector<Outline> shapes() {
    Outline rect, tee, bored;
    rect.polygons = {rectangle(-0.1, 0.1, -0.2, 0.2)};
    tee.polygons = {
        {{{-0.01, 0}, {0.01, 0}, {0.01, 0.3}, {0.1, 0.3}, {0.1, 0.32}, {-0.1, 0.32}, {-0.1, 0.3}, {-0.01, 0.3}}}};
    tee.move(-tee.centroid());
    bored.polygons = {rectangle(-0.1, 0.1, -0.15, 0.15)};
    bored.circles = {{{0.02, 0.03}, 0.06, true}};
    bored.move(-bored.centroid());
    return {rect,
            box(0.2, 0.1, 0.008),
            h_section(0.3, 0.3, 0.011, 0.019),
            h_section(0.15, 0.3, 0.0071, 0.0107),
            pipe(0.1, 0.09),
            pipe(0.05, 0),
            angle(0.1, 0.15, 0.012),
            tee,
            bored};
}

bool contains(const Outline& o, const Vector2d& at) {
    bool in = false;
    for (const Outline::Circle& c : o.circles)
        if ((at - c.centre).norm() < c.radius) in = !c.hole;
    for (const Outline::Polygon& p : o.polygons) {
        bool odd = false;
        for (std::size_t i = 0, n = p.corners.size(); i < n; ++i) {
            const Vector2d &a = p.corners[i], &b = p.corners[(i + 1) % n];
            if ((a.y() > at.y()) != (b.y() > at.y()) &&
                at.x() < a.x() + (at.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
                odd = !odd;
        }
        if (odd && !p.hole)
            in = o.circles.empty() || !o.circles[0].hole || (at - o.circles[0].centre).norm() >= o.circles[0].radius;
        if (odd && p.hole) in = false;
    }
    return in;
}

Vec3 random_strain(Dice& dice) {
    const double size = std::exp(dice(-3, 3));
    return size * Vec3(dice(-1, 1), dice(-1, 1), dice(-1, 1) * dice(0, 1.2));
}

}  // namespace

TEST_CASE("moduli are those of the axis that halves the area: the moments at N = 0") {
    for (const Outline& shape : shapes()) {
        const PlasticDomain domain(shape);
        for (int axis : {0, 1}) REQUIRE(std::abs(domain.contour(0, axis * std::numbers::pi / 2)[axis] - 1) < 1e-9);
    }
    // A tee: half of its area, 0.005 m^2, is above 0.25 m: the flange and 0.05 m of the web.
    const PlasticDomain tee(shapes()[7]);
    const double by_hand = 0.004 * 0.06 + 0.02 * 0.05 * 0.025 + 0.02 * 0.25 * 0.125;
    REQUIRE(std::abs(tee.moduli()[0] - by_hand) < 1e-12);
}

TEST_CASE("exact interaction: the forces of a strain are those of 10^5 fibres", "[plastic_domain]") {
    Dice dice(3);
    double worst = 0;
    for (const Outline& o : shapes()) {
        const PlasticDomain domain(o);
        std::vector<Vector2d> fibres;
        const int n = 600;
        const double size = 0.35;
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < n; ++k) {
                const Vector2d at(size * (2 * (i + 0.5) / n - 1), size * (2 * (k + 0.5) / n - 1));
                if (contains(o, at)) fibres.push_back(at);
            }
        Vector2d Z = Vector2d::Zero();  // about the lines that halve the area
        for (int axis : {0, 1}) {
            std::vector<double> at;
            for (const Vector2d& f : fibres) at.push_back(f[1 - axis]);
            std::nth_element(at.begin(), at.begin() + long(at.size() / 2), at.end());
            const double middle = at[at.size() / 2];
            for (double a : at) Z[axis] += std::abs(a - middle);
        }
        for (int trial = 0; trial < 40; ++trial) {
            const Vec3 v = random_strain(dice);
            Vec3 point, sum = Vec3::Zero();
            const double h = domain.support(v, point);
            const Vec3 strain(v[0] / domain.moduli()[0], v[1] / domain.moduli()[1], v[2] / domain.area());
            for (const Vector2d& f : fibres)
                sum += std::copysign(1.0, strain[2] + strain[0] * f.y() - strain[1] * f.x()) * Vec3(f.y(), -f.x(), 1);
            sum = sum.cwiseQuotient(Vec3(Z.x(), Z.y(), double(fibres.size())));
            worst = largest_of(worst, (sum - point).norm());
            CHECK(h == Approx(point.dot(v)));
        }
    }
    CHECK_FIGURE("forces against those of fibres 1 mm apart", worst, 0.03);
}

TEST_CASE("exact interaction: closed forms of a rectangle, a pipe and an H", "[plastic_domain]") {
    const auto all = shapes();
    double worst = 0;
    for (double n = -0.99; n < 1; n += 0.03) {
        const auto about = [n](const PlasticDomain& d, int axis) {
            return d.contour(n, axis * std::acos(-1.0) / 2)[axis];
        };
        // 1 - n^2 of a rectangle; cos(pi n / 2) of a thin pipe
        const PlasticDomain rect(all[0]), thin(pipe(1, 0.9999));
        for (int axis : {0, 1}) worst = largest_of(worst, std::abs(about(rect, axis) - (1 - n * n)));
        CHECK(about(thin, 0) == Approx(std::cos(n * std::acos(0.0))).margin(1e-4));
        // H: the strip of N within the web, or beyond it in the flanges
        const double b = 0.3, d = 0.3, w = 0.011, f = 0.019, A = 2 * b * f + (d - 2 * f) * w,
                     Z = b * f * (d - f) + w * (d - 2 * f) * (d - 2 * f) / 4, strip = std::abs(n) * A;
        const double web = (d - 2 * f) * w;
        double M = 0;
        if (strip <= web) M = Z - strip * strip / (4 * w);
        else {
            const double e = d / 2 - f + (strip - web) / (2 * b);
            M = b * (d * d / 4 - e * e);
        }
        worst = largest_of(worst, std::abs(about(PlasticDomain(all[2]), 0) - M / Z));
    }
    CHECK_FIGURE("moment beside N against closed forms", worst, 1e-12);
}

TEST_CASE("exact interaction: derivatives against differences, and the support function is convex",
          "[plastic_domain]") {
    Dice dice(5);
    double slope = 0, bend = 0, convex = 0, along = 0;
    for (const Outline& o : shapes()) {
        const PlasticDomain domain(o);
        for (int trial = 0; trial < 300; ++trial) {
            const Vec3 v = random_strain(dice);
            Vec3 point, less, more;
            Mat3 H;
            const double h = domain.support(v, point, &H), step = 1e-6 * v.norm();
            Mat3 by_differences;
            for (int i = 0; i < 3; ++i) {
                Vec3 up = v, down = v;
                up[i] += step, down[i] -= step;
                const double rise = domain.support(up, more) - domain.support(down, less);
                slope = largest_of(slope, std::abs(rise / (2 * step) - point[i]));
                by_differences.col(i) = (more - less) / (2 * step);
            }
            // a side of the outline beside the axis makes the second derivatives leap: few trials meet one
            const double off = largest_entry(H - by_differences) / largest_of(1e-3 / v.norm(), largest_entry(H));
            bend = largest_of(bend, off < 0.02 ? off : trial % 50 == 0 ? off : 0);
            convex = largest_of(convex, -Eigen::SelfAdjointEigenSolver<Mat3>(H).eigenvalues()[0] * v.norm());
            along = largest_of(along, largest_entry(H * v) / h * v.norm());
            const Vec3 other = random_strain(dice);
            Vec3 there, between;
            const double sum = domain.support(v + other, between), apart = h + domain.support(other, there);
            CHECK(sum <= apart * (1 + 1e-12));
        }
    }
    CHECK_FIGURE("gradient", slope, 1e-5);
    CHECK_FIGURE("second derivatives", bend, 0.02);
    CHECK_FIGURE("a negative eigenvalue", convex, 1e-9);
    CHECK_FIGURE("second derivatives along the strain", along, 1e-9);
}

TEST_CASE("exact interaction: the gauge of 10^5 forces, what is inside, and the ellipsoid", "[plastic_domain]") {
    Dice dice(7);
    double off = 0, normal_off = 0, least_missed = 1;
    long lost = 0, wrong = 0, missed = 0, asked = 0, outside = 0;
    for (const Outline& o : shapes()) {
        const PlasticDomain domain(o);
        for (int trial = 0; trial < 11000; ++trial) {
            const Vec3 v = random_strain(dice);
            Vec3 point, normal;
            domain.support(v, point);
            const double times = std::exp(dice(-2, 3));
            double error = 0;
            const double g = domain.gauge(times * point, &normal, &error);
            lost += error > 1e-9 * times;
            off = largest_of(off, std::abs(g / times - 1));
            Vec3 again;
            domain.support(normal, again);
            normal_off = largest_of(normal_off, (again - point).norm());
            const double share = dice(0.9, 1.02);
            const bool in = domain.surely_inside(share * point);
            wrong += in && share > 1 + 1e-9;
            if (std::abs(share * point[2]) < 0.95) {
                ++asked, missed += !in && share < 0.99;
                if (!in) least_missed = smallest_of(least_missed, share);
            }
        }
        for (int trial = 0; trial < 2000; ++trial) {
            const Vec3 q = Vec3(dice(-1, 1), dice(-1, 1), dice(-1, 1)).normalized().cwiseProduct(domain.ellipsoid());
            outside += domain.gauge(q) > 1;
        }
    }
    CHECK_FIGURE("gauge of t times a point of the surface", off, 1e-10);
    CHECK_FIGURE("point of the normal found", normal_off, 1e-8);
    CHECK(lost == 0);
    CHECK(wrong == 0);
    CHECK(outside == 0);
    CHECK_FIGURE("part of forces inside that is not told", double(missed) / double(asked), 0.011);
    CHECK_FIGURE("farthest of them from the surface", 1 - least_missed, 0.06);
}

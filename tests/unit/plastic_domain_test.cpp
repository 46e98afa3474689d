// The exact plastic interaction of N, Mx and My: against fibres, closed forms, differences, and its own rules.
#include "section/plastic_domain.h"

#include "domain_rules.h"
#include "outlines.h"

using namespace hinge;
using namespace hinge::beam;
using namespace hinge::test;
using Eigen::Vector2d;

namespace {

Outline box(double b, double d, double t) {
    Outline o;
    o.polygons = {rectangle(b, d), rectangle(b - 2 * t, d - 2 * t, true)};
    return o;
}

/// Shapes of all kinds: doubly symmetric, with one axis, with none; a hole, circles, both.
std::vector<Outline> shapes() {
    Outline rect, tee, bored;
    rect.polygons = {rectangle(0.2, 0.4)};
    tee.polygons = {
        {{{-0.01, 0}, {0.01, 0}, {0.01, 0.3}, {0.1, 0.3}, {0.1, 0.32}, {-0.1, 0.32}, {-0.1, 0.3}, {-0.01, 0.3}}}};
    tee.move(-tee.centroid());
    bored.polygons = {rectangle(0.2, 0.3)};
    bored.circles = {{{0.02, 0.03}, 0.06, true}};
    bored.move(-bored.centroid());
    return {rect,
            box(0.2, 0.1, 0.008),
            h_outline(0.3, 0.3, 0.011, 0.019),
            h_outline(0.15, 0.3, 0.0071, 0.0107),
            pipe_outline(0.1, 0.09),
            pipe_outline(0.05, 0),
            angle_outline(0.1, 0.15, 0.012),
            tee,
            bored};
}

bool contains(const Outline& o, const Vector2d& at) {
    bool in = false;
    for (const Outline::Circle& c : o.circles)
        if ((at - c.centre).norm() < c.radius) in = !c.hole;
    for (const Outline::Polygon& p : o.polygons) {
        const bool odd = within_polygon(p.corners, at);
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
        for (int axis : {0, 1}) REQUIRE(std::abs(domain.contour(0, axis * pi / 2)[axis] - 1) < 1e-9);
    }
    // A tee: half of its area, 0.005 m^2, is above 0.25 m: the flange and 0.05 m of the web.
    const PlasticDomain tee(shapes()[7]);
    const double by_hand = 0.004 * 0.06 + 0.02 * 0.05 * 0.025 + 0.02 * 0.25 * 0.125;
    REQUIRE(std::abs(tee.moduli()[0] - by_hand) < 1e-12);
}

TEST_CASE("exact interaction: the forces of a strain are those of 10^5 fibres") {
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

TEST_CASE("exact interaction: closed forms of a rectangle, a pipe and an H") {
    const auto all = shapes();
    double worst = 0;
    for (double n = -0.99; n < 1; n += 0.03) {
        const auto about = [n](const PlasticDomain& d, int axis) {
            return d.contour(n, axis * std::acos(-1.0) / 2)[axis];
        };
        // 1 - n^2 of a rectangle; cos(pi n / 2) of a thin pipe
        const PlasticDomain rect(all[0]), thin(pipe_outline(1, 0.9999));
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

TEST_CASE("exact interaction: derivatives, convexity, the gauge of 10^5 forces, what is inside, the ellipsoid") {
    Dice dice(5);
    DomainRules rules;
    for (const Outline& o : shapes()) {
        const PlasticDomain domain(o);
        for (int trial = 0; trial < 300; ++trial) {
            const Vec3 v = random_strain(dice), other = random_strain(dice);
            rules.derivatives(domain, v, other);
        }
        for (int trial = 0; trial < 11000; ++trial) rules.gauge(domain, random_strain(dice), dice, 1e-9);
        for (int trial = 0; trial < 2000; ++trial) rules.ellipsoid(domain, dice);
    }
    rules.check(1e-10, 1e-8, 0.011, 0.06);
}

// What holds of every plastic domain: its support function, its gauge, what is told to be inside, its ellipsoid.
#pragma once

#include <Eigen/Eigenvalues>

#include "helpers.h"
#include "section/plastic_domain.h"

namespace hinge::test {

/// By how much the rules are missed at random strains v and at forces about their points of the surface.
struct DomainRules {
    double slope = 0, bend = 0, convex = 0, along = 0, apart = -1;
    double off = 0, normal_off = 0, least_missed = 1, farthest = 0;
    long bends = 0, leaps = 0, lost = 0, wrong = 0, asked = 0, missed = 0;

    /// Returns how far the second derivatives are from differences.
    double derivatives(const beam::PlasticDomain& domain, const Vec3& v, const Vec3& other) {
        Vec3 point;
        Mat3 H;
        const double h = domain.support(v, point, &H);
        CHECK(h > 0);
        const auto work_and_point = [&](const Vec3& strain) {
            Eigen::Vector4d both;
            Vec3 there;
            both[0] = domain.support(strain, there);
            both.tail<3>() = there;
            return both;
        };
        const Vec3 steps = Vec3::Constant(1e-7 * v.norm());
        const Eigen::Matrix<double, 4, 3> slopes = differences(work_and_point, v, steps);
        slope = largest_of(slope, largest_entry(slopes.row(0).transpose() - point));
        const Mat3 by_differences = slopes.bottomRows<3>();
        const double curved = largest_entry(H - by_differences) / largest_of(1e-3 / v.norm(), largest_entry(H));
        ++bends, leaps += !(curved < 0.02);  // few: beside a corner or a side of the outline, at the edge of a bar
        bend = largest_of(bend, curved < 0.02 ? curved : 0);
        convex = largest_of(convex, -Eigen::SelfAdjointEigenSolver<Mat3>(H).eigenvalues()[0] * v.norm());
        along = largest_of(along, largest_entry(H * v) / h * v.norm());
        Vec3 there;
        const double sum = domain.support(v + other, there), both = h + domain.support(other, there);
        apart = largest_of(apart, sum / both - 1);
        return curved;
    }
    void gauge(const beam::PlasticDomain& domain, const Vec3& v, Dice& dice, double found) {
        Vec3 point, normal, again;
        domain.support(v, point);
        const double times = std::exp(dice(-2, 3)), share = dice(0.9, 1.02);
        double error = 0;
        const double g = domain.gauge(times * point, &normal, &error);
        lost += error > found * times;
        off = largest_of(off, std::abs(g / times - 1));
        domain.support(normal, again);
        normal_off = largest_of(normal_off, (again - point).norm());
        const Vec3 from_centre = share * (point - domain.centre());
        const bool in = domain.surely_inside(domain.centre() + from_centre);
        wrong += (in || domain.surely_inside(share * point)) && share > 1 + 1e-9;
        if (!(std::abs(from_centre[2]) < 0.95)) return;
        ++asked, missed += !in && share < 0.99;
        if (!in) least_missed = smallest_of(least_missed, share);
    }
    void ellipsoid(const beam::PlasticDomain& domain, Dice& dice) {
        const Vec3 q = Vec3(dice(-1, 1), dice(-1, 1), dice(-1, 1)).normalized().cwiseProduct(domain.ellipsoid());
        farthest = largest_of(farthest, domain.gauge(q));
    }
    /// `gauge_off`, `point_off`: of the gauge and of the point of its normal; `untold`, `untold_depth`: the part of
    /// forces inside that is not told, and how far inside they are.
    void check(double gauge_off, double point_off, double untold, double untold_depth) const {
        CHECK_FIGURE("gradient", slope, 1e-5);
        CHECK_FIGURE("second derivatives", bend, 0.02);
        CHECK_FIGURE("part of them at a leap", double(leaps) / double(bends), 0.02);
        CHECK_FIGURE("a negative eigenvalue", convex, 1e-9);
        CHECK_FIGURE("second derivatives along the strain", along, 1e-9);
        CHECK_FIGURE("h of a sum above the sum", apart, 1e-12);
        CHECK_FIGURE("gauge of t times a point of the surface", off, gauge_off);
        CHECK_FIGURE("point of the normal found", normal_off, point_off);
        CHECK(lost == 0);
        CHECK(wrong == 0);
        CHECK_FIGURE("gauge of points of the ellipsoid", farthest, 1);
        CHECK_FIGURE("part of forces inside that is not told", double(missed) / double(asked), untold);
        CHECK_FIGURE("farthest of them from the surface", 1 - least_missed, untold_depth);
    }
};

}  // namespace hinge::test

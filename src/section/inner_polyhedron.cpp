#include "section/inner_polyhedron.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace hinge::beam {
namespace {

constexpr int rays = 96;         ///< directions of the moment
constexpr double coarse = 0.04;  ///< largest side of a contour from which a level is made

/// The contour of one axial force as a convex polygon of its points; sides longer than `coarse` are halved.
void add_points(const InnerPolyhedron::Slice& slice, double n, double from, double to, const Eigen::Vector2d& a,
                const Eigen::Vector2d& b, int depth, std::vector<Eigen::Vector2d>& points) {
    if (depth > 0 && (b - a).norm() > coarse * (1 - n)) {
        const double middle = 0.5 * (from + to);
        const Eigen::Vector2d m = slice(n, middle);
        add_points(slice, n, from, middle, a, m, depth - 1, points);
        add_points(slice, n, middle, to, m, b, depth - 1, points);
    } else {
        points.push_back(a);
    }
}

/// Directions of the moment, and two vectors by which m = (by_alpha . m) this one + (by_beta . m) the next.
struct Ray {
    Eigen::Vector2d to, by_alpha, by_beta;
};

/// They divide the sides of the square |x| + |y| = 1 evenly, so that it takes no angle to find those beside m.
std::array<Ray, rays> make_rays() {
    const auto direction = [](int i) {
        const double at = 4.0 * (i % rays) / rays, past = at - int(at);
        const Eigen::Vector2d on_first(1 - past, past);
        Eigen::Vector2d on = on_first.normalized();
        for (int quarter = 0; quarter < int(at); ++quarter) on = Eigen::Vector2d(-on.y(), on.x());
        return on;
    };
    std::array<Ray, rays> all;
    for (int i = 0; i < rays; ++i) {
        const Eigen::Vector2d a = direction(i), b = direction(i + 1);
        const double across = cross(a, b);
        all[i] = {a, Eigen::Vector2d(b.y(), -b.x()) / across, Eigen::Vector2d(-a.y(), a.x()) / across};
    }
    return all;
}
const std::array<Ray, rays>& all_rays() {
    static const std::array<Ray, rays> all = make_rays();
    return all;
}

/// The ray at or before the direction of m, not zero.
int ray_before(const Eigen::Vector2d& m) {
    const double x = std::abs(m.x()), y = std::abs(m.y()), past = (m.x() >= 0) == (m.y() >= 0) ? y : x;
    const int quarter = m.y() >= 0 ? (m.x() >= 0 ? 0 : 1) : (m.x() >= 0 ? 3 : 2), each = rays / 4;
    return quarter * each + std::min(each - 1, int(each * past / (x + y)));
}

}  // namespace

namespace {

/// The polygon of a level. `quarter`: the first quarter of it is computed, the others are its mirror images.
std::vector<Eigen::Vector2d> contour_points(const InnerPolyhedron::Slice& slice, double n, bool quarter) {
    constexpr int first = 16;
    constexpr double full_turn = 2 * std::numbers::pi;
    const int parts = quarter ? first / 4 : first;
    std::vector<Eigen::Vector2d> points;
    Eigen::Vector2d start[first + 1];
    for (int k = 0; k <= parts; ++k) start[k] = k == first ? start[0] : slice(n, full_turn * k / first);
    for (int k = 0; k < parts; ++k)
        add_points(slice, n, full_turn * k / first, full_turn * (k + 1) / first, start[k], start[k + 1], 12, points);
    if (!quarter) return points;
    points.push_back(start[parts]);
    const std::size_t count = points.size();
    for (std::size_t i = count - 1; i-- > 0;) points.emplace_back(-points[i].x(), points[i].y());
    for (std::size_t i = 1; i < count; ++i) points.emplace_back(-points[i].x(), -points[i].y());
    for (std::size_t i = count - 1; i-- > 1;) points.emplace_back(points[i].x(), -points[i].y());
    return points;
}

/// Where the ray leaves the polygon.
double radius_along(const Eigen::Vector2d& to, const std::vector<Eigen::Vector2d>& points) {
    double radius = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector2d &p = points[i], edge = points[(i + 1) % points.size()] - p;
        const double across = cross(to, edge);
        if (!(std::abs(across) > 0)) continue;
        const double along = cross(to, p) / -across;
        if (along >= -1e-9 && along <= 1 + 1e-9) radius = std::max(radius, to.dot(p + along * edge));
    }
    return radius;
}

}  // namespace

/// The radius of each level in the direction of each ray, of polygons whose corners are on the surface.
void InnerPolyhedron::add_side(const Slice& slice, bool quarter) {
    const std::size_t before = inverse_.size();
    inverse_.resize(before + std::size_t(levels) * rays, 0.0);
    for (int level = 0; level < levels; ++level) {
        const std::vector<Eigen::Vector2d> points = contour_points(slice, double(level) / levels, quarter);
        double* row = &inverse_[before + std::size_t(level) * rays];
        const int computed = quarter ? rays / 4 + 1 : rays;
        for (int ray = 0; ray < computed; ++ray) {
            const double radius = radius_along(all_rays()[ray].to, points);
            row[ray] = radius > 0 ? 1 / ((1 - 1e-6) * radius) : std::numeric_limits<double>::infinity();
        }
        for (int ray = computed; ray < rays; ++ray) {
            const int upper = ray <= rays / 2 ? ray : rays - ray;
            row[ray] = row[upper <= rays / 4 ? upper : rays / 2 - upper];
        }
    }
}

InnerPolyhedron::Face InnerPolyhedron::face_at(double n, const Eigen::Vector2d& m, double side) const {
    Face f;
    const double at = levels * n;
    const bool two_sides = inverse_.size() > std::size_t(levels) * rays;
    const int level = int(at), ray = ray_before(m), next = (ray + 1) % rays, first = two_sides && side < 0 ? levels : 0;
    f.part = at - level;
    const auto& [to, by_alpha, by_beta] = all_rays()[ray];
    for (int i = 0; i < (level + 1 < levels ? 2 : 1); ++i) {
        const double* row = &inverse_[std::size_t(first + level + i) * rays];
        f.slope[i] = row[ray] * by_alpha + row[next] * by_beta;
        f.radius[i] = 1 / f.slope[i].dot(m);
    }
    f.times = (1 - f.part) * f.radius[0] + f.part * f.radius[1];
    return f;
}

}  // namespace hinge::beam

// Camera of a picture: selects the points of a scene to show, and fits the camera to them.
#include "output/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/errors.h"

namespace hinge::output {
namespace {

constexpr double typical_share = 0.98;
constexpr double stray_factor = 1.5;  // a corner of an intact building stays well below this
constexpr double view_angle = 20;     // degrees: depth can be felt, verticals stay nearly parallel
constexpr double used_share = 0.95;   // of the picture's width and height; the rest is margin

double middle(std::span<const Vec> points, int axis) {
    std::vector<double> values;
    values.reserve(points.size());
    for (const Vec& p : points) values.push_back(p[axis]);
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), half, values.end());
    return *half;
}

/// Any direction not along `back` will do when the wanted one is.
Vec usable_up(Vec up, Vec back) {
    for (const Vec& candidate : {up, Vec{0, 0, 1}, Vec{0, 1, 0}})
        if (finite(candidate) && length(candidate) > 0 && length(cross(unit(candidate), back)) > 1e-3) return candidate;
    return {1, 0, 0};
}

}  // namespace

double length(Vec a) { return std::sqrt(dot(a, a)); }

Vec across(Vec along) {
    return unit(cross(along, std::abs(along[2]) < 0.9 * length(along) ? Vec{0, 0, 1} : Vec{1, 0, 0}));
}

bool finite(Vec a) { return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]); }

double size_of(std::span<const Vec> points) {
    double size = 0;
    for (std::size_t c = 0; c < 3 && !points.empty(); ++c) {
        const auto [low, high] =
            std::minmax_element(points.begin(), points.end(), [&](const Vec& a, const Vec& b) { return a[c] < b[c]; });
        size = std::hypot(size, (*high)[c] - (*low)[c]);
    }
    return size;
}

std::vector<Vec> without_strays(std::span<const Vec> points) {
    if (points.empty()) return {};
    const Vec centre = {middle(points, 0), middle(points, 1), middle(points, 2)};
    std::vector<double> distances;
    distances.reserve(points.size());
    for (const Vec& p : points) distances.push_back(length(p - centre));
    const double rank = typical_share * static_cast<double>(points.size() - 1);
    const auto typical = distances.begin() + std::lround(rank);
    std::nth_element(distances.begin(), typical, distances.end());
    const double limit = *typical > 0 ? stray_factor * *typical : std::numeric_limits<double>::infinity();
    std::vector<Vec> kept;
    for (const Vec& p : points)
        if (length(p - centre) <= limit) kept.push_back(p);
    return kept;
}

// For an eye at depth d in front of the target, a point (x, y, z) seen from the target is inside the side planes when
//   |x - cx| <= (d - z) tx   and   |y - cy| <= (d - z) ty.
// Both planes of a side bind where  d tx = (R + L) / 2  and  cx = (R - L) / 2,
// with R = max(x + z tx) and L = max(-x + z tx): the tightest fit in closed form.
Camera fit_camera(std::span<const Vec> points, double reach, Vec from, Vec up, bool parallel, int width, int height) {
    if (!finite(from) || length(from) == 0) throw InputError("view.from must be a direction: three numbers, not all 0");
    Camera camera;
    camera.parallel = parallel;
    camera.view_angle = view_angle;
    camera.width = width, camera.height = height;
    camera.back = unit(from);
    camera.right = unit(cross(usable_up(up, camera.back), camera.back));
    camera.up = cross(camera.back, camera.right);

    // Without perspective the sides of what is seen are parallel: as if it were seen from far away.
    const double slope = std::tan(view_angle / 2 * std::numbers::pi / 180), lean = parallel ? 0 : 1;
    const double tx = used_share * slope * width / height, ty = used_share * slope;
    constexpr double none = -std::numeric_limits<double>::infinity();
    double right = none, left = none, top = none, bottom = none, front = none, rear = none;
    const Vec origin = points.empty() ? Vec{} : points.front();
    for (const Vec& p : points) {
        const double x = dot(p - origin, camera.right), y = dot(p - origin, camera.up),
                     z = dot(p - origin, camera.back);
        right = std::max(right, reach + x + lean * z * tx);
        left = std::max(left, reach - x + lean * z * tx);
        top = std::max(top, reach + y + lean * z * ty);
        bottom = std::max(bottom, reach - y + lean * z * ty);
        front = std::max(front, z);
        rear = std::max(rear, -z);
    }
    if (points.empty()) right = left = top = bottom = front = rear = 1;
    const double depth = front + rear;
    // A single point, or bars exactly along the line of sight, still need a picture of some size.
    const double wanted = std::max({(right + left) / (2 * tx), (top + bottom) / (2 * ty), 1e-3});
    const double eye = parallel ? front + depth + wanted : std::max(wanted, front + 0.05 * depth + 1e-3);
    const double centre = (front - rear) / 2;
    camera.target = origin + (right - left) / 2 * camera.right + (top - bottom) / 2 * camera.up + centre * camera.back;
    camera.eye = camera.target + (eye - centre) * camera.back;
    // Strays between the eye and the scene would hide it.
    const double beside = 0.25 * depth + 4 * reach + 0.05 * wanted;  // signs and sections stand out
    camera.nearest = std::max(eye - front - beside, 0.02 * (eye - centre));
    camera.farthest = eye + rear + 10 * std::max(depth, eye);
    camera.metres_per_pixel = 2 * slope * (parallel ? wanted : eye - centre) / height;
    return camera;
}

Vec Camera::project(Vec p) const {
    const Vec q = p - eye;
    const double depth = -dot(q, back), metres = pixel_at(p);
    return {width / 2 + dot(q, right) / metres, height / 2 + dot(q, up) / metres, depth};
}

double Camera::pixel_at(Vec p) const {
    if (parallel) return metres_per_pixel;
    return metres_per_pixel * dot(eye - p, back) / dot(eye - target, back);
}

Vec Camera::nearer(Vec p, double by) const { return p + by * (parallel ? back : unit(eye - p)); }

}  // namespace hinge::output

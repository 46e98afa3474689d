#include "section/plastic_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "section/section_outline.h"
#include "section/section.h"

namespace hinge {
namespace {

constexpr double mirrored = 1e-6;  ///< of the largest coordinate: corners at one place
constexpr double same = 1e-6;      ///< of area and moduli: a shape is known where the section has those of the shape

bool agree(double a, double b) { return std::abs(a - b) <= same * std::abs(b); }

/// Area of a circle's strip within `e` of a diameter, and the first moment of the circle beyond it, on both sides.
double strip_of_circle(double radius, double e) {
    e = std::min(e, radius);
    return radius > 0 ? 2 * (e * std::sqrt(radius * radius - e * e) + radius * radius * std::asin(e / radius)) : 0;
}
double moment_beyond(double radius, double e) {
    const double rest = radius * radius - e * e;
    return rest > 0 ? 4.0 / 3 * rest * std::sqrt(rest) : 0;
}

/// The part of a section beyond a distance from an axis through its centroid, m^2 and m^3, and its breadth there, m.
struct Beyond {
    double area = 0, moment = 0, breadth = 0;
};

/// What lies beyond `e` along x (k = 0) or y (k = 1), by Green's theorem along the edges beyond it.
Beyond beyond(const beam::Outline::Polygon& part, int k, double e) {
    Beyond sum;
    double whole = 0;
    const std::size_t count = part.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Vector2d &p = part.corners[i], &q = part.corners[(i + 1) % count];
        whole += p.x() * q.y() - q.x() * p.y();
        double a = p[k] - e, b = q[k] - e, from = p[1 - k], to = q[1 - k];
        if (!(a > 0 || b > 0)) continue;
        const double crossing = from + (to - from) * a / (a - b);
        if (!(a > 0)) a = 0, from = crossing, sum.breadth -= crossing;
        else if (!(b > 0)) b = 0, to = crossing, sum.breadth += crossing;
        sum.area += (to - from) * (a + b) / 2;
        sum.moment += (to - from) * (a * a + a * b + b * b) / 6;
    }
    sum.moment += e * sum.area;
    const double sign = ((whole > 0) == (k == 0) ? 1 : -1) * (part.hole ? -1 : 1);
    return {sign * sum.area, sign * sum.moment, sign * sum.breadth};
}

Beyond beyond(const beam::Outline& outline, int k, double e) {
    Beyond sum;
    for (const beam::Outline::Polygon& p : outline.polygons) {
        const Beyond of = beyond(p, k, e);
        sum.area += of.area, sum.moment += of.moment, sum.breadth += of.breadth;
    }
    for (const beam::Outline::Circle& c : outline.circles) {
        const double sign = c.hole ? -1 : 1, half = std::numbers::pi * c.radius * c.radius / 2;
        sum.area += sign * (half - strip_of_circle(c.radius, e) / 2);
        sum.moment += sign * moment_beyond(c.radius, e) / 2;
        if (e < c.radius) sum.breadth += sign * 2 * std::sqrt((c.radius - e) * (c.radius + e));
    }
    return sum;
}

double reach(const beam::Outline& outline) {
    double most = 0;
    for (const beam::Outline::Polygon& p : outline.polygons)
        for (const Eigen::Vector2d& c : p.corners) most = std::max(most, c.cwiseAbs().maxCoeff());
    for (const beam::Outline::Circle& c : outline.circles) most = std::max(most, c.radius);
    return most;
}

/// Each corner has its mirror images about x and about y among the corners of its polygon.
bool doubly_symmetric(const beam::Outline& outline) {
    const double near = mirrored * reach(outline);
    for (const beam::Outline::Circle& c : outline.circles)
        if (!(c.centre.norm() <= near)) return false;
    for (const beam::Outline::Polygon& p : outline.polygons)
        for (const Eigen::Vector2d& c : p.corners)
            for (const Eigen::Vector2d& image : {Eigen::Vector2d(-c.x(), c.y()), Eigen::Vector2d(c.x(), -c.y())})
                if (std::none_of(p.corners.begin(), p.corners.end(),
                                 [&](const Eigen::Vector2d& q) { return (q - image).norm() <= near; }))
                    return false;
    return true;
}

}  // namespace

/// The strip has the area n A. Beyond the distance e of its edge the section's first moment is left.
double PlasticShape::Bands::moment(double n) const {
    const double strip = n * area(), within = 2 * inner * step;
    if (strip <= within) {
        const double e = strip / (2 * inner);
        return (modulus() - inner * e * e) / modulus();
    }
    const double e = step + (strip - within) / (2 * outer);
    return outer * (height - e) * (height + e) / modulus();
}

/// The strip's edge is found by halving: its area rises with the distance.
double PlasticShape::moment_of_ring(double outer, double inner, double n) {
    const double area = std::numbers::pi * (outer * outer - inner * inner);
    double low = 0, high = outer;
    for (int i = 0; i < 60; ++i) {
        const double e = 0.5 * (low + high);
        (strip_of_circle(outer, e) - strip_of_circle(inner, e) < n * area ? low : high) = e;
    }
    const double e = 0.5 * (low + high);
    return (moment_beyond(outer, e) - moment_beyond(inner, e)) / (moment_beyond(outer, 0) - moment_beyond(inner, 0));
}

/// The strip's edge: Newton's method within what is known to hold it, for the area falls by the breadth.
double PlasticShape::moment_of_outline(int axis, double n) const {
    const beam::Outline& of = outline_->outline();
    const int k = 1 - axis;
    const double area = of.area(), rest = (1 - n) * area / 2;
    double low = 0, high = reach(of), e = n * high;
    Beyond there;
    for (int i = 0; i < 60; ++i) {
        there = beyond(of, k, e);
        if (std::abs(there.area - rest) <= 1e-14 * area) break;
        (there.area > rest ? low : high) = e;
        const double next = e + (there.area - rest) / there.breadth;
        e = next > low && next < high ? next : 0.5 * (low + high);
    }
    return there.moment / beyond(of, k, 0).moment;
}

double PlasticShape::moment(int axis, double n) const {
    n = std::abs(n);
    if (n >= 1) return 0;
    if (outline_) return n > 0 ? moment_of_outline(axis, n) : 1;
    return radius_ > 0 ? moment_of_ring(radius_, bore_, n) : bands_[axis].moment(n);
}

std::optional<PlasticShape> PlasticShape::of(const Section& s) {
    if (s.outline && s.outline->concrete()) return {};
    if (auto shape = by_sizes(s)) return shape;
    if (!s.outline || !(s.plastic_area > 0 && s.Zx > 0 && s.Zy > 0) || !doubly_symmetric(s.outline->outline()))
        return {};
    PlasticShape shape;
    shape.outline_ = s.outline;
    return shape;
}

std::optional<PlasticShape> PlasticShape::by_sizes(const Section& s) {
    PlasticShape shape;
    const double b = s.width, d = s.depth, A = s.plastic_area;
    if (!(b > 0 && d > 0 && A > 0 && s.Zx > 0 && s.Zy > 0)) return {};
    if (s.shape == "pipe" || s.shape == "round") {
        shape.radius_ = b / 2;
        shape.bore_ = std::sqrt(std::max(0.0, b * b / 4 - A / std::numbers::pi));
        if (s.shape == "round") shape.bore_ = 0;
        const double Z = (std::pow(shape.radius_, 3) - std::pow(shape.bore_, 3)) * 4 / 3;
        const bool known = agree(std::numbers::pi * (std::pow(shape.radius_, 2) - std::pow(shape.bore_, 2)), A);
        return known && agree(Z, s.Zx) && agree(Z, s.Zy) ? std::optional(shape) : std::nullopt;
    }
    if (s.shape == "solid") {
        shape.bands_[0] = {d / 2, d / 2, b, b};
        shape.bands_[1] = {b / 2, b / 2, d, d};
    } else if (s.shape == "h") {
        shape.bands_[0] = {d / 2 - s.flange, d / 2, s.web, b};
        shape.bands_[1] = {s.web / 2, b / 2, d, 2 * s.flange};
    } else if (s.shape == "box") {  // its hollow has the area b d - A and the modulus b d^2 / 4 - Zx
        const double hollow_depth = (b * d * d - 4 * s.Zx) / (b * d - A), hollow_width = (b * d - A) / hollow_depth;
        shape.bands_[0] = {hollow_depth / 2, d / 2, b - hollow_width, b};
        shape.bands_[1] = {hollow_width / 2, b / 2, d - hollow_depth, d};
    } else {
        return {};
    }
    const double Z[2] = {s.Zx, s.Zy};
    for (int axis : {0, 1}) {
        const Bands& of = shape.bands_[axis];
        const bool sound = of.step > 0 && of.step <= of.height && of.inner > 0 && of.outer > 0;
        if (!sound || !agree(of.area(), A) || !agree(of.modulus(), Z[axis])) return {};
    }
    return shape;
}

}  // namespace hinge

#include "beam/plastic_domain.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace hinge::beam {
namespace {

constexpr int levels = 24, rays = 64;  ///< of the polyhedron: axial forces from 0 to 1, directions of the moment
constexpr double coarse = 0.04;        ///< largest side of a contour from which a level is made
constexpr double pressed_axis = 0.6;   ///< half axis N of the ellipsoid; its other axes follow
constexpr double full_turn = 2 * std::numbers::pi;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double signed_area(const std::vector<Eigen::Vector2d>& corners) {
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) twice += cross(corners[i], corners[(i + 1) % corners.size()]);
    return twice / 2;
}

/// First moments of area, with the sign of the direction of rotation.
Eigen::Vector2d signed_moments(const std::vector<Eigen::Vector2d>& corners) {
    Eigen::Vector2d six = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d &p = corners[i], &q = corners[(i + 1) % corners.size()];
        six += cross(p, q) * (p + q);
    }
    return six / 6;
}

}  // namespace

double Outline::area() const {
    double sum = 0;
    for (const Polygon& p : polygons) sum += (p.hole ? -1 : 1) * std::abs(signed_area(p.corners));
    for (const Circle& c : circles) sum += (c.hole ? -1 : 1) * std::numbers::pi * c.radius * c.radius;
    return sum;
}

Eigen::Vector2d Outline::centroid() const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Polygon& p : polygons)
        sum += (p.hole == (signed_area(p.corners) > 0) ? -1 : 1) * signed_moments(p.corners);
    for (const Circle& c : circles) sum += (c.hole ? -1 : 1) * std::numbers::pi * c.radius * c.radius * c.centre;
    return sum / area();
}

void Outline::move(const Eigen::Vector2d& by) {
    for (Polygon& p : polygons)
        for (Eigen::Vector2d& corner : p.corners) corner += by;
    for (Circle& c : circles) c.centre += by;
}

/// Sums over the area: of z = (y, -x, 1) on the positive side of the neutral axis, and of z z^T along the axis.
struct PlasticDomain::Sums {
    explicit Sums(const Vec3& v) : strain(v), gradient(-v[1], v[0]), slope(gradient.norm()) {
        if (slope == 0) return;
        origin = -v[2] / (slope * slope) * gradient;
        axis = Eigen::Vector2d(gradient.y(), -gradient.x()) / slope;
    }
    double at(const Eigen::Vector2d& p) const { return strain[2] + gradient.dot(p); }
    void add_positive(double area, const Eigen::Vector2d& moment) { positive += Vec3(moment.y(), -moment.x(), area); }
    void add_crossing(double sign, double t) {
        line[0] += sign * t, line[1] += sign * t * t / 2, line[2] += sign * t * t * t / 3;
    }
    Mat3 of_axis() const {
        const Vec3 z0(origin.y(), -origin.x(), 1), z1(axis.y(), -axis.x(), 0);
        const Mat3 mixed = z0 * z1.transpose();
        return 2 / slope *
               (line[0] * z0 * z0.transpose() + line[1] * (mixed + mixed.transpose()) + line[2] * z1 * z1.transpose());
    }

    Vec3 strain;
    Eigen::Vector2d gradient;
    double slope;
    Eigen::Vector2d origin = Eigen::Vector2d::Zero(),
                    axis = Eigen::Vector2d::Zero();  ///< a point of the axis, and along
    Vec3 positive = Vec3::Zero();
    double line[3] = {0, 0, 0};  ///< integrals of 1, t and t^2 along the axis, within the area
};

double Reinforcement::Bar::radius() const { return std::sqrt(area / std::numbers::pi); }

PlasticDomain::PlasticDomain(const Outline& outline, const Reinforcement* concrete) {
    for (const Outline::Polygon& p : outline.polygons) {
        Polygon part{p.corners, 0, Eigen::Vector2d::Zero()};
        if ((signed_area(part.corners) > 0) == p.hole) std::reverse(part.corners.begin(), part.corners.end());
        part.area = signed_area(part.corners), part.moment = signed_moments(part.corners);
        polygons_.push_back(part);
    }
    for (const Outline::Circle& c : outline.circles) circles_.push_back({c.centre, c.radius, c.hole ? -1.0 : 1.0});
    area_ = outline.area();
    total_ = weighted_ = Vec3(0, 0, area_);
    if (concrete) {
        const double fc = concrete->concrete;
        stress_ = fc / 2, total_ *= 2;
        for (const Reinforcement::Bar& bar : concrete->bars) {
            const double weight = (bar.tension + bar.compression - fc) / fc;
            circles_.push_back({bar.centre, bar.radius(), weight});
            area_ += weight * bar.area;
            const Vec3 z = bar.area * Vec3(bar.centre.y(), -bar.centre.x(), 1);
            weighted_ += weight * z, total_ += 2 * (bar.compression - fc) / fc * z;
        }
    }
    bool halved[2];  // by the axis through the centroid
    for (int axis : {0, 1}) {
        Sums sums(axis == 0 ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
        add_parts(sums);
        modulus_[axis] = 2 * sums.positive[axis] - weighted_[axis];
        halved[axis] = std::abs(2 * sums.positive[2] - area_) <= 1e-9 * area_;
    }
    set_scale();
    const Eigen::Vector2d share(halved[0] ? 1 : slice(0, 0)[0], halved[1] ? 1 : slice(0, full_turn / 4)[1]);
    modulus_ = modulus_.cwiseProduct(share);
    set_scale();
    make_polyhedron();
    if (concrete) make_ellipsoid_of_concrete();
    else make_ellipsoid();
}

void PlasticDomain::set_scale() {
    scale_ = Vec3(area_ / modulus_[0], area_ / modulus_[1], 1);
    if (!concrete()) return;
    centre_ = (weighted_ - total_).cwiseProduct(scale_) / area_;
    end_ = weighted_.cwiseProduct(scale_).head<2>() / area_;
}

void PlasticDomain::add_parts(Sums& sums) const {
    for (const Polygon& p : polygons_) add(p, sums);
    for (const Circle& c : circles_) add(c, sums);
}

/// The triangles between a point of the neutral axis and the outline's edges on the positive side: those of the axis
/// itself have no area, so that it need not be known in which order it crosses the outline.
void PlasticDomain::add(const Polygon& part, Sums& sums) {
    const std::size_t n = part.corners.size();
    double last = sums.at(part.corners[n - 1]);
    bool any = false, all = true;
    for (const Eigen::Vector2d& c : part.corners) {
        const bool beyond = sums.at(c) > 0;
        any |= beyond, all &= beyond;
    }
    if (!any) return;
    if (all) return sums.add_positive(part.area, part.moment);
    double area = 0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < n; ++i) {
        Eigen::Vector2d p = part.corners[i == 0 ? n - 1 : i - 1], q = part.corners[i];
        const double now = sums.at(q);
        if (last > 0 || now > 0) {
            if (!(last > 0 && now > 0)) {
                const Eigen::Vector2d c = p + last / (last - now) * (q - p);
                sums.add_crossing(now > 0 ? 1 : -1, (c - sums.origin).dot(sums.axis));
                (now > 0 ? p : q) = c;
            }
            const double twice = cross(p - sums.origin, q - sums.origin);
            area += twice / 2;
            moment += twice / 6 * (p + q + sums.origin);
        }
        last = now;
    }
    sums.add_positive(area, moment);
}

void PlasticDomain::add(const Circle& part, Sums& sums) {
    const double R = part.radius, centre = sums.at(part.centre), whole = part.weight * std::numbers::pi * R * R;
    if (std::abs(centre) >= R * sums.slope) {
        if (centre > 0) sums.add_positive(whole, whole * part.centre);
        return;
    }
    const double d = centre / sums.slope, half = std::sqrt(R * R - d * d);
    const double area = whole / 2 + part.weight * (R * R * std::asin(d / R) + d * half);
    sums.add_positive(area,
                      area * part.centre + part.weight * 2.0 / 3 * half * half * half / sums.slope * sums.gradient);
    const double t = (part.centre - sums.origin).dot(sums.axis);
    sums.add_crossing(part.weight, t + half);
    sums.add_crossing(-part.weight, t - half);
}

double PlasticDomain::support(const Vec3& v, Vec3& point, Mat3* curvature) const {
    Sums sums(v.cwiseProduct(scale_));
    add_parts(sums);
    const Vec3 z = (2 * sums.positive - total_) / area_;
    point = z.cwiseProduct(scale_);
    if (curvature) {
        if (sums.slope > 0) *curvature = scale_.asDiagonal() * (sums.of_axis() / area_) * scale_.asDiagonal();
        else curvature->setZero();
    }
    return point.dot(v);
}

double PlasticDomain::gauge(const Vec3& q, Vec3* normal, double* error) const {
    const double size = q.norm();
    if (error) *error = 0;
    if (!(size > 0)) {
        if (normal) normal->setZero();
        return size;
    }
    Vec3 v;
    surely_inside(q, &v);
    double missed = 0;
    double h = find_gauge(q / size, v, missed);
    if (missed > 1e-9) h = find_gauge(q / size, v = q / size, missed);
    if (error) *error = size * missed;
    if (normal) *normal = v / h;
    return size * h;
}

/// The gauge of the unit vector `to` is h(v) where h^2 / 2 - to . v is least; `v`: where the search starts, and ends.
/// `missed`: the gauge of what is left of `to`, 0 where nearly nothing is.
double PlasticDomain::find_gauge(const Vec3& to, Vec3& v, double& missed) const {
    Vec3 point;
    v.normalize();
    if (!(v.dot(to) > 0.01)) v = to;
    Mat3 curvature;
    double h = support(v, point, &curvature);
    v *= to.dot(v) / (h * h), h = point.dot(v), curvature /= v.norm();
    double F = h * h / 2 - to.dot(v), damping = 0;
    missed = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 off = to - h * point;
        if (off.norm() <= 1e-12 * h) return h;
        const Mat3 H = point * point.transpose() + h * curvature;
        bool fell = false;
        for (int tries = 0; tries < 60 && !fell; ++tries) {
            Mat3 damped = H;
            damped.diagonal().array() += std::max(damping, 1e-13) * H.trace();
            Vec3 next = v + damped.ldlt().solve(off), there;
            Mat3 bent;
            double h_next = support(next, there, &bent);
            if (h_next > 0) {  // along a ray the least is known
                const double times = to.dot(next) / (h_next * h_next);
                if (times > 0) next *= times, h_next *= times, bent /= times;
            }
            const double F_next = h_next * h_next / 2 - to.dot(next);
            // near the least value F no longer tells
            if (F_next < F || (off.norm() < 1e-4 && (to - h_next * there).norm() < 0.5 * off.norm())) {
                fell = true, v = next, h = h_next, point = there, curvature = bent, F = F_next;
                damping *= 0.1;
                if (damping < 1e-12) damping = 0;
            } else {
                damping = damping == 0 ? 1e-6 : 8 * damping;
            }
        }
        if (!fell) break;
    }
    missed = (to - h * point).cwiseQuotient(ellipsoid_).norm();
    return h;
}

double PlasticDomain::farthest() const {
    double most = 0;
    for (const Polygon& p : polygons_)
        for (const Eigen::Vector2d& c : p.corners) most = std::max(most, c.norm());
    for (const Circle& c : circles_) most = std::max(most, c.centre.norm() + c.radius);
    return most;
}

/// N rises with e: Newton's method within what is known to hold the answer.
Eigen::Vector2d PlasticDomain::contour(double n, double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    double low = -1.001 * farthest() * std::hypot(c * scale_[0], s * scale_[1]), high = -low, e = 0;
    Vec3 point;
    Mat3 curvature;
    for (int i = 0; i < 100; ++i) {
        support({c, s, e}, point, &curvature);
        const double off = point[2] - n;
        if (std::abs(off) < 1e-13) break;
        (off < 0 ? low : high) = e;
        double next = e - off / curvature(2, 2);
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (next == e) break;
        e = next;
    }
    return point.head<2>();
}

/// The contour about the centre: n of it is 0, and the line between the ends of N is the axis of all contours.
Eigen::Vector2d PlasticDomain::slice(double n, double angle) const {
    if (!concrete()) return contour(n, angle);
    return contour(n + centre_[2], angle) - centre_.head<2>() - n * end_;
}

namespace {

/// The contour of one axial force as a convex polygon of its points; sides longer than `coarse` are halved.
template <class Slice>
void add_points(const Slice& slice, double n, double from, double to, const Eigen::Vector2d& a,
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

double angle_of(const Eigen::Vector2d& m) {
    const double angle = std::atan2(m.y(), m.x());
    return angle < 0 ? angle + full_turn : angle;
}

}  // namespace

/// The radius of each level in the direction of each ray, of polygons whose corners are on the surface.
void PlasticDomain::make_polyhedron() {
    constexpr int first = 16;
    inverse_.assign(std::size_t(levels) * rays, 0.0);
    for (int level = 0; level < levels; ++level) {
        const double n = double(level) / levels;
        std::vector<Eigen::Vector2d> points;
        Eigen::Vector2d start[first + 1];
        for (int k = 0; k < first; ++k) start[k] = slice(n, full_turn * k / first);
        start[first] = start[0];
        for (int k = 0; k < first; ++k)
            add_points([this](double at, double angle) { return slice(at, angle); }, n, full_turn * k / first,
                       full_turn * (k + 1) / first, start[k], start[k + 1], 12, points);
        for (int ray = 0; ray < rays; ++ray) {
            const Eigen::Vector2d to(std::cos(full_turn * ray / rays), std::sin(full_turn * ray / rays));
            double radius = 0;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Eigen::Vector2d &p = points[i], side = points[(i + 1) % points.size()] - p;
                const double across = cross(to, side);
                if (!(std::abs(across) > 0)) continue;
                const double along = cross(to, p) / -across;
                if (along >= -1e-9 && along <= 1 + 1e-9) radius = std::max(radius, to.dot(p + along * side));
            }
            inverse_[std::size_t(level) * rays + ray] =
                radius > 0 ? 1 / ((1 - 1e-6) * radius) : std::numeric_limits<double>::infinity();
        }
    }
}

/// At axial force n and in the direction of m the radius is a mean of those of two levels, each on the side between two
/// rays.
bool PlasticDomain::surely_inside(const Vec3& forces, Vec3* normal) const {
    Vec3 q = forces;
    if (concrete()) q -= centre_, q.head<2>() -= q[2] * end_;
    const double side = q[2] < 0 ? -1 : 1, n = levels * std::abs(q[2]);
    const Eigen::Vector2d m = side * q.head<2>();
    if (normal) *normal = q;
    if (!(n < levels && m.allFinite())) return false;
    if (m.isZero(0)) return true;
    constexpr double step = full_turn / rays;
    static const auto directions = [] {
        std::array<Eigen::Vector2d, rays + 1> all;
        for (int i = 0; i <= rays; ++i) all[i] = {std::cos(step * i), std::sin(step * i)};
        return all;
    }();
    const int level = int(n), ray = std::min(rays - 1, int(angle_of(m) / step)), next = (ray + 1) % rays;
    const double part = n - level, across = std::sin(step);
    // m = alpha (one ray) + beta (the next)
    const Eigen::Vector2d &a = directions[ray], &b = directions[ray + 1];
    const Eigen::Vector2d by_alpha = Eigen::Vector2d(b.y(), -b.x()) / across,
                          by_beta = Eigen::Vector2d(-a.y(), a.x()) / across;
    double inverse[2] = {1, std::numeric_limits<double>::infinity()};  // |m| over the radius of the level
    Eigen::Vector2d slope[2];
    for (int i = 0; i < (level + 1 < levels ? 2 : 1); ++i) {
        const double* row = &inverse_[std::size_t(level + i) * rays];
        slope[i] = row[ray] * by_alpha + row[next] * by_beta;
        inverse[i] = slope[i].dot(m);
    }
    const double radius[2] = {1 / inverse[0], 1 / inverse[1]};
    if (normal) {
        Eigen::Vector2d of_m = (1 - part) * radius[0] * radius[0] * slope[0];
        if (radius[1] > 0) of_m += part * radius[1] * radius[1] * slope[1];
        *normal << side * of_m, side * levels * (radius[0] - radius[1]);
        if (concrete()) (*normal)[2] -= end_.dot(normal->head<2>());
    }
    return (1 - part) * radius[0] + part * radius[1] >= 1;
}

/// The largest within the surface, of equal half axes of both moments: sqrt(a^2 k^2 + b^2 e^2) <= h for all strains.
void PlasticDomain::make_ellipsoid() {
    constexpr int turns = 96, steps = 40;
    double least = 1;
    for (int i = 0; i < turns; ++i) {
        const double c = std::cos(full_turn * i / turns), s = std::sin(full_turn * i / turns);
        const double most = farthest() * std::hypot(c * scale_[0], s * scale_[1]);
        for (int k = 0; k <= steps; ++k) {
            const double e = most * k / steps;
            Vec3 point;
            const double h = support({c, s, e}, point);
            least = std::min(least, h * h - pressed_axis * pressed_axis * e * e);
        }
    }
    const double axis = 0.98 * std::sqrt(std::max(0.0, least));
    ellipsoid_ = {axis, axis, pressed_axis};
}

/// The same about a point that is not the centre, so that both signs of e count. The half axis N is shortened until
/// enough is left for moments: where bars lie on one side, N at one end of its range has a moment beside it.
void PlasticDomain::make_ellipsoid_of_concrete() {
    constexpr int turns = 120, steps = 80, beyond = 30;
    std::vector<Eigen::Vector2d> supports;  // e and h, at |k| = 1
    for (int i = 0; i < turns; ++i) {
        const double c = std::cos(full_turn * i / turns), s = std::sin(full_turn * i / turns);
        const double most = farthest() * std::hypot(c * scale_[0], s * scale_[1]);
        for (int k = -steps - beyond; k <= steps + beyond; ++k) {
            const int past = std::max(0, std::abs(k) - steps);
            const double e = most * k / std::max(steps, std::abs(k)) * std::pow(1.25, past);
            Vec3 point;
            supports.emplace_back(e, support({c, s, e}, point));
        }
    }
    double axis = pressed_axis * (1 - std::abs(centre_[2])), least = 0;
    for (int tries = 0; tries < 30; ++tries, axis *= 0.7) {
        least = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector2d& of : supports)
            least = std::min(least, of[1] > 0 ? of[1] * of[1] - axis * axis * of[0] * of[0] : -1.0);
        if (least > 0.25 * axis * axis) break;
    }
    const double moment = 0.9 * std::sqrt(std::max(0.0, least));
    ellipsoid_ = {moment, moment, 0.9 * axis};
}

}  // namespace hinge::beam

#include "section/plastic_domain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/lanes.h"

namespace hinge::beam {
namespace {

constexpr double pressed_axis = 0.6;  ///< half axis N of the ellipsoid; its other axes follow
constexpr double full_turn = 2 * std::numbers::pi;
constexpr double all_round = 200;  ///< e over |k|: near the end of N of a smooth domain

}  // namespace

/// Sums over the area: of z = (y, -x, 1) on the positive side of the neutral axis, and of z z^T along the axis.
struct PlasticDomain::Sums {
    [[gnu::always_inline]] explicit Sums(const Vec3& v)
        : strain(v), gradient(-v[1], v[0]), slope(std::sqrt(v[0] * v[0] + v[1] * v[1])) {
        if (slope == 0) return;
        const double inverse = 1 / slope;
        axis = {v[0] * inverse, v[1] * inverse};
        const double away = -v[2] * inverse;
        origin = {-away * axis.y(), away * axis.x()};
    }
    double at(const Eigen::Vector2d& p) const { return strain[2] + gradient.dot(p); }
    void add_positive(double area, const Eigen::Vector2d& moment) {
        positive[0] += moment.y(), positive[1] -= moment.x(), positive[2] += area;
    }
    void add_crossing(double sign, double t) {
        line[0] += sign * t, line[1] += sign * t * t / 2, line[2] += sign * t * t * t / 3;
    }
    /// 2 / slope times the integral of z z^T along the axis, with both z times `scale`.
    [[gnu::always_inline]] void of_axis(const Vec3& scale, double times, Mat3& out) const {
        const double z0[3] = {origin.y() * scale[0], -origin.x() * scale[1], scale[2]},
                     z1[3] = {axis.y() * scale[0], -axis.x() * scale[1], 0}, all = 2 * times / slope;
        for (int i = 0; i < 3; ++i) {
            const double by_0 = all * (line[0] * z0[i] + line[1] * z1[i]),
                         by_1 = all * (line[1] * z0[i] + line[2] * z1[i]);
            for (int j = 0; j < 3; ++j) out(j, i) = by_0 * z0[j] + by_1 * z1[j];
        }
    }

    Vec3 strain;
    Eigen::Vector2d gradient;
    double slope;
    Eigen::Vector2d origin = Eigen::Vector2d::Zero(),
                    axis = Eigen::Vector2d::Zero();  ///< a point of the axis, and along
    Vec3 positive = Vec3::Zero();
    double line[3] = {0, 0, 0};  ///< integrals of 1, t and t^2 along the axis, within the area
};
PlasticDomain::PlasticDomain(const Outline& outline, const Reinforcement* concrete) {
    if (concrete && concrete->strains) {
        set_states(outline, *concrete);
        make_polyhedron();
        make_ellipsoid_of_concrete();
        return;
    }
    for (const Outline::Polygon& p : outline.polygons) add_polygon(p.corners, p.hole, edges_);
    pad(edges_);
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

/// The scale of the states is that of their largest moments; that of the domain is the moments beyond the centre's.
void PlasticDomain::set_states(const Outline& outline, const Reinforcement& concrete) {
    states_ = std::make_shared<const UltimateStates>(outline, concrete, *concrete.strains);
    for (const Outline::Polygon& p : outline.polygons) add_polygon(p.corners, p.hole, edges_);
    for (const Outline::Circle& c : outline.circles) circles_.push_back({c.centre, c.radius, c.hole ? -1.0 : 1.0});
    stress_ = concrete.concrete / 2;
    Vec3 tension, compression;
    const auto find_ends = [&] {
        support({0, 0, 1}, tension), support({0, 0, -1}, compression);
        centre_ = 0.5 * (tension + compression), end_ = tension.head<2>() - centre_.head<2>();
    };
    find_ends();
    const Vec3 share(slice(0, 0)[0], slice(0, full_turn / 4)[1], tension[2] - centre_[2]),
        strength = states_->strength().cwiseProduct(share);
    of_states_ = share.cwiseInverse();
    find_ends();
    area_ = strength[2] / stress_, modulus_ = strength.head<2>() / stress_;
    scale_ = Vec3(area_ / modulus_[0], area_ / modulus_[1], 1);
}

void PlasticDomain::set_scale() {
    scale_ = Vec3(area_ / modulus_[0], area_ / modulus_[1], 1);
    if (!concrete()) return;
    centre_ = (weighted_ - total_).cwiseProduct(scale_) / area_;
    end_ = weighted_.cwiseProduct(scale_).head<2>() / area_;
}

void PlasticDomain::add_polygon(Polygon corners, bool hole, Edges& to) {
    if ((signed_area(corners) > 0) == hole) std::reverse(corners.begin(), corners.end());
    to.area += signed_area(corners), to.moment += signed_moments(corners);
    for (std::size_t i = 0; i <= corners.size(); ++i) {
        const Eigen::Vector2d& at = corners[i % corners.size()];
        to.x.push_back(at.x()), to.y.push_back(at.y()), to.weight.push_back(i < corners.size() ? 1 : 0);
        to.farthest = std::max(to.farthest, at.norm());
    }
}

/// To whole blocks of eight edges; those that are added have no length.
void PlasticDomain::pad(Edges& edges) {
    while (edges.x.size() % lane_count != 1)
        for (std::vector<double>* list : {&edges.x, &edges.y, &edges.weight}) list->push_back(0);
}

PlasticDomain::Walls::Walls(const Polygons& walls) {
    for (const int axis : {0, 1}) {
        for (const Outline::Polygon& p : walls[axis]) add_polygon(p.corners, p.hole, edges_[axis]);
        pad(edges_[axis]);
    }
}

void PlasticDomain::add_parts(Sums& sums) const {
    if (edges_.area > 0) add(edges_, sums);
    for (const Circle& c : circles_) add(c, sums);
}

/// The triangles between a point of the neutral axis and the outline's edges on the positive side: those of the axis
/// itself have no area, so that it need not be known in which order it crosses the outline. Eight edges at once.
void PlasticDomain::add(const Edges& edges, Sums& sums) {
    if (std::abs(sums.strain[2]) >= sums.slope * edges.farthest) {
        if (sums.strain[2] > 0) sums.add_positive(edges.area, edges.moment);
        return;
    }
    const auto c = [](double v) { return spread(v, Lanes{}); };
    const auto load = [](const double* from) -> Lanes { return *reinterpret_cast<const LanesAnywhere*>(from); };
    const Lanes none = c(0), one = c(1), ox = c(sums.origin.x()), oy = c(sums.origin.y()), ax = c(sums.axis.x()),
                ay = c(sums.axis.y()), gx = c(sums.gradient.x()), gy = c(sums.gradient.y());
    const auto strain = [&](const Lanes& x, const Lanes& y) { return gx * x + gy * y; };  // of places from the origin
    Lanes area = none, moment_x = none, moment_y = none, line[3] = {none, none, none};
    const int blocks = int(edges.x.size()) / lane_count;
    for (int i = 0; i < blocks * lane_count; i += lane_count) {
        const Lanes px = load(&edges.x[i]) - ox, py = load(&edges.y[i]) - oy, qx = load(&edges.x[i + 1]) - ox,
                    qy = load(&edges.y[i + 1]) - oy, weight = load(&edges.weight[i]);
        const Lanes from = strain(px, py), to = strain(qx, qy), part = from / (from - to);
        const Lanes cx = px + part * (qx - px), cy = py + part * (qy - py);
        const auto from_in = from > none, to_in = to > none;
        const Lanes x1 = from_in ? px : cx, y1 = from_in ? py : cy, x2 = to_in ? qx : cx, y2 = to_in ? qy : cy;
        const Lanes twice = (from_in | to_in) ? weight * (x1 * y2 - y1 * x2) : none;
        area += twice;
        moment_x += (from_in | to_in) ? twice * (x1 + x2) : none;
        moment_y += (from_in | to_in) ? twice * (y1 + y2) : none;
        const Lanes sign = from_in ? (to_in ? none : -one) : (to_in ? one : none);
        const Lanes t = sign != none ? cx * ax + cy * ay : none, signed_t = weight * sign * t;
        line[0] += signed_t, line[1] += signed_t * t, line[2] += signed_t * t * t;
    }
    const double whole = sum_of(area) / 2;
    sums.add_positive(whole, Eigen::Vector2d(sum_of(moment_x), sum_of(moment_y)) / 6 + whole * sums.origin);
    sums.line[0] += sum_of(line[0]), sums.line[1] += sum_of(line[1]) / 2, sums.line[2] += sum_of(line[2]) / 3;
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

double PlasticDomain::support(const Vec3& v, Vec3& point, Mat3* curvature, const Lost* lost) const {
    if (states_) {
        const double h = states_->support(v.cwiseProduct(of_states_), point, curvature);
        point = point.cwiseProduct(of_states_);
        if (curvature) *curvature = of_states_.asDiagonal() * *curvature * of_states_.asDiagonal();
        return h;
    }
    Sums sums(v.cwiseProduct(scale_));
    add_parts(sums);
    Vec3 total = total_;
    for (int axis = 0; lost && axis < 2; ++axis) {
        const double part = lost->part[axis];
        const Edges& walls = lost->walls->edges_[axis];
        if (!(part > 0 && walls.area > 0)) continue;
        Sums of_walls(sums.strain);
        add(walls, of_walls);
        sums.positive -= part * of_walls.positive;
        for (int i = 0; i < 3; ++i) sums.line[i] -= part * of_walls.line[i];
        total -= part * Vec3(walls.moment.y(), -walls.moment.x(), walls.area);
    }
    const Vec3 z = (2 * sums.positive - total) / area_;
    point = z.cwiseProduct(scale_);
    if (curvature) {
        if (sums.slope > 0) sums.of_axis(scale_, 1 / area_, *curvature);
        else curvature->setZero();
    }
    return point.dot(v);
}

double PlasticDomain::farthest() const {
    double most = edges_.farthest;
    for (const Circle& c : circles_) most = std::max(most, c.centre.norm() + c.radius);
    return most;
}

/// N rises with e: Newton's method within what is known to hold the answer, which is halved where a step does not bring
/// half of what is off. So it ends.
Eigen::Vector2d PlasticDomain::contour(double n, double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    double low = -1.001 * farthest() * std::hypot(c * scale_[0], s * scale_[1]), high = -low, e = 0;
    if (states_) low = -all_round, high = all_round;
    Vec3 point;
    Mat3 curvature;
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 200; ++i) {
        support({c, s, e}, point, &curvature);
        const double off = point[2] - n, middle = 0.5 * ((off < 0 ? e : low) + (off < 0 ? high : e));
        if (std::abs(off) < 1e-13 || middle == e) break;
        (off < 0 ? low : high) = e;
        const double next = e - off / curvature(2, 2);
        e = next > low && next < high && std::abs(off) < 0.5 * before ? next : middle;
        before = std::abs(off);
    }
    return point.head<2>();
}

/// The contour about the centre: n of it is 0, and the line between the ends of N is the axis of all contours.
Eigen::Vector2d PlasticDomain::slice(double n, double angle) const {
    if (!concrete()) return contour(n, angle);
    return contour(n + centre_[2], angle) - centre_.head<2>() - n * end_;
}
/// Each support is an integral over the whole outline: some that agree with those of both mirror images tell.
bool PlasticDomain::doubly_symmetric() const {
    constexpr int tries = 12;
    for (int i = 0; i < tries; ++i) {
        const double angle = (i + 0.37) * full_turn / 4 / tries, e = (i % 4 - 1.3) / 3;
        const Vec3 v(std::cos(angle), std::sin(angle), e);
        Vec3 point;
        const double h = support(v, point);
        for (const Vec3& mirrored : {Vec3(-v[0], v[1], e), Vec3(v[0], -v[1], e)})
            if (!(std::abs(support(mirrored, point) - h) <= 1e-12 * h)) return false;
    }
    return true;
}

/// Points at N below the centre's are taken to the other side, through the centre.
void PlasticDomain::make_polyhedron() {
    const bool quarter = doubly_symmetric();
    polyhedron_.add_side([&](double n, double angle) -> Eigen::Vector2d { return slice(n, angle); }, quarter);
    if (states_)
        polyhedron_.add_side([&](double n, double angle) -> Eigen::Vector2d { return -slice(-n, angle); }, quarter);
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

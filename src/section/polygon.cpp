#include "section/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hinge::beam {
namespace {

/// Where the two points between its ends are, for an arc of radius 1 from -beta to beta: radius and angles -a and a.
struct PointsOfArc {
    double radius, angle;
};
PointsOfArc points_of_arc(double beta) {
    const auto radius = [beta](double a) {  // the sector has the area beta
        const double s = std::sin(beta - a), m = std::sin(2 * a) / 2;
        return (std::sqrt(s * s + 4 * m * beta) - s) / (2 * m);
    };
    double low = 0.05 * beta, high = 0.95 * beta;
    for (int i = 0; i < 60; ++i) {
        const double a = (low + high) / 2, r = radius(a);
        const double end_part = r * std::sin(beta - a), middle = r * r * std::sin(2 * a) / 2;
        // three times the first moment of half of it
        const double moment = end_part * (std::cos(beta) + r * std::cos(a)) + 2 * middle * r * std::cos(a);
        (moment > 2 * std::sin(beta) ? low : high) = a;
    }
    return {radius((low + high) / 2), (low + high) / 2};
}

/// The arc of radius r that touches both sides of a corner.
void add_arc(Corners& to, const RoundedCorner& before, const RoundedCorner& corner, const RoundedCorner& after) {
    double ax = before.x - corner.x, ay = before.y - corner.y, bx = after.x - corner.x, by = after.y - corner.y;
    const double a = std::sqrt(ax * ax + ay * ay), b = std::sqrt(bx * bx + by * by), r = corner.r;
    ax /= a, ay /= a, bx /= b, by /= b;
    const double half = std::acos(ax * bx + ay * by) / 2;  // between a side and the line to the arc's centre
    const double beta = std::numbers::pi / 2 - half, tangent = r / std::tan(half), distance = r / std::sin(half);
    const double ox = (ax + bx) / (2 * std::cos(half)), oy = (ay + by) / (2 * std::cos(half));  // that line's direction
    const double side = ax * by - ay * bx < 0 ? 1 : -1;  // convex corners turn left
    const auto [radius, angle] = points_of_arc(beta);
    to.emplace_back(corner.x + tangent * ax, corner.y + tangent * ay);
    for (const double sign : {-1.0, 1.0}) {
        const double along = distance - radius * r * std::cos(angle),
                     across = sign * side * radius * r * std::sin(angle);
        to.emplace_back(corner.x + along * ox + across * oy, corner.y + along * oy - across * ox);
    }
    to.emplace_back(corner.x + tangent * bx, corner.y + tangent * by);
}

/// Area and first moment of what lies beyond e along the axis `k`.
struct PartBeyond {
    double area = 0, moment = 0;
};
PartBeyond part_beyond(const Corners& corners, int k, double e) {
    const int other = 1 - k;
    const double sign = k == 0 ? 1 : -1;
    PartBeyond out;
    const Eigen::Vector2d* p = &corners.back();
    for (const Eigen::Vector2d& q : corners) {
        const double a = (*p)[k] - e, b = q[k] - e;
        if (a > 0 || b > 0) {
            double pa = a, qa = b, from = (*p)[other], to = q[other];
            if (a <= 0) pa = 0, from = from + (to - from) * a / (a - b);
            else if (b <= 0) qa = 0, to = from + (to - from) * a / (a - b);
            out.area = out.area + sign * (to - from) * (pa + qa) / 2;
            out.moment = out.moment + sign * (to - from) * (pa * pa + pa * qa + qa * qa) / 6;
        }
        p = &q;
    }
    out.moment = out.moment + e * out.area;
    return out;
}

}  // namespace

Corners rounded(const std::vector<RoundedCorner>& corners) {
    Corners to;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (corners[i].r > 0) add_arc(to, corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]);
        else to.emplace_back(corners[i].x, corners[i].y);
    }
    return to;
}

Corners rectangle(double b, double d, double r) {
    return rounded({{-b / 2, -d / 2, r}, {b / 2, -d / 2, r}, {b / 2, d / 2, r}, {-b / 2, d / 2, r}});
}

AreaMoments moments_of(const Corners& corners) {
    AreaMoments m;
    const Eigen::Vector2d* p = &corners.back();
    for (const Eigen::Vector2d& q : corners) {
        const double px = p->x(), py = p->y(), qx = q.x(), qy = q.y(), c = px * qy - qx * py;
        m.A = m.A + c / 2, m.x = m.x + c * (px + qx) / 6, m.y = m.y + c * (py + qy) / 6;
        m.xx = m.xx + c * (px * px + px * qx + qx * qx) / 12;
        m.yy = m.yy + c * (py * py + py * qy + qy * qy) / 12;
        m.xy = m.xy + c * (px * (2 * py + qy) + qx * (2 * qy + py)) / 24;
        p = &q;
    }
    return m;
}

Corners moved(const Corners& corners, double x, double y, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    Corners to;
    for (const Eigen::Vector2d& p : corners) {
        const double u = p.x() - x, v = p.y() - y;
        to.emplace_back(c * u + s * v, c * v - s * u);
    }
    return to;
}

double plastic_modulus(const Corners& corners, int k) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Eigen::Vector2d& p : corners) low = std::min(low, p[k]), high = std::max(high, p[k]);
    const double whole = moments_of(corners).A, all = part_beyond(corners, k, low).moment;
    for (int i = 0; i < 100; ++i) {
        const double e = (low + high) / 2;
        (part_beyond(corners, k, e).area > whole / 2 ? low : high) = e;
    }
    return 2 * part_beyond(corners, k, (low + high) / 2).moment - all;
}

double shear_area(const Corners& path, const std::vector<double>& t, int k) {
    const auto length = [&](std::size_t i) {
        const double x = path[i + 1].x() - path[i].x(), y = path[i + 1].y() - path[i].y();
        return std::sqrt(x * x + y * y);
    };
    double I = 0, S = 0, flow = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const double a = path[i][k], b = path[i + 1][k];
        I = I + t[i] * length(i) * (a * a + a * b + b * b) / 3;
    }
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const double a = path[i][k], b = path[i + 1][k], l = length(i);
        for (int g :
             {-1, 0, 1}) {  // S is a parabola along the wall: three points of Gauss integrate its square exactly
            const double at = 0.5 + g * std::sqrt(0.15), S_at = S + t[i] * l * at * (a + 0.5 * at * (b - a));
            flow = flow + (g == 0 ? 8.0 : 5.0) / 18 * l * (S_at * S_at) / t[i];
        }
        S = S + t[i] * l * (a + b) / 2;
    }
    return I * I / flow;
}

}  // namespace hinge::beam

#include "contact/point_on_panel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hinge::contact {
namespace {

constexpr double xi[4] = {-1, 1, 1, -1}, eta[4] = {-1, -1, 1, 1};
constexpr double farthest = 4;  ///< of `at`: beyond it the foot of a panel is no matter

void set_shares(Foot& f, bool quad) {
    const double s = f.at[0], t = f.at[1];
    if (quad) {
        for (std::size_t i = 0; i < 4; ++i) {
            f.share[i] = 0.25 * (1 + xi[i] * s) * (1 + eta[i] * t);
            f.slope[0][i] = 0.25 * xi[i] * (1 + eta[i] * t), f.slope[1][i] = 0.25 * eta[i] * (1 + xi[i] * s);
        }
        f.beyond = std::max(std::abs(s), std::abs(t)) - 1;
    } else {
        f.share = {1 - s - t, s, t, 0};
        f.slope[0] = {-1, 1, 0, 0}, f.slope[1] = {-1, 0, 1, 0};
        f.beyond = -2 * std::min({f.share[0], s, t});
    }
}

Vec3 sum(std::span<const Vec3> corners, const std::array<double, 4>& parts) {
    Vec3 v = Vec3::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) v += parts[i] * corners[i];
    return v;
}

/// Axes that rotate with the surface: along the first side, across it, the normal.
Mat3 axes_of(const Foot& f) {
    Mat3 axes;
    axes.col(0) = f.along[0].normalized(), axes.col(2) = f.normal;
    axes.col(1) = f.normal.cross(axes.col(0));
    return axes;
}

}  // namespace

Foot surface_at(std::span<const Vec3> corners, const double at[2]) {
    Foot f;
    f.at[0] = at[0], f.at[1] = at[1];
    set_shares(f, corners.size() == 4);
    for (int c : {0, 1}) f.along[c] = sum(corners, f.slope[c]);
    f.normal = f.along[0].cross(f.along[1]).normalized();
    return f;
}

Foot foot_of(std::span<const Vec3> corners, const Vec3& point) {
    const bool quad = corners.size() == 4;
    // place = middle + s a + t b + s t twist
    Vec3 middle = corners[0], a = corners[1] - corners[0], b = corners[2] - corners[0], twist = Vec3::Zero();
    if (quad) {
        middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
        a = 0.25 * (corners[1] + corners[2] - corners[0] - corners[3]);
        b = 0.25 * (corners[2] + corners[3] - corners[0] - corners[1]);
        twist = 0.25 * (corners[0] - corners[1] + corners[2] - corners[3]);
    }
    double at[2] = {0, 0};
    for (int i = 0; i < 30; ++i) {  // Newton's method for the nearest place of the surface
        const Vec3 u = a + at[1] * twist, v = b + at[0] * twist;
        const Vec3 r = point - middle - at[0] * a - at[1] * v;
        const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), curved = uv - r.dot(twist);
        const double cross = i > 0 && std::abs(curved) < std::sqrt(uu * vv) ? curved : uv;
        const double det = uu * vv - cross * cross, ru = r.dot(u), rv = r.dot(v);
        const double by[2] = {(vv * ru - cross * rv) / det, (uu * rv - cross * ru) / det};
        double change = 0;
        for (int c : {0, 1}) {
            const double next = std::clamp(at[c] + by[c], -farthest, farthest);
            change = std::max(change, std::abs(next - at[c]));
            at[c] = next;
        }
        if (!(change < 1e-13) && (quad || i == 0)) continue;
        Foot f = surface_at(corners, at);
        f.height = f.normal.dot(point - sum(corners, f.share));
        return f;
    }
    Foot none = surface_at(corners, at);
    none.beyond = std::numeric_limits<double>::infinity();
    return none;
}

Vec3 carried(const Vec3& v, const Foot& from, const Foot& to) {
    if (v.isZero(0)) return v;
    return axes_of(to) * (axes_of(from).transpose() * v);
}

Vec3 slope_of_normal(const Foot& f, const Vec3& direction, std::size_t i) {
    const Vec3 e = (direction - direction.dot(f.normal) * f.normal) / f.along[0].cross(f.along[1]).norm();
    return f.slope[0][i] * f.along[1].cross(e) + f.slope[1][i] * e.cross(f.along[0]);
}

}  // namespace hinge::contact

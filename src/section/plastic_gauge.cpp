// The gauge of forces against the yield surface of a PlasticDomain, and its quick inner bound.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/positive.h"
#include "section/plastic_domain.h"

namespace hinge::beam {
namespace {

/// A section is at least as strong as if all of it had lost what its weakest walls have.
double left_of(const PlasticDomain::Lost* lost) { return lost ? 1 - std::max(lost->part[0], lost->part[1]) : 1; }

}  // namespace

double PlasticDomain::gauge(const Vec3& q, Vec3* normal, double* error, double limit, const Lost* lost) const {
    const double size = q.norm();
    if (error) *error = 0;
    if (!(size > 0)) {
        if (normal) normal->setZero();
        return size;
    }
    Vec3 v = about_normal(q);
    double missed = 0;
    double h = find_gauge(q / size, v, missed, limit / size, lost, !normal);
    if (missed > 1e-9 && !(h * size > limit || (h + missed) * size <= limit))
        h = find_gauge(q / size, v = q / size, missed, limit / size, lost, !normal);
    if (error) *error = size * missed;
    if (normal) *normal = v / h;
    return size * h;
}

/// The gauge of the unit vector `to` is h(v) where h^2 / 2 - to . v is least; `v`: where the search starts, and ends.
/// `missed`: the gauge of what is left of `to`, 0 where nearly nothing is.
/// It ends where it is known on which side of `limit` the gauge is: no h is above it, and none below it by more than
/// the gauge of what is left.
/// `alone`: the gauge is asked for without v. Where Newton's method converges, the fall of its next step is known, and
/// the step is not taken.
double PlasticDomain::find_gauge(const Vec3& to, Vec3& v, double& missed, double limit, const Lost* lost,
                                 bool alone) const {
    constexpr double near = 1e-6, quick = 1e-2;  // what is left of `to`, and over that before the last step
    constexpr double small_fall = 1e-9;          // of h^2: where the surface is nearly flat, a step may lead far
    Vec3 point;
    v.normalize();
    if (!(v.dot(to) > 0.01)) v = to;
    Mat3 curvature;
    double h = support(v, point, &curvature, lost);
    const Vec3 within = left_of(lost) * ellipsoid_;
    v *= to.dot(v) / (h * h), h = point.dot(v), curvature /= v.norm();
    double F = h * h / 2 - to.dot(v), damping = 0, off_before = 0;
    missed = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 off = to - h * point;
        if (off.norm() <= 1e-12 * h) return missed = 0, h;
        if (limit < std::numeric_limits<double>::infinity()) {
            missed = off.cwiseQuotient(within).norm();
            if (h > limit || h + missed <= limit) return h;
        }
        const Mat3 H = point * point.transpose() + h * curvature;
        bool fell = false;
        for (int tries = 0; tries < 60 && !fell; ++tries) {
            Mat3 damped = H;
            damped.diagonal().array() += std::max(damping, 1e-13) * H.trace();
            Vec3 way = off, there;
            const bool solved = solve_positive(damped, way);
            if (alone && solved && damping == 0 && off.norm() <= std::min(near * h, quick * off_before) &&
                std::abs(off.dot(way)) <= small_fall * h * h)
                return missed = 0, std::sqrt(h * h + off.dot(way));
            Vec3 next = v + way;
            Mat3 bent;
            double h_next = solved ? support(next, there, &bent, lost) : 0;
            if (h_next > 0) {  // along a ray the least is known
                const double times = to.dot(next) / (h_next * h_next);
                if (times > 0) next *= times, h_next *= times, bent /= times;
            }
            const double F_next = solved ? h_next * h_next / 2 - to.dot(next) : F;
            // near the least value F no longer tells
            if (F_next < F || (solved && off.norm() < 1e-4 && (to - h_next * there).norm() < 0.5 * off.norm())) {
                fell = true, v = next, h = h_next, point = there, curvature = bent, F = F_next;
                off_before = off.norm();
                damping = damping < 1e-10 ? 0 : 0.1 * damping;
            } else {
                damping = damping == 0 ? 1e-4 : 8 * damping;
            }
        }
        if (!fell) break;
    }
    missed = (to - h * point).cwiseQuotient(within).norm();
    return h;
}

/// About the centre, N with a positive sign; `side`: its sign.
Vec3 PlasticDomain::about_centre(const Vec3& forces, double& side) const {
    Vec3 q = forces;
    if (concrete()) q -= centre_, q.head<2>() -= q[2] * end_;
    side = q[2] < 0 ? -1 : 1;
    return side * q;
}

bool PlasticDomain::surely_inside(const Vec3& forces, Vec3* normal, const Lost* lost) const {
    const double left = left_of(lost);
    if (!normal && forces.cwiseQuotient(ellipsoid_).squaredNorm() <= left * left) return true;
    double side;
    const Vec3 q = about_centre(forces, side) / left;
    const Eigen::Vector2d m = q.head<2>();
    if (normal) *normal = side * q;
    if (!(q[2] < 1 && m.allFinite())) return false;
    if (m.isZero(0)) return true;
    const InnerPolyhedron::Face f = polyhedron_.face_at(q[2], m, side);
    if (normal) {
        Eigen::Vector2d of_m = (1 - f.part) * f.radius[0] * f.radius[0] * f.slope[0];
        if (f.radius[1] > 0) of_m += f.part * f.radius[1] * f.radius[1] * f.slope[1];
        *normal << side * of_m, side * InnerPolyhedron::levels * (f.radius[0] - f.radius[1]);
        if (concrete()) (*normal)[2] -= end_.dot(normal->head<2>());
    }
    return f.times >= 1;
}

/// About the strain whose point is in the direction of the forces: that of the polyhedron's face there. What is left
/// of the radius beyond t m falls with t, faster and faster.
Vec3 PlasticDomain::about_normal(const Vec3& forces) const {
    constexpr int most = 4;
    double side, t = 0;
    const Vec3 q = about_centre(forces, side);
    const Eigen::Vector2d m = q.head<2>();
    Vec3 normal = forces;
    if (concrete() || m.isZero(0) || !q.allFinite()) return surely_inside(forces, &normal), normal;
    const double most_t = q[2] > 0 ? 1 / q[2] : std::numeric_limits<double>::infinity();
    double low = 0, left = polyhedron_.face_at(0, m, side).times, high = std::min(most_t, left), over = -high;
    if (high < most_t) over = polyhedron_.face_at(high * q[2], m, side).times - high;
    for (int i = 0; i < most; ++i) {
        t = low + (high - low) * left / (left - over);
        if (!(t > low && t < high)) break;
        const double off = polyhedron_.face_at(t * q[2], m, side).times - t;
        if (std::abs(off) < 0.01 * t) break;
        if (off > 0) low = t, left = off, over *= 0.5;
        else high = t, over = off, left *= 0.5;
    }
    surely_inside(side * t * q, &normal);
    return normal;
}

}  // namespace hinge::beam

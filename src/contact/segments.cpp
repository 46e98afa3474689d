#include "contact/segments.h"

#include <algorithm>
#include <cmath>

namespace hinge::contact {

namespace {

double clamp01(double x) { return x < 0 ? 0.0 : x > 1 ? 1.0 : x; }

// Two directions closer than this (sine squared) have no usable common normal.
constexpr double parallel = 1e-20;
// Lengths whose square is below this fraction of the other's are no lengths.
constexpr double pointlike = 1e-24;
// Candidates whose squared distances differ by less than this fraction of the lengths squared are equally close.
constexpr double equally = 1e-14;

struct Candidate {
    double s, t, squared;
};

}  // namespace

// |p_b - p_a|^2 is convex over the unit square of (s, t). Its least value lies either inside (both axes crossed by
// their common normal) or on an edge of the square, that is at the end of a segment: four distances from a point to a
// segment.
Closest closest_points(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    const Vec3 da = a1 - a0, db = b1 - b0, e = b0 - a0;
    const double aa = da.squaredNorm(), bb = db.squaredNorm(), scale = std::max(aa, bb);
    Closest out;
    const auto finish = [&](double s, double t, Nearness kind) {
        out.s = s;
        out.t = t;
        out.between = e + t * db - s * da;
        out.distance = out.between.norm();
        out.kind = kind;
        return out;
    };

    const bool no_a = aa <= pointlike * scale, no_b = bb <= pointlike * scale;
    if (no_a || no_b) {
        const double s = no_a || scale == 0 ? 0.0 : clamp01(da.dot(e) / aa);
        const double t = no_b || scale == 0 ? 0.0 : clamp01(-db.dot(e) / bb);
        return finish(s, t, Nearness::point);
    }

    // The normal comes from the cross product, not from aa bb - ab^2: its error grows with 1 / angle, not with its
    // square.
    const Vec3 normal = da.cross(db);
    const double nn = normal.squaredNorm();
    const bool has_normal = nn > parallel * aa * bb;
    double s = -1, t = -1;
    if (has_normal) {
        s = e.cross(db).dot(normal) / nn;
        t = e.cross(da).dot(normal) / nn;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1 && nn > 1e-6 * aa * bb) return finish(s, t, Nearness::crossing);
    }

    const double ab = da.dot(db), ea = e.dot(da), eb = e.dot(db);
    Candidate found[5];
    const auto add = [&](int i, double s_, double t_) { found[i] = {s_, t_, (e + t_ * db - s_ * da).squaredNorm()}; };
    add(0, 0.0, clamp01(-eb / bb));
    add(1, 1.0, clamp01((ab - eb) / bb));
    add(2, clamp01(ea / aa), 0.0);
    add(3, clamp01((ea + ab) / aa), 1.0);
    int n = 4;
    if (has_normal && s >= 0 && s <= 1 && t >= 0 && t <= 1) add(n++, s, t);  // nearly parallel, yet crossing

    const Candidate* best = found;
    for (int i = 1; i < n; ++i)
        if (found[i].squared < best->squared) best = found + i;

    // Equally close points form a stretch (the function is convex): take its middle.
    const Candidate *low = best, *high = best;
    const double same = best->squared + equally * scale;
    for (int i = 0; i < n; ++i) {
        if (found[i].squared > same) continue;
        if (found[i].s < low->s) low = found + i;
        if (found[i].s > high->s) high = found + i;
    }
    if (nn <= 1e-12 * aa * bb && high->s - low->s > 1e-6)
        return finish(0.5 * (low->s + high->s), 0.5 * (low->t + high->t), Nearness::alongside);

    const bool end_a = best->s == 0 || best->s == 1, end_b = best->t == 0 || best->t == 1;
    return finish(best->s, best->t,
                  end_a && end_b   ? Nearness::end_to_end
                  : end_a || end_b ? Nearness::end_on_side
                                   : Nearness::crossing);
}

}  // namespace hinge::contact

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

/// Two segments a0 + s da and b0 + t db with e = b0 - a0.
struct Segments {
    Vec3 da, db, e;
    double aa, bb, scale;  ///< squared lengths, and the larger of them

    Segments(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1)
        : da(a1 - a0), db(b1 - b0), e(b0 - a0), aa(da.squaredNorm()), bb(db.squaredNorm()), scale(std::max(aa, bb)) {}

    Closest closest(double s, double t, Nearness kind) const {
        Closest out;
        out.s = s;
        out.t = t;
        out.between = e + t * db - s * da;
        out.distance = out.between.norm();
        out.kind = kind;
        return out;
    }
    Candidate candidate(double s, double t) const { return {s, t, (e + t * db - s * da).squaredNorm()}; }
};

/// At least one of the two has no length.
Closest closest_to_point(const Segments& two, bool no_a, bool no_b) {
    const double s = no_a || two.scale == 0 ? 0.0 : clamp01(two.da.dot(two.e) / two.aa);
    const double t = no_b || two.scale == 0 ? 0.0 : clamp01(-two.db.dot(two.e) / two.bb);
    return two.closest(s, t, Nearness::point);
}

/// From each end of one the closest point of the other.
void candidates_at_ends(const Segments& two, Candidate found[4]) {
    const double ab = two.da.dot(two.db), ea = two.e.dot(two.da), eb = two.e.dot(two.db);
    found[0] = two.candidate(0.0, clamp01(-eb / two.bb));
    found[1] = two.candidate(1.0, clamp01((ab - eb) / two.bb));
    found[2] = two.candidate(clamp01(ea / two.aa), 0.0);
    found[3] = two.candidate(clamp01((ea + ab) / two.aa), 1.0);
}

/// The closest of the candidates; of parallel segments the middle of the stretch over which they are equally close.
Closest closest_of(const Segments& two, const Candidate* found, int n, bool nearly_parallel) {
    const Candidate* best = found;
    for (int i = 1; i < n; ++i)
        if (found[i].squared < best->squared) best = found + i;

    // The function is convex: equally close points form a stretch.
    const Candidate *low = best, *high = best;
    const double same = best->squared + equally * two.scale;
    for (int i = 0; i < n; ++i) {
        if (found[i].squared > same) continue;
        if (found[i].s < low->s) low = found + i;
        if (found[i].s > high->s) high = found + i;
    }
    if (nearly_parallel && high->s - low->s > 1e-6)
        return two.closest(0.5 * (low->s + high->s), 0.5 * (low->t + high->t), Nearness::alongside);

    const bool end_a = best->s == 0 || best->s == 1, end_b = best->t == 0 || best->t == 1;
    return two.closest(best->s, best->t,
                       end_a && end_b   ? Nearness::end_to_end
                       : end_a || end_b ? Nearness::end_on_side
                                        : Nearness::crossing);
}

}  // namespace

// |p_b - p_a|^2 is convex over the unit square of (s, t). Its least value lies either inside (both axes crossed by
// their common normal) or on an edge of the square, that is at the end of a segment: four distances from a point to a
// segment.
Closest closest_points(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    const Segments two(a0, a1, b0, b1);
    const double aa = two.aa, bb = two.bb;
    const bool no_a = aa <= pointlike * two.scale, no_b = bb <= pointlike * two.scale;
    if (no_a || no_b) return closest_to_point(two, no_a, no_b);

    // The normal comes from the cross product, not from aa bb - ab^2: its error grows with 1 / angle, not with its
    // square.
    const Vec3 normal = two.da.cross(two.db);
    const double nn = normal.squaredNorm();
    const bool has_normal = nn > parallel * aa * bb;
    double s = -1, t = -1;
    if (has_normal) {
        s = two.e.cross(two.db).dot(normal) / nn;
        t = two.e.cross(two.da).dot(normal) / nn;
    }
    const bool inside = s >= 0 && s <= 1 && t >= 0 && t <= 1;
    if (inside && nn > 1e-6 * aa * bb) return two.closest(s, t, Nearness::crossing);

    Candidate found[5];
    candidates_at_ends(two, found);
    int n = 4;
    if (inside) found[n++] = two.candidate(s, t);  // nearly parallel, yet crossing
    return closest_of(two, found, n, nn <= 1e-12 * aa * bb);
}

}  // namespace hinge::contact

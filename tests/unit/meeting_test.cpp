// Where bars meet: closest points, eqs 17 to 19, the sweep over a step and the broad phase, against brute force.
#include <algorithm>
#include <utility>

#include "contact/broad_phase.h"
#include "contact/gap_rule.h"
#include "contact/segments.h"
#include "contact_parts.h"

using namespace hinge;
using namespace hinge::contact;

namespace {

/// The least distance by search: along a by thirds (the distance to b is convex there), along b by projection.
double searched_distance(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    const auto to_b = [&](double s) {
        const Vec3 p = a0 + s * (a1 - a0), d = b1 - b0;
        return (b0 + std::clamp((p - b0).dot(d) / d.squaredNorm(), 0.0, 1.0) * d - p).norm();
    };
    double low = 0, high = 1;
    for (int i = 0; i < 200; ++i) {
        const double third = (high - low) / 3;
        (to_b(low + third) < to_b(high - third) ? high : low) +=
            to_b(low + third) < to_b(high - third) ? -third : third;
    }
    return std::min({to_b(0), to_b(1), to_b(0.5 * (low + high))});
}

}  // namespace

// ---- segments

TEST_CASE("contact: closest points of two segments in every named position") {
    struct Case {
        const char* name;
        Vec3 a0, a1, b0, b1;
        double distance, s, t;
        Nearness kind;
    };
    const Case cases[] = {
        {"crossing", {-1, 0, 0}, {1, 0, 0}, {0, -1, 2}, {0, 3, 2}, 2, 0.5, 0.25, Nearness::crossing},
        {"cutting", {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 3, 0}, 0, 0.5, 0.25, Nearness::crossing},
        {"end on side", {-1, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 4, 0}, 1, 0.75, 0, Nearness::end_on_side},
        {"side on end", {0.5, 1, 0}, {0.5, 4, 0}, {-1, 0, 0}, {1, 0, 0}, 1, 0, 0.75, Nearness::end_on_side},
        {"corner", {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, 1, 1, 0, Nearness::end_to_end},
        {"collinear, apart", {0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {1.5, 0, 0}, 0.5, 1, 1, Nearness::end_to_end},
        {"collinear, overlapping", {0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {2.5, 0, 0}, 0, 0.75, 0.125, Nearness::alongside},
        {"collinear, one in the other", {0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {2, 0, 0}, 0, 0.375, 0.5, Nearness::alongside},
        {"coincident", {0, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, 0, 0.5, 0.5, Nearness::alongside},
        {"coincident, opposite", {0, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 0, 0}, 0, 0.5, 0.5, Nearness::alongside},
        {"parallel, abreast", {0, 0, 0}, {2, 0, 0}, {0, 0, 3}, {2, 0, 3}, 3, 0.5, 0.5, Nearness::alongside},
        {"parallel, staggered", {0, 0, 0}, {2, 0, 0}, {1, 0, 3}, {3, 0, 3}, 3, 0.75, 0.25, Nearness::alongside},
        {"parallel, end against end", {0, 0, 0}, {2, 0, 0}, {2, 0, 3}, {4, 0, 3}, 3, 1, 0, Nearness::end_to_end},
        {"parallel, past each other", {0, 0, 0}, {2, 0, 0}, {5, 4, 0}, {9, 4, 0}, 5, 1, 0, Nearness::end_to_end},
        {"no length, on a side", {1, 2, 0}, {1, 2, 0}, {0, 0, 0}, {4, 0, 0}, 2, 0, 0.25, Nearness::point},
        {"no length, the other one", {0, 0, 0}, {4, 0, 0}, {1, 2, 0}, {1, 2, 0}, 2, 0.25, 0, Nearness::point},
        {"no length, both", {1, 2, 0}, {1, 2, 0}, {1, 5, 4}, {1, 5, 4}, 5, 0, 0, Nearness::point},
        {"all one point", {1, 2, 0}, {1, 2, 0}, {1, 2, 0}, {1, 2, 0}, 0, 0, 0, Nearness::point},
    };
    for (const Case& c : cases) {
        INFO(c.name);
        const Closest found = closest_points(c.a0, c.a1, c.b0, c.b1);
        CHECK(found.distance == Approx(c.distance).margin(1e-14));
        CHECK(found.s == Approx(c.s).margin(1e-14));
        CHECK(found.t == Approx(c.t).margin(1e-14));
        CHECK(found.kind == c.kind);
        CHECK(found.between.norm() == Approx(c.distance).margin(1e-14));
    }
}

TEST_CASE("contact: closest points agree with a search, however the segments lie") {
    Dice dice(1);
    for (int i = 0; i < 400; ++i) {
        const Vec3 a0 = dice.vector(1), a1 = a0 + dice(0.1, 3) * dice.direction();
        Vec3 b0 = dice.vector(1), d = dice(0.1, 3) * dice.direction();
        if (i % 4 == 1) d = dice(-2, 2) * (a1 - a0);  // parallel
        if (i % 4 == 2)
            d = dice(-2, 2) * (a1 - a0) + std::pow(10, dice(-12, -2)) * dice.direction();    // nearly parallel
        if (i % 8 == 3) b0 = a0 + dice(-0.5, 1.5) * (a1 - a0), d = dice(-2, 2) * (a1 - a0);  // collinear
        const Vec3 b1 = b0 + d;
        const Closest found = closest_points(a0, a1, b0, b1), swapped = closest_points(b0, b1, a0, a1);
        const double expected = searched_distance(a0, a1, b0, b1);
        INFO("case " << i);
        CHECK(found.distance <= expected + 1e-12);
        CHECK(found.distance == Approx(expected).margin(1e-7));
        CHECK(swapped.distance == Approx(found.distance).margin(1e-13));
        CHECK(distance(a0, a1, b0, b1) == found.distance);
        CHECK((found.s >= 0 && found.s <= 1 && found.t >= 0 && found.t <= 1));
        CHECK((b0 + found.t * d - a0 - found.s * (a1 - a0) - found.between).norm() < 1e-14);
    }
}

TEST_CASE("contact: nearly parallel segments that cross have the distance of their common normal") {
    for (double angle : {1e-1, 1e-3, 1e-5, 1e-7, 1e-8}) {
        const Vec3 d(std::cos(angle), std::sin(angle), 0);
        const Closest found = closest_points({-1, 0, 0}, {1, 0, 0}, Vec3(0, 0, 0.03) - d, Vec3(0, 0, 0.03) + d);
        CHECK(found.distance == Approx(0.03).epsilon(1e-12));
        CHECK(found.s == Approx(0.5).margin(1e-6));
    }
}

// ---- eqs 17 to 19

TEST_CASE("contact: eq 17 is six times the tetrahedron's volume, as printed and between any points of the axes",
          "[contact]") {
    Dice dice(2);
    for (int i = 0; i < 50; ++i) {
        const BarPair two{{dice.vector(2), dice.vector(2)}, {dice.vector(2), dice.vector(2)}};
        const auto &c1 = two.a[0], &c2 = two.a[1], &i1 = two.b[0], &i2 = two.b[1];
        const double printed =
            ((i1.y() - c2.y()) * (i2.z() - c2.z()) - (i2.y() - c2.y()) * (i1.z() - c2.z())) * (c1.x() - c2.x()) +
            ((i2.x() - c2.x()) * (i1.z() - c2.z()) - (i1.x() - c2.x()) * (i2.z() - c2.z())) * (c1.y() - c2.y()) +
            ((i1.x() - c2.x()) * (i2.y() - c2.y()) - (i2.x() - c2.x()) * (i1.y() - c2.y())) * (c1.z() - c2.z());
        CHECK(coplanarity(two) == Approx(printed).margin(1e-13));
        const Vec3 p = c1 + dice(-1, 2) * (c2 - c1), q = i1 + dice(-1, 2) * (i2 - i1);
        CHECK(coplanarity(two) == Approx((q - p).dot((c2 - c1).cross(i2 - i1))).margin(1e-12));
    }
    const BarPair corner{{{1, 0, 0}, {0, 0, 0}}, {{0, 1, 0}, {0, 0, 1}}};  // volume 1/6
    CHECK(coplanarity(corner) == 1);
}

TEST_CASE("contact: eq 18 and eq 19 at their limits") {
    // Two bars of length 2, mid over mid at a right angle, h apart: four distances sqrt(2 + h^2) <= 1.8 * 4 / 4.
    const double h = std::sqrt(1.8 * 1.8 - 2);
    const auto cross = [](double z) { return BarPair{{{-1, 0, 0}, {1, 0, 0}}, {{0, -1, z}, {0, 1, z}}}; };
    CHECK(spread(cross(0.5)) == Approx(4 * std::sqrt(2.25)));
    CHECK(within_contact_length(cross(h * (1 - 1e-9)), 1.8));
    CHECK_FALSE(within_contact_length(cross(h * (1 + 1e-9)), 1.8));
    CHECK(within_contact_length(cross(1e6), infinite));
    // f = 4 z.
    CHECK(coplanarity(cross(0.1)) == Approx(0.4));
    CHECK(coplanar(cross(0.74e-4), 3e-4));
    CHECK(coplanar(cross(-0.74e-4), 3e-4));
    CHECK_FALSE(coplanar(cross(0.76e-4), 3e-4));
    CHECK_FALSE(coplanar(cross(-0.76e-4), 3e-4));
    // f with its sign, as printed: on one side at any distance
    const double side = coplanarity(cross(1)) < 0 ? 1 : -1;
    CHECK(coplanar(cross(side), 3e-4, true));
    CHECK_FALSE(coplanar(cross(-side), 3e-4, true));
    CHECK(coplanar(cross(-0.74e-4 * side), 3e-4, true));
    CHECK_FALSE(coplanar(cross(-0.76e-4 * side), 3e-4, true));
    // Rounding must not keep parallel bars from being flat, even with no tolerance at all.
    CHECK(coplanar({{{0.1, 0.2, 0.3}, {1.1, 2.2, 3.3}}, {{0.7, 0.9, 0.4}, {1.7, 2.9, 3.4}}}, 0));
    // End on, two bars of length 1 reach eq 18 only when they overlap by a tenth of their lengths' sum.
    const auto end_on = [](double overlap) {
        return BarPair{{{0, 0, 0}, {1, 0, 0}}, {{1 - overlap, 0, 0}, {2 - overlap, 0, 0}}};
    };
    CHECK_FALSE(within_contact_length(end_on(0.199), 1.8));
    CHECK(within_contact_length(end_on(0.201), 1.8));
}

TEST_CASE("contact: f over a step is the cubic") {
    Dice dice(3);
    for (int i = 0; i < 50; ++i) {
        const Moving m{{{dice.vector(2), dice.vector(2)}, {dice.vector(2), dice.vector(2)}},
                       {{dice.vector(1), dice.vector(1)}, {dice.vector(1), dice.vector(1)}}};
        const Cubic f = coplanarity_over(m);
        const double tau = dice(0, 1), h = 1e-5;
        CHECK(f(tau) == Approx(coplanarity(m.at(tau))).margin(1e-12));
        CHECK(f.slope(tau) == Approx((f(tau + h) - f(tau - h)) / (2 * h)).margin(1e-7));
        CHECK(m.closing_bound() >= std::abs(distance(m.at(0).a[0], m.at(0).a[1], m.at(0).b[0], m.at(0).b[1]) -
                                            distance(m.at(1).a[0], m.at(1).a[1], m.at(1).b[0], m.at(1).b[1])));
    }
}

TEST_CASE("contact: spans of a cubic between two values agree with sampling") {
    Dice dice(4);
    for (int i = 0; i < 500; ++i) {
        // Roots near the unit interval; sometimes a quadratic, a line, a constant, a double root.
        const double r1 = dice(-0.5, 1.5), r2 = i % 5 == 1 ? r1 : dice(-0.5, 1.5), r3 = dice(-0.5, 1.5);
        Cubic p{{-r1 * r2 * r3, r1 * r2 + r1 * r3 + r2 * r3, -(r1 + r2 + r3), 1}};
        if (i % 5 == 2) p = {{r1 * r2, -(r1 + r2), 1, 0}};
        if (i % 5 == 3) p = {{-r1, 1, 0, 0}};
        if (i % 50 == 4) p = {{r1, 0, 0, 0}};
        double lo = -dice(0, 0.05), hi = dice(0, 0.05);
        if (i % 7 == 1) lo = -infinite;
        if (i % 7 == 2) hi = infinite;
        Span spans[3];
        const int n = spans_between(p, lo, hi, spans);
        REQUIRE(n <= 3);
        for (int k = 0; k <= 1000; ++k) {
            const double tau = k / 1000.0, value = p(tau);
            bool inside = false;
            for (int j = 0; j < n; ++j) inside = inside || (tau >= spans[j].from && tau <= spans[j].to);
            if (value > lo + 1e-12 && value < hi - 1e-12) CHECK(inside);
            else if (value < lo - 1e-12 || value > hi + 1e-12) CHECK_FALSE(inside);
            else CHECK((std::abs(value - lo) <= 2e-12 || std::abs(value - hi) <= 2e-12));  // at a limit
        }
        for (int j = 0; j < n; ++j) CHECK((0 <= spans[j].from && spans[j].from <= spans[j].to && spans[j].to <= 1));
    }
    Span spans[3];
    CHECK(spans_between({{-1, 2, 0, 0}}, 0, 0, spans) == 1);  // a window of no width is still hit
    CHECK(spans[0].from == Approx(0.5));
    CHECK(spans[0].to == Approx(0.5));
}

// ---- swept over a step

namespace {

/// What the rule says at one instant, from the definitions.
struct Instant {
    double f, distance, beyond, rate;
};

Instant instant(const Moving& m, double tau, const Vec3& normal, double contact_length) {
    const BarPair now = m.at(tau);
    const Closest c = closest_points(now);
    const double lengths = (now.a[1] - now.a[0]).norm() + (now.b[1] - now.b[0]).norm();
    const Vec3 w = (1 - c.t) * m.move.b[0] + c.t * m.move.b[1] - (1 - c.s) * m.move.a[0] - c.s * m.move.a[1];
    const Vec3 way = c.distance > 1e-7 && c.between.dot(normal) >= 0 ? Vec3(c.between / c.distance) : normal;
    return {coplanarity(now), c.distance, std::isinf(contact_length) ? -1 : spread(now) - contact_length * lengths,
            -w.dot(way)};
}

/// A meeting found must be one by the definitions.
bool sound(const Moving& m, const Meeting& meeting, const Vec3& normal, const RuleNumbers& r) {
    const Instant now = instant(m, meeting.tau, normal, r.contact_length);
    return std::abs(now.f) <= r.alpha * (1 + 1e-6) + 1e-12 && now.distance <= r.contact_distance * (1 + 1e-6) &&
           now.beyond <= 1e-9 && now.rate > 0;
}

/// The first instant of many that is clearly a meeting; 2 if there is none. Grazes do not count.
double sampled(const Moving& m, const Vec3& normal, const RuleNumbers& r, int samples) {
    const double bound = m.closing_bound();
    Instant before = instant(m, 0, normal, r.contact_length);
    for (int k = 0; k <= samples; ++k) {
        const double tau = static_cast<double>(k) / samples;
        const Instant now = instant(m, tau, normal, r.contact_length);
        const bool flat_now = std::abs(now.f) <= r.alpha * (1 - 1e-6) || (now.f < 0) != (before.f < 0);
        for (const Instant& at : {before, now})
            if (flat_now && at.distance <= 0.97 * r.contact_distance - bound / samples &&
                at.beyond <= -1e-6 - 8 * bound / samples && at.rate > 1e-2 * bound)
                return tau;
        before = now;
    }
    return 2;
}

}  // namespace

TEST_CASE("contact: bars that pass through each other within a step are found every time") {
    Dice dice(5);
    int count = 0;
    for (double angle : {90.0, 70.0, 45.0, 20.0, 1.0})
        for (double speed : {50.0, 122.0, 300.0, 1000.0})
            for (double dt : {1e-5, 1e-4, 1e-3})
                for (int k = 0; k < 40; ++k) {
                    // Crossing at chosen places of both axes at a chosen moment, from a random direction, turning a
                    // little.
                    const Quat all = dice.rotation(pi);
                    const double rad = angle * pi / 180, la = dice(0.3, 2), lb = la * dice(0.6, 1.6);
                    const Vec3 da = all * Vec3(la, 0, 0), db = all * (lb * Vec3(std::cos(rad), std::sin(rad), 0));
                    const Vec3 way = all * Vec3(dice(-0.5, 0.5), dice(-0.5, 0.5), 1).normalized();
                    const double s = dice(0.1, 0.9), t = dice(0.1, 0.9), when = dice(0.05, 0.95),
                                 radius = dice(0.02, 0.2);
                    const Vec3 at = dice.vector(10);
                    Moving m;
                    const Vec3 shared = dice.vector(20) * dt;
                    for (int e = 0; e < 2; ++e) {
                        const Vec3 wobble_a = dice.vector(2) * dt, wobble_b = dice.vector(2) * dt;
                        m.move.a[e] = shared + wobble_a;
                        m.move.b[e] = shared - speed * dt * way + wobble_b;
                        m.start.a[e] = at + (e - s) * da - when * m.move.a[e];
                        m.start.b[e] = at + (e - t) * db - when * m.move.b[e];
                    }
                    const Closest begin = closest_points(m.start);
                    const Vec3 normal = begin.between.normalized();
                    const RuleNumbers numbers{infinite, 3e-4, 2 * radius};
                    const Meeting meeting = first_meeting(m, begin, normal, numbers);
                    INFO("angle " << angle << " speed " << speed << " dt " << dt << " case " << k);
                    REQUIRE(meeting.found);
                    CHECK(meeting.tau <= when + 1e-9);
                    CHECK(sound(m, meeting, normal, numbers));
                    ++count;
                }
    CHECK(count == 2400);
}

TEST_CASE("contact: the sweep agrees with fine sub-sampling of the step") {
    Dice dice(6);
    int hits = 0, misses = 0;
    for (int k = 0; k < 8000; ++k) {
        const double la = dice(0.3, 2), lb = dice(0.3, 2), stride = std::pow(10, dice(-3, 0));
        const Vec3 da = la * dice.direction();
        Vec3 db = lb * dice.direction();
        if (k % 5 == 1) db = lb / la * da;                                   // parallel
        if (k % 5 == 2) db = lb / la * (da + 0.02 * la * dice.direction());  // nearly parallel
        if (k % 5 == 3) db -= da * da.dot(db) / (la * la) * dice(0, 1);      // rather square
        const double radius = dice(0.02, 0.2);
        const Vec3 near = dice(-0.2, 1.2) * da + (radius * 2 + dice(0, 1) * stride) * dice.direction();
        Moving m;
        m.start = {{Vec3::Zero(), da}, {near - dice(-0.2, 1.2) * db, Vec3::Zero()}};
        m.start.b[1] = m.start.b[0] + db;
        const Vec3 way = dice.direction() * stride * 0.5 - near.normalized() * stride;
        for (int e = 0; e < 2; ++e) {
            m.move.a[e] = dice.vector(0.1) * stride;
            m.move.b[e] = way + dice.vector(k % 2 ? 0.3 : 0.0) * stride;
        }
        const Closest begin = closest_points(m.start);
        if (begin.distance < 2.01 * radius) continue;
        const Vec3 normal = begin.between / begin.distance;
        const RuleNumbers numbers{k % 3 ? 1.8 : infinite, k % 4 ? 3e-4 : 3e-2, 2 * radius};
        const Meeting meeting = first_meeting(m, begin, normal, numbers);
        const double first = sampled(m, normal, numbers, 2000);
        INFO("case " << k);
        if (meeting.found) CHECK(sound(m, meeting, normal, numbers));
        if (first <= 1) {
            CHECK(meeting.found);
            CHECK(meeting.tau <= first + 1.0 / 128);  // the least stride of the sweep, twice
            ++hits;
        } else {
            ++misses;
        }
    }
    CHECK(hits > 300);
    CHECK(misses > 300);
}

TEST_CASE("contact: the sweep in parallel, touching and overlapping positions") {
    const auto meet = [](const BarPair& start, const Vec3& down, double contact_length = 1.8) {
        const Moving m{start, {{Vec3::Zero(), Vec3::Zero()}, {down, down}}};
        const Closest begin = closest_points(start);
        return first_meeting(m, begin, begin.between.normalized(), {contact_length, 3e-4, 0.05});
    };
    const Vec3 o(0, 0, 0), x(1, 0, 0);
    const auto beside = [&](double y, double z) { return BarPair{{o, x}, {Vec3(0, y, z), Vec3(1, y, z)}}; };
    SECTION("parallel, abreast: the half depths decide, since f is always zero") {
        const Meeting hit = meet(beside(0, 0.25), {0, 0, -0.5});
        REQUIRE(hit.found);
        CHECK(hit.tau == Approx(0.4).epsilon(1e-9));
        CHECK(hit.s == Approx(0.5));
        CHECK(hit.t == Approx(0.5));
        CHECK_FALSE(meet(beside(0, 0.25), {0, 0, -0.19}).found);
        CHECK_FALSE(meet(beside(0, 0.25), {0, 0, 0.5}).found);
    }
    SECTION("parallel, passing at a distance") {
        CHECK_FALSE(meet(beside(0.06, 0.25), {0, 0, -0.5}).found);
        CHECK(meet(beside(0.04, 0.25), {0, 0, -0.5}).found);
    }
    SECTION("in one plane, an end against a side") {
        const Meeting hit = meet({{{0, 0, 0}, {1, 0, 0}}, {{0.5, 0, 0.1}, {0.5, 0, 1.1}}}, {0, 0, -0.1});
        REQUIRE(hit.found);
        CHECK(hit.tau == Approx(0.5).epsilon(1e-9));
        CHECK(hit.t == 0);
    }
    SECTION("end on: eq 18 waits for an overlap of a tenth of the lengths, without eq 18 the half depths decide") {
        const BarPair rods{{{0, 0, 0}, {1, 0, 0}}, {{1.1, 0, 0}, {2.1, 0, 0}}};
        const Meeting late = meet(rods, {-0.5, 0, 0});
        REQUIRE(late.found);
        CHECK(late.tau == Approx(0.6).margin(1.0 / 128));
        const Meeting contact = meet(rods, {-0.5, 0, 0}, infinite);
        REQUIRE(contact.found);
        CHECK(contact.tau == Approx(0.1).epsilon(1e-9));
    }
    SECTION("a bar of no length") {
        const BarPair dot{{{0, 0, 0}, {1, 0, 0}}, {{0.5, 0, 0.1}, {0.5, 0, 0.1}}};
        CHECK_FALSE(meet(dot, {0, 0, -0.2}).found);  // eq 18: 4 * 0.5 > 1.8
        CHECK(meet(dot, {0, 0, -0.2}, infinite).found);
    }
    SECTION("in one plane but apart, the planes cross beside the bars; and nothing moves") {
        CHECK_FALSE(meet({{o, x}, {{1.2, -0.5, 0.1}, {1.2, 0.5, 0.1}}}, {0, 0, -0.2}).found);
        CHECK_FALSE(meet({{{0, 0, 0}, {1, 0, 0}}, {{0.5, -0.5, 0}, {0.5, 0.5, 0}}}, Vec3::Zero()).found);
        CHECK_FALSE(meet({{{0, 0, 0}, {1, 0, 0}}, {{0.5, -0.5, 0.05}, {0.5, 0.5, 0.05}}}, Vec3::Zero()).found);
    }
}

TEST_CASE("contact: as printed, a step that jumps over the window misses") {
    // |f| changes by l1 l2 v dt = 0.25 m^2 * 0.5 mm a step; the window is 2 * 1.2 mm wide at 50 m/s, and 0.5 m/s steps
    // land in it.
    const auto steps_to_bind = [](double speed, double dt, bool as_printed) {
        Scene s = crossing(speed, 0.25);
        Contact contact(ContactSettings{.as_printed = as_printed});
        for (int i = 0; i * speed * dt < 0.5; ++i) {
            if (s.detect(contact, dt, i * dt) > 0) return i;
            s.move(dt);
        }
        return -1;
    };
    CHECK(steps_to_bind(50, 1e-5, true) > 0);
    CHECK(steps_to_bind(50, 1e-5, false) > 0);
    CHECK(steps_to_bind(1000, 3.5e-5, true) == -1);  // 35 mm a step: 0.25, 0.215, ... 0.005, -0.03
    CHECK(steps_to_bind(1000, 3.5e-5, false) == 7);  // found in the step that crosses
}

// ---- broad phase

TEST_CASE("contact: boxes beyond all bounds, or of what is not a number, meet every other") {
    const double nan = std::nan("");
    std::vector<Box> boxes;
    for (int i = 0; i < 200; ++i) boxes.emplace_back(Vec3(10.0 * i, 0, 0), Vec3(10.0 * i + 1, 1, 1));
    boxes.emplace_back(Vec3::Constant(nan), Vec3::Constant(nan));
    boxes.emplace_back(Vec3::Constant(-infinite), Vec3::Constant(infinite));
    boxes.emplace_back(Vec3(-1e300, -1e300, 0), Vec3(1e300, 1e300, 1));
    const auto pairs = overlapping(boxes, [](int, int) { return true; });
    CHECK(pairs.size() == 3 * 200 + 3);
}

TEST_CASE("contact: overlapping boxes agree with testing every pair") {
    Dice dice(7);
    for (int round = 0; round < 60; ++round) {
        std::vector<Box> boxes(round < 3 ? round : 120);
        for (Box& box : boxes) {
            const Vec3 low = dice.vector(1).cwiseProduct(Vec3(round % 3 == 0 ? 0 : 3, 1, round % 2 ? 8 : 0.1));
            const Vec3 high =
                low + (round % 5 ? dice(0, 0.6) : 0) * Vec3::Ones() + (dice.vector(0.3) + 0.3 * Vec3::Ones());
            box = Box(low, high);
            CHECK((box.low.cast<double>().array() <= low.array()).all());
            CHECK((box.high.cast<double>().array() >= high.array()).all());
        }
        if (boxes.size() > 10) {
            boxes[5] = boxes[4];           // the same box twice
            boxes[7].low = boxes[6].high;  // touching in a corner
            boxes[7].high = boxes[7].low + Eigen::Vector3f::Ones();
            boxes[9].high = boxes[9].low;  // a point
        }
        std::vector<IndexPair> expected;
        const auto wanted = [&](int a, int b) { return round % 4 != 0 || (a + b) % 3 != 0; };
        for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
            for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j)
                if (wanted(i, j) && (boxes[i].low.array() <= boxes[j].high.array()).all() &&
                    (boxes[j].low.array() <= boxes[i].high.array()).all())
                    expected.push_back({i, j});
        CHECK(overlapping(boxes, wanted) == expected);
    }
}

// Contact: geometry against brute force, gap elements against finite differences, the rule at work in small scenes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "contact/bond.h"
#include "contact/broad_phase.h"
#include "contact/contact.h"
#include "contact/gap_rule.h"
#include "contact/segments.h"
#include "core/archive.h"

using namespace hinge;
using namespace hinge::contact;

namespace {

constexpr double pi = 3.14159265358979323846;
const double infinite = std::numeric_limits<double>::infinity();

/// Random numbers that are the same on every machine.
struct Dice {
    std::mt19937_64 engine;
    explicit Dice(unsigned seed) : engine(seed) {}
    double operator()(double low, double high) { return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53; }
    Vec3 vector(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
    Vec3 direction() {
        while (true) {
            const Vec3 v = vector(1);
            if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
        }
    }
    Quat turn(double angle) { return Quat(Eigen::AngleAxisd((*this)(-angle, angle), direction())); }
};

Quat turned(const Vec3& by, const Quat& rotation) {
    const double angle = by.norm();
    return angle > 0 ? Quat(Eigen::AngleAxisd(angle, by / angle)) * rotation : rotation;
}

/// The least distance by search: along a by thirds (the distance to b is convex there), along b by projection.
double searched_distance(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    const auto to_b = [&](double s) {
        const Vec3 p = a0 + s * (a1 - a0), d = b1 - b0;
        return (b0 + std::clamp((p - b0).dot(d) / d.squaredNorm(), 0.0, 1.0) * d - p).norm();
    };
    double low = 0, high = 1;
    for (int i = 0; i < 200; ++i) {
        const double third = (high - low) / 3;
        (to_b(low + third) < to_b(high - third) ? high : low) += to_b(low + third) < to_b(high - third) ? -third : third;
    }
    return std::min({to_b(0), to_b(1), to_b(0.5 * (low + high))});
}

/// A structure of bars for Contact: nodes, their motion, and a step that just moves them.
struct Scene {
    std::vector<Vec3> x;
    std::vector<Quat> q;
    std::vector<Vec6> v;
    std::vector<Bar> bars;

    int node(const Vec3& at, const Vec3& velocity = Vec3::Zero()) {
        x.push_back(at);
        q.push_back(Quat::Identity());
        Vec6 w = Vec6::Zero();
        w.head<3>() = velocity;
        v.push_back(w);
        return static_cast<int>(x.size()) - 1;
    }
    Bar& bar(int a, int b, double radius = 0.025, double stiffness = 5e8) {
        Bar bar;
        bar.element = static_cast<int>(bars.size());
        bar.node[0] = a;
        bar.node[1] = b;
        bar.radius = radius;
        bar.stiffness = stiffness;
        bars.push_back(bar);
        return bars.back();
    }
    /// A member of n elements.
    void member(const Vec3& from, const Vec3& to, int n, const Vec3& velocity = Vec3::Zero()) {
        int last = node(from, velocity);
        for (int i = 1; i <= n; ++i) {
            const int next = node(from + (to - from) * i / n, velocity);
            bar(last, next);
            last = next;
        }
    }
    Motion motion() const { return {x, q, v}; }
    void move(double dt) {
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += dt * v[i].head<3>();
            q[i] = turned(dt * v[i].tail<3>(), q[i]).normalized();
        }
    }
    std::vector<Vec6> forces(Contact& contact) const {
        std::vector<Vec6> f(x.size(), Vec6::Zero());
        contact.add_internal_forces(x, q, f);
        return f;
    }
};

/// Two members of two elements, mid over mid at `angle`, `gap` apart, the upper one coming down.
Scene crossing(double speed, double gap, double angle = pi / 2, const Vec3& offset = Vec3::Zero()) {
    Scene s;
    s.member({-0.5, 0, 0}, {0.5, 0, 0}, 2);
    const Vec3 d(0.5 * std::cos(angle), 0.5 * std::sin(angle), 0), c = offset + Vec3(0, 0, gap);
    s.member(c - d, c + d, 2, {0, 0, -speed});
    return s;
}

/// A bond of two bars in general position, one of them a stub with arms, everything turned since it was bound.
struct Bound {
    std::vector<Vec3> x;
    std::vector<Quat> q;
    Bond bond;
};

Bound bound_pair(unsigned seed, double stretch, double turn_each, double turn_all, bool arms) {
    Dice dice(seed);
    Bound out;
    for (int i = 0; i < 4; ++i) {
        out.x.push_back(dice.vector(0.5));
        out.q.push_back(dice.turn(pi));
    }
    for (int i = 0; i < 4; ++i) {
        out.bond.end[i].node = i;
        out.bond.end[i].arm = arms ? dice.vector(0.3) : Vec3::Zero();
    }
    const auto point = [&](int i) { return Vec3(out.x[i] + out.q[i] * out.bond.end[i].arm); };
    for (int g = 0; g < 4; ++g) {
        out.bond.gap[g].rest = point(gap_b(g)) - point(gap_a(g));
        out.bond.gap[g].stiffness = 1e3 * (1 + g);
    }
    out.bond.side = Vec3::UnitZ();
    out.bond.at[0] = 0.3;
    out.bond.at[1] = 0.6;
    const Quat all = dice.turn(turn_all);
    out.bond.turn = all;  // as a bond has that followed the whole so far
    const Vec3 shift = dice.vector(3);
    for (int i = 0; i < 4; ++i) {
        out.x[i] = all * out.x[i] + shift + dice.vector(stretch);
        out.q[i] = dice.turn(turn_each) * all * out.q[i];
    }
    return out;
}

std::vector<Vec6> forces_of(Bound& b) {
    std::vector<Vec6> f(b.x.size(), Vec6::Zero());
    add_bond_forces(b.bond, b.x, b.q, f);
    return f;
}

/// `b` with freedom `k` of node `n` moved by h.
Bound nudged(const Bound& b, int n, int k, double h) {
    Bound out = b;
    if (k < 3)
        out.x[n][k] += h;
    else
        out.q[n] = turned(h * Vec3::Unit(k - 3), out.q[n]);
    return out;
}

}  // namespace

// ---------------------------------------------------------------------------------------------------------------- segments

TEST_CASE("contact: closest points of two segments in every named position", "[contact]") {
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
        {"collinear, one inside the other", {0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {2, 0, 0}, 0, 0.375, 0.5, Nearness::alongside},
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

TEST_CASE("contact: closest points agree with a search, however the segments lie", "[contact]") {
    Dice dice(1);
    for (int i = 0; i < 400; ++i) {
        const Vec3 a0 = dice.vector(1), a1 = a0 + dice(0.1, 3) * dice.direction();
        Vec3 b0 = dice.vector(1), d = dice(0.1, 3) * dice.direction();
        if (i % 4 == 1) d = dice(-2, 2) * (a1 - a0);                                                    // parallel
        if (i % 4 == 2) d = dice(-2, 2) * (a1 - a0) + std::pow(10, dice(-12, -2)) * dice.direction();   // nearly parallel
        if (i % 8 == 3) b0 = a0 + dice(-0.5, 1.5) * (a1 - a0), d = dice(-2, 2) * (a1 - a0);             // collinear
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

TEST_CASE("contact: nearly parallel segments that cross have the distance of their common normal", "[contact]") {
    for (double angle : {1e-1, 1e-3, 1e-5, 1e-7, 1e-8}) {
        const Vec3 d(std::cos(angle), std::sin(angle), 0);
        const Closest found = closest_points({-1, 0, 0}, {1, 0, 0}, Vec3(0, 0, 0.03) - d, Vec3(0, 0, 0.03) + d);
        CHECK(found.distance == Approx(0.03).epsilon(1e-12));
        CHECK(found.s == Approx(0.5).margin(1e-6));
    }
}

// ------------------------------------------------------------------------------------------------------------ eqs 17 to 19

TEST_CASE("contact: eq 17 is six times the tetrahedron's volume, as printed and between any points of the axes", "[contact]") {
    Dice dice(2);
    for (int i = 0; i < 50; ++i) {
        const Two two{{dice.vector(2), dice.vector(2)}, {dice.vector(2), dice.vector(2)}};
        const auto &c1 = two.a[0], &c2 = two.a[1], &i1 = two.b[0], &i2 = two.b[1];
        const double printed =
            ((i1.y() - c2.y()) * (i2.z() - c2.z()) - (i2.y() - c2.y()) * (i1.z() - c2.z())) * (c1.x() - c2.x()) +
            ((i2.x() - c2.x()) * (i1.z() - c2.z()) - (i1.x() - c2.x()) * (i2.z() - c2.z())) * (c1.y() - c2.y()) +
            ((i1.x() - c2.x()) * (i2.y() - c2.y()) - (i2.x() - c2.x()) * (i1.y() - c2.y())) * (c1.z() - c2.z());
        CHECK(flatness(two) == Approx(printed).margin(1e-13));
        const Vec3 p = c1 + dice(-1, 2) * (c2 - c1), q = i1 + dice(-1, 2) * (i2 - i1);
        CHECK(flatness(two) == Approx((q - p).dot((c2 - c1).cross(i2 - i1))).margin(1e-12));
    }
    const Two corner{{{1, 0, 0}, {0, 0, 0}}, {{0, 1, 0}, {0, 0, 1}}};  // volume 1/6
    CHECK(flatness(corner) == 1);
}

TEST_CASE("contact: eq 18 and eq 19 at their limits", "[contact]") {
    // Two bars of length 2, mid over mid at a right angle, h apart: four distances sqrt(2 + h^2) <= 1.8 * 4 / 4.
    const double h = std::sqrt(1.8 * 1.8 - 2);
    const auto cross = [](double z) { return Two{{{-1, 0, 0}, {1, 0, 0}}, {{0, -1, z}, {0, 1, z}}}; };
    CHECK(spread(cross(0.5)) == Approx(4 * std::sqrt(2.25)));
    CHECK(within_reach(cross(h * (1 - 1e-9)), 1.8));
    CHECK_FALSE(within_reach(cross(h * (1 + 1e-9)), 1.8));
    CHECK(within_reach(cross(1e6), infinite));
    // f = 4 z.
    CHECK(flatness(cross(0.1)) == Approx(0.4));
    CHECK(flat(cross(0.74e-4), 3e-4));
    CHECK(flat(cross(-0.74e-4), 3e-4));
    CHECK_FALSE(flat(cross(0.76e-4), 3e-4));
    CHECK_FALSE(flat(cross(-0.76e-4), 3e-4));
    // Rounding must not keep parallel bars from being flat, even with no tolerance at all.
    CHECK(flat({{{0.1, 0.2, 0.3}, {1.1, 2.2, 3.3}}, {{0.7, 0.9, 0.4}, {1.7, 2.9, 3.4}}}, 0));
    // End on, two bars of length 1 reach eq 18 only when they overlap by a tenth of their lengths' sum.
    const auto end_on = [](double overlap) { return Two{{{0, 0, 0}, {1, 0, 0}}, {{1 - overlap, 0, 0}, {2 - overlap, 0, 0}}}; };
    CHECK_FALSE(within_reach(end_on(0.199), 1.8));
    CHECK(within_reach(end_on(0.201), 1.8));
}

TEST_CASE("contact: f over a step is the cubic", "[contact]") {
    Dice dice(3);
    for (int i = 0; i < 50; ++i) {
        const Moving m{{{dice.vector(2), dice.vector(2)}, {dice.vector(2), dice.vector(2)}},
                       {{dice.vector(1), dice.vector(1)}, {dice.vector(1), dice.vector(1)}}};
        const Cubic f = flatness_over(m);
        const double tau = dice(0, 1), h = 1e-5;
        CHECK(f(tau) == Approx(flatness(m.at(tau))).margin(1e-12));
        CHECK(f.slope(tau) == Approx((f(tau + h) - f(tau - h)) / (2 * h)).margin(1e-7));
        CHECK(m.closing_bound() >= std::abs(distance(m.at(0).a[0], m.at(0).a[1], m.at(0).b[0], m.at(0).b[1]) -
                                            distance(m.at(1).a[0], m.at(1).a[1], m.at(1).b[0], m.at(1).b[1])));
    }
}

TEST_CASE("contact: spans of a cubic between two values agree with sampling", "[contact]") {
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
            if (value < lo - 1e-12 || value > hi + 1e-12) CHECK_FALSE(inside);
        }
        for (int j = 0; j < n; ++j) CHECK((0 <= spans[j].from && spans[j].from <= spans[j].to && spans[j].to <= 1));
    }
    Span spans[3];
    CHECK(spans_between({{-1, 2, 0, 0}}, 0, 0, spans) == 1);  // a window of no width is still hit
    CHECK(spans[0].from == Approx(0.5));
    CHECK(spans[0].to == Approx(0.5));
}

// --------------------------------------------------------------------------------------------------------- swept over a step

namespace {

/// What the rule says at one instant, from the definitions.
struct Instant {
    double f, distance, beyond, rate;
};

Instant instant(const Moving& m, double tau, const Vec3& side, double reach) {
    const Two now = m.at(tau);
    const Closest c = closest_points(now);
    const double lengths = (now.a[1] - now.a[0]).norm() + (now.b[1] - now.b[0]).norm();
    const Vec3 w = (1 - c.t) * m.move.b[0] + c.t * m.move.b[1] - (1 - c.s) * m.move.a[0] - c.s * m.move.a[1];
    const Vec3 way = c.distance > 1e-7 && c.between.dot(side) >= 0 ? Vec3(c.between / c.distance) : side;
    return {flatness(now), c.distance, std::isinf(reach) ? -1 : spread(now) - reach * lengths, -w.dot(way)};
}

/// A meeting found must be one by the definitions.
bool sound(const Moving& m, const Meeting& meeting, const Vec3& side, const RuleNumbers& r) {
    const Instant now = instant(m, meeting.tau, side, r.reach);
    return std::abs(now.f) <= r.alpha * (1 + 1e-6) + 1e-12 && now.distance <= r.touch * (1 + 1e-6) && now.beyond <= 1e-9 && now.rate > 0;
}

/// The first instant of many that is clearly a meeting; 2 if there is none. Grazes do not count.
double sampled(const Moving& m, const Vec3& side, const RuleNumbers& r, int samples) {
    const double bound = m.closing_bound();
    Instant before = instant(m, 0, side, r.reach);
    for (int k = 0; k <= samples; ++k) {
        const double tau = static_cast<double>(k) / samples;
        const Instant now = instant(m, tau, side, r.reach);
        const bool flat_now = std::abs(now.f) <= r.alpha * (1 - 1e-6) || (now.f < 0) != (before.f < 0);
        for (const Instant& at : {before, now})
            if (flat_now && at.distance <= 0.97 * r.touch - bound / samples && at.beyond <= -1e-6 - 8 * bound / samples &&
                at.rate > 1e-2 * bound)
                return tau;
        before = now;
    }
    return 2;
}

}  // namespace

TEST_CASE("contact: bars that pass through each other within a step are found every time", "[contact]") {
    Dice dice(5);
    int count = 0;
    for (double angle : {90.0, 70.0, 45.0, 20.0, 1.0})
        for (double speed : {50.0, 122.0, 300.0, 1000.0})
            for (double dt : {1e-5, 1e-4, 1e-3})
                for (int k = 0; k < 40; ++k) {
                    // Crossing at chosen places of both axes at a chosen moment, from a random direction, turning a little.
                    const Quat all = dice.turn(pi);
                    const double rad = angle * pi / 180, la = dice(0.3, 2), lb = la * dice(0.6, 1.6);
                    const Vec3 da = all * Vec3(la, 0, 0), db = all * (lb * Vec3(std::cos(rad), std::sin(rad), 0));
                    const Vec3 way = all * Vec3(dice(-0.5, 0.5), dice(-0.5, 0.5), 1).normalized();
                    const double s = dice(0.1, 0.9), t = dice(0.1, 0.9), when = dice(0.05, 0.95), radius = dice(0.02, 0.2);
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
                    const Vec3 side = begin.between.normalized();
                    const RuleNumbers numbers{infinite, 3e-4, 2 * radius};
                    const Meeting meeting = first_meeting(m, begin, side, numbers);
                    INFO("angle " << angle << " speed " << speed << " dt " << dt << " case " << k);
                    REQUIRE(meeting.found);
                    CHECK(meeting.tau <= when + 1e-9);
                    CHECK(sound(m, meeting, side, numbers));
                    ++count;
                }
    CHECK(count == 2400);
}

TEST_CASE("contact: the sweep agrees with fine sub-sampling of the step", "[contact]") {
    Dice dice(6);
    int hits = 0, misses = 0;
    for (int k = 0; k < 8000; ++k) {
        const double la = dice(0.3, 2), lb = dice(0.3, 2), stride = std::pow(10, dice(-3, 0));
        const Vec3 da = la * dice.direction();
        Vec3 db = lb * dice.direction();
        if (k % 5 == 1) db = lb / la * da;                                              // parallel
        if (k % 5 == 2) db = lb / la * (da + 0.02 * la * dice.direction());             // nearly parallel
        if (k % 5 == 3) db -= da * da.dot(db) / (la * la) * dice(0, 1);                 // rather square
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
        const Vec3 side = begin.between / begin.distance;
        const RuleNumbers numbers{k % 3 ? 1.8 : infinite, k % 4 ? 3e-4 : 3e-2, 2 * radius};
        const Meeting meeting = first_meeting(m, begin, side, numbers);
        const double first = sampled(m, side, numbers, 2000);
        INFO("case " << k);
        if (meeting.found) CHECK(sound(m, meeting, side, numbers));
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

TEST_CASE("contact: what the sweep does in degenerate positions", "[contact]") {
    const auto meet = [](const Two& start, const Vec3& down, double reach = 1.8) {
        const Moving m{start, {{Vec3::Zero(), Vec3::Zero()}, {down, down}}};
        const Closest begin = closest_points(start);
        return first_meeting(m, begin, begin.between.normalized(), {reach, 3e-4, 0.05});
    };
    SECTION("parallel, abreast: touch decides, since f is always zero") {
        const Meeting hit = meet({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0.25}, {1, 0, 0.25}}}, {0, 0, -0.5});
        REQUIRE(hit.found);
        CHECK(hit.tau == Approx(0.4).epsilon(1e-9));
        CHECK(hit.s == Approx(0.5));
        CHECK(hit.t == Approx(0.5));
        CHECK_FALSE(meet({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0.25}, {1, 0, 0.25}}}, {0, 0, -0.19}).found);
        CHECK_FALSE(meet({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0.25}, {1, 0, 0.25}}}, {0, 0, 0.5}).found);
    }
    SECTION("parallel, passing at a distance") {
        CHECK_FALSE(meet({{{0, 0, 0}, {1, 0, 0}}, {{0, 0.06, 0.25}, {1, 0.06, 0.25}}}, {0, 0, -0.5}).found);
        CHECK(meet({{{0, 0, 0}, {1, 0, 0}}, {{0, 0.04, 0.25}, {1, 0.04, 0.25}}}, {0, 0, -0.5}).found);
    }
    SECTION("in one plane, an end against a side") {
        const Meeting hit = meet({{{0, 0, 0}, {1, 0, 0}}, {{0.5, 0, 0.1}, {0.5, 0, 1.1}}}, {0, 0, -0.1});
        REQUIRE(hit.found);
        CHECK(hit.tau == Approx(0.5).epsilon(1e-9));
        CHECK(hit.t == 0);
    }
    SECTION("end on: eq 18 waits for an overlap of a tenth of the lengths, without eq 18 touch decides") {
        const Two rods{{{0, 0, 0}, {1, 0, 0}}, {{1.1, 0, 0}, {2.1, 0, 0}}};
        const Meeting late = meet(rods, {-0.5, 0, 0});
        REQUIRE(late.found);
        CHECK(late.tau == Approx(0.6).margin(1.0 / 128));
        const Meeting touch = meet(rods, {-0.5, 0, 0}, infinite);
        REQUIRE(touch.found);
        CHECK(touch.tau == Approx(0.1).epsilon(1e-9));
    }
    SECTION("a bar of no length") {
        const Two dot{{{0, 0, 0}, {1, 0, 0}}, {{0.5, 0, 0.1}, {0.5, 0, 0.1}}};
        CHECK_FALSE(meet(dot, {0, 0, -0.2}).found);  // eq 18: 4 * 0.5 > 1.8
        CHECK(meet(dot, {0, 0, -0.2}, infinite).found);
    }
    SECTION("in one plane but apart: the planes cross beside the bars") {
        CHECK_FALSE(meet({{{0, 0, 0}, {1, 0, 0}}, {{1.2, -0.5, 0.1}, {1.2, 0.5, 0.1}}}, {0, 0, -0.2}).found);
    }
    SECTION("nothing moves") {
        CHECK_FALSE(meet({{{0, 0, 0}, {1, 0, 0}}, {{0.5, -0.5, 0}, {0.5, 0.5, 0}}}, Vec3::Zero()).found);
        CHECK_FALSE(meet({{{0, 0, 0}, {1, 0, 0}}, {{0.5, -0.5, 0.05}, {0.5, 0.5, 0.05}}}, Vec3::Zero()).found);
    }
}

TEST_CASE("contact: to the letter, a step that jumps over the window misses", "[contact]") {
    // |f| changes by l1 l2 v dt = 0.25 m^2 * 0.5 mm a step; the window is 2 * 1.2 mm wide at 50 m/s, and 0.5 m/s steps land in it.
    const auto steps_to_bind = [](double speed, double dt, bool letter) {
        Scene s = crossing(speed, 0.25);
        ContactSettings settings;
        settings.letter = letter;
        Contact contact(settings);
        for (int i = 0; i * speed * dt < 0.5; ++i) {
            if (contact.detect(s.bars, false, s.motion(), dt, i * dt) > 0) return i;
            s.move(dt);
        }
        return -1;
    };
    CHECK(steps_to_bind(50, 1e-5, true) > 0);
    CHECK(steps_to_bind(50, 1e-5, false) > 0);
    CHECK(steps_to_bind(1000, 3.5e-5, true) == -1);   // 35 mm a step: 0.25, 0.215, ... 0.005, -0.03
    CHECK(steps_to_bind(1000, 3.5e-5, false) == 7);   // found in the step that crosses
}

// ------------------------------------------------------------------------------------------------------------- broad phase

TEST_CASE("contact: boxes beyond all bounds, or of what is not a number, meet every other", "[contact]") {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
    std::vector<Box> boxes;
    for (int i = 0; i < 200; ++i) boxes.emplace_back(Vec3(10.0 * i, 0, 0), Vec3(10.0 * i + 1, 1, 1));
    boxes.emplace_back(Vec3(nan, nan, nan), Vec3(nan, nan, nan));
    boxes.emplace_back(Vec3(-inf, -inf, -inf), Vec3(inf, inf, inf));
    boxes.emplace_back(Vec3(-1e300, -1e300, 0), Vec3(1e300, 1e300, 1));
    const auto pairs = overlapping(boxes, [](int, int) { return true; });
    CHECK(pairs.size() == 3 * 200 + 3);
}

TEST_CASE("contact: overlapping boxes agree with testing every pair", "[contact]") {
    Dice dice(7);
    for (int round = 0; round < 60; ++round) {
        std::vector<Box> boxes(round < 3 ? round : 120);
        for (Box& box : boxes) {
            const Vec3 low = dice.vector(1).cwiseProduct(Vec3(round % 3 == 0 ? 0 : 3, 1, round % 2 ? 8 : 0.1));
            const Vec3 high = low + (round % 5 ? dice(0, 0.6) : 0) * Vec3::Ones() + (dice.vector(0.3) + 0.3 * Vec3::Ones());
            box = Box(low, high);
            CHECK((box.low.cast<double>().array() <= low.array()).all());
            CHECK((box.high.cast<double>().array() >= high.array()).all());
        }
        if (boxes.size() > 10) {
            boxes[5] = boxes[4];                       // the same box twice
            boxes[7].low = boxes[6].high;              // touching in a corner
            boxes[7].high = boxes[7].low + Eigen::Vector3f::Ones();
            boxes[9].high = boxes[9].low;              // a point
        }
        std::vector<IndexPair> expected;
        const auto wanted = [&](int a, int b) { return round % 4 != 0 || (a + b) % 3 != 0; };
        for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
            for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j)
                if (wanted(i, j) && (boxes[i].low.array() <= boxes[j].high.array()).all() && (boxes[j].low.array() <= boxes[i].high.array()).all())
                    expected.push_back({i, j});
        CHECK(overlapping(boxes, wanted) == expected);
    }
}

// ------------------------------------------------------------------------------------------------------------- gap element

TEST_CASE("contact: a bond's forces are the derivative of their energy", "[contact]") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const bool arms = seed % 2;
        // The nodes turn against each other as well: that must not matter, but for arms.
        Bound b = bound_pair(seed, 0.02, seed < 10 ? 0.05 : 1.0, 2.0, arms);
        const std::vector<Vec6> f = forces_of(b);
        double largest = 0;
        for (const Vec6& n : f) largest = std::max(largest, n.cwiseAbs().maxCoeff());
        const double h = 1e-5;
        for (int n = 0; n < 4; ++n)
            for (int k = 0; k < 6; ++k) {
                Bound up = nudged(b, n, k, h), down = nudged(b, n, k, -h);
                forces_of(up);
                forces_of(down);
                CHECK(f[n][k] == Approx((up.bond.energy - down.bond.energy) / (2 * h)).margin(1e-6 * largest));
            }
    }
}

TEST_CASE("contact: a bond's forces and moments balance", "[contact]") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Bound b = bound_pair(seed, 0.1, 0.5, 3.0, seed % 2);
        const std::vector<Vec6> f = forces_of(b);
        Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
        double size = 0;
        for (int n = 0; n < 4; ++n) {
            force += f[n].head<3>();
            moment += f[n].tail<3>() + b.x[n].cross(f[n].head<3>());
            size += f[n].norm();
        }
        CHECK(force.norm() < 1e-14 * size);
        CHECK(moment.norm() < 1e-14 * size * 5);
    }
}

TEST_CASE("contact: a bond that moves as one piece stores nothing", "[contact]") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Bound b = bound_pair(seed, 0.0, 0.0, pi, seed % 2);
        for (const Vec6& n : forces_of(b)) CHECK(n.norm() < 1e-11);
        CHECK(b.bond.energy < 1e-24);
    }
}

TEST_CASE("contact: a bond resists the same way whether or not the bars have passed each other", "[contact]") {
    // Crossing bars 0.2 mm apart. A gap that pulled along the line between nodes would flip as they pass.
    Bond bond;
    const std::vector<Vec3> start{{-0.5, 0, 0}, {0.4, 0, 0}, {0, -0.3, 2e-4}, {0, 0.6, 2e-4}};
    for (int i = 0; i < 4; ++i) bond.end[i].node = i;
    for (int g = 0; g < 4; ++g) bond.gap[g] = {start[gap_b(g)] - start[gap_a(g)], 1e9};
    bond.side = Vec3::UnitZ();
    bond.at[0] = 5.0 / 9;
    bond.at[1] = 1.0 / 3;
    // A node that spins does not loosen the bond.
    for (const Vec3& spin : {Vec3(0, 0, 0), Vec3(0.3, -0.2, 0.4)}) {
        std::vector<Quat> q(4, Quat::Identity());
        q[0] = q[3] = turned(spin, q[0]);
        for (double way : {0.0, 1e-4, 2e-4, 3e-4, 1e-3}) {
            std::vector<Vec3> x = start;
            x[2].z() -= way;
            x[3].z() -= way;
            std::vector<Vec6> f(4, Vec6::Zero());
            add_bond_forces(bond, x, q, f);
            // As one piece turns along a little with the shift, the force is below 4 k way, but not by much.
            CHECK(bond.energy <= 2e9 * way * way * (1 + 1e-6) + 1e-20);
            CHECK(bond.energy >= 1.7e9 * way * way);
            CHECK(bond.opening == Approx(-way).epsilon(0.2).margin(1e-15));
            CHECK(f[2][2] + f[3][2] <= -3.4e9 * way);
            for (const Vec6& n : f) CHECK(n.tail<3>().norm() == 0);
        }
    }
}

TEST_CASE("contact: bonds in degenerate positions", "[contact]") {
    struct Case {
        const char* name;
        Vec3 a0, a1, b0, b1;
    };
    const Case cases[] = {
        {"parallel, abreast", {0, 0, 0}, {1, 0, 0}, {0, 0, 0.05}, {1, 0, 0.05}},
        {"coincident", {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}},
        {"collinear, overlapping", {0, 0, 0}, {1, 0, 0}, {0.8, 0, 0}, {1.8, 0, 0}},
        {"collinear, end to end", {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}},
        {"an end on a side", {0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {0.5, 0, 1}},
        {"no length", {0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {0.5, 0, 0}},
        {"all one point", {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
    };
    for (const Case& c : cases) {
        INFO(c.name);
        Bond bond;
        const std::vector<Vec3> start{c.a0, c.a1, c.b0, c.b1};
        for (int i = 0; i < 4; ++i) bond.end[i].node = i;
        for (int g = 0; g < 4; ++g) bond.gap[g] = {start[gap_b(g)] - start[gap_a(g)], 1e9};
        Dice dice(11);
        for (double stretch : {0.0, 1e-6, 1e-3, 0.1, 3.0}) {
            std::vector<Vec3> x = start;
            std::vector<Quat> q(4, dice.turn(1));
            for (Vec3& p : x) p = q[0] * p + dice.vector(stretch);
            std::vector<Vec6> f(4, Vec6::Zero());
            add_bond_forces(bond, x, q, f);
            Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
            for (int n = 0; n < 4; ++n) {
                force += f[n].head<3>();
                moment += x[n].cross(f[n].head<3>());
            }
            const double size = 1e9 * (stretch + 1e-15) * 20;
            CHECK(force.norm() <= 1e-13 * size + 1e-6);
            CHECK(moment.norm() <= 1e-9 * size + 1e-6);
            CHECK(bond.energy <= 4 * 0.5e9 * 12 * stretch * stretch + 1e-15);
            add_bond_stiffness(bond, x, q, [](int, int, const Mat12& m) { CHECK(m.allFinite()); });
        }
    }
}

TEST_CASE("contact: the tangent is the derivative of the forces", "[contact]") {
    for (unsigned seed = 0; seed < 16; ++seed) {
        const bool arms = seed % 2, stub = seed >= 12;   // a stub: both ends of a bar on one node
        Bound b = bound_pair(seed, 0.05, 0.3, 2.0, arms || stub);
        if (stub) {
            // The end keeps its place; node 1, or node 3, is left alone.
            const int from = seed < 14 ? 1 : 3, to = from - 1;
            End& end = b.bond.end[from];
            end.arm = b.q[to].conjugate() * (b.x[from] + b.q[from] * end.arm - b.x[to]);
            end.node = to;
        }
        Eigen::MatrixXd k = Eigen::MatrixXd::Zero(24, 24), d = k;
        add_bond_stiffness(b.bond, b.x, b.q, [&](int p, int r, const Mat12& m) {
            CHECK(p != r);
            CHECK((m - m.transpose()).cwiseAbs().maxCoeff() == 0);
            const int node[2] = {p, r};
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j) k.block<6, 6>(6 * node[i], 6 * node[j]) += m.block<6, 6>(6 * i, 6 * j);
        });
        const double h = 1e-5;
        for (int n = 0; n < 4; ++n)
            for (int c = 0; c < 6; ++c) {
                Bound up = nudged(b, n, c, h), down = nudged(b, n, c, -h);
                const std::vector<Vec6> fu = forces_of(up), fd = forces_of(down);
                for (int i = 0; i < 4; ++i) d.block<6, 1>(6 * i, 6 * n + c) = (fu[i] - fd[i]) / (2 * h);
            }
        // Moments about fixed axes make the derivative of an arm's moment lopsided; its symmetric part is the tangent.
        if (!arms && !stub) CHECK((d - d.transpose()).cwiseAbs().maxCoeff() < 1e-6 * k.cwiseAbs().maxCoeff());
        const double error = (k - 0.5 * (d + d.transpose())).cwiseAbs().maxCoeff();
        INFO("seed " << seed << " error " << error << " of " << k.cwiseAbs().maxCoeff());
        CHECK(error <= 1e-6 * k.cwiseAbs().maxCoeff());
    }
}

TEST_CASE("contact: stiffness of a gap element", "[contact]") {
    CHECK(gap_stiffness(2e8, 2e8, 0.5, 0.1) == Approx(4e8));
    CHECK(gap_stiffness(2e8, 2e8, 1e-6, 0.1) == Approx(2e9));          // floored
    CHECK(gap_stiffness(1e8, 1e12, 1, 0.1) == Approx(2e8).epsilon(1e-3));   // the softer bar rules
}

// ------------------------------------------------------------------------------------------------------- the rule at work

TEST_CASE("contact: members crossing at their mid nodes bind up to four element pairs", "[contact]") {
    for (double angle : {90.0, 45.0, 10.0}) {
        Scene s = crossing(50, 2e-4, angle * pi / 180);
        // First seen apart, else they would count as joined.
        for (int n = 3; n < 6; ++n) s.x[n].z() += 0.1;
        Contact contact{ContactSettings()};
        CHECK(contact.detect(s.bars, false, s.motion(), 1e-6, 0) == 0);
        for (int n = 3; n < 6; ++n) s.x[n].z() -= 0.1;
        // Halves that point away from each other by more than 106 degrees are too long for eq 18: two of the four at 45 degrees.
        const std::vector<std::pair<int, int>> all{{0, 2}, {0, 3}, {1, 2}, {1, 3}}, near{{0, 2}, {1, 3}};
        const auto& pairs = angle > 74 ? all : near;
        CHECK(contact.detect(s.bars, false, s.motion(), 1e-5, 1e-5) == static_cast<int>(pairs.size()));
        REQUIRE(contact.bonds().size() == pairs.size());
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            CHECK(contact.bonds()[i].element[0] == pairs[i].first);
            CHECK(contact.bonds()[i].element[1] == pairs[i].second);
            CHECK(contact.bonds()[i].side.z() == Approx(1));
            for (const Gap& gap : contact.bonds()[i].gap) CHECK(gap.stiffness <= 5e8 / 0.25 * (1 + 1e-12));
        }
        int added = 0;
        contact.add_stiffness(s.x, s.q, [&](int, int, const Mat12&) { ++added; });
        CHECK(added == 6 * static_cast<int>(pairs.size()));
        s.forces(contact);
        CHECK(contact.stored_energy() == 0);
        CHECK_FALSE(contact.idle());
        CHECK(contact.events().size() == pairs.size());
        CHECK(contact.counts().bound == static_cast<long>(pairs.size()));
    }
}

TEST_CASE("contact: detect finds fast crossings at any speed, step and angle", "[contact]") {
    Dice dice(8);
    for (double speed : {50.0, 122.0, 1000.0})
        for (double dt : {1e-5, 1e-4, 1e-3})
            for (double angle : {90.0, 70.0, 45.0, 20.0, 1.0}) {
                // Over each other at any place of both members.
                const double rad = angle * pi / 180, along_a = dice(-0.45, 0.45), along_b = dice(-0.45, 0.45);
                const Vec3 offset(along_a - along_b * std::cos(rad), -along_b * std::sin(rad), 0);
                Scene s = crossing(speed, 0.25 + dice(0, 1) * speed * dt, rad, offset);
                Contact contact{ContactSettings()};
                int bound = 0;
                for (int i = 0; bound == 0 && s.x[3].z() > -0.1; ++i) {
                    bound = contact.detect(s.bars, false, s.motion(), dt, i * dt);
                    s.move(dt);
                }
                INFO(speed << " m/s, dt " << dt << ", " << angle << " degrees, at " << along_a << " and " << along_b);
                CHECK(bound > 0);
            }
}

TEST_CASE("contact: bars that part or stay are left alone", "[contact]") {
    for (double speed : {-50.0, 0.0}) {
        Scene s = crossing(speed, 0.06);
        Contact contact{ContactSettings()};
        for (int i = 0; i < 20; ++i) {
            CHECK(contact.detect(s.bars, false, s.motion(), 1e-4, i * 1e-4) == 0);
            s.move(1e-4);
        }
    }
}

TEST_CASE("contact: bars that share a node or are joined when first seen never bind, until they have parted", "[contact]") {
    // A brace through a brace, in touch; a third bar shares a node with the first.
    Scene s;
    const int a = s.node({-1, 0, 0}), b = s.node({1, 0, 0}), c = s.node({0, -1, 0.01}), d = s.node({0, 1, 0.01}), e = s.node({1, 0.04, 1});
    s.bar(a, b);
    s.bar(c, d);
    s.bar(b, e);
    Contact contact{ContactSettings()};
    double time = 0;
    const auto step = [&](const Vec3& velocity, int steps) {
        int bound = 0;
        s.v[c].head<3>() = s.v[d].head<3>() = velocity;
        for (int i = 0; i < steps; ++i, time += 1e-4) {
            bound += contact.detect(s.bars, false, s.motion(), 1e-4, time);
            s.move(1e-4);
        }
        return bound;
    };
    CHECK(step({0, 0, -10}, 30) == 0);  // through, 20 mm beyond
    CHECK(step({0, 0, 10}, 40) == 0);   // and back
    CHECK(step({0, 0, 10}, 60) == 0);   // apart by more than the sum of the half depths
    CHECK(step({0, 0, -10}, 100) == 1); // now it is contact
}

TEST_CASE("contact: a broken element's stub is a new bar, joined to what it touches", "[contact]") {
    // Elements 0: nodes 0-1, 1: nodes 1-2. Element 0 breaks at node 1 and hangs on node 0 with an arm.
    Scene s;
    const int n0 = s.node({0, 0, 0}), n1 = s.node({1, 0, 0}), n2 = s.node({2, 0, 0});
    s.bar(n0, n1);
    s.bar(n1, n2);
    ContactSettings settings;
    settings.reach = infinite;
    Contact contact(settings);
    contact.detect(s.bars, false, s.motion(), 1e-4, 0);
    s.bars[0].node[1] = n0;
    s.bars[0].arm = Vec3(1, 0, 0);
    s.v[n0].head<3>() = Vec3(1, 0, 0);
    for (int i = 0; i < 50; ++i) {
        CHECK(contact.detect(s.bars, i == 0, s.motion(), 1e-4, i * 1e-4) == 0);
        s.move(1e-4);
    }
    // The stub swings away about its node by half a turn a second, and back: it has parted, and meets the other bar.
    s.v[n0] << 0, 0, 0, 0, 0, 100;
    for (int i = 0; i < 10; ++i) {
        CHECK(contact.detect(s.bars, false, s.motion(), 1e-3, 0) == 0);
        s.move(1e-3);
    }
    s.v[n0] << 0, 0, 0, 0, 0, -100;
    int bound = 0;
    for (int i = 0; i < 12 && bound == 0; ++i) {
        bound = contact.detect(s.bars, false, s.motion(), 1e-3, 0);
        s.move(1e-3);
    }
    CHECK(bound == 1);
    CHECK(contact.bonds().front().end[1].arm.x() == 1);
    CHECK(contact.bonds().front().end[1].node == n0);
}

TEST_CASE("contact: the candidate list changes nothing", "[contact]") {
    // A swarm of bars with changing velocities. The reference looks at every pair in every step, with nothing kept but the side.
    for (bool letter : {false, true}) {
        Dice dice(letter ? 9 : 10);
        ContactSettings settings;
        settings.letter = letter;
        settings.flatness = letter ? 3e-3 : 3e-4;
        settings.binding_time = 1e9;
        Scene s;
        for (int i = 0; i < 60; ++i) {
            const Vec3 at = dice.vector(1.2), d = dice(0.4, 1) * dice.direction();
            s.bar(s.node(at), s.node(at + d), dice(0.02, 0.05));
        }
        Contact contact(settings);
        std::map<std::pair<int, int>, Vec3> side;
        std::map<std::pair<int, int>, int> state;  // 0 unseen, 1 free, 2 joined, 3 bound
        const double dt = 1e-4;
        std::size_t total = 0;
        for (int step = 0; step < 600; ++step) {
            for (std::size_t n = 0; n < s.v.size(); n += 2)
                if (step % 20 == 0) {
                    const Vec3 v = dice.vector(20) - 3 * s.x[n];
                    s.v[n].head<3>() = v + dice.vector(3);
                    s.v[n + 1].head<3>() = v + dice.vector(3);
                }
            std::vector<std::pair<int, int>> expected;
            for (int i = 0; i < 60; ++i)
                for (int j = i + 1; j < 60; ++j) {
                    const Two two{{s.x[2 * i], s.x[2 * i + 1]}, {s.x[2 * j], s.x[2 * j + 1]}};
                    const Closest c = closest_points(two);
                    const double touch = s.bars[i].radius + s.bars[j].radius;
                    Vec3& way = side.try_emplace({i, j}, Vec3::Zero()).first->second;
                    int& is = state[{i, j}];
                    const bool near = letter ? within_reach(two, settings.reach) : c.distance <= touch;
                    if (is == 0) is = near && (c.distance <= touch || flat(two, settings.flatness)) ? 2 : 1;
                    if (is == 2 && !near) is = 1;
                    if (c.distance > touch || c.between.dot(way) > 0) way = c.between.normalized();
                    if (is != 1) continue;
                    const Moving m{two, {{dt * s.v[2 * i].head<3>(), dt * s.v[2 * i + 1].head<3>()},
                                         {dt * s.v[2 * j].head<3>(), dt * s.v[2 * j + 1].head<3>()}}};
                    const RuleNumbers numbers{settings.reach, settings.flatness, touch};
                    const Meeting meeting = letter ? letter_meeting(m, c, way, numbers) : first_meeting(m, c, way, numbers);
                    if (meeting.found) {
                        is = 3;
                        expected.push_back({i, j});
                    }
                }
            const std::size_t before = contact.bonds().size();
            const int bound = contact.detect(s.bars, false, s.motion(), dt, step * dt);
            REQUIRE(bound == static_cast<int>(expected.size()));
            for (std::size_t k = 0; k < expected.size(); ++k) {
                CHECK(contact.bonds()[before + k].element[0] == expected[k].first);
                CHECK(contact.bonds()[before + k].element[1] == expected[k].second);
            }
            total += expected.size();
            s.move(dt);
        }
        CHECK(total > 12);
        CHECK(contact.counts().list_builds < (letter ? 200 : 120));
        if (!letter) CHECK(contact.counts().pair_tests < 600 * 60 * 59 / 2 / 50);
    }
}

TEST_CASE("contact: the order of the bars does not matter", "[contact]") {
    Scene s = crossing(122, 0.2, 1.0, {0.03, 0.02, 0});
    Scene shuffled = s;
    std::reverse(shuffled.bars.begin(), shuffled.bars.end());
    std::swap(shuffled.bars[0], shuffled.bars[2]);
    Contact one{ContactSettings()}, two{ContactSettings()};
    for (int i = 0; i < 300; ++i) {
        CHECK(one.detect(s.bars, false, s.motion(), 1e-5, i * 1e-5) == two.detect(shuffled.bars, false, shuffled.motion(), 1e-5, i * 1e-5));
        s.move(1e-5);
        shuffled.move(1e-5);
    }
    REQUIRE(one.bonds().size() == two.bonds().size());
    REQUIRE(one.bonds().size() > 0);
    for (std::size_t i = 0; i < one.bonds().size(); ++i) {
        CHECK(one.bonds()[i].element[0] == two.bonds()[i].element[0]);
        CHECK(one.bonds()[i].element[1] == two.bonds()[i].element[1]);
        CHECK(one.bonds()[i].gap[3].rest == two.bonds()[i].gap[3].rest);
    }
}

TEST_CASE("contact: nothing near, next to nothing done", "[contact]") {
    Scene s = crossing(10, 5.0);
    Contact contact{ContactSettings()};
    for (int i = 0; i < 10000; ++i) {
        contact.detect(s.bars, false, s.motion(), 1e-5, i * 1e-5);
        s.move(1e-5);
    }
    CHECK(contact.counts().pair_tests == 0);
    CHECK(contact.counts().list_builds < 110);
    CHECK(contact.candidates() == 0);
    // No bars, one bar, and a motion that is not finite are no reason to fall over.
    const std::vector<Bar> none, one(s.bars.begin(), s.bars.begin() + 1);
    CHECK(contact.detect(none, true, s.motion(), 1e-5, 1) == 0);
    CHECK(contact.detect(one, true, s.motion(), 1e-5, 1) == 0);
    s.v[0][0] = std::numeric_limits<double>::quiet_NaN();
    CHECK(contact.detect(s.bars, true, s.motion(), 1e-5, 1) == 0);
    s.v[0][0] = 0;
    s.x[0][1] = infinite;
    CHECK(contact.detect(s.bars, false, s.motion(), 1e-5, 1) == 0);
}

TEST_CASE("contact: to the letter without eq 18, every flat pair that approaches", "[contact]") {
    Scene s = crossing(50, 1.0);
    ContactSettings settings;
    settings.letter = true;
    settings.reach = infinite;
    Contact contact(settings);
    CHECK(contact.detect(s.bars, false, s.motion(), 1e-5, 0) == 0);
    for (int n = 3; n < 6; ++n) s.x[n].z() = 1e-3;
    CHECK(contact.detect(s.bars, false, s.motion(), 1e-5, 0) == 4);
}

// ----------------------------------------------------------------------------------------------------------- letting go

namespace {

/// A pair of crossing bars bound at time 0, and what a test wants to do with it.
struct Held {
    Scene s;
    Contact contact;

    explicit Held(ContactSettings settings = ContactSettings()) : s(crossing(50, 0.06)), contact(settings) {
        contact.detect(s.bars, false, s.motion(), 1e-6, -1);
        for (int n = 3; n < 6; ++n) s.x[n].z() = 2e-4;
        REQUIRE(contact.detect(s.bars, false, s.motion(), 1e-5, 0) == 4);
    }
    /// The upper member at height z; what is let go at time t.
    double at(double t, double z) {
        for (int n = 3; n < 6; ++n) s.x[n].z() = z;
        s.forces(contact);
        return contact.release(t);
    }
};

}  // namespace

TEST_CASE("contact: cut at the binding time, whatever the bond carries", "[contact]") {
    ContactSettings settings;
    settings.hold_until_parting = false;
    Held held(settings);
    CHECK(held.at(0.3e-3, -1e-3) == 0);
    CHECK(held.contact.bonds().size() == 4);
    const double stored = held.contact.stored_energy();
    CHECK(stored > 0);
    CHECK(held.at(0.5e-3, -1e-3) == Approx(stored));
    CHECK(held.contact.idle());
    CHECK(held.contact.counts().released == 4);
    CHECK(held.contact.counts().energy_let_go == Approx(stored));
    CHECK(held.contact.stored_energy() == 0);
    CHECK(held.contact.events().size() == 8);
    CHECK_FALSE(held.contact.events().back().bound);
}

TEST_CASE("contact: held until the bars part and the energy is low", "[contact]") {
    SECTION("not while pressing on, at the bottom of a swing of the energy") {
        Held held;
        held.at(0.1e-3, -3e-3);                    // pressed in
        CHECK(held.at(0.6e-3, -2e-3) == 0);        // coming back: falling
        CHECK(held.at(0.7e-3, -0.5e-3) == 0);
        const double out = held.at(0.8e-3, 1e-3);  // past the rest position, outwards, rising again: let go
        CHECK(held.contact.idle());
        CHECK(out > 0);
    }
    SECTION("nothing left in it") {
        Held held;
        held.at(0.1e-3, -3e-3);
        held.at(0.6e-3, -2e-3);
        held.at(0.7e-3, 2e-4);
        CHECK(held.contact.idle());
    }
    SECTION("passing the rest position inwards is no parting") {
        Held held;
        held.at(0.1e-3, 3e-3);
        held.at(0.6e-3, 2e-3);
        CHECK(held.at(0.7e-3, 2e-4) == 0);
        CHECK_FALSE(held.contact.idle());
    }
    SECTION("a high minimum is no end") {
        Held held;
        held.at(0.1e-3, -3e-3);
        held.at(0.6e-3, -2.0e-3);
        held.at(0.7e-3, -2.1e-3);
        held.at(0.8e-3, -2.0e-3);
        held.at(0.9e-3, -2.2e-3);
        CHECK(held.contact.bonds().size() == 4);
    }
    SECTION("not for ever") {
        Held held;
        held.at(0.1e-3, -3e-3);
        CHECK(held.at(9.99e-3, -3.1e-3) == 0);
        CHECK(held.at(10e-3, -3.2e-3) > 0);
        CHECK(held.contact.idle());
    }
}

TEST_CASE("contact: after a release a pair binds again only when it approaches, seen from the side it came from", "[contact]") {
    ContactSettings settings;
    settings.hold_until_parting = false;
    for (double z : {-2e-3, 2e-4}) {  // let go after it has passed through a little, or not
        Held held(settings);
        held.at(0.5e-3, z);
        REQUIRE(held.contact.idle());
        for (int n = 3; n < 6; ++n) held.s.v[n][2] = 5;  // back up: parting, though |f| may fall
        for (int i = 0; i < 5; ++i) {
            CHECK(held.contact.detect(held.s.bars, false, held.s.motion(), 1e-4, 0) == 0);
            held.s.move(1e-4);
        }
        held.at(0.5e-3, z);
        for (int n = 3; n < 6; ++n) held.s.v[n][2] = -5;  // down: on through
        CHECK(held.contact.detect(held.s.bars, false, held.s.motion(), 1e-4, 0) == 4);
        CHECK(held.contact.bonds().front().side.z() == Approx(1));
    }
}

TEST_CASE("contact: a falling bar does not tunnel, and its energy comes back", "[contact]") {
    // Each node of the falling member is a mass; the lower member does not move. Small explicit steps: nothing but the bond.
    for (bool hold : {true, false}) {
        ContactSettings settings;
        settings.hold_until_parting = hold;
        Scene s;
        s.member({-0.5, 0, 0}, {0.5, 0, 0}, 1);
        s.member({-0.1, -0.6, 0.06}, {0.2, 0.4, 0.06}, 1, {0, 0, -20});
        Contact contact(settings);
        const double dt = 2e-6, mass = 5, inertia = 0.05;
        double let_go = 0, worst = 0, lowest = 1;
        const double begin = 2 * 0.5 * mass * 400;
        for (int step = 0; step < 20000; ++step) {
            let_go += contact.release(step * dt);
            contact.detect(s.bars, false, s.motion(), dt, step * dt);
            for (int half = 0; half < 2; ++half) {
                const std::vector<Vec6> f = s.forces(contact);
                for (int n = 2; n < 4; ++n) {
                    s.v[n].head<3>() -= 0.5 * dt / mass * f[n].head<3>();
                    s.v[n].tail<3>() -= 0.5 * dt / inertia * f[n].tail<3>();
                }
                if (half == 0) s.move(dt);
            }
            double energy = contact.stored_energy() + let_go;
            for (int n = 2; n < 4; ++n)
                energy += 0.5 * mass * s.v[n].head<3>().squaredNorm() + 0.5 * inertia * s.v[n].tail<3>().squaredNorm();
            worst = std::max(worst, std::abs(energy / begin - 1));
            lowest = std::min(lowest, closest_points(s.x[0], s.x[1], s.x[2], s.x[3]).between.z());
        }
        INFO("hold " << hold << ", let go " << let_go / begin << ", lowest " << lowest << ", bound " << contact.counts().bound);
        CHECK(contact.counts().bound > 0);
        CHECK(contact.idle());
        CHECK(worst < 0.02);
        CHECK(lowest > -0.02);
        CHECK(s.x[2].z() + s.x[3].z() > 0.12);
        if (hold) CHECK(let_go < 0.15 * begin);
    }
}

TEST_CASE("contact: a broken element loses its bonds, not its memory", "[contact]") {
    Held held;
    held.at(0.1e-3, -1e-3);
    const double all = held.contact.stored_energy(), part = held.contact.drop(2);
    CHECK(part > 0);
    CHECK(held.contact.bonds().size() == 2);
    CHECK(held.contact.stored_energy() == Approx(all - part));
    CHECK(held.contact.counts().dropped == 2);
    CHECK(held.contact.drop(2) == 0);
    // What is left of element 2 hangs on node 4 (its far end went): it is bound again while it presses on.
    contact::Bar& stub = held.s.bars[2];
    stub.node[0] = stub.node[1] = 4;
    stub.arm = held.s.x[3] - held.s.x[4];
    CHECK(held.contact.detect(held.s.bars, true, held.s.motion(), 1e-5, 0.1e-3) == 2);
    CHECK(held.contact.bonds().back().side.z() == Approx(1));
}

// -------------------------------------------------------------------------------------------------------------- snapshots

namespace {

std::string record(const Contact& c) {
    std::string bytes;
    Writer{bytes}(c);
    return bytes;
}

}  // namespace

TEST_CASE("contact: a copy and a saved record continue with the same bits", "[contact]") {
    const auto run = [](Scene& s, Contact& contact, int from, int to) {
        for (int i = from; i < to; ++i) {
            contact.detect(s.bars, i == 0, s.motion(), 1e-5, i * 1e-5);
            const std::vector<Vec6> f = s.forces(contact);
            for (std::size_t n = 3; n < s.v.size(); ++n) {
                s.v[n].head<3>() -= 1e-5 / 50 * f[n].head<3>();
                s.v[n].tail<3>() -= 1e-5 / 50 * f[n].tail<3>();
            }
            s.move(1e-5);
            s.forces(contact);
            contact.release((i + 1) * 1e-5);
        }
    };
    Scene s = crossing(80, 0.1, 0.8, {0.1, 0.05, 0});
    Contact contact{ContactSettings()};
    run(s, contact, 0, 150);
    REQUIRE_FALSE(contact.idle());
    Scene s2 = s, s3 = s;
    Contact copy = contact, read{ContactSettings()};
    const std::string bytes = record(contact);
    Reader reader{bytes};
    reader(read);
    CHECK(reader.rest().empty());
    const int nodes = int(s.x.size()), bars = int(s.bars.size());
    int elements = 0;
    for (const contact::Bar& bar : s.bars) elements = std::max(elements, bar.element + 1);
    CHECK(read.makes_sense(nodes, elements, bars));
    CHECK_FALSE(read.makes_sense(nodes - 1, elements, bars));
    CHECK_FALSE(read.makes_sense(nodes, elements - 1, bars));
    CHECK_FALSE(read.makes_sense(nodes, elements, bars - 1));

    run(s, contact, 150, 600);
    run(s2, copy, 150, 600);
    run(s3, read, 150, 600);
    CHECK(record(contact) == record(copy));
    CHECK(record(contact) == record(read));
    CHECK(contact.counts().released > 0);
    for (std::size_t n = 0; n < s.x.size(); ++n) CHECK((s.x[n] == s2.x[n] && s.x[n] == s3.x[n]));

    for (std::size_t size = 0; size < bytes.size(); ++size) {  // cut short anywhere
        Contact half{ContactSettings()};
        Reader cut{std::string_view(bytes).substr(0, size)};
        CHECK_THROWS_AS(cut(half), Damaged);
    }
}

TEST_CASE("contact: a step that is taken back leaves every byte as it was, and the next one goes on as if it had not been", "[contact]") {
    for (const ContactRuleKind rule : {ContactRuleKind::gap, ContactRuleKind::surface}) {
        ContactSettings settings;
        settings.rule = rule;
        const auto step = [](Scene& s, Contact& contact, int i) {
            contact.detect(s.bars, i == 0 || i == 300, s.motion(), 1e-5, i * 1e-5);
            const std::vector<Vec6> f = s.forces(contact);
            for (std::size_t n = 3; n < s.v.size(); ++n) s.v[n].head<3>() -= 1e-5 / 50 * f[n].head<3>();
            s.move(1e-5);
            s.forces(contact);
            contact.release((i + 1) * 1e-5);
            std::vector<Vec6> impulse(s.x.size(), Vec6::Zero());
            contact.settle((i + 1) * 1e-5, 1e-5, s.x, s.q, impulse);
            if (i == 300) contact.drop(0);
        };
        Scene straight = crossing(80, 0.1, 0.8, {0.1, 0.05, 0}), s = straight;
        Contact steady{settings}, contact{settings};
        int differs = 0, bound = 0;
        for (int i = 0; i < 600; ++i) {
            const std::string before = record(contact);
            const Scene here = s;
            contact.remember();
            step(s, contact, i);
            differs += record(contact) != before;
            contact.take_back();
            CHECK(record(contact) == before);
            s = here;
            step(s, contact, i);
            contact.forget();
            step(straight, steady, i);
            bound += !contact.idle();
        }
        CHECK(differs == 600);
        CHECK(bound > 0);
        CHECK(contact.counts().list_builds > 1);
        CHECK(record(contact) == record(steady));
    }
}

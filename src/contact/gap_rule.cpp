#include "contact/gap_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hinge::contact {

double coplanarity(const BarPair& two) {
    const Vec3 &a1 = two.a[0], &a2 = two.a[1], &b1 = two.b[0], &b2 = two.b[1];
    return (b1 - a2).cross(b2 - a2).dot(a1 - a2);  // eq 17
}

double spread(const BarPair& two) {
    return (two.b[0] - two.a[0]).norm() + (two.b[1] - two.a[0]).norm() + (two.b[0] - two.a[1]).norm() +
           (two.b[1] - two.a[1]).norm();
}

namespace {

double lengths(const BarPair& two) { return (two.a[1] - two.a[0]).norm() + (two.b[1] - two.b[0]).norm(); }

// Rounding of f for bars of these lengths: parallel bars must count as coplanar even when alpha is zero. Of 80 runs of
// contacts in tests/hard, 8 to 256 times a scene's step, one ends in other bits at 0, none at 1e-10.
double coplanarity_noise(const BarPair& two) {
    const double l = lengths(two);
    return 1e-13 * l * l * l;
}

}  // namespace

// Eq 18.
bool within_contact_length(const BarPair& two, double contact_length) {
    return std::isinf(contact_length) || spread(two) <= contact_length * lengths(two);
}

// Eq 19. Its f has the sign of the side of a's second end on which b lies, by the order of their ends.
bool coplanar(const BarPair& two, double alpha, bool signed_f) {
    const double f = coplanarity(two);
    return (signed_f ? f : std::abs(f)) <= alpha + coplanarity_noise(two);
}

BarPair Moving::at(double tau) const {
    BarPair two;
    for (int i = 0; i < 2; ++i) {
        two.a[i] = start.a[i] + tau * move.a[i];
        two.b[i] = start.b[i] + tau * move.b[i];
    }
    return two;
}

double Moving::closing_bound() const {
    // The relative motion of any two points is a mean of the four relative motions of ends.
    return std::sqrt(std::max(std::max((move.b[0] - move.a[0]).squaredNorm(), (move.b[1] - move.a[0]).squaredNorm()),
                              std::max((move.b[0] - move.a[1]).squaredNorm(), (move.b[1] - move.a[1]).squaredNorm())));
}

// f = e . (da x db), each of the three linear in tau; e joins the two middles, so that cancellation is least.
Cubic coplanarity_over(const Moving& moving) {
    const BarPair &x = moving.start, &u = moving.move;
    const Vec3 a0 = x.a[1] - x.a[0], a1 = u.a[1] - u.a[0];
    const Vec3 b0 = x.b[1] - x.b[0], b1 = u.b[1] - u.b[0];
    const Vec3 e0 = 0.5 * ((x.b[0] - x.a[0]) + (x.b[1] - x.a[1]));
    const Vec3 e1 = 0.5 * ((u.b[0] - u.a[0]) + (u.b[1] - u.a[1]));
    const Vec3 n0 = a0.cross(b0), n1 = a1.cross(b0) + a0.cross(b1), n2 = a1.cross(b1);
    return {{e0.dot(n0), e1.dot(n0) + e0.dot(n1), e1.dot(n1) + e0.dot(n2), e1.dot(n2)}};
}

namespace {

// Parts of [0, 1] on which p is monotone: their borders, 0 and 1 included. Returns the number of borders.
int monotone_borders(const Cubic& p, double border[4]) {
    int n = 0;
    border[n++] = 0;
    const double a = 3 * p.c[3], b = 2 * p.c[2], c = p.c[1];
    double root[2];
    int roots = 0;
    const double discriminant = b * b - 4 * a * c;
    if (discriminant >= 0) {
        const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
        if (q != 0) root[roots++] = c / q;
        if (a != 0) root[roots++] = q / a;
    }
    if (roots == 2 && root[0] > root[1]) std::swap(root[0], root[1]);
    for (int i = 0; i < roots; ++i)
        if (root[i] > border[n - 1] && root[i] < 1) border[n++] = root[i];
    border[n++] = 1;
    return n;
}

// Where a monotone p takes `value` between from and to, which lie on its two sides: Newton, kept inside by bisection.
double root_of(const Cubic& p, double value, double from, double to) {
    const bool rising = p(to) > p(from);
    double tau = 0.5 * (from + to);
    for (int i = 0; i < 80 && to - from > 1e-15; ++i) {
        const double h = p(tau) - value;
        if (h == 0) return tau;
        ((h > 0) == rising ? to : from) = tau;
        const double slope = p.slope(tau), next = slope != 0 ? tau - h / slope : from;
        if (next > from && next < to) {
            if (std::abs(next - tau) < 1e-15) return next;
            tau = next;
        } else {
            tau = 0.5 * (from + to);
        }
    }
    return tau;
}

}  // namespace

int spans_between(const Cubic& p, double lo, double hi, Span out[3]) {
    double border[4];
    const int borders = monotone_borders(p, border);
    int n = 0;
    for (int i = 0; i + 1 < borders; ++i) {
        double from = border[i], to = border[i + 1];
        const double at_from = p(from), at_to = p(to);
        if (std::max(at_from, at_to) < lo || std::min(at_from, at_to) > hi) continue;
        const double x = border[i], y = border[i + 1];
        if (at_from < lo) from = root_of(p, lo, x, y);
        if (at_from > hi) from = root_of(p, hi, x, y);
        if (at_to < lo) to = root_of(p, lo, x, y);
        if (at_to > hi) to = root_of(p, hi, x, y);
        out[n++] = {from, std::max(from, to)};
    }
    return n;
}

Approach approach(const Moving& moving, const BarPair& now, const Closest& closest, const Vec3& normal,
                  double contact_distance) {
    const double s = closest.s, t = closest.t;
    const Vec3 relative =
        (1 - t) * moving.move.b[0] + t * moving.move.b[1] - (1 - s) * moving.move.a[0] - s * moving.move.a[1];
    const double cutting = 1e-6 * contact_distance + 1e-9 * lengths(now);
    const bool known = closest.distance > cutting && closest.between.dot(normal) >= 0;
    const Vec3 direction = known ? Vec3(closest.between / closest.distance) : normal;
    return {-relative.dot(direction), direction};
}

Meeting first_meeting(const Moving& moving, const Closest& begin, const Vec3& normal, const RuleNumbers& numbers) {
    const double infinite = std::numeric_limits<double>::infinity();
    const double contact_distance = numbers.contact_distance, bound = moving.closing_bound();
    if (begin.distance - bound > contact_distance) return {};

    // A pair that was in contact already may have passed through a little without a tie (or when a tie was released).
    // Then the sign of f tells on which side b is: it is that of a x b along `normal`. Everything beyond the band of eq
    // 19 on the far side counts as coplanar too. In one plane (a x b and `normal` at a right angle) f tells no side,
    // and the band has two limits.
    const Cubic f = coplanarity_over(moving);
    const double alpha = numbers.alpha + coplanarity_noise(moving.start);
    const Vec3 across = (moving.start.a[1] - moving.start.a[0]).cross(moving.start.b[1] - moving.start.b[0]);
    const double along = across.dot(normal), half = 0.5 * across.norm();
    double lo = -alpha, hi = alpha;
    if (begin.distance <= contact_distance && along > half) lo = -infinite;
    if (begin.distance <= contact_distance && along < -half) hi = infinite;

    Span spans[3];
    const int n = spans_between(f, lo, hi, spans);
    if (n == 0) return {};

    // Inside a span nothing but distances counts. They change no faster than `bound` per step, so what is missing says
    // how far ahead the next look may be (conservative advancement); the least stride bounds the work when bars slide
    // along each other. From 1e-3 to 1 of the contact distance and from 1/16 to 1e-6 of the step the scenes of
    // tests/hard, at up to 256 times their step, find the same contacts; at a whole step bars pass through each other
    // at 1000 m/s. The first 0.06 s of Case I take 64 % more looks with 1e-3 of the contact distance, 5 % fewer with
    // 0.1.
    const double least = std::max(1.0 / 256, std::min(1.0, 0.01 * contact_distance / std::max(bound, 1e-300)));
    const double stretch = (moving.move.a[1] - moving.move.a[0]).norm() + (moving.move.b[1] - moving.move.b[0]).norm();
    for (int i = 0; i < n; ++i) {
        double tau = spans[i].from;
        while (true) {
            const BarPair now = moving.at(tau);
            const Closest closest = tau == 0 ? begin : closest_points(now);
            double wait = (closest.distance - contact_distance) / bound;
            if (!std::isinf(numbers.contact_length)) {
                const double beyond = spread(now) - numbers.contact_length * lengths(now);
                if (beyond > 0) wait = std::max(wait, beyond / (4 * bound + numbers.contact_length * stretch));
            }
            if (!(wait > 1e-12)) {  // rounding, here and in the next; 1e-8 gives tests/hard the same bits
                const Approach found = approach(moving, now, closest, normal, contact_distance);
                if (found.rate > 1e-12 * contact_distance) return {true, tau, closest.s, closest.t, found.direction};
            }
            if (tau >= spans[i].to) break;
            tau = std::min(spans[i].to, tau + std::max(wait, least));
        }
    }
    return {};
}

Meeting printed_meeting(const Moving& moving, const Closest& begin, const Vec3& normal, const RuleNumbers& numbers) {
    const BarPair& now = moving.start;
    if (!within_contact_length(now, numbers.contact_length) || !coplanar(now, numbers.alpha, numbers.signed_f))
        return {};
    const Approach found = approach(moving, now, begin, normal, 0);
    if (!(found.rate > 1e-12 * lengths(now))) return {};
    return {true, 0, begin.s, begin.t, found.direction};
}

}  // namespace hinge::contact

// Touches (rule `surface`): forces against the derivative of their energy, balance, tangent, friction, what a step
// misses.

#include "contact/shared_spring.h"
#include "contact_parts.h"

using namespace hinge;
using namespace hinge::contact;

namespace {

/// Two bars that press on each other, in a position of the kind asked for; one may be broken and follow one node.
struct Pressed {
    std::vector<Vec3> x;
    std::vector<Quat> q;
    SurfaceContact contact;

    Pressed(Dice& dice, Nearness kind, bool broken, double friction = 0) {
        const Quat all = dice.rotation();
        const double angle = kind == Nearness::crossing ? dice(0.3, 1.2) : dice(0.7, 1.2),
                     at = kind == Nearness::crossing ? 0.2 : 1.0;
        const Vec3 along(std::cos(angle), std::sin(angle), dice(-0.05, 0.05)), middle(0.1, 0, 0.045);
        const Vec3 b1 = kind == Nearness::crossing ? Vec3(middle - at * along) : Vec3(middle + 0.01 * along);
        const Vec3 place[4] = {{-0.5, 0, 0}, {0.6, 0.02, 0}, b1, middle + 0.8 * along};
        for (int i = 0; i < 4; ++i) {
            x.push_back(all * place[i]);
            q.push_back(dice.rotation());
            contact.end[i].node = i;
        }
        if (broken) {  // b follows node 2; node 3 is left alone
            contact.end[3] = {2, q[2].conjugate() * (x[3] - x[2])};
            x[3] += dice.vector(1);
        }
        contact.radius[0] = 0.03;
        contact.radius[1] = 0.02;
        contact.stiffness = 1e6;
        contact.friction = friction;
        contact.normal_before = (all * Vec3(0.1, -0.2, 1)).normalized();
        update();
    }
    void update() { contact::update(contact, x, q); }
    std::vector<Vec6> forces() {
        update();
        std::vector<Vec6> f(4, Vec6::Zero());
        add_contact_forces(contact, q, f);
        return f;
    }
    Pressed nudged(int n, int c, double h) const {
        Pressed out = *this;
        nudge(out.x, out.q, n, c, h);
        out.update();
        return out;
    }
};

constexpr Nearness kinds[] = {Nearness::crossing, Nearness::end_on_side};

}  // namespace

TEST_CASE("surface contact: forces are the derivative of the energy") {
    Dice dice(1);
    for (int i = 0; i < 12; ++i) {
        Pressed p(dice, kinds[i % 2], i % 3 == 0);
        const std::vector<Vec6> f = p.forces();
        REQUIRE(p.contact.penetration > 0);
        const double scale = p.contact.stiffness * p.contact.penetration, h = 1e-7;
        double worst = 0;
        for (int n = 0; n < 4; ++n)
            for (int c = 0; c < 6; ++c) {
                const double slope = (p.nudged(n, c, h).contact.energy - p.nudged(n, c, -h).contact.energy) / (2 * h);
                worst = largest_of(worst, std::abs(slope - f[n][c]) / scale);
            }
        CHECK_FIGURE("force against the energy's slope", worst, 1e-5);
    }
}

TEST_CASE("surface contact: forces and moments balance, with and without friction") {
    Dice dice(2);
    for (int i = 0; i < 24; ++i) {
        Pressed p(dice, kinds[i % 2], i % 3 == 0, i % 4 < 2 ? 0.0 : i % 4 == 2 ? 0.01 : 10.0);
        end_step(p.contact, p.x, p.q);
        for (int n = 0; n < 4; ++n) p.x[n] += dice.vector(1e-3), p.q[n] = exponential(dice.vector(0.02)) * p.q[n];
        const std::vector<Vec6> f = p.forces();
        if (p.contact.friction > 0) REQUIRE(p.contact.slip.norm() > 0);
        if (p.contact.friction > 0) CHECK(p.contact.slides == (p.contact.friction < 1));
        const auto [force, moment] = sums_of(p.x, f);
        const double scale = p.contact.stiffness * p.contact.penetration;
        CHECK_FIGURE("sum of forces", force.norm() / scale, 1e-13);
        CHECK_FIGURE("sum of moments", moment.norm() / scale, 1e-13);
    }
}

TEST_CASE("surface contact: the tangent is what the force's derivative is without the turning of n") {
    Dice dice(3);
    for (int i = 0; i < 12; ++i) {
        const bool sticks = i % 2;
        Pressed p(dice, kinds[i / 2 % 2], i % 3 == 0, sticks ? 10.0 : 0.0);
        // all but no penetration: n rotates by g / (h_a + h_b) of what it is left out for
        const Vec3 lift = (p.contact.penetration - 1e-7) * p.contact.normal;
        for (int n : {2, 3}) p.x[n] += lift;
        p.update();
        end_step(p.contact, p.x, p.q);
        const Eigen::MatrixXd k = gathered([&](auto add) { add_contact_stiffness(p.contact, p.q, add); }),
                              d = slope_of([&](int n, int c, double h) { return p.nudged(n, c, h).forces(); }, 1e-9);
        CHECK_FIGURE("tangent", largest_entry(k - d) / largest_entry(k), 1e-4);
    }
}

TEST_CASE("surface contact: bars whose axes have passed each other are pushed back to their sides") {
    Dice dice(4);
    Pressed p(dice, Nearness::crossing, false);
    end_step(p.contact, p.x, p.q);
    const Vec3 normal = p.contact.normal;
    double last = p.contact.penetration;
    for (int i = 0; i < 30; ++i) {
        for (int n : {2, 3}) p.x[n] -= 3e-3 * normal;
        const std::vector<Vec6> f = p.forces();
        CHECK(p.contact.penetration == Approx(last + 3e-3));
        CHECK((f[2] + f[3]).head<3>().dot(normal) < 0);  // what resists; it pushes b along the normal
        last = p.contact.penetration;
        end_step(p.contact, p.x, p.q);
    }
    CHECK(last > p.contact.radius[0] + p.contact.radius[1]);
}

TEST_CASE("surface contact: axes that meet, at distance zero, are pushed apart to the side from which they came") {
    const Vec3 a[2] = {{-0.5, 0, 0}, {0.5, 0, 0}};
    const struct {
        Nearness kind;
        Vec3 b[2];
    } cases[] = {{Nearness::crossing, {{0.1, -0.4, 0}, {0.1, 0.4, 0}}},
                 {Nearness::crossing, {{0.1, 0, 0}, {0.1, 0.8, 0}}},      // an end on the other's axis
                 {Nearness::crossing, {{0.5, 0, 0}, {0.9, 0.8, 0}}},      // end on end
                 {Nearness::end_on_side, {{0.1, 0, 0}, {0.9, 5e-4, 0}}},  // all but parallel: no normal
                 {Nearness::end_to_end, {{0.5, 0, 0}, {0.9, 0, 0}}},      // on one line, one behind the other
                 {Nearness::alongside, {{0.2, 0, 0}, {0.9, 0, 0}}},       // on one line, over a stretch
                 {Nearness::point, {{0.2, 0, 0}, {0.2, 0, 0}}}};
    Dice dice(6);
    for (const auto& c : cases)
        for (int i = 0; i < 8; ++i) {  // as it stands, where the distance is zero to the bit, and turned
            const Quat all = i < 2 ? Quat::Identity() : dice.rotation();
            const Vec3 normal = all * Vec3::UnitZ();
            SurfaceContact contact;
            contact.radius[0] = 0.03, contact.radius[1] = 0.02;
            contact.stiffness = 1e6;
            contact.normal_before = normal;
            std::vector<Quat> q(4, Quat::Identity());
            std::vector<Vec3> x;
            const int first = i % 2;  // the bar's other end first: the normal of the two axes points the other way
            for (const Vec3& end : {a[0], a[1], c.b[first], c.b[1 - first]}) x.push_back(all * end);
            for (int n = 0; n < 4; ++n) contact.end[n].node = n;
            for (const double lift : {1e-3, 0.0, -1e-3}) {  // coming, meeting, passed
                INFO("kind " << int(c.kind) << ", " << lift << " m above");
                std::vector<Vec3> now = x;
                for (int n : {2, 3}) now[n] += lift * normal;
                const Vec3 points[4] = {now[0], now[1], now[2], now[3]};
                Closest closest;
                Vec3 found = contact.normal_before;
                signed_distance(points, closest, found);
                if (i == 0) CHECK(closest.kind == c.kind);
                update(contact, now, q);
                CHECK_FIGURE("penetration", std::abs(contact.penetration - (0.05 - lift)), 1e-14);
                CHECK_FIGURE("normal", (contact.normal - normal).norm(), 1e-12);
                std::vector<Vec6> f(4, Vec6::Zero());
                add_contact_forces(contact, q, f);
                const Vec3 wanted = -contact.stiffness * (0.05 - lift) * normal;  // on b, what resists
                CHECK_FIGURE("force on b", ((f[2] + f[3]).head<3>() - wanted).norm() / wanted.norm(), 1e-12);
                CHECK_FIGURE("force on a", ((f[0] + f[1]).head<3>() + wanted).norm() / wanted.norm(), 1e-12);
                end_step(contact, now, q);
            }
        }
}

TEST_CASE("surface contact: the impulse that a step misses gives a bounce its speed back") {
    // a mass m on a fixed plane, the trapezoidal rule by hand: with the impulse the bounce keeps its energy, without it
    // does not
    const double m = 2, k = 1e6, v0 = 3, dt = 0.4 / std::sqrt(k / m);
    const auto bounce = [&](double start, bool mend) {
        double x = start, v = -v0, f = 0;  // penetration g = -x
        for (int step = 0; step < 40; ++step) {
            // average acceleration, linear in the new force
            const bool press = x + dt * v < 0;
            const double to = press ? (x + dt * v + 0.25 * dt * dt / m * f) / (1 + 0.25 * dt * dt * k / m)
                                    : x + dt * v + 0.25 * dt * dt / m * f;
            const double force = press ? -k * to : 0;
            v += 0.5 * dt / m * (f + force);
            SurfaceContact contact;
            contact.stiffness = k;
            contact.penetration_before = -x;
            contact.penetration = -to;
            contact.normal = Vec3::UnitZ();
            for (int i = 0; i < 4; ++i) contact.end[i].node = i;
            std::vector<Vec6> impulse(4, Vec6::Zero());
            std::vector<Quat> q(4, Quat::Identity());
            missed_impulse(contact, dt, q, impulse);
            if (mend) v += (impulse[2] + impulse[3])[2] / m;
            x = to;
            f = force;
        }
        return v;
    };
    double worst = 0, worst_without = 0;
    for (int i = 0; i < 20; ++i) {
        const double start = 5e-3 + v0 * dt * i / 20;
        worst = largest_of(worst, off(bounce(start, true), v0));
        worst_without = largest_of(worst_without, off(bounce(start, false), v0));
    }
    CHECK_FIGURE("speed after a bounce", worst, 3e-3);
    CHECK(worst_without > 5 * worst);
}

TEST_CASE("shared spring: pairs of one contact press as the energy's derivative, none pulls, all are one spring") {
    Dice dice(5);
    const double k = 1e6, g = 1e-3;
    const auto energy = [&](std::vector<SurfaceContact>& pairs, const std::vector<double>& depths) {
        double sum = 0;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            pairs[i].stiffness = k;
            pairs[i].penetration = depths[i];
            pairs[i].group = 0;
            pairs[i].next = i + 1 < pairs.size() ? int(i) + 1 : -1;
        }
        share_depth(pairs, 0);
        for (const SurfaceContact& c : pairs) sum += 0.5 * k * c.depth * c.penetration;
        return sum;
    };
    for (int n = 1; n <= 6; ++n) {
        std::vector<SurfaceContact> pairs(n), other(n);
        const double equal = energy(pairs, std::vector<double>(n, g)) / (0.5 * k * g * g);
        CHECK(equal == Approx(1 / (1 - own_part + own_part / n)));
        CHECK(equal < 1.042);
        for (int trial = 0; trial < 20; ++trial) {
            std::vector<double> depths(n);
            for (double& d : depths) d = g * dice(0.9, 1.0);
            if (trial % 2) depths[0] = -g;
            energy(pairs, depths);
            double worst = 0;
            for (int i = 0; i < n; ++i) {
                CHECK(pairs[i].depth >= 0);
                CHECK(pairs[i].depth <= (depths[i] > 0 ? depths[i] : 0) * (1 + 1e-12));
                std::vector<double> up = depths, down = depths;
                up[i] += 1e-5 * g, down[i] -= 1e-5 * g;
                const double slope = (energy(other, up) - energy(other, down)) / (2e-5 * g);
                worst = largest_of(worst, std::abs(slope - k * pairs[i].depth) / (k * g));
            }
            CHECK_FIGURE("slope of the energy", worst, 1e-3);  // the step may lie across a pair's beginning
        }
    }
}

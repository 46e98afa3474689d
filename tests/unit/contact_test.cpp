// Contact: the rule at work in small scenes, who is released when, what a record keeps.
#include <algorithm>
#include <map>
#include <utility>

#include "contact/gap_rule.h"
#include "contact/ground_friction.h"
#include "contact/segments.h"
#include "core/archive.h"
#include "contact_parts.h"

using namespace hinge;
using namespace hinge::contact;

namespace {

std::pair<int, int> elements_of(const Tie& tie) { return {tie.element[0], tie.element[1]}; }

/// What forces do in dt to nodes of this mass and rotary inertia, from the node `first` on.
void accelerate(Scene& s, const std::vector<Vec6>& f, std::size_t first, double dt, double mass, double inertia) {
    for (std::size_t n = first; n < s.v.size(); ++n) {
        s.v[n].head<3>() -= dt / mass * f[n].head<3>();
        s.v[n].tail<3>() -= dt / inertia * f[n].tail<3>();
    }
}

}  // namespace

// ---- the rule at work

TEST_CASE("contact: members crossing at their mid nodes bind up to four element pairs") {
    for (double angle : {90.0, 45.0, 10.0}) {
        Scene s = crossing(50, 2e-4, angle * pi / 180);
        // First seen apart, else they would count as joined.
        s.lift(0.1);
        Contact contact{ContactSettings()};
        CHECK(s.detect(contact, 1e-6, 0) == 0);
        s.lift(-0.1);
        // Halves that point away from each other by more than 106 degrees are too long for eq 18: two of the four at 45
        // degrees.
        const std::vector<std::pair<int, int>> all{{0, 2}, {0, 3}, {1, 2}, {1, 3}}, near{{0, 2}, {1, 3}};
        const auto& pairs = angle > 74 ? all : near;
        CHECK(s.detect(contact, 1e-5, 1e-5) == int(pairs.size()));
        REQUIRE(contact.ties().size() == pairs.size());
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            CHECK(elements_of(contact.ties()[i]) == pairs[i]);
            CHECK(contact.ties()[i].normal.z() == Approx(1));
            for (const Gap& gap : contact.ties()[i].gap) CHECK(gap.stiffness <= 5e8 / 0.25 * (1 + 1e-12));
        }
        int added = 0;
        contact.add_stiffness(s.x, s.q, [&](int, int, const Mat12&) { ++added; });
        CHECK(added == 6 * int(pairs.size()));
        s.forces(contact);
        CHECK(contact.stored_energy() == 0);
        CHECK_FALSE(contact.idle());
        CHECK(contact.events().size() == pairs.size());
        CHECK(contact.counts().bound == long(pairs.size()));
    }
}

TEST_CASE("contact: bars that part or stay are left alone") {
    for (double speed : {-50.0, 0.0}) {
        Scene s = crossing(speed, 0.06);
        Contact contact{ContactSettings()};
        CHECK(s.detect_and_move(contact, 1e-4, 20) == 0);
    }
}

TEST_CASE("contact: bars that share a node or are joined when first seen never bind, until they have parted") {
    // A brace through a brace, in contact; a third bar shares a node with the first.
    Scene s;
    const int a = s.node({-1, 0, 0}), b = s.node({1, 0, 0}), c = s.node({0, -1, 0.01}), d = s.node({0, 1, 0.01}),
              e = s.node({1, 0.04, 1});
    s.bar(a, b);
    s.bar(c, d);
    s.bar(b, e);
    Contact contact{ContactSettings()};
    double time = 0;
    const auto step = [&](double velocity, int steps) {
        s.v[c][2] = s.v[d][2] = velocity;
        time += 1e-4 * steps;
        return s.detect_and_move(contact, 1e-4, steps, time - 1e-4 * steps);
    };
    CHECK(step(-10, 30) == 0);   // through, 20 mm beyond
    CHECK(step(10, 40) == 0);    // and back
    CHECK(step(10, 60) == 0);    // apart by more than the sum of the half depths
    CHECK(step(-10, 100) == 1);  // now it is contact
}

TEST_CASE("contact: what is left of a broken element is a new bar, joined to what it meets") {
    // Elements 0: nodes 0-1, 1: nodes 1-2. Element 0 breaks at node 1 and hangs on node 0 with an arm.
    Scene s;
    const int n0 = s.node({0, 0, 0}), n1 = s.node({1, 0, 0}), n2 = s.node({2, 0, 0});
    s.bar(n0, n1);
    s.bar(n1, n2);
    Contact contact(ContactSettings{.contact_length = infinite});
    s.detect(contact, 1e-4, 0);
    s.bars[0].node[1] = n0;
    s.bars[0].arm = Vec3(1, 0, 0);
    s.v[n0].head<3>() = Vec3(1, 0, 0);
    CHECK(s.detect(contact, 1e-4, 0, true) == 0);
    s.move(1e-4);
    CHECK(s.detect_and_move(contact, 1e-4, 49, 1e-4) == 0);
    // It swings away about its node at pi rad a second, and back: it has parted, and meets the other bar.
    s.v[n0] << 0, 0, 0, 0, 0, 100;
    CHECK(s.detect_and_move(contact, 1e-3, 10) == 0);
    s.v[n0] << 0, 0, 0, 0, 0, -100;
    CHECK(s.detect_and_move(contact, 1e-3, 12) == 1);
    CHECK(contact.ties().front().end[1].arm.x() == 1);
    CHECK(contact.ties().front().end[1].node == n0);
}

TEST_CASE("contact: the candidate list finds the contacts of all pairs tested in every step") {
    // A swarm of bars with changing velocities. The reference looks at every pair in every step, with nothing kept but
    // the side.
    for (bool as_printed : {false, true}) {
        Dice dice(as_printed ? 9 : 10);
        ContactSettings settings{
            .coplanarity_tolerance = as_printed ? 3e-3 : 3e-4, .binding_time = 1e9, .as_printed = as_printed};
        Scene s;
        for (int i = 0; i < 60; ++i) {
            const Vec3 at = dice.vector(1.2), d = dice(0.4, 1) * dice.direction();
            s.bar(s.node(at), s.node(at + d), dice(0.02, 0.05));
        }
        Contact contact(settings);
        std::map<std::pair<int, int>, Vec3> normal;
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
                    const BarPair two{{s.x[2 * i], s.x[2 * i + 1]}, {s.x[2 * j], s.x[2 * j + 1]}};
                    const Closest c = closest_points(two);
                    const double contact_distance = s.bars[i].radius + s.bars[j].radius;
                    Vec3& way = normal.try_emplace({i, j}, Vec3::Zero()).first->second;
                    int& is = state[{i, j}];
                    const bool near = as_printed ? within_contact_length(two, settings.contact_length)
                                                 : c.distance <= contact_distance;
                    if (is == 0)
                        is = near && (c.distance <= contact_distance || coplanar(two, settings.coplanarity_tolerance))
                                 ? 2
                                 : 1;
                    if (is == 2 && !near) is = 1;
                    if (c.distance > contact_distance || c.between.dot(way) > 0) way = c.between.normalized();
                    if (is != 1) continue;
                    const Moving m{two,
                                   {{dt * s.v[2 * i].head<3>(), dt * s.v[2 * i + 1].head<3>()},
                                    {dt * s.v[2 * j].head<3>(), dt * s.v[2 * j + 1].head<3>()}}};
                    const RuleNumbers numbers{settings.contact_length, settings.coplanarity_tolerance,
                                              contact_distance};
                    const Meeting meeting =
                        as_printed ? printed_meeting(m, c, way, numbers) : first_meeting(m, c, way, numbers);
                    if (meeting.found) {
                        is = 3;
                        expected.push_back({i, j});
                    }
                }
            const std::size_t before = contact.ties().size();
            const int bound = s.detect(contact, dt, step * dt);
            REQUIRE(bound == int(expected.size()));
            for (std::size_t k = 0; k < expected.size(); ++k)
                CHECK(elements_of(contact.ties()[before + k]) == expected[k]);
            total += expected.size();
            s.move(dt);
        }
        CHECK(total > 12);
        CHECK(contact.counts().list_builds < (as_printed ? 200 : 120));
        if (!as_printed) CHECK(contact.counts().pair_tests < 600 * 60 * 59 / 2 / 50);
    }
}

TEST_CASE("contact: the order of the bars does not matter") {
    Scene s = crossing(122, 0.2, 1.0, {0.03, 0.02, 0});
    Scene shuffled = s;
    std::reverse(shuffled.bars.begin(), shuffled.bars.end());
    std::swap(shuffled.bars[0], shuffled.bars[2]);
    Contact one{ContactSettings()}, two{ContactSettings()};
    for (int i = 0; i < 300; ++i) {
        CHECK(one.detect(s.bars, false, s.motion(), 1e-5, i * 1e-5) ==
              two.detect(shuffled.bars, false, shuffled.motion(), 1e-5, i * 1e-5));
        s.move(1e-5);
        shuffled.move(1e-5);
    }
    REQUIRE(one.ties().size() == two.ties().size());
    REQUIRE(one.ties().size() > 0);
    for (std::size_t i = 0; i < one.ties().size(); ++i) {
        CHECK(elements_of(one.ties()[i]) == elements_of(two.ties()[i]));
        CHECK(one.ties()[i].gap[3].rest == two.ties()[i].gap[3].rest);
    }
}

TEST_CASE("contact: bars far apart are seldom tested") {
    Scene s = crossing(10, 5.0);
    Contact contact{ContactSettings()};
    s.detect_and_move(contact, 1e-5, 10000);
    CHECK(contact.counts().pair_tests == 0);
    CHECK(contact.counts().list_builds < 110);
    CHECK(contact.candidates() == 0);
    // No bars, one bar, and a motion that is not finite are no reason to fall over.
    const std::vector<Bar> none, one(s.bars.begin(), s.bars.begin() + 1);
    CHECK(contact.detect(none, true, s.motion(), 1e-5, 1) == 0);
    CHECK(contact.detect(one, true, s.motion(), 1e-5, 1) == 0);
    s.v[0][0] = std::numeric_limits<double>::quiet_NaN();
    CHECK(s.detect(contact, 1e-5, 1, true) == 0);
    s.v[0][0] = 0;
    s.x[0][1] = infinite;
    CHECK(s.detect(contact, 1e-5, 1) == 0);
}

TEST_CASE("contact: f with its sign, as printed: pairs on one side bind at any distance, on the other they do not") {
    for (const bool with_sign : {false, true}) {
        int bound[2];
        for (const int turned : {0, 1}) {
            Scene s = crossing(50, 1.0, turned ? -pi / 2 : pi / 2);  // the ends of one bar in the other order
            Contact contact(ContactSettings{.contact_length = infinite, .as_printed = true, .signed_f = with_sign});
            s.lift_to(-1);  // first seen on the other side
            CHECK(s.detect(contact, 1e-5, 0, true) == 0);
            s.lift_to(1);
            bound[turned] = s.detect(contact, 1e-5, 0);
            s.lift_to(1e-3);  // coplanar: without eq 18 every pair that approaches
            if (!with_sign) CHECK(s.detect(contact, 1e-5, 0) == 4);
        }
        CHECK(bound[0] + bound[1] == (with_sign ? 4 : 0));
        CHECK(bound[0] * bound[1] == 0);
    }
}

TEST_CASE("contact: as printed, short bars with a large C_l bind from as far as eq 18 reaches") {
    // Bars one above the other, side by side: coplanar at any distance, so that eq 18 alone decides; far beyond the sum
    // of their half depths.
    const struct {
        double length[2], contact_length;
    } cases[] = {{{0.05, 0.05}, 20}, {{0.6, 0.03}, 4}, {{0.03, 0.6}, 4}, {{0.02, 0.02}, 200}};
    for (const auto& c : cases) {
        INFO("lengths " << c.length[0] << " and " << c.length[1] << " m, C_l " << c.contact_length);
        const double v = 10, dt = 2e-4, from = 0.3 * c.contact_length * (c.length[0] + c.length[1]);
        Scene s;
        const Vec3 a(0.5 * c.length[0], 0, 0), b(0.5 * c.length[1], 0, 0), above(0, 0, from);
        const int upper = 2;
        s.bar(s.node(-a), s.node(a), 0.005);
        s.bar(s.node(above - b, {0, 0, -v}), s.node(above + b, {0, 0, -v}), 0.005);
        Contact contact(ContactSettings{.contact_length = c.contact_length, .as_printed = true});
        // eq 18 by hand: twice the distance of ends on one side, twice that of ends on opposite sides
        const auto reaches = [&](double z) {
            const double near = 0.5 * (c.length[0] - c.length[1]), far = 0.5 * (c.length[0] + c.length[1]);
            return 2 * std::hypot(z, near) + 2 * std::hypot(z, far) <= c.contact_length * (c.length[0] + c.length[1]);
        };
        REQUIRE_FALSE(reaches(from));
        bool bound = false;
        for (int i = 0; !bound && s.x[upper].z() > 0; ++i) {
            const double z = s.x[upper].z();
            bound = s.detect(contact, dt, i * dt) > 0;
            INFO("at " << z << " m");
            REQUIRE(bound == reaches(z));
            s.move(dt);
        }
        CHECK(bound);
    }
}

// ---- release

namespace {

/// A pair of crossing bars bound at time 0, and what a test wants to do with it.
struct Held {
    Scene s;
    Contact contact;

    explicit Held(ContactSettings settings = ContactSettings()) : s(crossing(50, 0.06)), contact(settings) {
        s.detect(contact, 1e-6, -1);
        s.lift_to(2e-4);
        REQUIRE(s.detect(contact, 1e-5, 0) == 4);
    }
    /// The upper member at height z; what is released at time t.
    double at(double t, double z) {
        s.lift_to(z);
        s.forces(contact);
        return contact.release(t);
    }
};

}  // namespace

TEST_CASE("contact: cut at the binding time, whatever the tie carries") {
    Held held({.hold_until_parting = false});
    CHECK(held.at(0.3e-3, -1e-3) == 0);
    CHECK(held.contact.ties().size() == 4);
    const double stored = held.contact.stored_energy();
    CHECK(stored > 0);
    CHECK(held.at(0.5e-3, -1e-3) == Approx(stored));
    CHECK(held.contact.idle());
    CHECK(held.contact.counts().released == 4);
    CHECK(held.contact.counts().energy_released == Approx(stored));
    CHECK(held.contact.stored_energy() == 0);
    CHECK(held.contact.events().size() == 8);
    CHECK_FALSE(held.contact.events().back().bound);
}

TEST_CASE("contact: held until the bars part and the energy is low") {
    SECTION("not while pressing on, at the bottom of a swing of the energy") {
        Held held;
        held.at(0.1e-3, -3e-3);              // pressed in
        CHECK(held.at(0.6e-3, -2e-3) == 0);  // coming back: falling
        CHECK(held.at(0.7e-3, -0.5e-3) == 0);
        CHECK(held.at(0.8e-3, 1e-3) > 0);  // past the rest position, outwards, rising again: released
        CHECK(held.contact.idle());
    }
    const struct {
        const char* name;
        std::vector<std::pair<double, double>> times_and_heights;
        bool released;
    } ways[] = {
        {"nothing left in it", {{0.1e-3, -3e-3}, {0.6e-3, -2e-3}, {0.7e-3, 2e-4}}, true},
        {"passing the rest position inwards is no parting", {{0.1e-3, 3e-3}, {0.6e-3, 2e-3}, {0.7e-3, 2e-4}}, false},
        {"a high minimum is no end",
         {{0.1e-3, -3e-3}, {0.6e-3, -2e-3}, {0.7e-3, -2.1e-3}, {0.8e-3, -2e-3}, {0.9e-3, -2.2e-3}},
         false},
    };
    for (const auto& way : ways) {
        INFO(way.name);
        Held held;
        for (const auto& [t, z] : way.times_and_heights) held.at(t, z);
        CHECK(held.contact.idle() == way.released);
        CHECK(held.contact.ties().size() == (way.released ? 0 : 4));
    }
    SECTION("not for ever") {
        Held held;
        held.at(0.1e-3, -3e-3);
        CHECK(held.at(9.99e-3, -3.1e-3) == 0);
        CHECK(held.at(10e-3, -3.2e-3) > 0);
        CHECK(held.contact.idle());
    }
}

TEST_CASE("contact: after a release a pair binds again only when it approaches, seen from where it came") {
    for (double z : {-2e-3, 2e-4}) {  // released after it has passed through a little, or not
        Held held({.hold_until_parting = false});
        held.at(0.5e-3, z);
        REQUIRE(held.contact.idle());
        for (int n = 3; n < 6; ++n) held.s.v[n][2] = 5;  // back up: parting, though |f| may fall
        CHECK(held.s.detect_and_move(held.contact, 1e-4, 5) == 0);
        held.at(0.5e-3, z);
        for (int n = 3; n < 6; ++n) held.s.v[n][2] = -5;  // down: on through
        CHECK(held.s.detect(held.contact, 1e-4, 0) == 4);
        CHECK(held.contact.ties().front().normal.z() == Approx(1));
    }
}

TEST_CASE("contact: a falling bar does not tunnel, and its energy comes back") {
    // Each node of the falling member is a mass; the lower member does not move. Small explicit steps: nothing but the
    // tie.
    for (bool hold : {true, false}) {
        Scene s;
        s.member({-0.5, 0, 0}, {0.5, 0, 0}, 1);
        s.member({-0.1, -0.6, 0.06}, {0.2, 0.4, 0.06}, 1, {0, 0, -20});
        Contact contact(ContactSettings{.hold_until_parting = hold});
        const double dt = 2e-6, mass = 5, inertia = 0.05;
        double released = 0, worst = 0, lowest = 1;
        const double begin = 2 * 0.5 * mass * 400;
        for (int step = 0; step < 20000; ++step) {
            released += contact.release(step * dt);
            s.detect(contact, dt, step * dt);
            for (int half = 0; half < 2; ++half) {
                accelerate(s, s.forces(contact), 2, 0.5 * dt, mass, inertia);
                if (half == 0) s.move(dt);
            }
            double energy = contact.stored_energy() + released;
            for (int n = 2; n < 4; ++n)
                energy += 0.5 * mass * s.v[n].head<3>().squaredNorm() + 0.5 * inertia * s.v[n].tail<3>().squaredNorm();
            worst = largest_of(worst, std::abs(energy / begin - 1));
            lowest = smallest_of(lowest, closest_points(s.x[0], s.x[1], s.x[2], s.x[3]).between.z());
        }
        INFO("hold " << hold << ", released " << released / begin << ", lowest " << lowest << ", bound "
                     << contact.counts().bound);
        CHECK(contact.counts().bound > 0);
        CHECK(contact.idle());
        CHECK(worst < 0.02);
        CHECK(lowest > -0.02);
        CHECK(s.x[2].z() + s.x[3].z() > 0.12);
        if (hold) CHECK(released < 0.15 * begin);
    }
}

TEST_CASE("contact: a broken element loses its ties, not its memory") {
    Held held;
    held.at(0.1e-3, -1e-3);
    const double all = held.contact.stored_energy(), part = held.contact.drop(2);
    CHECK(part > 0);
    CHECK(held.contact.ties().size() == 2);
    CHECK(held.contact.stored_energy() == Approx(all - part));
    CHECK(held.contact.counts().dropped == 2);
    CHECK(held.contact.drop(2) == 0);
    // What is left of element 2 hangs on node 4 (its far end went): it is bound again while it presses on.
    contact::Bar& broken = held.s.bars[2];
    broken.node[0] = broken.node[1] = 4;
    broken.arm = held.s.x[3] - held.s.x[4];
    CHECK(held.s.detect(held.contact, 1e-5, 0.1e-3, true) == 2);
    CHECK(held.contact.ties().back().normal.z() == Approx(1));
}

TEST_CASE("contact: one event of a surface contact of four pairs, and each that ends has begun before") {
    Scene s = crossing(10, 0.06);
    Contact contact(ContactSettings{.rule = ContactRuleKind::surface});

    const auto now = [&] { return std::pair{contact.counts().bound, contact.counts().released}; };
    CHECK(s.detect(contact, 1e-4, 0) == 0);
    s.lift(-0.01 - 2e-8);  // as an impulse leads them into each other, by less than what counts as a depth
    CHECK(s.detect(contact, 1e-4, 1e-4) == 4);
    CHECK(now() == std::pair{1L, 0L});
    // What is left of a broken element may lie elsewhere.
    s.lift(0.02);
    contact.follow_broken(s.bars, s.x, s.q);
    CHECK(now() == std::pair{1L, 1L});
    s.lift(-0.02);
    contact.follow_broken(s.bars, s.x, s.q);
    CHECK(now() == std::pair{2L, 1L});
    s.lift(0.02);
    s.forces(contact);
    std::vector<Vec6> impulse(s.x.size(), Vec6::Zero());
    contact.end_step(2e-4, 1e-4, s.x, s.q, impulse);
    CHECK(now() == std::pair{2L, 2L});
    long began = 0;
    for (const ContactEvent& event : contact.events()) began += event.bound ? 1 : -1;
    CHECK(contact.events().size() == 4);
    CHECK(began == 0);
}

// ---- snapshots

namespace {

std::string record(const Contact& c) {
    std::string bytes;
    Writer{bytes}(c);
    return bytes;
}

}  // namespace

TEST_CASE("contact: a copy and a saved record continue with the same bits") {
    const auto run = [](Scene& s, Contact& contact, int from, int to) {
        for (int i = from; i < to; ++i) {
            s.detect(contact, 1e-5, i * 1e-5, i == 0);
            accelerate(s, s.forces(contact), 3, 1e-5, 50, 50);
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
    for (const contact::Bar& bar : s.bars) elements = std::max<int>(elements, bar.element + 1);
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

TEST_CASE(
    "contact: a step that is taken back leaves every byte as it was, and the next goes on as if it had not been") {
    for (const ContactRuleKind rule : {ContactRuleKind::gap, ContactRuleKind::surface}) {
        const auto step = [](Scene& s, Contact& contact, int i) {
            s.detect(contact, 1e-5, i * 1e-5, i == 0 || i == 300);
            accelerate(s, s.forces(contact), 3, 1e-5, 50, infinite);
            s.move(1e-5);
            s.forces(contact);
            contact.release((i + 1) * 1e-5);
            std::vector<Vec6> impulse(s.x.size(), Vec6::Zero());
            contact.end_step((i + 1) * 1e-5, 1e-5, s.x, s.q, impulse);
            if (i == 300) contact.drop(0);
        };
        Scene straight = crossing(80, 0.1, 0.8, {0.1, 0.05, 0}), s = straight;
        Contact steady{ContactSettings{.rule = rule}}, contact = steady;
        int differs = 0, bound = 0;
        for (int i = 0; i < 600; ++i) {
            const std::string before = record(contact);
            const Scene here = s;
            contact.save_step();
            step(s, contact, i);
            differs += record(contact) != before;
            contact.roll_back();
            CHECK(record(contact) == before);
            s = here;
            step(s, contact, i);
            contact.release_step();
            step(straight, steady, i);
            bound += !contact.idle();
        }
        CHECK(differs == 600);
        CHECK(bound > 0);
        CHECK(contact.counts().list_builds > 1);
        CHECK(record(contact) == record(steady));
    }
}

TEST_CASE("contact: friction where nothing presses is none, also where rounding leaves less than nothing") {
    for (const double most : {0.0, -1e-21})
        for (const double moved : {0.0, 1e-3}) {
            const Friction f = friction(Vec3::Zero(), Vec3(moved, 0, 0), 1, 1e8, most);
            CHECK(f.slip == Vec3::Zero());
            CHECK(f.heat == 0);
        }
}
